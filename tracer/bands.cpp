// bands.cpp: D and S of each light as a picture, times the colours of each band.
#include "tracer/bands.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <glm/mat3x3.hpp>
#include <optional>

#include "scene/bands.h"
#include "scene/observer.h"
#include "tracer/light_terms.h"

namespace litmus {
namespace {

// ---- Geometry, once --------------------------------------------------------------------------

bool any(const std::vector<double>& bands) {
  return std::any_of(bands.begin(), bands.end(), [](double value) { return value != 0; });
}

/// The scene in colours of which each channel is a term: of a light D in red, S in green, and for
/// the sample code the lamps in view in blue; of the ambient layer the object's index + 1 in red.
/// Every sample is a pixel.
Scene terms_scene(const Scene& scene) {
  Scene terms = scene;
  terms.spectra.reset();
  terms.width *= scene.samples, terms.height *= scene.samples, terms.samples = 1;
  terms.materials.clear();
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const std::size_t material = std::size_t(scene.objects[i].material);
    const BandColors& colors = scene.spectra->materials[material];
    terms.objects[i].material = int(i);
    terms.materials.push_back({scene.materials[material].name, Color(double(i + 1), 0, 1),
                               any(colors.diffuse) ? Color(1, 0, 0) : Color(0),
                               any(colors.specular) ? Color(0, 1, 0) : Color(0),
                               scene.materials[material].shininess});
  }
  terms.ambient = scene.shading == Shading::SampleCode ? Color(0, 0, 1) : Color(1, 0, 0);
  for (Light& light : terms.lights) {
    if (light.intensity != 0 || scene.shading == Shading::SampleCode) light.intensity = 1;
    light.diffuse = light.specular = Color(1, 1, 0);  // the sample code takes diffuse for both
    light.ambient = Color(0);
  }
  return terms;
}

struct Geometry {
  Rendering terms;
  Picture objects;  ///< red: the index of the object seen + 1
};

Geometry render_geometry(const Scene& scene, RenderOptions options) {
  options.shift_x *= scene.samples, options.shift_y *= scene.samples;
  options.layers = true;
  Scene terms = terms_scene(scene);
  RenderOptions with_objects = options;  // the ambient layer says which object is seen
  if (with_objects.effects) with_objects.effects->ambient = true;
  const bool equation = scene.shading == Shading::Equation;
  Geometry geometry{render(terms, equation ? with_objects : options), {}};
  if (equation) {
    geometry.objects = std::move(geometry.terms.layers.front().picture);
    return geometry;
  }
  // Without the equation's ambient term: the camera's rays once more.
  terms.shading = Shading::Equation;
  terms.ambient = Color(1, 0, 0);
  terms.lights.clear();
  geometry.objects = render(terms, with_objects).whole;
  return geometry;
}

// ---- Colours, once per object and light -------------------------------------------------------

/// What an object and a layer give per band for each unit of D, of S and of lamps in view, and what
/// the observer sees of that, in linear sRGB. Of the ambient layer `in_view` is all there is.
struct BandAnswer {
  std::vector<double> diffuse, specular, in_view;
  glm::dmat3 colors{0};  ///< one column each
};

glm::dvec3 seen_color(const Spectra& spectra, const std::vector<double>& bands) {
  glm::dvec3 xyz(0);
  for (std::size_t b = 0; b < spectra.xyz.size(); ++b) xyz += bands[b] * spectra.xyz[b];
  return linear_srgb(xyz);
}

/// The answers of all objects, layer by layer: object * layers + layer. Bands beyond the last,
/// which fill up the last picture of three, are 0.
std::vector<BandAnswer> answers_of(const Scene& scene) {
  const std::size_t layers = scene.lights.size() + 1, objects = scene.objects.size();
  std::vector<BandAnswer> answers(layers * objects);
  for (Scene& three : band_scenes(scene)) {
    for (Object& object : three.objects) object.shape = Sphere{};  // colours are all that counts
    const Plan<double> plan = lower<double>(three);
    const auto add = [](std::vector<double>& bands, const Vec<double>& color) {
      bands.insert(bands.end(), {color.x, color.y, color.z});
    };
    for (std::size_t object = 0; object < objects; ++object) {
      const Finish<double>& finish = plan.finishes[object];
      BandAnswer* answer = &answers[object * layers];
      add(answer->diffuse, {}), add(answer->specular, {});
      add(answer->in_view, plan.sample_code ? Vec<double>{} : finish.ambient * plan.ambient);
      for (const Source<double>& source : plan.sources) {
        const auto unit = [&](double d, double s, double lamps) {
          LightTerms<double> terms;
          terms.diffuse = d, terms.specular = s, terms.unoccluded = lamps;
          return light_color(plan, source, finish, terms);
        };
        ++answer;
        add(answer->diffuse, unit(1, 0, 0)), add(answer->specular, unit(0, 1, 0));
        add(answer->in_view, unit(0, 0, 1));
      }
    }
  }
  for (BandAnswer& answer : answers)
    answer.colors = {seen_color(*scene.spectra, answer.diffuse),
                     seen_color(*scene.spectra, answer.specular),
                     seen_color(*scene.spectra, answer.in_view)};
  return answers;
}

// ---- Both together ----------------------------------------------------------------------------

/// Adds D, S and lamps in view, each times `share`, times the colours of each band. Returns how
/// many products that took.
std::int64_t add_products(const BandAnswer& answer, const glm::dvec3& terms, double share,
                          std::vector<double>& bands) {
  std::int64_t products = 0;
  const auto add = [&](double term, const std::vector<double>& colors) {
    if (term == 0) return;
    const double factor = term * share;
    for (std::size_t b = 0; b < bands.size(); ++b) bands[b] += factor * colors[b];
    products += std::int64_t(bands.size());
  };
  add(terms.x, answer.diffuse), add(terms.y, answer.specular), add(terms.z, answer.in_view);
  return products;
}

struct Contraction {
  const Scene& scene;
  const Geometry& geometry;
  const std::vector<BandAnswer> answers;
  const KeepBands keep;

  /// A layer's colour in a pixel, the mean over its samples; its bands are added to `bands` if they
  /// are kept, and the products counted.
  glm::dvec3 color_at(int x, int y, std::size_t layer, std::vector<double>& bands,
                      std::int64_t& products) const {
    const std::size_t layers = scene.lights.size() + 1;
    const double share = 1.0 / (scene.samples * scene.samples);
    glm::dvec3 color(0);
    for (int j = 0; j < scene.samples; ++j)
      for (int i = 0; i < scene.samples; ++i) {
        const int sx = x * scene.samples + i, sy = y * scene.samples + j;
        const int object = int(geometry.objects.at(sx, sy).x) - 1;
        if (object < 0) continue;
        const glm::dvec3 terms =
            layer == 0 ? glm::dvec3(0, 0, 1) : geometry.terms.layers[layer].picture.at(sx, sy);
        const BandAnswer& answer = answers[std::size_t(object) * layers + layer];
        color += answer.colors * terms;
        products += 3;
        if (keep != KeepBands::None) products += add_products(answer, terms, share, bands);
      }
    return color * share;
  }

  std::int64_t row(int y, BandRendering& result) const {
    std::int64_t products = 0;
    std::vector<double> bands(3 * std::size_t(band_pictures(*scene.spectra)));
    const auto store = [&](std::size_t layer, int x) {
      for (std::size_t p = 0; p < result.pictures.size(); ++p)
        result.pictures[p][layer].picture.at(x, y) = {bands[3 * p], bands[3 * p + 1],
                                                      bands[3 * p + 2]};
      std::fill(bands.begin(), bands.end(), 0.0);
    };
    for (int x = 0; x < scene.width; ++x) {
      glm::dvec3 whole(0);
      for (std::size_t layer = 0; layer < result.rendering.layers.size(); ++layer) {
        const glm::dvec3 color = color_at(x, y, layer, bands, products);
        result.rendering.layers[layer].picture.at(x, y) = color;
        whole += color;
        if (keep == KeepBands::Layers) store(layer, x);
      }
      result.rendering.whole.at(x, y) = whole;
      if (keep == KeepBands::Whole) store(0, x);
    }
    return products;
  }
};

/// Leaves the ambient layer black, for whoever asks for a picture without that effect.
void leave_out_ambient(std::vector<BandAnswer>& answers, std::size_t layers) {
  for (std::size_t i = 0; i < answers.size(); i += layers) {
    answers[i].colors = glm::dmat3(0);
    std::fill(answers[i].in_view.begin(), answers[i].in_view.end(), 0.0);
  }
}

/// What the samples of each pixel have in common: signatures mixed, flags or-ed.
void gather(const Scene& scene, Rendering& terms, Rendering& result) {
  if (scene.samples == 1) {
    result.signatures = std::move(terms.signatures), result.flags = std::move(terms.flags);
    return;
  }
  const int n = scene.samples, width = scene.width * n;
  const auto pixel_of = [&](std::size_t i) {
    return i / std::size_t(width) / std::size_t(n) * std::size_t(scene.width) +
           i % std::size_t(width) / std::size_t(n);
  };
  const std::size_t pixels = result.whole.pixels.size();
  for (const Signature& fine : terms.signatures) {
    Signature coarse{scene.width, scene.height, std::vector<std::uint64_t>(pixels)};
    for (std::size_t i = 0; i < fine.values.size(); ++i) {
      std::uint64_t& value = coarse.values[pixel_of(i)];
      value = mix(value, fine.values[i]);
    }
    result.signatures.push_back(std::move(coarse));
  }
  for (const std::vector<std::uint8_t>& fine : terms.flags) {
    std::vector<std::uint8_t> coarse(pixels);
    for (std::size_t i = 0; i < fine.size(); ++i) coarse[pixel_of(i)] |= fine[i];
    result.flags.push_back(std::move(coarse));
  }
}

/// Black pictures of the right names and sizes.
BandRendering blank(const Scene& scene, KeepBands keep) {
  BandRendering result;
  Rendering& rendering = result.rendering;
  rendering.whole = Picture(scene.width, scene.height);
  rendering.layers.push_back({"ambient", "ambient", rendering.whole});
  for (const Light& light : scene.lights)
    rendering.layers.push_back({light.name, std::string(light_type(light)), rendering.whole});
  if (keep == KeepBands::None) return result;
  const Layers one =
      keep == KeepBands::Layers ? rendering.layers : Layers{{"all", "all", rendering.whole}};
  result.pictures.assign(std::size_t(band_pictures(*scene.spectra)), one);
  return result;
}

}  // namespace

BandRendering render_bands(const Scene& scene, const RenderOptions& options, KeepBands keep) {
  if (!scene.spectra) return {render(scene, options), {}, 0};
  Geometry geometry = render_geometry(scene, options);
  BandRendering result = blank(scene, keep);
  std::optional<tbb::global_control> limit;
  if (options.threads > 0)
    limit.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(options.threads));
  const auto start = std::chrono::steady_clock::now();
  std::vector<BandAnswer> answers = answers_of(scene);
  if (options.effects && !options.effects->ambient)
    leave_out_ambient(answers, result.rendering.layers.size());
  const Contraction contraction{scene, geometry, std::move(answers), keep};
  std::atomic<std::int64_t> products = 0;
  tbb::parallel_for(0, scene.height, [&](int y) { products += contraction.row(y, result); });
  result.products = products;
  gather(scene, geometry.terms, result.rendering);
  result.rendering.counts = geometry.terms.counts, result.rendering.target = geometry.terms.target;
  if (!options.layers) result.rendering.layers.clear();
  result.rendering.seconds =
      geometry.terms.seconds +
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

Probe probe_bands(const Scene& scene, const RenderOptions& options) {
  std::vector<Probe> probes;
  for (const Scene& three : band_scenes(scene)) probes.push_back(probe(three, options));
  return [probes, spectra = *scene.spectra](double x, double y) {
    std::vector<glm::dvec3> colors;
    for (std::size_t p = 0; p < probes.size(); ++p) {
      const std::vector<glm::dvec3> three = probes[p](x, y);
      colors.resize(three.size());
      for (std::size_t k = 0; k < three.size(); ++k)
        for (int c = 0; c < 3; ++c)
          if (const std::size_t band = 3 * p + std::size_t(c); band < spectra.xyz.size())
            colors[k] += three[k][c] * spectra.xyz[band];
    }
    for (glm::dvec3& color : colors) color = linear_srgb(color);
    return colors;
  };
}

}  // namespace litmus
