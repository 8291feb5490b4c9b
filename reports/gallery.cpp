// gallery.cpp: the seminar's figures, drawn by the tracer's formulas and rendered by the tracer.
#include "reports/gallery.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "reports/panels.h"
#include "reports/wavelength_figure.h"
#include "scene/load.h"
#include "scene/observer.h"
#include "tracer/lights.h"
#include "tracer/render.h"

namespace litmus {
namespace {

// ---- Drawings -------------------------------------------------------------------------------

constexpr double kPlotWidth = 340, kPlotHeight = 200, kLeft = 34, kBottom = 28, kTop = 8;

std::string polyline(const std::string& points, const char* dashes) {
  return fmt::format("<polyline points=\"{}\" stroke-dasharray=\"{}\"/>", points, dashes);
}

// Slide 12: what is left of the intensity at a distance of x ranges.
std::string attenuation_curves() {
  struct Curve {
    const char *name, *dashes;
    double linear, quadratic;
  };
  constexpr Curve kCurves[] = {
      {"a", "", 1, 0}, {"b", "7 3", 0, 1}, {"c", "2 3", 0.5, 0.5}, {"d", "10 3 2 3", 0, 0}};
  constexpr double kReach = 4;  // ranges
  constexpr int kSteps = 80;
  const auto across = [](double x) { return kLeft + x / kReach * (kPlotWidth - kLeft - 24); };
  const auto up = [](double y) {
    return kPlotHeight - kBottom - y * (kPlotHeight - kBottom - kTop);
  };
  std::string svg = fmt::format(
      "<svg viewBox=\"0 0 {} {}\" class=\"figure\" role=\"img\" "
      "aria-label=\"four attenuation curves\">",
      kPlotWidth, kPlotHeight);
  for (int i = 0; i <= 4; ++i)
    svg += fmt::format(
        "<line x1=\"{0:.1f}\" y1=\"{1:.1f}\" x2=\"{2:.1f}\" y2=\"{1:.1f}\"/>"
        "<text x=\"{3:.1f}\" y=\"{4:.1f}\" text-anchor=\"end\">{5}</text>"
        "<text x=\"{6:.1f}\" y=\"{7:.1f}\" text-anchor=\"middle\">{8}</text>",
        kLeft, up(i / 4.0), across(kReach), kLeft - 5, up(i / 4.0) + 4, i / 4.0, across(i),
        kPlotHeight - 16, i);
  double label = 0;  // below the one before, so that two can be told apart
  for (const Curve& curve : {kCurves[3], kCurves[0], kCurves[1], kCurves[2]}) {
    std::string points;
    double last = 1;
    for (int i = 0; i <= kSteps; ++i) {
      const double x = kReach * i / kSteps;
      last = linear_attenuation(x, curve.linear) * quadratic_attenuation(x, curve.quadratic);
      points += fmt::format("{:.1f},{:.1f} ", across(x), up(last));
    }
    svg += polyline(points, curve.dashes);
    label = std::max(label + 12, up(last) + 2);
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{})</text>", across(kReach) + 5, label,
                       curve.name);
  }
  return svg + fmt::format(
                   "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">distance / "
                   "range</text></svg>",
                   across(kReach / 2), kPlotHeight - 4);
}

// Slide 20: the samples of an area light with its frame, seen from the side and above.
std::string area_setup(const AreaLight& light) {
  const AreaFrame<double> frame = area_frame<double>(light);
  const Vec<double> origin(light.point.origin);
  const auto place = [&](const Vec<double>& point) {
    const Vec<double> p = point - origin;
    // Parallel projection: x to the right, y into the depth, z up.
    return std::pair(170 + 95 * (p.x + 0.45 * p.y), 92 - 95 * (p.z + 0.35 * p.y));
  };
  const auto line = [&](const Vec<double>& to, const char* name, const char* what) {
    const auto [x0, y0] = place(origin);
    const auto [x1, y1] = place(to);
    return fmt::format(
        "<line class=\"{}\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" "
        "y2=\"{:.1f}\"/><text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>",
        name, x0, y0, x1, y1, x1 < x0 ? x1 - 4 : x1 + 4, y1 + 4, x1 < x0 ? "end" : "start", what);
  };
  std::string svg = fmt::format(
      "<svg viewBox=\"0 0 {} {}\" class=\"figure\" role=\"img\" "
      "aria-label=\"the grid of an area light and its frame\">",
      kPlotWidth, kPlotHeight);
  std::string corners;
  const Vec<double> r = light.width / 2 * frame.right, u = light.height / 2 * frame.up;
  for (const Vec<double>& corner :
       {origin - r - u, origin + r - u, origin + r + u, origin - r + u}) {
    const auto [x, y] = place(corner);
    corners += fmt::format("{:.1f},{:.1f} ", x, y);
  }
  svg += fmt::format("<polygon points=\"{}\"/>", corners);
  for (const Vec<double>& sample : area_samples<double>(light)) {
    const auto [x, y] = place(sample);
    svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\"/>", x, y);
  }
  svg += line(origin + frame.normal, "axis", "normal");
  svg += line(origin + 1.25 * frame.right, "axis", "right");
  svg += line(origin + frame.up, "axis", "up' = n × right");
  return svg + "</svg>";
}

// ---- Figures --------------------------------------------------------------------------------

GalleryFigure one_render(const char* slides, const char* title, const char* caption,
                         const char* scene, int threads) {
  return {slides, title, caption, {panel(scene, rendered(panel_scene(scene), threads).whole)}};
}

GalleryFigure linear_against_quadratic(int threads) {
  GalleryFigure figure{"slide 13",
                       "Linear against quadratic attenuation",
                       "The same lamp: linear attenuation 1, then quadratic attenuation 1.",
                       {}};
  for (const bool quadratic : {false, true}) {
    Scene scene = panel_scene("x2");
    Attenuation& attenuation = std::get<PointLight>(scene.lights[0].shape).attenuation;
    attenuation.linear = quadratic ? 0 : 1, attenuation.quadratic = quadratic ? 1 : 0;
    figure.panels.push_back(
        panel(quadratic ? "quadratic" : "linear", rendered(scene, threads).whole));
  }
  return figure;
}

GalleryFigure exponents(int threads) {
  GalleryFigure figure{"slide 17",
                       "Exponent difference",
                       "The same spot: a large exponent keeps the light up to the cone's border.",
                       {}};
  for (const int exponent : {3, 30}) {
    Scene scene = panel_scene("x3");
    std::get<SpotLight>(scene.lights[0].shape).exponent = exponent;
    figure.panels.push_back(
        panel(fmt::format("exponent = {}", exponent), rendered(scene, threads).whole));
  }
  return figure;
}

/// Whether a scene cannot be loaded here for want of a package's data.
bool lacks_data(const std::filesystem::path& file) {
  try {
    load_scene(file);
  } catch (const MissingData&) {
    return true;
  }
  return false;
}

std::vector<GalleryFigure> figures_of_lights(int threads) {
  const Scene area = panel_scene("x4");
  return {
      one_render("slide 7", "Sun light", "Parallel rays, equal everywhere.", "x1", threads),
      one_render("slide 9", "Point light", "Weaker with distance.", "x2", threads),
      {"slide 12",
       "Attenuation curves",
       "What is left of the intensity: a) linear attenuation 1, b) quadratic 1, c) 0.5 of both, d) "
       "none.",
       {{"", "", attenuation_curves()}}},
      linear_against_quadratic(threads),
      one_render("slide 14", "Spot light", "A point light in a cone.", "x3", threads),
      exponents(threads),
      one_render("slide 18", "Area light", "A grid of point lights.", "x4", threads),
      {"slide 20",
       "Area light setup",
       "The samples and the frame of the area light on slide 18's picture; its normal looks at the "
       "scene's origin.",
       {{"", "", area_setup(std::get<AreaLight>(area.lights[0].shape))}}},
  };
}

}  // namespace

bool is_full_run(const Study& study) {
  std::set<std::string> names;
  for (const Case& one : study.cases) names.insert(one.scene);
  const std::vector<std::filesystem::path> files = canonical_scenes();
  return !files.empty() && std::all_of(files.begin(), files.end(), [&](const auto& file) {
    return names.contains(file.stem().string()) || lacks_data(file);
  });
}

std::vector<GalleryFigure> gallery(int threads) {
  std::vector<GalleryFigure> figures = figures_of_lights(threads);
  if (!lacks_data(find_scene("w2"))) figures.insert(figures.begin(), wavelength_figure(threads));
  return figures;
}

}  // namespace litmus
