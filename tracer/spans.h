// spans.h: where in a row of the picture a solid may be seen.
//
// The rays through a row lie in a plane, and those that meet a ball form an interval of it: found
// once for a row, it spares every ray of the row the question. The margins are wider than any
// rounding, of the rays and of the surfaces' own tests, so no bit of a picture changes.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "tracer/plan.h"

namespace litmus {

/// Positions across the picture, from -1 (left) to 1; none if high < low.
template <Real R>
struct Span {
  R low = -std::numeric_limits<R>::infinity(), high = std::numeric_limits<R>::infinity();
};

template <Real R>
Vec<double> in_double(const Vec<R>& v) {
  return {double(v.x), double(v.y), double(v.z)};
}

/// Where the rays through the row at `up` (from -1, bottom, to 1) may meet a ball. All of the row
/// for an orthographic view, from inside of the ball, and where part of the ball is behind the eye.
template <Real R>
Span<R> span_of(const View<R>& view, R up, const Ball<R>& ball) {
  if (view.orthographic) return {};
  using D = Vec<double>;
  const double rounding = 64 * kUnit<double>;
  const double own = 1024 * std::max(double(kUnit<R>), kUnit<double>);  // of the rays
  const D f = in_double(view.eye) - in_double(ball.center), step = in_double(view.right);
  const D middle = in_double(view.forward) + double(up) * in_double(view.up);
  // Outside of the ball by g = |f|^2 - r^2, a ray along d meets it where (f.d)^2 >= g |d|^2: with
  // d = middle + x step, where a x^2 + 2 b x + c >= 0.
  const double squared = dot(f, f), radius = double(ball.radius);
  const double g = squared - (radius * radius + own * squared + double(kTiny<R>));
  if (!(g > 1e-100 && squared < 1e100)) return {};  // squares of these neither over- nor underflow
  const double fs = dot(f, step), fm = dot(f, middle);
  const double ss = dot(step, step), ms = dot(middle, step), mm = dot(middle, middle);
  const double a = fs * fs - g * ss, b = fm * fs - g * ms, c = fm * fm - g * mm;
  // The sums without cancellation bound the rounding errors.
  const double most_a = fs * fs + g * ss, most_b = std::fabs(fm * fs) + g * std::fabs(ms);
  const double most_c = fm * fm + g * mm;
  if (!(a < -1e-6 * most_a)) return {};
  const double discriminant = b * b - a * c + rounding * (most_b * most_b + most_a * most_c);
  if (discriminant < 0) return {R(1), R(-1)};
  const double center = b / -a, half = std::sqrt(discriminant) / -a;
  const double margin = rounding * (1 + (most_b + std::fabs(b) * most_a / -a) / -a) +
                        own * (1 + std::fabs(center) + half);
  const Span<R> span{R(center - half - margin), R(center + half + margin)};
  return span.low <= span.high ? span : Span<R>{};
}

/// The spans of a row, for each entry of the plan's lists.
template <Real R>
struct RowSpans {
  std::vector<Span<R>> spheres, boxes;
};

/// Finds the spans of the row at `up`.
template <Real R>
void find_spans(const Plan<R>& plan, R up, RowSpans<R>& spans) {
  const auto find = [&](const auto& parts, std::vector<Span<R>>& found) {
    found.clear();
    for (const auto& part : parts) found.push_back(span_of(plan.view, up, ball_around(part.shape)));
  };
  find(plan.spheres, spans.spheres);
  find(plan.boxes, spans.boxes);
}

}  // namespace litmus
