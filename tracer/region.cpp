// region.cpp: clipping, and integrals along the sides of polygons.
#include "tracer/region.h"

#include <algorithm>
namespace litmus {
namespace {

/// P_0 to P_kMostPoints at x.
std::array<double, kMostPoints + 1> legendre(double x) {
  const double square = x * x;
  return {1, x, 1.5 * square - 0.5, (2.5 * square - 1.5) * x,
          (4.375 * square - 3.75) * square + 0.375};
}

/// Their integrals that are x, and 0 at -1 and 1, at x: (P_(i+1) - P_(i-1)) / (2 i + 1).
std::array<double, kMostPoints> legendre_integrals(const std::array<double, kMostPoints + 1>& p) {
  return {p[1], (p[2] - p[0]) * (1 / 3.), (p[3] - p[1]) * (1 / 5.), (p[4] - p[2]) * (1 / 7.)};
}

/// (2 i + 1) w_a P_i(x_a): a function's values at the nodes to its Legendre coefficients.
using ToLegendre = std::array<std::array<double, kMostPoints>, kMostPoints>;
ToLegendre to_legendre(int points) {
  ToLegendre to{};
  const GaussRule& rule = short_rule(points);
  for (std::size_t a = 0; a < std::size_t(points); ++a) {
    const auto p = legendre(rule.nodes[a]);
    for (std::size_t i = 0; i < std::size_t(points); ++i)
      to[i][a] = double(2 * i + 1) * rule.weights[a] * p[i];
  }
  return to;
}

}  // namespace

Polygon Polygon::square() {
  Polygon all;
  all.count_ = 4;
  all.corners_[0] = {-1, -1}, all.corners_[1] = {1, -1};
  all.corners_[2] = {1, 1}, all.corners_[3] = {-1, 1};
  return all;
}

Polygon& Polygon::operator=(const Polygon& other) {
  count_ = other.count_;
  std::copy_n(other.corners_.begin(), count_, corners_.begin());
  return *this;
}

void Polygon::clip(const HalfPlane& side) {
  std::array<double, kMostCorners> height;
  bool all = true;
  for (std::size_t i = 0; i < std::size_t(count_); ++i) {
    height[i] = side.at(corners_[i]);
    all = all && height[i] > 0;
  }
  if (all) return;
  const Polygon from = *this;
  const std::size_t corners = std::size_t(count_);
  count_ = 0;
  for (std::size_t i = 0; i < corners; ++i) {
    const std::size_t next = i + 1 < corners ? i + 1 : 0;
    const Corner &a = from.corners_[i], &b = from.corners_[next];
    if (height[i] > 0) corners_[std::size_t(count_++)] = a;
    if ((height[i] > 0) != (height[next] > 0)) {
      const double t = height[i] / (height[i] - height[next]);
      corners_[std::size_t(count_++)] = {a.u + t * (b.u - a.u), a.v + t * (b.v - a.v)};
    }
  }
}

void Polygon::clip(const ConvexSet& set) {
  for (const HalfPlane& side : set.all()) {
    clip(side);
    if (empty()) return;
  }
}

double Polygon::area() const {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < std::size_t(count_); ++i) {
    const Corner &o = corners_[0], &a = corners_[i], &b = corners_[i + 1];
    twice += (a.u - o.u) * (b.v - o.v) - (b.u - o.u) * (a.v - o.v);
  }
  return twice / 2;
}

Corner Polygon::centroid() const {
  const Corner& o = corners_[0];
  double twice = 0, u = 0, v = 0;
  for (std::size_t i = 1; i + 1 < std::size_t(count_); ++i) {
    const Corner a{corners_[i].u - o.u, corners_[i].v - o.v};
    const Corner b{corners_[i + 1].u - o.u, corners_[i + 1].v - o.v};
    const double part = a.u * b.v - b.u * a.v;
    twice += part, u += part * (a.u + b.u), v += part * (a.v + b.v);
  }
  return twice > 0 ? Corner{o.u + u / (3 * twice), o.v + v / (3 * twice)} : o;
}

void add_polygon(Moments& moments, const Polygon& polygon, double sign) {
  // The mean of P_i(u) P_j(v) is 1/4 of the integral of Q_i(u) P_j(v) dv around the polygon, where
  // Q_i' = P_i, Q_i = (P_(i+1) - P_(i-1)) / (2 i + 1); of degree 2 points - 1 along a side.
  const std::size_t points = std::size_t(moments.points);
  const GaussRule& rule = short_rule(moments.points);
  const auto corners = polygon.corners();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Corner &a = corners[k], &b = corners[k + 1 < corners.size() ? k + 1 : 0];
    const double rise = sign * (b.v - a.v) / 4;
    if (rise == 0) continue;
    for (std::size_t g = 0; g < points; ++g) {
      const double t = 0.5 * rule.nodes[g] + 0.5;
      const auto along = legendre_integrals(legendre(a.u + t * (b.u - a.u)));
      const auto up = legendre(a.v + t * (b.v - a.v));
      const double weight = rise * rule.weights[g];
      for (std::size_t i = 0; i < points; ++i)
        for (std::size_t j = 0; j < points; ++j) moments.of[i][j] += weight * along[i] * up[j];
    }
  }
}

void add_visible(Moments& moments, const Polygon& polygon, std::span<const ConvexSet> hidden,
                 double sign) {
  add_polygon(moments, polygon, sign);
  // Away with what each set hides and none before it does.
  for (std::size_t i = 0; i < hidden.size(); ++i) {
    Polygon part = polygon;
    part.clip(hidden[i]);
    if (!part.empty()) add_visible(moments, part, hidden.first(i), -sign);
  }
}

std::array<double, kMostPoints * kMostPoints> node_weights(const Moments& moments) {
  static const std::array to_all{to_legendre(1), to_legendre(2), to_legendre(3), to_legendre(4)};
  const std::size_t points = std::size_t(moments.points);
  const ToLegendre& to = to_all[points - 1];
  std::array<double, kMostPoints * kMostPoints> weights{};
  for (std::size_t i = 0; i < points; ++i) {
    for (std::size_t b = 0; b < points; ++b) {
      double along_v = 0;
      for (std::size_t j = 0; j < points; ++j) along_v += moments.of[i][j] * to[j][b];
      for (std::size_t a = 0; a < points; ++a) weights[a * points + b] += to[i][a] * along_v;
    }
  }
  return weights;
}

}  // namespace litmus
