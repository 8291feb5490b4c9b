// leaks.cpp: rays that get out of closed meshes, in the tracer's own build and in a contracted one.
#include <fmt/format.h>

#include "stress/leak_rays.h"
#include "stress/leaks_contracted.h"
#include "stress/sweep.h"
#include "stress/ulp.h"
#include "tracer/closest.h"
#include "tracer/visibility.h"

namespace litmus {
namespace {

struct LeakTally {
  std::uint64_t leaks[2] = {};  ///< of litmus, of the control

  void add(const LeakTally& other) {
    for (int i = 0; i < 2; ++i) leaks[i] += other.leaks[i];
  }
};

Scene scene_of(const auto& mesh) {
  const auto point = [](const auto& v) { return Point(double(v.x), double(v.y), double(v.z)); };
  Mesh corners;
  for (const auto& vertex : mesh.vertices) corners.vertices.push_back(point(vertex));
  for (const auto& [a, b, c] : kCorners) corners.triangles.push_back({a, b, c});
  Scene scene;
  scene.materials.emplace_back();
  scene.objects.push_back({"mesh", corners, 0, true});
  return scene;
}

/// The tracer's own way: the tree of boxes, then the triangles.
template <Real R>
LeakTally own_build(std::uint64_t meshes) {
  return sweep(meshes, LeakTally{}, [](std::uint64_t i, LeakTally& tally) {
    Draw draw(200 + sizeof(R), i);
    const ClosedMesh<R> mesh = closed_mesh<R>(draw, i % 2 ? 1e5 : 0);
    const Plan<R> plan = lower<R>(scene_of(mesh));
    for (int ray = 0; ray < kRaysPerMesh; ++ray) {
      const Ray<R> aimed = aimed_ray(draw, mesh);
      tally.leaks[0] += closest_hit(plan, aimed).kind == Kind::None;
      tally.leaks[1] += leaks_moeller_trumbore(mesh, aimed);
    }
  });
}

template <Real R>
LeakTally contracted_build(std::uint64_t meshes) {
  return sweep(meshes, LeakTally{}, [](std::uint64_t i, LeakTally& tally) {
    if constexpr (std::is_same_v<R, float>) {
      litmus_contracted::count_leaks_float(i, i + 1, tally.leaks);
    } else {
      litmus_contracted::count_leaks_double(i, i + 1, tally.leaks);
    }
  });
}

bool processor_fits() {
  const litmus_contracted::Needs& needs = litmus_contracted::kNeeds;
  return (!needs.fma || __builtin_cpu_supports("fma")) &&
         (!needs.avx2 || __builtin_cpu_supports("avx2")) &&
         (!needs.avx512 || __builtin_cpu_supports("avx512f"));
}

template <Real R>
StressRow row_of(const char* build, std::uint64_t meshes, const LeakTally& tally) {
  const std::string scalar(kScalarName<R>);
  return {fmt::format("leaks-{}-{}", build, scalar),
          "meshes",
          fmt::format("rays through the edges and vertices of closed meshes, {} build", build),
          scalar,
          "meshes 10 to 1000 large, at the origin and 1e5 away",
          "leaks",
          meshes * kRaysPerMesh,
          double(tally.leaks[0]),
          0,
          "Moeller-Trumbore",
          double(tally.leaks[1])};
}

template <Real R>
void add_rows(std::vector<StressRow>& rows, std::uint64_t meshes) {
  rows.push_back(row_of<R>("plain", meshes, own_build<R>(meshes)));
  if (processor_fits()) {
    rows.push_back(row_of<R>("contracted", meshes, contracted_build<R>(meshes)));
  } else {
    rows.push_back(row_of<R>("contracted", 0, {}));
    rows.back().judged = false;
    rows.back().domain = "not run: it was built for another processor than this one";
  }
}

}  // namespace

std::vector<StressRow> stress_leaks(const StressOptions& options) {
  const std::uint64_t meshes = options.rays / kRaysPerMesh;
  std::vector<StressRow> rows;
  add_rows<float>(rows, meshes);
  add_rows<double>(rows, meshes);
  return rows;
}

}  // namespace litmus
