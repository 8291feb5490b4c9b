// envelope_study.cpp: moves a scene about and counts the pixels that change.
#include "reports/envelope_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <map>
#include <numbers>

#include "tracer/render.h"

namespace litmus {
namespace {

constexpr double kVisible = 1.0 / 255;

struct MovedScene {
  std::string axis;
  double value;
  Scene scene;
};

/// A sphere and a box on a floor, side by side in the light of a lamp with quadratic attenuation,
/// which every renderer has of its own.
Scene stage(double scale, double offset) {
  const Point at = offset * Point(1, 0.5, 0.25);
  const auto point = [&](double x, double y, double z) { return at + scale * Point(x, y, z); };
  Scene scene;
  scene.name = fmt::format("scale-{:g}-offset-{:g}", scale, offset);
  scene.tags = {"unmoved"};
  scene.width = 64, scene.height = 48;
  scene.camera.eye = point(0.4, -6, 3), scene.camera.target = point(0, 0, 0.5);
  scene.camera.fov = 40 * std::numbers::pi / 180;
  scene.materials.push_back({"gloss", Color(1), Color(0.6, 0.5, 0.4), Color(0.3), 20});
  scene.objects.push_back({"floor", Plane{at, {0, 0, 1}}, 0, true});
  scene.objects.push_back({"ball", Sphere{point(-0.8, 0, 0.7), 0.7 * scale}, 0, true});
  scene.objects.push_back({"block", Box{point(0.4, -0.5, 0), point(1.3, 0.6, 1.1)}, 0, true});
  Light lamp;
  lamp.name = "lamp";
  lamp.shape = PointLight{point(1.5, -2.5, 4), {5 * scale, 0, 0.5}};
  scene.lights.push_back(lamp);
  return scene;
}

std::vector<MovedScene> places() {
  std::vector<MovedScene> all;
  for (int decade = -6; decade <= 6; ++decade)
    all.push_back({"scale", std::pow(10, decade), stage(std::pow(10, decade), 0)});
  for (int decade = 2; decade <= 8; ++decade)
    all.push_back({"offset", std::pow(10, decade), stage(1, std::pow(10, decade))});
  return all;
}

double percent_differing(const Picture& a, const Picture& b) {
  if (a.pixels.size() != b.pixels.size()) return 100;
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const glm::dvec3 d = glm::abs(a.pixels[i] - b.pixels[i]);
    count += !(std::max({d.x, d.y, d.z}) <= kVisible) || std::isnan(d.x + d.y + d.z);
  }
  return 100.0 * double(count) / double(a.pixels.size());
}

/// A picture, or why there is none.
struct Shown {
  Picture picture;
  std::string failure;
};

/// One renderer's pictures by the scene's name; that of scale 1 is what the others must show.
void add_points(std::vector<EnvelopePoint>& points, const std::string& renderer,
                const std::vector<MovedScene>& places,
                const std::map<std::string, Shown>& pictures) {
  const Shown& expected = pictures.at(stage(1, 0).name);
  for (const MovedScene& place : places) {
    const Shown& shown = pictures.at(place.scene.name);
    EnvelopePoint point{place.axis, place.value, renderer, 100, shown.failure};
    if (point.failure.empty() && !expected.failure.empty())
      point.failure = "nothing to compare with: no picture at scale 1";
    if (point.failure.empty()) point.differing = percent_differing(shown.picture, expected.picture);
    points.push_back(std::move(point));
  }
}

std::map<std::string, Shown> by_litmus(const std::vector<MovedScene>& places, Precision precision) {
  std::map<std::string, Shown> pictures;
  for (const MovedScene& place : places)
    pictures[place.scene.name].picture = render(place.scene, {precision}).whole;
  return pictures;
}

std::map<std::string, Shown> by_driver(const std::vector<MovedScene>& places, const Driver& driver,
                                       const Installation& installation, ReferenceOptions options) {
  std::vector<Scene> scenes;
  std::map<std::string, Shown> pictures;
  for (const MovedScene& place : places) {
    scenes.push_back(place.scene);
    pictures[place.scene.name].failure = "no picture";
  }
  options.work /= "envelope-" + driver.name;
  std::filesystem::create_directories(options.work);
  driver.render(installation, scenes, options, [&](ReferenceResult result) {
    Shown& shown = pictures.at(result.scene);
    shown.failure = result.failure + result.skipped;
    if (!result.layers.empty()) shown = {sum(result.layers), ""};
  });
  return pictures;
}

}  // namespace

std::vector<EnvelopePoint> run_envelope_study(const ReferenceOptions& options,
                                              std::span<const Driver> drivers) {
  const std::vector<MovedScene> all = places();
  std::vector<EnvelopePoint> points;
  add_points(points, "litmus double", all, by_litmus(all, Precision::Double));
  add_points(points, "litmus float", all, by_litmus(all, Precision::Float));
  for (const Driver& driver : drivers) {
    if (options.progress) options.progress(driver.title);
    if (const auto installation = driver.find()) {
      add_points(points, driver.title, all, by_driver(all, driver, *installation, options));
    } else {
      for (const MovedScene& place : all)
        points.push_back({place.axis, place.value, driver.title, 100, "not installed"});
    }
  }
  return points;
}

std::vector<std::string> envelope_failures(const std::vector<EnvelopePoint>& points) {
  std::vector<std::string> order;
  std::map<std::string, std::size_t> total;
  std::map<std::string, std::map<std::string, std::vector<std::string>>> where;  // renderer, reason
  for (const EnvelopePoint& point : points) {
    if (++total[point.renderer] == 1) order.push_back(point.renderer);
    if (point.failure.empty()) continue;
    where[point.renderer][point.failure].push_back(fmt::format("{} {:g}", point.axis, point.value));
  }
  std::vector<std::string> lines;
  for (const std::string& renderer : order) {
    for (const auto& [reason, places] : where[renderer]) {
      const bool everywhere = places.size() == total[renderer];
      lines.push_back(fmt::format("{}{}: {}", renderer,
                                  everywhere ? "" : fmt::format(", {}", fmt::join(places, ", ")),
                                  reason));
    }
  }
  return lines;
}

}  // namespace litmus
