// scene.h: the scene as plain data, exactly as its author wrote it. No computation happens here.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace litmus {

using Point = glm::dvec3;   ///< scene units, right-handed, z up
using Vector = glm::dvec3;  ///< any length but zero: whoever needs a unit vector normalises
using Color = glm::dvec3;   ///< linear RGB (Rec.709 primaries), >= 0, not clamped

// ---- Lights (slides 6-20) --------------------------------------------------------------------

/// How a light weakens with distance (slide 10). No attenuation: linear = quadratic = 0.
struct Attenuation {
  double range = 1;      ///< scene units, > 0
  double linear = 0;     ///< dimensionless, >= 0
  double quadratic = 0;  ///< dimensionless, >= 0
};

/// The sun: parallel rays, equal everywhere (slide 8).
struct DirectionalLight {
  Vector direction{0, 0, -1};  ///< the way the light travels
};

struct PointLight {
  Point origin{0};
  Attenuation attenuation;
};

/// A point light narrowed to a cone (slides 15, 16).
struct SpotLight {
  PointLight point;
  Vector direction{0, 0, -1};  ///< the cone's axis, away from the light
  double cutoff = 0;           ///< half angle in radians, 0 < cutoff <= pi
  double exponent = 1;         ///< >= 0; 0 lights nothing
};

/// Where the samples of an area light lie on its rectangle.
enum class Placement {
  Centres,  ///< sample i of n at ((2i + 1 - n) / (2n)) * size
  Corners,  ///< sample i of n at (i / (n - 1) - 1/2) * size; n = 1 is the centre
};

/// A rectangle approximated by a grid of point lights (slides 19, 20).
struct AreaLight {
  PointLight point;  ///< the centre of the rectangle, and the attenuation of each sample
  std::optional<Vector> normal;  ///< absent: from the light towards the origin (slide 20)
  std::optional<Vector> right;   ///< absent: up x n, or (1,0,0) where n is vertical
  double width = 1, height = 1;  ///< along right and along n x right, scene units, >= 0
  int columns = 1, rows = 1;     ///< samples along the width and along the height
  Placement placement = Placement::Centres;
};

struct Light {
  std::string name;
  std::variant<DirectionalLight, PointLight, SpotLight, AreaLight> shape;
  double intensity = 1;
  Color diffuse{1}, specular{1}, ambient{0};  ///< the light's three colours (slide 6)
};

/// "directional", "point", "spot" or "area".
std::string_view light_type(const Light& light);

/// The attenuation of a light, or none for a directional one.
Attenuation attenuation_of(const Light& light);

// ---- Surfaces --------------------------------------------------------------------------------

/// The factors ka, kd, ks and the exponent ns of slide 5.
struct Material {
  std::string name;
  Color ambient{1}, diffuse{1}, specular{0};
  double shininess = 1;  ///< >= 0
};

struct Sphere {
  Point center{0};
  double radius = 1;  ///< > 0
};

/// An infinite plane.
struct Plane {
  Point point{0};
  Vector normal{0, 0, 1};
};

/// An axis-aligned box, min < max on every axis.
struct Box {
  Point min{-1}, max{1};
};

struct Triangle {
  Point a{0}, b{0}, c{0};
};

/// An indexed triangle mesh. `normals` is empty (flat) or has one unit normal per vertex (smooth).
struct Mesh {
  std::vector<Point> vertices;
  std::vector<Vector> normals;
  std::vector<std::array<std::int32_t, 3>> triangles;
};

struct Object {
  std::string name;
  std::variant<Sphere, Plane, Box, Triangle, Mesh> shape;
  int material = 0;            ///< index into Scene::materials
  bool camera_visible = true;  ///< false: casts shadows, is not seen
};

// ---- Camera and scene ------------------------------------------------------------------------

enum class Projection { Perspective, Orthographic };

/// Looks from eye to target; rays pass through pixel centres, row 0 is the top.
struct Camera {
  Projection projection = Projection::Perspective;
  Point eye{0, 0, 1}, target{0};
  Vector up{0, 0, 1};
  double fov = 0.7;   ///< perspective: full vertical angle in radians, in (0, pi)
  double height = 1;  ///< orthographic: vertical extent of the picture in scene units
};

/// The colours of a material or of a light per wavelength: one number a band, each >= 0.
struct BandColors {
  std::vector<double> ambient, diffuse, specular;
};

/// The colours of a scene that names spectra. Its RGB colours then only stand in: those of the
/// materials in white light (D65), those of the lights on white.
struct Spectra {
  int bands = 0;                              ///< equal parts of 380..780 nm (scene/spectrum.h)
  std::vector<double> ambient;                ///< the scene's part of Ia
  std::vector<BandColors> materials, lights;  ///< as Scene::materials and Scene::lights
  std::vector<glm::dvec3> xyz;  ///< CIE 1931 XYZ of a band of value 1, where D65 has Y = 1
  std::string note{};  ///< what a colour is only near to, and the remedy; empty: all are as named
};

/// The slide's equation, or the slide's sample code (they differ: README, "The sample code").
enum class Shading { Equation, SampleCode };

/// A closed form that holds in a scene: something that is true by geometry, without any renderer
/// (reference/closed_form.h computes it, scene/expect.h names it).
enum class Oracle {
  Ambient,
  Floor,
  Spheres,
  Boxes,
  Shell,
  Dark,
  ShadowCurves,
  ConeCurve,
  ShadowArea,
  Highlight,
  RectangleLimit
};

struct Scene {
  std::string name;            ///< the file's stem
  std::filesystem::path file;  ///< where it was read from
  std::string about;           ///< one sentence: what the scene shows
  std::vector<std::string> tags;
  std::vector<Oracle> expect;     ///< what is known of the picture beforehand
  int width = 128, height = 128;  ///< pixels
  int samples = 1;                ///< samples x samples box filter per pixel
  Camera camera;
  Color ambient{0};  ///< the scene's part of Ia
  bool shadows = true;
  Shading shading = Shading::Equation;
  std::vector<Material> materials;
  std::vector<Object> objects;
  std::vector<Light> lights;
  std::optional<Spectra> spectra;     ///< only if a colour of the scene is a spectrum
  std::vector<std::string> warnings;  ///< what the loader dropped, such as degenerate triangles
};

}  // namespace litmus
