// quadrature_bound.h: how far Gauss-Legendre quadrature over a piece of an area light can be off.
#pragma once

#include <array>

#include "tracer/lights.h"
#include "tracer/shade.h"

namespace litmus {

/// What a piece of an area light looks like from a surface point, at the piece's centre.
struct LightPatch {
  Lamp<double> lamp;    ///< at the centre of the piece
  double distance;      ///< of the centre, scene units
  double across, up;    ///< half its sides over that distance
  Vec<double> l, e, n;  ///< slide 5, unit: towards the centre, the eye, the normal
  double shininess;
  bool shiny;
};

/// Upper bounds of the terms D and S (shade.h) anywhere on the piece. Nothing is in the way.
Terms<double> largest_terms(const LightPatch& patch);

inline constexpr int kMostPoints = 3;

/// Bounds on the error of 1 x 1, 2 x 2 and 3 x 3 points of Gauss-Legendre quadrature of the means of
/// D and S over a piece on which no cosine changes its sign.
///
/// An m-point rule on [-1, 1] is off by at most (64/15) M rho^(-2m) / (1 - rho^-2), m >= 2, for a
/// function that is analytic and at most M in the Bernstein ellipse rho (Trefethen 2013, theorem
/// 19.3; for m = 1 the same argument gives 16/3). M is found for both directions at once: with one
/// coordinate anywhere in the ellipse, the other on [-1, 1], the vector to the light differs from
/// the one to the centre by at most delta = across * (rho + 1/rho)/2 + up of its length, so
///     |d^2/d0^2 - 1| <= q = 2 delta + delta^2,  |d/d0 - 1| <= eta = 1 - sqrt(1 - q),
///     |l - l0| <= lambda = (delta + eta) / (1 - eta),
///     |D| <= attenuation(d0 (1 - eta)) (l0.n + lambda),
///     |S| <= attenuation(d0 (1 - eta)) ((l0 + e).n + lambda)^ns / (2 + 2 l0.e - 2 lambda)^(ns/2),
/// all of them analytic while q < 1, lambda < (l0 + e).n and lambda < 1 + l0.e. Several rho are
/// tried. Rounding is not counted.
std::array<Terms<double>, kMostPoints> quadrature_bounds(const LightPatch& patch);

}  // namespace litmus
