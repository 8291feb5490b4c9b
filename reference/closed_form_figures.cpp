// closed_form_figures.cpp: areas, peaks and limits.
#include "reference/closed_form_figures.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>

#include "reference/closed_form_curves.h"
#include "reference/closed_form_view.h"
#include "scene/refusal.h"

namespace litmus {
namespace {

[[noreturn]] void needs(const Scene& scene, const std::string& what) {
  throw Refusal(scene.name + ": expect: " + what);
}

bool from_above(const Scene& scene) {
  const Vector view = scene.camera.target - scene.camera.eye;
  return scene.camera.projection == Projection::Orthographic && view.x == 0 && view.y == 0;
}

/// An ellipse's perimeter is at most that of the rectangle around it.
double perimeter_bound(const Conic& ellipse) { return double(4 * (ellipse.a + ellipse.b)); }

/// The pixel (as real numbers) in which an orthographic camera sees a point.
glm::dvec2 pixel_of(const Scene& scene, const ExactVec& point) {
  const ExactFrame frame = exact_frame(scene.camera);
  const ExactVec from_eye = point - ExactVec(scene.camera.eye);
  const Exact pixels = scene.height / Exact(scene.camera.height);
  return {double(scene.width / 2.0L + glm::dot(from_eye, frame.right) * pixels),
          double(scene.height / 2.0L - glm::dot(from_eye, frame.up) * pixels)};
}

double distance_to_brightest(const Picture& picture, const glm::dvec2& expected) {
  const auto brightest = std::max_element(
      picture.pixels.begin(), picture.pixels.end(),
      [](const auto& a, const auto& b) { return a.x + a.y + a.z < b.x + b.y + b.z; });
  const auto index = brightest - picture.pixels.begin();
  return glm::distance(expected, glm::dvec2(double(index % picture.width) + 0.5,
                                            double(index / picture.width) + 0.5));
}

}  // namespace

Exact rectangle_mean_cosine(std::array<Exact, 2> x, std::array<Exact, 2> y, Exact height) {
  const auto antiderivative = [&](Exact u, Exact v) {
    const Exact R = std::sqrt(u * u + v * v + height * height);
    return u * std::log(v + R) + v * std::log(u + R) - height * std::atan2(u * v, height * R);
  };
  const Exact sum = antiderivative(x[1], y[1]) - antiderivative(x[0], y[1]) -
                    antiderivative(x[1], y[0]) + antiderivative(x[0], y[0]);
  return height * sum / ((x[1] - x[0]) * (y[1] - y[0]));
}

void measure_shadow_area(const Scene& scene, std::vector<Figure>& figures) {
  const Object& floor = floor_of(scene);
  if (!from_above(scene)) needs(scene, "\"shadow-area\" needs a camera above");
  const double pixel = scene.camera.height / scene.height;
  const std::size_t before = figures.size();
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    const ExactLamp lamp = exact_lamps(scene.lights[k]).front();
    if (!lamp.sun) continue;
    double area = 0, perimeter = 0;
    for (const Object& object : scene.objects) {
      if (&object == &floor) continue;
      const auto* sphere = std::get_if<Sphere>(&object.shape);
      if (!sphere || object.camera_visible)
        needs(scene, "\"shadow-area\" needs spheres that the camera does not see");
      const Conic ellipse = sun_shadow(*sphere, lamp.place, 0);
      area += double(std::numbers::pi_v<Exact> * ellipse.a * ellipse.b);
      perimeter += perimeter_bound(ellipse);
    }
    figures.push_back(
        {Oracle::ShadowArea, k + 1, area, perimeter * pixel * std::numbers::sqrt2 / 2,
         "square units", [pixel](const Picture& picture) {
           return pixel * pixel *
                  double(std::count(picture.pixels.begin(), picture.pixels.end(), glm::dvec3(0)));
         }});
  }
  if (figures.size() == before) needs(scene, "\"shadow-area\" needs a sun");
}

void measure_highlight(const Scene& scene, std::vector<Figure>& figures) {
  const Plane& plane = std::get<Plane>(floor_of(scene).shape);
  if (scene.materials[std::size_t(floor_of(scene).material)].diffuse != Color(0))
    needs(scene, "\"highlight-peak\" needs a floor without diffuse light");
  if (scene.camera.projection != Projection::Orthographic)
    needs(scene, "\"highlight-peak\" needs an orthographic camera");
  const ExactVec n = glm::normalize(ExactVec(plane.normal)), e = -exact_frame(scene.camera).forward;
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    const std::vector<ExactLamp> lamps = exact_lamps(scene.lights[k]);
    if (lamps.size() > 1 || lamps.front().sun || lamps.front().cone)
      needs(scene, "\"highlight-peak\" needs point lights");
    // The mirror image of the lamp, moved along the view onto the floor.
    const ExactVec lamp = lamps.front().place;
    const Exact height = glm::dot(lamp - ExactVec(plane.point), n);
    const ExactVec image = lamp - 2 * height * n;
    const ExactVec peak = image + height / glm::dot(e, n) * e;
    figures.push_back({Oracle::Highlight, k + 1, 0, std::numbers::sqrt2 / 2 + 1e-9, "pixels",
                       [expected = pixel_of(scene, peak)](const Picture& picture) {
                         return distance_to_brightest(picture, expected);
                       }});
  }
}

void measure_rectangle_limit(const Scene& scene, std::vector<Figure>& figures) {
  const Object& floor = floor_of(scene);
  const Material& material = scene.materials[std::size_t(floor.material)];
  const std::size_t before = figures.size();
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    const auto* area = std::get_if<AreaLight>(&scene.lights[k].shape);
    if (!area || !area->normal || area->right) continue;
    const Attenuation& a = area->point.attenuation;
    if (scene.objects.size() > 1 || !from_above(scene) || area->normal->x != 0 ||
        area->normal->y != 0 || a.linear != 0 || a.quadratic != 0 ||
        material.specular != Color(0) || area->placement != Placement::Centres)
      needs(scene,
            "\"rectangle-limit\" needs an open matte floor below a level rectangle of centres "
            "without attenuation");
    const Exact H = area->point.origin.z - std::get<Plane>(floor.shape).point.z;
    const auto offsets = [](Exact from, Exact to, Exact size) {
      return std::array{to - size / 2 - from, to + size / 2 - from};
    };
    const ClosedFormView view = view_of(scene);
    double exact = 0;
    for (int y = 0; y < scene.height; ++y)
      for (int x = 0; x < scene.width; ++x) {
        const ExactVec at = floor_point(floor, sight(view, x, y))->at;
        exact +=
            double(rectangle_mean_cosine(offsets(at.x, area->point.origin.x, area->width),
                                         offsets(at.y, area->point.origin.y, area->height), H));
      }
    const double scale = material.diffuse.x * scene.lights[k].diffuse.x * scene.lights[k].intensity;
    exact *= scale / (scene.width * scene.height);
    const double hx = area->width / area->columns, hy = area->height / area->rows;
    figures.push_back({Oracle::RectangleLimit, k + 1, exact,
                       scale * (hx * hx + hy * hy) / double(24 * H * H), "mean of red",
                       [](const Picture& picture) {
                         double total = 0;
                         for (const glm::dvec3& pixel : picture.pixels) total += pixel.x;
                         return total / double(picture.pixels.size());
                       }});
  }
  if (figures.size() == before)
    needs(scene, "\"rectangle-limit\" needs an area light with a normal");
}

}  // namespace litmus
