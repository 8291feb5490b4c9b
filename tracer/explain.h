// explain.h: slide 5 with numbers: everything that went into one pixel, light by light.
//
// Every number comes from the functions that the kernel itself calls, in double. l, n, h, e, x and
// alpha are the letters of the slides; D and S are the factors of kd Id and of ks Is.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace litmus {

/// Why a lamp adds nothing to a point, the first reason that holds. The sample code's reading knows
/// only Open and Blocked.
enum class Gate {
  Open,            ///< it adds something
  Behind,          ///< l.n <= 0
  BehindGeometry,  ///< l.n > 0, but the geometric normal faces away (smooth meshes)
  OutsideCone,     ///< alpha > cutoff
  NoLight,         ///< attenuation and decay leave nothing
  Blocked,         ///< something is in between
};

/// "the light is behind the surface", ...
std::string_view gate_reason(Gate gate);

/// One lamp at the point seen: the sun, a point or spot light, or one sample of an area light.
struct LampExplanation {
  glm::dvec3 l{0};         ///< unit, towards the lamp; 0 where the lamp is at the point
  glm::dvec3 h{0};         ///< unit, between l and e; 0 for a material without specular
  double distance = 0;     ///< d, scene units; infinite for the sun
  double x = 0;            ///< d / R; infinite for the sun
  double linear = 1;       ///< the attenuation l of slide 11
  double quadratic = 1;    ///< q
  double attenuation = 1;  ///< l q
  double alpha = 0;        ///< spots: off the axis, radians
  double decay = 1;        ///< spots: slide 16
  double intensity = 1;    ///< what arrives: attenuation times decay
  double l_dot_n = 0;      ///< not clamped
  double h_dot_n = 0;      ///< not clamped; 0 for a material without specular
  double power = 0;        ///< (h.n)^ns; 0 for a material without specular
  double visibility = 1;   ///< 0 or 1; asked even where the lamp adds nothing anyway
  int blocker = -1;        ///< index into Scene::objects of the first object found in between
  double diffuse = 0;      ///< D of this lamp: visibility * intensity * (l.n), gated
  double specular = 0;     ///< S of this lamp: visibility * intensity * power, gated
  Gate gate = Gate::Open;
};

/// A term of the equation as a number per lamp.
struct Term {
  std::string_view name, meaning;
  double LampExplanation::*member;
  /// Whether a light of a scene has the term at all.
  bool (*applies)(const Scene&, const Light&);
};

/// d, l, q, alpha, decay, l.n, h.n, power, visibility, diffuse, specular.
std::span<const Term> terms();

struct LightExplanation {
  std::string name, type;
  std::vector<LampExplanation> lamps;  ///< none for a light of intensity 0
  double weight = 1;                   ///< 1 / number of lamps
  double diffuse = 0, specular = 0;    ///< D and S: the lamps' sum times the weight
  glm::dvec3 light_diffuse{0};         ///< Id: intensity times colour
  glm::dvec3 light_specular{0};        ///< Is; in the sample code's reading it is Id
  glm::dvec3 diffuse_color{0};         ///< kd Id D
  glm::dvec3 specular_color{0};        ///< ks Is S
  glm::dvec3 ambient_color{0};         ///< the sample code's reading: ka Ia for each lamp in view
  glm::dvec3 color{0};                 ///< what the light adds
};

/// The mean of a lamp's number over the lamps of a light; 0 without any.
double mean(const LightExplanation& light, double LampExplanation::*member);

struct Explanation {
  int x = 0, y = 0;
  int samples = 1;    ///< the pixel is the mean of samples x samples; its centre is explained
  bool hit = false;   ///< false: the background, all that follows is 0
  int object = -1;    ///< index into Scene::objects
  Material material;  ///< of that object
  double t = 0;  ///< along the ray, scene units: from the eye, or from the plane of the picture
  glm::dvec3 point{0};
  glm::dvec3 e{0};                       ///< unit, towards the eye
  glm::dvec3 normal{0};                  ///< n, unit, for shading, towards the eye
  glm::dvec3 geometric{0};               ///< unit normal of the surface, towards the eye
  glm::dvec3 ambient{0};                 ///< Ia: the scene's and each light's
  glm::dvec3 ambient_color{0};           ///< ka Ia; 0 in the sample code's reading
  std::vector<LightExplanation> lights;  ///< in the scene's order
  glm::dvec3 whole{0};                   ///< at the centre: ambient_color plus each light's color
  std::vector<glm::dvec3> layers;  ///< the rendered pixel: ambient, then each light; of several
                                   ///< samples their mean
  glm::dvec3 picture{0};           ///< the rendered pixel's whole
};

/// Explains a pixel as render() computes it in double; (0, 0) is the top left. Throws Refusal that
/// names the range if there is no such pixel.
Explanation explain(const Scene& scene, int x, int y);

/// The same for many pixels of one scene, which is lowered once. May be called from any thread.
using Explainer = std::function<Explanation(int x, int y)>;
Explainer explainer(const Scene& scene);

/// One term of one light at the centre of every pixel: the mean over its lamps, 0 where nothing is
/// seen.
struct TermPicture {
  std::string light;
  std::string_view term;      ///< Term::name
  std::vector<float> values;  ///< width * height, row by row
};

/// All terms that the scene's lights have, light by light in the scene's order, terms in the order
/// of terms(). With one sample per pixel the picture is, per channel,
///     ka Ia + sum over lights of kd Id diffuse + ks Is specular,
/// and in the sample code's reading
///     sum over lights of lamps * visibility * ka Ia + kd Id diffuse + ks Id specular.
std::vector<TermPicture> term_pictures(const Scene& scene);

/// Why a light adds nothing, or not all, at the centre of every pixel; row by row.
struct StopPicture {
  std::string light;
  std::vector<Gate> gates;    ///< what all of its lamps have in common; Open if nothing
  std::vector<int> blockers;  ///< object in between for the first blocked lamp; -1: none is
};

/// One for each light, in the scene's order.
std::vector<StopPicture> stop_pictures(const Scene& scene);

/// The object seen at the centre of every pixel, as index into Scene::objects; -1 is none.
std::vector<int> objects_seen(const Scene& scene);

}  // namespace litmus
