// camera.h: where a sample of the picture looks.
#pragma once

#include "tracer/plan.h"

namespace litmus {

/// The position of sample i (a whole number) of `count` along a side, from -1 to 1; antisymmetric
/// in i without rounding. `shift` moves it by that many half samples.
template <Value V>
V screen(const V& i, int count, Scalar<V> shift = 0) {
  using R = Scalar<V>;
  return (R(2) * i + R(1 - count) + shift) / R(count);
}

/// A ray through the point (x, y) of the picture, both from -1 (left, bottom) to 1.
template <Real R, Value V>
Ray<V> camera_ray(const View<R>& view, const V& x, const V& y) {
  const Vec<V> across = x * Vec<V>(view.right) + y * Vec<V>(view.up);
  if (view.orthographic) return {Vec<V>(view.eye) + across, Vec<V>(view.forward)};
  return {Vec<V>(view.eye), Vec<V>(view.forward) + across};
}

}  // namespace litmus
