// pixels.h: the loop over the pixels of a row, their samples and the lights, for every value.
#pragma once

#include <glm/vec3.hpp>

#include "tracer/camera.h"
#include "tracer/closest.h"
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

/// What a sample of the picture sees.
template <Value V>
struct Shot {
  Hit<V> hit;
  Vec<V> eye;  ///< unit, towards the eye; unset where nothing shines
};

/// Calls visit(layer, seen) for each layer that shows anything in a shot, and for all if edges are
/// asked for. `suspects` are those of each light, or null: everything.
template <Real R, Value V, class T, class Visit>
void show(const Plan<R>& plan, const Shot<V>& shot, const Suspects* suspects, const T& task,
          const Visit& visit) {
  const Hit<V>& hit = shot.hit;
  Seen<V> seen;
  PerLane<std::uint64_t, V> numbers{};
  for (int i = 0; i < kLanes<V> && task.edges; ++i)
    at_lane(numbers, i) = std::uint64_t(surface_at(hit, i).object + 1);
  if (task.edges) seen.signature = numbers;
  if (none_of(seen_by(hit))) {
    for (std::size_t k = 0; k <= plan.sources.size() && task.edges; ++k) visit(k, seen);
    return;
  }
  const Finish<V> finish = finish_of(plan, hit);
  if (!task.sample_code) seen.color = widen(finish.ambient) * Vec<Sum<V>>(widen(plan.ambient));
  visit(std::size_t(0), seen);
  for (std::size_t k = 0; k < plan.sources.size(); ++k) {
    const LightTerms<V> terms = light_terms(plan, plan.sources[k], hit, finish, shot.eye,
                                            suspects ? suspects[k] : kEverything, task);
    seen.color = light_color(plan, plan.sources[k], finish, terms, task);
    if (task.edges) {
      seen.flags = terms.flags;
      for (int i = 0; i < kLanes<V>; ++i) {
        const std::uint64_t number = at_lane(numbers, i);
        at_lane(seen.signature, i) =
            surface_at(hit, i).object >= 0 ? mix(number, at_lane(terms.signature, i)) : number;
      }
    }
    visit(k + 1, seen);
  }
}

/// Looks through the point (x, y) of the picture, both from -1 (left, bottom) to 1, and shows what
/// is seen there.
template <Real R, class Visit>
void look(const Plan<R>& plan, const R& x, const R& y, const Visit& visit) {
  const Ray<R> ray = camera_ray(plan.view, x, y);
  Shot<R> shot;
  find_closest(plan, ray, shot.hit);
  shot.eye = -normalize<Divide::Once>(ray.direction);
  show(plan, shot, nullptr, task_of(plan), visit);
}

/// Writes a colour's lanes to the pixels from x on, as many as are left in the row.
template <Value S>
void store(const Vec<S>& color, Picture& picture, int x, int y) {
  using R = Scalar<S>;
  glm::dvec3* const pixels = &picture.at(x, y);
  if constexpr (std::is_same_v<R, double>) {
    if (x + kLanes<S> <= picture.width) {
      copy_interleaved(color.x, color.y, color.z, &pixels->x);
      return;
    }
  }
  R lanes[3 * kLanes<S>];
  copy_interleaved(color.x, color.y, color.z, lanes);
  for (int i = 0; i < kLanes<S> && x + i < picture.width; ++i) {
    pixels[i] = {double(lanes[3 * i]), double(lanes[3 * i + 1]), double(lanes[3 * i + 2])};
  }
}

/// Values side by side in a row, whose lights share one look at what may be in their way.
template <Value V>
inline constexpr int kStretch = kLanes<V> == 1   ? 32
                                : kLanes<V> <= 8 ? 8
                                                 : 4;

/// What the loop over a row needs.
template <Value V>
struct Row {
  using R = Scalar<V>;
  V lane_numbers;                  ///< 0, 1, ...
  std::vector<RowSpans<R>> spans;  ///< of each row of samples
  std::vector<Suspects> suspects;  ///< of each light, for a stretch
  Shot<V> shots[kStretch<V>];
  Vec<Sum<V>> whole[kStretch<V>];   ///< what a pixel of each lane adds up to over its samples
  std::vector<Vec<Sum<V>>> layers;  ///< the same, layer by layer; empty unless layers are asked for
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

/// What the lights of a stretch may be hidden by; null where that is not asked.
template <Value V, Real R, class T>
const Suspects* suspects_of(const Plan<R>& plan, const T& task, int count, Row<V>& row) {
  if (!plan.shadows || task.everything) return nullptr;
  RegionOf<V> points;
  for (int k = 0; k < count; ++k) points.add(row.shots[k].hit);
  const HitRegion region = points.region();
  for (std::size_t i = 0; i < plan.sources.size() && !region.empty; ++i)
    find_suspects(plan, plan.sources[i], region, row.suspects[i]);
  return row.suspects.data();
}

/// A stretch of `count` values from x on; each lane is a pixel.
template <Value V, Real R, class T>
void render_stretch(const Plan<R>& plan, const RenderOptions& options, const T& task, int x, int y,
                    int count, Row<V>& row, Rendering& result) {
  const View<R>& view = plan.view;
  const int n = view.samples;
  const std::size_t layers = row.layers.size() / kStretch<V>;
  const R shift_x = R(2 * options.shift_x * n), shift_y = R(2 * options.shift_y * n);
  std::fill(row.layers.begin(), row.layers.end(), Vec<Sum<V>>{});
  std::fill(row.whole, row.whole + count, Vec<Sum<V>>{});
  for (int j = 0; j < n; ++j) {
    const R up = -screen<R>(R(y * n + j), view.height * n, shift_y);
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k < count; ++k) {
        const V column = R(x + k * kLanes<V>) + row.lane_numbers;
        const V across = screen<V>(R(n) * column + R(i), view.width * n, shift_x);
        const Ray<V> ray = camera_ray(view, across, V(up));
        Shot<V>& shot = row.shots[k];
        if (task.everything) {
          find_closest(plan, ray, shot.hit);
        } else {
          find_closest(plan, ray, row.spans[std::size_t(j)], across, shot.hit);
        }
        if (const Mask<V> inside = column < R(view.width); !all_of(inside)) {
          mix_lanes(shot.hit);
          shot.hit.object = select(inside, shot.hit.object, Index<V>(-1));
        }
        if (plan.specular) shot.eye = -normalize<Divide::Once>(ray.direction);
      }
      const Suspects* const suspects = suspects_of(plan, task, count, row);
      for (int k = 0; k < count; ++k) {
        show(plan, row.shots[k], suspects, task, [&](std::size_t layer, const Seen<V>& seen) {
          row.whole[k] = row.whole[k] + seen.color;
          if (layers > 0) {
            Vec<Sum<V>>& sum = row.layers[std::size_t(k) * layers + layer];
            sum = sum + seen.color;
          }
          if (task.edges) {
            add_edges(seen, x + k * kLanes<V>, y, result.signatures[layer], result.flags[layer]);
          }
        });
      }
    }
  }
  const auto mean = [&](const Vec<Sum<V>>& sum) {
    return n == 1 ? sum : sum / Sum<V>(Sum<R>(n * n));
  };
  for (int k = 0; k < count; ++k) {
    for (std::size_t layer = 0; layer < layers; ++layer) {
      store(mean(row.layers[std::size_t(k) * layers + layer]), result.layers[layer].picture,
            x + k * kLanes<V>, y);
    }
    store(mean(row.whole[k]), result.whole, x + k * kLanes<V>, y);
  }
}

/// Whether pictures of V have code of their own for the common case: long double and Quad tell what
/// is true, however long that takes.
template <Value V>
inline constexpr bool kHasBareTask = !std::is_same_v<V, long double> && !std::is_same_v<V, Quad>;

/// One row of the picture, in each of its layers.
template <Value V, Real R>
void render_row(const Plan<R>& plan, const RenderOptions& options, int y, Rendering& result,
                Counts* counts) {
  const View<R>& view = plan.view;
  const Task task = task_of(plan, counts);
  const bool bare = !task.edges && !task.everything && !task.sample_code && !counts;
  Row<V> row;
  for (int i = 0; i < kLanes<V>; ++i) set_lane(row.lane_numbers, i, R(i));
  if (options.layers) row.layers.resize(result.layers.size() * kStretch<V>);
  row.suspects.resize(plan.sources.size());
  row.spans.resize(std::size_t(view.samples));
  for (int j = 0; j < view.samples && !plan.everything; ++j) {
    const R shift = R(2 * options.shift_y * view.samples);
    find_spans(plan, R(-screen<R>(R(y * view.samples + j), view.height * view.samples, shift)),
               row.spans[std::size_t(j)]);
  }
  for (int x = 0; x < view.width; x += kStretch<V> * kLanes<V>) {
    const int left = (view.width - x + kLanes<V> - 1) / kLanes<V>;
    const int count = std::min(left, kStretch<V>);
    if constexpr (kHasBareTask<V>) {
      if (bare) {
        render_stretch(plan, options, BareTask{}, x, y, count, row, result);
        continue;
      }
    }
    render_stretch(plan, options, task, x, y, count, row, result);
  }
  if (counts) {
    counts->camera_rays += std::uint64_t(view.width) * std::uint64_t(view.samples * view.samples);
  }
}

}  // namespace litmus
