// fingerprint.cpp: one number for everything in a scene that decides its picture.
#include <xxhash.h>

#include <cstring>
#include <memory>

#include "scene/load.h"

namespace litmus {
namespace {

/// Changed whenever the fields below change, so that old fingerprints match nothing.
constexpr std::uint32_t kLayout = 1;

/// Feeds values to the hash, each list preceded by its length so that no two scenes read alike.
class Hash {
 public:
  Hash() { XXH3_128bits_reset(state_.get()); }

  void add(double value) { bytes(&value, sizeof value); }
  void add(std::int64_t value) { bytes(&value, sizeof value); }
  void add(const glm::dvec3& v) { add(v.x), add(v.y), add(v.z); }
  void add(const std::string& text) {
    add(std::int64_t(text.size()));
    bytes(text.data(), text.size());
  }
  void add(const std::array<std::int32_t, 3>& triangle) { bytes(triangle.data(), sizeof triangle); }
  void add(const std::optional<Vector>& vector) {
    add(std::int64_t(vector.has_value()));
    if (vector) add(*vector);
  }
  template <class T>
  void add(const std::vector<T>& list) {
    add(std::int64_t(list.size()));
    for (const T& element : list) add(element);
  }

  void add(const Attenuation& a) { add(a.range), add(a.linear), add(a.quadratic); }
  void add(const DirectionalLight& light) { add(light.direction); }
  void add(const PointLight& light) { add(light.origin), add(light.attenuation); }
  void add(const SpotLight& light) {
    add(light.point), add(light.direction), add(light.cutoff), add(light.exponent);
  }
  void add(const AreaLight& light) {
    add(light.point), add(light.normal), add(light.right), add(light.width), add(light.height);
    add(std::int64_t(light.columns)), add(std::int64_t(light.rows));
    add(std::int64_t(light.placement));
  }
  void add(const Light& light) {  // its name too: the layers carry it
    add(light.name), add_variant(light.shape), add(light.intensity);
    add(light.diffuse), add(light.specular), add(light.ambient);
  }

  /// In float: the formulas of spectra may differ in the last digits between mathematical
  /// libraries.
  void add(const std::vector<double>& bands) {
    add(std::int64_t(bands.size()));
    for (const double value : bands) add(double(float(value)));
  }
  void add(const BandColors& c) { add(c.ambient), add(c.diffuse), add(c.specular); }

  void add(const Material& m) { add(m.ambient), add(m.diffuse), add(m.specular), add(m.shininess); }
  void add(const Sphere& sphere) { add(sphere.center), add(sphere.radius); }
  void add(const Plane& plane) { add(plane.point), add(plane.normal); }
  void add(const Box& box) { add(box.min), add(box.max); }
  void add(const Triangle& t) { add(t.a), add(t.b), add(t.c); }
  void add(const Mesh& mesh) { add(mesh.vertices), add(mesh.normals), add(mesh.triangles); }

  void add(const Camera& camera) {
    add(std::int64_t(camera.projection)), add(camera.eye), add(camera.target), add(camera.up);
    add(camera.projection == Projection::Perspective ? camera.fov : camera.height);
  }

  template <class Variant>
  void add_variant(const Variant& variant) {
    add(std::int64_t(variant.index()));
    std::visit([this](const auto& value) { add(value); }, variant);
  }

  std::string text() const {
    XXH128_canonical_t canonical;
    XXH128_canonicalFromHash(&canonical, XXH3_128bits_digest(state_.get()));
    std::string digits;
    for (const unsigned char byte : canonical.digest)
      for (const int nibble : {byte >> 4, byte & 15}) digits += "0123456789abcdef"[nibble];
    return digits;
  }

 private:
  void bytes(const void* data, std::size_t size) { XXH3_128bits_update(state_.get(), data, size); }

  struct Free {
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
  };
  std::unique_ptr<XXH3_state_t, Free> state_{XXH3_createState()};
};

/// A scene without colours of any kind.
Scene without_colors(Scene scene) {
  scene.spectra.reset();
  scene.ambient = Color(0);
  for (Material& m : scene.materials) m.ambient = m.diffuse = m.specular = Color(0);
  for (Light& light : scene.lights) light.ambient = light.diffuse = light.specular = Color(0);
  return scene;
}

/// Of a spectral scene the bands decide, not the RGB colours that stand in for them.
std::string spectral_fingerprint(const Scene& scene) {
  const Spectra& spectra = *scene.spectra;
  Hash hash;
  hash.add(fingerprint(without_colors(scene)));
  hash.add(spectra.ambient);
  for (const Object& object : scene.objects)
    hash.add(spectra.materials[std::size_t(object.material)]);
  hash.add(spectra.lights);
  return hash.text();
}

}  // namespace

std::string fingerprint(const Scene& scene) {
  if (scene.spectra) return spectral_fingerprint(scene);
  Hash hash;
  hash.add(std::int64_t(kLayout));
  for (const int value : {scene.width, scene.height, scene.samples, int(scene.shadows)})
    hash.add(std::int64_t(value));
  hash.add(std::int64_t(scene.shading));
  hash.add(scene.camera);
  hash.add(scene.ambient);
  hash.add(std::int64_t(scene.objects.size()));
  for (const Object& object : scene.objects) {
    hash.add_variant(object.shape);
    hash.add(
        scene.materials[std::size_t(object.material)]);  // by value: an unused one does not count
    hash.add(std::int64_t(object.camera_visible));
  }
  hash.add(scene.lights);
  return hash.text();
}

}  // namespace litmus
