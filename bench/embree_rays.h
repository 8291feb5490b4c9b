// embree_rays.h: the primary rays of a picture of one mesh through Embree, for comparison.
#pragma once

#include <embree3/rtcore.h>

#include <memory>
#include <variant>

#include "tracer/camera.h"

namespace litmus {

/// A mesh in Embree (float, not robust: its fastest).
class EmbreeMesh {
 public:
  explicit EmbreeMesh(const Mesh& mesh) {
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

  /// How many of the view's primary rays hit it, one after the other.
  int primary_hits(const View<double>& view) const {
    int hits = 0;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (int y = 0; y < view.height; ++y) {
      for (int x = 0; x < view.width; ++x) {
        const Ray<double> ray =
            camera_ray(view, screen<double>(x, view.width), -screen<double>(y, view.height));
        RTCRayHit one{};
        one.ray.org_x = float(ray.origin.x), one.ray.org_y = float(ray.origin.y);
        one.ray.org_z = float(ray.origin.z), one.ray.dir_x = float(ray.direction.x);
        one.ray.dir_y = float(ray.direction.y), one.ray.dir_z = float(ray.direction.z);
        one.ray.tfar = std::numeric_limits<float>::infinity(), one.ray.mask = ~0u;
        one.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_, &context, &one);
        hits += one.hit.geomID != RTC_INVALID_GEOMETRY_ID;
      }
    }
    return hits;
  }

 private:
  RTCDevice device_ = rtcNewDevice("threads=1");
  RTCScene scene_ = rtcNewScene(device_);
};

}  // namespace litmus
