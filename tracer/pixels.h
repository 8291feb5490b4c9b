// pixels.h: the loop over the pixels of a row, their samples and the lights, for every value.
#pragma once

#include <glm/vec3.hpp>

#include "tracer/camera.h"
#include "tracer/light_terms.h"
#include "tracer/render.h"

namespace litmus {

/// What one sample of each lane's pixel sees: a colour, a signature and flags per layer.
template <Value V>
struct Seen {
  std::vector<Vec<Sum<V>>> colors;
  std::vector<PerLane<std::uint64_t, V>> signatures;
  std::vector<PerLane<std::uint8_t, V>> flags;

  explicit Seen(std::size_t layers) : colors(layers), signatures(layers), flags(layers) {}
};

template <Value V>
Vec<Sum<V>> widen(const Vec<V>& v) {
  return {widen(v.x), widen(v.y), widen(v.z)};
}

template <Real R>
glm::dvec3 to_double(const Vec<R>& v) {
  return {double(v.x), double(v.y), double(v.z)};
}

/// Looks through the point (x, y) of the picture, both from -1 (left, bottom) to 1.
template <Real R, Value V>
void look(const Plan<R>& plan, const V& x, const V& y, Seen<V>& seen) {
  const Ray<V> ray = camera_ray(plan.view, x, y);
  const Hit<V> hit = closest_hit<R, V>(plan, ray);
  for (std::size_t k = 0; k < seen.colors.size(); ++k) {
    seen.colors[k] = {}, seen.flags[k] = {};
    for (int i = 0; i < kLanes<V>; ++i) {
      at_lane(seen.signatures[k], i) = std::uint64_t(lane(hit.object, i) + 1);
    }
  }
  if (none_of(hit.object >= Index<V>(0))) return;
  const Vec<V> eye = -normalize(ray.direction);
  const Finish<V> finish = finish_of(plan, hit);
  if (!plan.sample_code) {
    seen.colors[0] = widen(finish.ambient) * Vec<Sum<V>>(widen(plan.ambient));
  }
  for (std::size_t k = 0; k < plan.sources.size(); ++k) {
    const LightTerms<V> terms = light_terms(plan, plan.sources[k], hit, finish, eye);
    seen.colors[k + 1] = light_color(plan, plan.sources[k], finish, terms);
    for (int i = 0; i < kLanes<V>; ++i) {
      if (lane(hit.object, i) < 0) continue;
      std::uint64_t& signature = at_lane(seen.signatures[k + 1], i);
      signature = mix(signature, at_lane(terms.signature, i));
    }
    seen.flags[k + 1] = terms.flags;
  }
}

/// Writes a colour's lanes to the pixels from x on, as many as are left in the row.
template <Value S>
void store(const Vec<S>& color, Picture& picture, int x, int y) {
  for (int i = 0; i < kLanes<S> && x + i < picture.width; ++i) {
    picture.at(x + i, y) = {double(lane(color.x, i)), double(lane(color.y, i)),
                            double(lane(color.z, i))};
  }
}

/// The pixels x, x + 1, ... of a row, one for each lane of V.
template <Value V, Real R>
void render_pixels(const Plan<R>& plan, const RenderOptions& options, int x, int y, Seen<V>& seen,
                   std::vector<Vec<Sum<V>>>& totals, Rendering& result) {
  const View<R>& view = plan.view;
  const int n = view.samples;
  const R shift_x = R(2 * options.shift_x * n), shift_y = R(2 * options.shift_y * n);
  V column;
  for (int i = 0; i < kLanes<V>; ++i) set_lane(column, i, R((x + i) * n));
  std::fill(totals.begin(), totals.end(), Vec<Sum<V>>{});
  Vec<Sum<V>> whole;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      look(plan, screen<V>(column + R(i), view.width * n, shift_x),
           V(-screen<R>(R(y * n + j), view.height * n, shift_y)), seen);
      for (std::size_t k = 0; k < totals.size(); ++k) {
        totals[k] = totals[k] + seen.colors[k];
        whole = whole + seen.colors[k];
        for (int at = 0; at < kLanes<V> && x + at < view.width; ++at) {
          const std::size_t pixel = std::size_t(y) * std::size_t(view.width) + std::size_t(x + at);
          std::uint64_t& signature = result.signatures[k].values[pixel];
          signature = mix(signature, at_lane(seen.signatures[k], at));
          result.flags[k][pixel] |= at_lane(seen.flags[k], at);
        }
      }
    }
  }
  const Sum<V> count = Sum<R>(n * n);
  for (std::size_t k = 0; k < totals.size(); ++k) {
    store(totals[k] / count, result.layers[k].picture, x, y);
  }
  store(whole / count, result.whole, x, y);
}

/// One row of the picture, in each of its layers.
template <Value V, Real R>
void render_row(const Plan<R>& plan, const RenderOptions& options, int y, Rendering& result) {
  const std::size_t layers = result.layers.size();
  Seen<V> seen(layers);
  std::vector<Vec<Sum<V>>> totals(layers);
  for (int x = 0; x < plan.view.width; x += kLanes<V>) {
    render_pixels<V>(plan, options, x, y, seen, totals, result);
  }
}

}  // namespace litmus
