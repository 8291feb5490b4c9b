// camera.h: where a sample of the picture looks.
#pragma once

#include "tracer/plan.h"

namespace litmus {

/// The position of sample i of `count` along a side, from -1 to 1; antisymmetric in i without
/// rounding. `shift` moves it by that many half samples.
template <Real R>
R screen(int i, int count, R shift = 0) {
  return (R(2 * i + 1 - count) + shift) / R(count);
}

/// A ray through the point (x, y) of the picture, both from -1 (left, bottom) to 1.
template <Real R>
Ray<R> camera_ray(const View<R>& view, R x, R y) {
  const Vec<R> across = x * view.right + y * view.up;
  if (view.orthographic) return {view.eye + across, view.forward};
  return {view.eye, view.forward + across};
}

}  // namespace litmus
