// naive.h: the formulas and rays as they are usually written. They are the controls of the
// experiments and must fail there; nothing else uses them.
#pragma once

#include <cmath>

#include "tracer/intersect.h"

namespace litmus::naive {

template <Real R>
Vec<R> normalize(const Vec<R>& v) {
  return v / std::sqrt(dot(v, v));
}

/// The arccosine of the normalised dot product.
template <Real R>
R angle_between(const Vec<R>& a, const Vec<R>& b) {
  return std::acos(dot(naive::normalize(a), naive::normalize(b)));
}

/// Slide 16 word for word.
template <Real R>
R spot_decay(R alpha, R cutoff, R exponent) {
  return alpha > cutoff ? R(0) : 1 - std::pow(alpha / cutoff, exponent);
}

/// Slide 11 word for word.
template <Real R>
R linear_attenuation(R range, R distance, R linear) {
  return range / (range + linear * distance);
}
template <Real R>
R quadratic_attenuation(R range, R distance, R quadratic) {
  return range * range / (range * range + quadratic * distance * distance);
}

/// Slide 5 word for word: the power of a rounded cosine.
template <Real R>
R specular_power(const Vec<R>& h, const Vec<R>& n, R shininess) {
  return std::pow(dot(h, n), shininess);
}

/// Slide 20 word for word: right = up x n, up = n x right, neither normalised.
template <Real R>
void area_axes(const Vec<R>& n, Vec<R>& right, Vec<R>& up) {
  right = naive::normalize(cross(Vec<R>{0, 0, 1}, n));
  up = cross(n, right);
}

/// Moeller and Trumbore 1997: t of the hit, negative if it misses.
template <Real R>
R moeller_trumbore(const std::array<Vec<R>, 3>& triangle, const Ray<R>& ray) {
  const auto plain_cross = [](const Vec<R>& a, const Vec<R>& b) {
    return Vec<R>{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  };
  const Vec<R> e1 = triangle[1] - triangle[0], e2 = triangle[2] - triangle[0];
  const Vec<R> p = plain_cross(ray.direction, e2);
  const R determinant = dot(e1, p);
  if (determinant == 0) return R(-1);
  const Vec<R> from = ray.origin - triangle[0];
  const R u = dot(from, p) / determinant;
  if (u < 0 || u > 1) return R(-1);
  const Vec<R> q = plain_cross(from, e1);
  const R v = dot(ray.direction, q) / determinant;
  if (v < 0 || u + v > 1) return R(-1);
  return dot(e2, q) / determinant;
}

}  // namespace litmus::naive
