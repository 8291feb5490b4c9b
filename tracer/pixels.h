// pixels.h: the loop over the pixels of a row, their samples and the lights, for every value.
#pragma once

#include <glm/vec3.hpp>

#include "tracer/camera.h"
#include "tracer/light_terms.h"
#include "tracer/render.h"

namespace litmus {

template <Value V>
Vec<Sum<V>> widen(const Vec<V>& v) {
  return {widen(v.x), widen(v.y), widen(v.z)};
}

template <Real R>
glm::dvec3 to_double(const Vec<R>& v) {
  return {double(v.x), double(v.y), double(v.z)};
}

/// What one layer shows at a sample.
template <Value V>
struct Seen {
  Vec<Sum<V>> color;
  PerLane<std::uint64_t, V> signature{};
  PerLane<std::uint8_t, V> flags{};
};

/// Looks through the point (x, y) of the picture, both from -1 (left, bottom) to 1, and calls
/// visit(layer, seen) for each layer that shows anything, and for all if edges are asked for. Lanes
/// that are not `inside` see nothing.
template <Real R, Value V, class Visit>
void look(const Plan<R>& plan, const V& x, const V& y, const Mask<V>& inside, Counts* counts,
          Visit visit) {
  const Ray<V> ray = camera_ray(plan.view, x, y);
  Hit<V> hit = closest_hit<R, V>(plan, ray);
  hit.object = select(inside, hit.object, Index<V>(-1));
  Seen<V> object;
  for (int i = 0; i < kLanes<V> && plan.edges; ++i) {
    at_lane(object.signature, i) = std::uint64_t(lane(hit.object, i) + 1);
  }
  if (none_of(hit.object >= Index<V>(0))) {
    for (std::size_t k = 0; k <= plan.sources.size() && plan.edges; ++k) visit(k, object);
    return;
  }
  const Vec<V> eye = -normalize<Divide::Once>(ray.direction);
  const Finish<V> finish = finish_of(plan, hit);
  Seen<V> seen = object;
  if (!plan.sample_code) seen.color = widen(finish.ambient) * Vec<Sum<V>>(widen(plan.ambient));
  visit(std::size_t(0), seen);
  for (std::size_t k = 0; k < plan.sources.size(); ++k) {
    const LightTerms<V> terms = light_terms(plan, plan.sources[k], hit, finish, eye, counts);
    seen.color = light_color(plan, plan.sources[k], finish, terms);
    seen.flags = terms.flags;
    for (int i = 0; i < kLanes<V> && plan.edges; ++i) {
      const std::uint64_t& number = at_lane(object.signature, i);
      at_lane(seen.signature, i) =
          lane(hit.object, i) >= 0 ? mix(number, at_lane(terms.signature, i)) : number;
    }
    visit(k + 1, seen);
  }
}

/// Writes a colour's lanes to the pixels from x on, as many as are left in the row.
template <Value S>
void store(const Vec<S>& color, Picture& picture, int x, int y) {
  using R = Scalar<S>;
  R red[kLanes<S>], green[kLanes<S>], blue[kLanes<S>];
  copy_lanes(color.x, red), copy_lanes(color.y, green), copy_lanes(color.z, blue);
  glm::dvec3* const pixels = &picture.at(x, y);
  for (int i = 0; i < kLanes<S> && x + i < picture.width; ++i) {
    pixels[i] = {double(red[i]), double(green[i]), double(blue[i])};
  }
}

/// What a pixel of each lane adds up to over its samples.
template <Value V>
struct PixelSums {
  std::vector<Vec<Sum<V>>> layers;  ///< empty unless layers are asked for
  Vec<Sum<V>> whole;
  V lane_numbers;  ///< 0, 1, ...
};

/// Mixes a sample's signature and flags into those of the pixels from x on.
template <Value V>
void add_edges(const Seen<V>& seen, int x, int y, Signature& signature,
               std::vector<std::uint8_t>& flags) {
  const std::size_t first = std::size_t(y) * std::size_t(signature.width) + std::size_t(x);
  for (int i = 0; i < kLanes<V> && x + i < signature.width; ++i) {
    std::uint64_t& value = signature.values[first + std::size_t(i)];
    value = mix(value, at_lane(seen.signature, i));
    flags[first + std::size_t(i)] |= at_lane(seen.flags, i);
  }
}

/// The pixels x, x + 1, ... of a row, one for each lane of V.
template <Value V, Real R>
void render_pixels(const Plan<R>& plan, const RenderOptions& options, int x, int y,
                   PixelSums<V>& sums, Rendering& result, Counts* counts) {
  const View<R>& view = plan.view;
  const int n = view.samples;
  const R shift_x = R(2 * options.shift_x * n), shift_y = R(2 * options.shift_y * n);
  const V column = R(n) * (R(x) + sums.lane_numbers);
  const Mask<V> inside = R(x) + sums.lane_numbers < R(view.width);
  std::fill(sums.layers.begin(), sums.layers.end(), Vec<Sum<V>>{});
  sums.whole = {};
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const V across = screen<V>(column + R(i), view.width * n, shift_x);
      const V up = -screen<R>(R(y * n + j), view.height * n, shift_y);
      look(plan, across, up, inside, counts, [&](std::size_t k, const Seen<V>& seen) {
        sums.whole = sums.whole + seen.color;
        if (!sums.layers.empty()) sums.layers[k] = sums.layers[k] + seen.color;
        if (plan.edges) add_edges(seen, x, y, result.signatures[k], result.flags[k]);
      });
    }
  }
  const auto mean = [&](const Vec<Sum<V>>& sum) {
    return n == 1 ? sum : sum / Sum<V>(Sum<R>(n * n));
  };
  for (std::size_t k = 0; k < sums.layers.size(); ++k) {
    store(mean(sums.layers[k]), result.layers[k].picture, x, y);
  }
  store(mean(sums.whole), result.whole, x, y);
}

/// One row of the picture, in each of its layers.
template <Value V, Real R>
void render_row(const Plan<R>& plan, const RenderOptions& options, int y, Rendering& result,
                Counts* counts) {
  PixelSums<V> sums;
  for (int i = 0; i < kLanes<V>; ++i) set_lane(sums.lane_numbers, i, R(i));
  if (options.layers) sums.layers.resize(result.layers.size());
  for (int x = 0; x < plan.view.width; x += kLanes<V>) {
    render_pixels(plan, options, x, y, sums, result, counts);
  }
  if (counts) {
    counts->camera_rays +=
        std::uint64_t(plan.view.width) * std::uint64_t(plan.view.samples * plan.view.samples);
  }
}

}  // namespace litmus
