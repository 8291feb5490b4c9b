// peer_meshes.cpp: rays of one mesh, in double by litmus and in float by Embree.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "reports/mesh_rays.h"
#include "reports/peer_entrants.h"
#include "reports/plain_text.h"
#include "reports/stage.h"
#include "tracer/cpu_clock.h"
#include "tracer/kernel.h"
#ifdef LITMUS_EMBREE
#include "reports/embree_rays.h"
#endif

namespace litmus {
namespace {

constexpr std::string_view kOurDouble = "litmus, double";

/// A mesh ready for both, with the rays of its picture.
struct Stage {
  explicit Stage(int about, int size) {
    const Scene scene = mesh_stage(size, about);
    const Mesh& mesh = std::get<Mesh>(scene.objects[0].shape);
    triangles = mesh.triangles.size();
    plan = lower<double>(scene);
    plan.edges = false;
    sources = plan.sources;
    primary = primary_rays(plan), shadow = shadow_rays(plan);
    picture.whole = Picture(size, size);
#ifdef LITMUS_EMBREE
    embree = std::make_unique<EmbreeMesh>(mesh);
#endif
  }

  /// Renders the mesh unlit, lit, or lit with shadows; by the widest packets.
  double rows(bool lit, bool shadows) {
    plan.sources = lit ? sources : std::vector<Source<double>>{};
    plan.shadows = shadows;
    RenderOptions options;
    options.layers = options.edges = false;
    const double start = cpu_seconds();
    for (int y = 0; y < plan.view.height; ++y)
      packet_kernels()[0].double_row(plan, options, y, picture, nullptr);
    return cpu_seconds() - start;
  }

  double primary_seconds() {
    return least_of([this] { return rows(false, false); });
  }

  /// What shadows add to a picture; with and without in turns, as it is a small part of it.
  double shadow_seconds() {
    constexpr int kPairs = 7;
    double without = rows(true, false), with = rows(true, true);
    for (int i = 1; i < kPairs; ++i) {
      without = std::min(without, rows(true, false));
      with = std::min(with, rows(true, true));
    }
    if (with <= without) throw std::runtime_error("the machine is too busy: shadows took no time");
    return with - without;
  }

  std::size_t triangles = 0;
  Plan<double> plan;
  std::vector<Source<double>> sources;
  RaySet primary, shadow;
  Rendering picture;
#ifdef LITMUS_EMBREE
  std::unique_ptr<EmbreeMesh> embree;
#endif
};

using SharedStage = std::shared_ptr<Stage>;

std::string no_packets() {
  return packet_kernels().empty() ? "this processor has no AVX2, which packets need" : "";
}

#ifdef LITMUS_EMBREE
/// Times Embree on the rays, and holds what it finds against litmus' own count.
double embree_seconds(const EmbreeMesh& mesh, const RaySet& set, bool shadow) {
  constexpr double kAgree = 0.01;  // of the rays: a float's rounding flips some at silhouettes
  const auto once = [&] {
    const double start = cpu_seconds();
    const int met = shadow ? mesh.occluded(set.rays) : mesh.hits(set.rays);
    const double seconds = cpu_seconds() - start;
    if (std::abs(met - set.met) > kAgree * double(set.rays.size()))
      throw std::runtime_error(fmt::format("{} of {} rays meet the mesh, but {} by litmus", met,
                                           set.rays.size(), set.met));
    return seconds;
  };
  return least_of(once);
}
#endif

Entrant embree_entrant([[maybe_unused]] const SharedStage& stage, [[maybe_unused]] bool shadow) {
  const std::string name = "Embree, float, not robust, ray by ray";
#ifdef LITMUS_EMBREE
  return {name, [=] {
            return embree_seconds(*stage->embree, shadow ? stage->shadow : stage->primary, shadow);
          }};
#else
  return {name, {}, "this build is without it (apt-get install libembree-dev, then build again)"};
#endif
}

std::string memory_note(const Stage& stage) {
  std::string text = fmt::format("Memory: litmus {:.0f} bytes a triangle",
                                 mesh_bytes(stage.plan) / double(stage.triangles));
#ifdef LITMUS_EMBREE
  text += fmt::format(", Embree {:.0f}", stage.embree->bytes() / double(stage.triangles));
#endif
  return text + ".";
}

}  // namespace

std::vector<PeerTask> mesh_tasks(int triangles, int size, const PeerOptions& options) {
  const auto stage = std::make_shared<Stage>(triangles, size);
  const std::string mesh = with_commas((long long)(stage->triangles));
  PeerTask primary{fmt::format("primary-{}", stage->triangles),
                   fmt::format("{} triangles, primary rays, {} x {}", mesh, size, size), "ray",
                   double(stage->primary.rays.size())};
  PeerTask shadow{fmt::format("shadow-{}", stage->triangles),
                  fmt::format("{} triangles, shadow rays to one lamp", mesh), "ray",
                  double(stage->shadow.rays.size())};
  primary.notes = {"litmus: the whole picture, unlit. Embree: its rays alone, made before.",
                   memory_note(*stage)};
  shadow.notes = {"litmus: a picture with shadows less one without. Embree: its rays alone."};
  const auto ours = [&](const auto& measure) {
    return Entrant{std::string(kOurDouble), measure, no_packets()};
  };
  return {take_turns(primary,
                     {ours([=] { return stage->primary_seconds(); }), embree_entrant(stage, false)},
                     options),
          take_turns(shadow,
                     {ours([=] { return stage->shadow_seconds(); }), embree_entrant(stage, true)},
                     options)};
}

std::vector<PeerTask> growth_tasks(const std::vector<int>& triangles, int size,
                                   const PeerOptions& options) {
  std::vector<Entrant> ours, embree;
  double least = 0;
  for (const int about : triangles) {
    const auto stage = std::make_shared<Stage>(about, size);
    const double count = double(stage->triangles);
    if (least == 0) least = count;
    const std::string name =
        fmt::format("{} triangles (their logarithm: {:.2f} times)",
                    with_commas((long long)(stage->triangles)), std::log(count) / std::log(least));
    ours.push_back({name, [=] { return stage->primary_seconds(); }, no_packets(), count});
    embree.push_back(embree_entrant(stage, false));
    embree.back().name = name, embree.back().triangles = count;
  }
  const auto task = [&](const std::string& name, const std::string& who) {
    return PeerTask{name, fmt::format("{}, primary rays, {} x {}, by triangles", who, size, size),
                    "ray", double(size) * size};
  };
  return {take_turns(task("growth-litmus", std::string(kOurDouble)), ours, options),
          take_turns(task("growth-embree", "Embree, float"), embree, options)};
}

}  // namespace litmus
