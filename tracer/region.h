// region.h: convex parts of a square, and what is left of it in Legendre moments.
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "tracer/gauss.h"

namespace litmus {

/// Of the square -1..1 by -1..1 unless clipped.
struct Corner {
  double u, v;
};

/// constant + along_u u + along_v v > 0.
struct HalfPlane {
  double constant, along_u, along_v;

  double at(const Corner& c) const { return constant + along_u * c.u + along_v * c.v; }
};

inline constexpr int kMostSides = 24;  ///< of a convex set
inline constexpr int kMostHidden = 4;  ///< sets that are cut away from a square
inline constexpr int kMostCuts = 24;   ///< lines that it is cut by besides
inline constexpr int kMostCorners = 6 + kMostCuts + kMostHidden * kMostSides;

/// The points for which all half-planes hold.
struct ConvexSet {
  int count = 0;
  std::array<HalfPlane, kMostSides> sides;

  ConvexSet() {}
  ConvexSet(const ConvexSet& other) { *this = other; }
  ConvexSet& operator=(const ConvexSet& other) {
    count = other.count;
    std::copy_n(other.sides.begin(), count, sides.begin());
    return *this;
  }
  void add(const HalfPlane& side) { sides[std::size_t(count++)] = side; }
  std::span<const HalfPlane> all() const { return {sides.data(), std::size_t(count)}; }
};

/// A convex polygon, its corners counter-clockwise.
class Polygon {
 public:
  static Polygon square();
  Polygon(const Polygon& other) { *this = other; }
  Polygon& operator=(const Polygon& other);

  std::span<const Corner> corners() const { return {corners_.data(), std::size_t(count_)}; }
  bool empty() const { return count_ == 0; }
  /// Keeps the part in the half-plane (Sutherland and Hodgman 1974).
  void clip(const HalfPlane& side);
  void clip(const ConvexSet& set);
  double area() const;
  Corner centroid() const;  ///< of one that is not empty

 private:
  Polygon() = default;
  int count_ = 0;
  std::array<Corner, kMostCorners> corners_;
};

/// Means over the square of P_i(u) P_j(v) inside a region, P Legendre's polynomials, i, j < points.
struct Moments {
  int points;
  std::array<std::array<double, kMostPoints>, kMostPoints> of{};

  double share() const { return of[0][0]; }  ///< of the square's area
};

/// Adds `sign` times a polygon's moments: exact integrals along its sides (Green's theorem).
void add_polygon(Moments& moments, const Polygon& polygon, double sign);

/// Adds the moments of what is left of a polygon without the points of any of the sets.
void add_visible(Moments& moments, const Polygon& polygon, std::span<const ConvexSet> hidden,
                 double sign = 1);

/// Weights of the points x points nodes of Gauss-Legendre quadrature, u first: with them the sum is
/// the integral over the region of the polynomial that has the function's values at the nodes,
/// divided by the square's area. For the whole square they are Gauss's own.
std::array<double, kMostPoints * kMostPoints> node_weights(const Moments& moments);

}  // namespace litmus
