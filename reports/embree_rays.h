// embree_rays.h: rays through Embree, for comparison.
#pragma once

#include <embree3/rtcore.h>

#include <atomic>
#include <span>

#include "reports/mesh_rays.h"
#include "scene/scene.h"

namespace litmus {

/// A mesh in Embree: float, not robust, single rays; its fastest for rays that come one by one.
class EmbreeMesh {
 public:
  explicit EmbreeMesh(const Mesh& mesh) {
    rtcSetDeviceMemoryMonitorFunction(device_, count_bytes, &bytes_);
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, mesh.vertices.size()));
    for (const Point& p : mesh.vertices) {
      *vertices++ = float(p.x), *vertices++ = float(p.y), *vertices++ = float(p.z);
    }
    auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.triangles.size()));
    for (const auto& triangle : mesh.triangles) {
      for (const std::int32_t i : triangle) *indices++ = unsigned(i);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  ~EmbreeMesh() { rtcReleaseScene(scene_), rtcReleaseDevice(device_); }
  EmbreeMesh(const EmbreeMesh&) = delete;
  EmbreeMesh& operator=(const EmbreeMesh&) = delete;

  /// How many of the rays hit it, nearest hits.
  int hits(std::span<const FloatRay> rays) const {
    int hits = 0;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (const FloatRay& ray : rays) {
      RTCRayHit one{};
      one.ray = taken(ray);
      one.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(scene_, &context, &one);
      hits += one.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }
    return hits;
  }

  /// How many of the rays hit it at all: for shadows.
  int occluded(std::span<const FloatRay> rays) const {
    int occluded = 0;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (const FloatRay& ray : rays) {
      RTCRay one = taken(ray);
      rtcOccluded1(scene_, &context, &one);
      occluded += one.tfar < 0;
    }
    return occluded;
  }

  /// What it holds: tree, triangles and its copy of the vertices.
  double bytes() const { return double(bytes_); }

 private:
  static bool count_bytes(void* total, ssize_t bytes, bool) {
    *static_cast<std::atomic<ssize_t>*>(total) += bytes;
    return true;
  }

  static RTCRay taken(const FloatRay& ray) {
    RTCRay one{};
    one.org_x = ray.origin[0], one.org_y = ray.origin[1], one.org_z = ray.origin[2];
    one.dir_x = ray.direction[0], one.dir_y = ray.direction[1], one.dir_z = ray.direction[2];
    one.tnear = ray.from, one.tfar = ray.to, one.mask = ~0u;
    return one;
  }

  std::atomic<ssize_t> bytes_ = 0;
  RTCDevice device_ = rtcNewDevice("threads=1");
  RTCScene scene_ = rtcNewScene(device_);
};

}  // namespace litmus
