// mesh_rays_test.cpp: a picture's rays, and that both sides find the same with them.
#include "reports/mesh_rays.h"

#include <gtest/gtest.h>

#include "reports/stage.h"
#include "tracer/render.h"
#ifdef LITMUS_EMBREE
#include "reports/embree_rays.h"
#endif

namespace litmus {
namespace {

constexpr int kMeshSize = 48;

Scene small_mesh() { return mesh_stage(kMeshSize, 2000); }

TEST(PrimaryRays, AreOneAPixel) {
  const RaySet set = primary_rays(lower<double>(small_mesh()));
  EXPECT_EQ(set.rays.size(), std::size_t(kMeshSize) * kMeshSize);
  EXPECT_GT(set.met, kMeshSize * kMeshSize / 10);
  EXPECT_LT(set.met, kMeshSize * kMeshSize) << "some pass the mesh";
}

TEST(ShadowRays, AreThoseThatThePictureTraces) {
  const Scene scene = small_mesh();
  const RaySet set = shadow_rays(lower<double>(scene));
  const Rendering picture = render(scene, {.counts = true});
  EXPECT_EQ(set.rays.size(), picture.counts.shadow_rays);
  EXPECT_GT(set.met, 0) << "the mesh shadows itself";
  EXPECT_LT(std::size_t(set.met), set.rays.size());
}

TEST(MeshBytes, AreAboutTheSameForEachTriangle) {
  const auto bytes = [](int triangles) {
    const Plan<double> plan = lower<double>(mesh_stage(kMeshSize, triangles));
    return mesh_bytes(plan) / double(plan.triangles.size());
  };
  EXPECT_GT(bytes(1000), 9 * sizeof(double)) << "three corners at least";
  EXPECT_NEAR(bytes(4000) / bytes(1000), 1, 0.1);
}

#ifdef LITMUS_EMBREE
TEST(EmbreeMesh, MeetsWhatLitmusMeets) {
  const Scene scene = small_mesh();
  const Plan<double> plan = lower<double>(scene);
  const EmbreeMesh mesh(std::get<Mesh>(scene.objects[0].shape));
  const RaySet primary = primary_rays(plan), shadow = shadow_rays(plan);
  EXPECT_NEAR(mesh.hits(primary.rays), primary.met, 2) << "silhouettes";
  EXPECT_NEAR(mesh.occluded(shadow.rays), shadow.met, 0.01 * double(shadow.rays.size()));
  EXPECT_GT(mesh.bytes(), 2000 * 12.0);
}
#else
TEST(EmbreeMesh, MeetsWhatLitmusMeets) { GTEST_SKIP() << "built without libembree-dev"; }
#endif

}  // namespace
}  // namespace litmus
