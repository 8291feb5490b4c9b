// quadrature_bound.h: how far Gauss-Legendre quadrature over a piece of an area light can be off.
#pragma once

#include <array>

#include "tracer/gauss.h"
#include "tracer/lights.h"
#include "tracer/shade.h"

namespace litmus {

/// What a piece of an area light looks like from a surface point, at the piece's centre.
struct LightPatch {
  Lamp<double> lamp;    ///< at the centre of the piece
  double distance;      ///< of the centre, scene units
  double across, up;    ///< half its sides over that distance, at right angles
  double slant;         ///< the larger |cosine| between a side and the way to the centre
  Vec<double> l, e, n;  ///< slide 5, unit: towards the centre, the eye, the normal
  double shininess;
  bool shiny;
};

/// What is integrated over: a whole piece, or any region of it.
enum class Region { Whole, Part };

/// Upper bounds of the terms D and S (shade.h) anywhere on the piece, with nothing in the way, and of
/// their errors for 1, 2, ... points.
struct QuadratureBounds {
  Terms<double> largest;
  std::array<Terms<double>, kMostPoints> error;
};

/// Bounds on the error of points x points nodes of Gauss-Legendre quadrature of D and S over a piece
/// on which no cosine changes its sign, or of node_weights() (region.h) over a region of it, times
/// the region's share of its area; there D may go on below 0.
///
/// An m-point rule on [-1, 1] is off by at most (64/15) M rho^(-2m) / (1 - rho^-2), m >= 2, for a
/// function that is analytic and at most M in the Bernstein ellipse rho (Trefethen 2013, theorem
/// 19.3; for m = 1 the same argument gives 16/3). Its interpolating polynomial is off by at most
/// e = 2 M rho^-m (c + (1 + L) / (rho - 1)) anywhere: Chebyshev's coefficients are at most
/// 2 M rho^-k (theorem 8.1), the interpolant of T_k is off by at most 1 + L, L the Lebesgue constant
/// of the nodes, and that of T_m by c = 2^(2m-1) m!^2 / (2m)!; in two directions by (1 + L) e.
///
/// M is found for both directions at once. A point of the ellipse is at most (rho - 1/rho) / 2 away
/// from [-1, 1], so the vector to the light differs from one that ends on the piece, of length d and
/// direction l, by a complex multiple, at most delta d, of a side's direction. With k the largest
/// |cosine| between the two,
///     |d'^2/d^2 - 1| <= q = 2 delta k + delta^2,  |d'/d - 1| <= eta = 1 - sqrt(1 - q),
///     |l' - l| <= lambda = (delta + eta) / (1 - eta),
///     |D| <= attenuation(d (1 - eta)) (|l.n| + lambda),
/// and as h' = (l' + e) / sqrt(2 + 2 l'.e), with L = |l + e| and theta = 1 - sqrt(1 - 2 lambda/L^2),
///     |h' - h| <= epsilon = (lambda/L + theta) / (1 - theta).
/// h'.n = 1 - (n - h')^2 / 2, so that where t = |n - h| (real)
///     Re(h'.n) <= 1 - (t^2 - 2 t epsilon - epsilon^2) / 2,  |Im(h'.n)| <= t epsilon + epsilon^2/2,
///     |S| <= attenuation(d (1 - eta)) |h'.n|^ns,
/// all of it analytic while q < 1, 2 lambda < L^2 and t + epsilon < sqrt(2). Several delta are tried.
/// Rounding is not counted.
QuadratureBounds quadrature_bounds(const LightPatch& patch, Region region);

}  // namespace litmus
