// bands.cpp: D and S of each light as a picture, times the colours of each band.
#include "tracer/bands.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <optional>

#include "scene/bands.h"
#include "scene/observer.h"
#include "tracer/contraction.h"
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

/// The layers are the terms of the lights, but the first is the index of the object seen + 1, in
/// red.
Rendering render_geometry(const Scene& scene, RenderOptions options) {
  options.shift_x *= scene.samples, options.shift_y *= scene.samples;
  options.layers = true;
  Scene terms = terms_scene(scene);
  RenderOptions with_objects = options;  // the ambient layer says which object is seen
  if (with_objects.effects) with_objects.effects->ambient = true;
  if (scene.shading == Shading::Equation) return render(terms, with_objects);
  Rendering geometry = render(terms, options);
  // Without the equation's ambient term: the camera's rays once more.
  terms.shading = Shading::Equation;
  terms.ambient = Color(1, 0, 0);
  terms.lights.clear();
  geometry.layers.front().picture = render(terms, with_objects).whole;
  return geometry;
}

// ---- Pixels ------------------------------------------------------------------------------------

/// What the samples of each pixel have in common: signatures mixed, flags or-ed.
void gather(const Scene& scene, const Rendering& terms, Rendering& result) {
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

/// The names of all layers, without pictures.
Layers names_of(const Scene& scene) {
  Layers layers{{"ambient", "ambient", {}}};
  for (const Light& light : scene.lights)
    layers.push_back({light.name, std::string(light_type(light)), {}});
  return layers;
}

/// A rendering of pixels, still black, for one of samples.
Rendering gathered(const Scene& scene, const Rendering& terms) {
  Rendering pixels;
  pixels.whole = Picture(scene.width, scene.height);
  pixels.layers = names_of(scene);
  for (Layer& layer : pixels.layers) layer.picture = pixels.whole;
  gather(scene, terms, pixels);
  pixels.counts = terms.counts, pixels.target = terms.target, pixels.seconds = terms.seconds;
  return pixels;
}

/// The pictures of all bands, picture by picture.
std::vector<Layers> band_pictures_of(const Scene& scene, const std::vector<RowProducts>& rows,
                                     KeepBands keep) {
  std::vector<Layers> pictures(std::size_t(band_pictures(*scene.spectra)));
  tbb::parallel_for(std::size_t(0), pictures.size(), [&](std::size_t p) {
    pictures[p] = keep == KeepBands::Layers ? names_of(scene) : Layers{{"all", "all", {}}};
    multiply_bands(rows, p, scene.width, pictures[p]);
  });
  return pictures;
}

}  // namespace

BandRendering render_bands(const Scene& scene, const RenderOptions& options, KeepBands keep) {
  if (!scene.spectra) return {render(scene, options), {}, 0};
  Rendering samples = render_geometry(scene, options);
  std::optional<tbb::global_control> limit;
  if (options.threads > 0)
    limit.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(options.threads));
  const auto start = std::chrono::steady_clock::now();
  // With one sample a pixel the colours take the place of the terms.
  const bool in_place = scene.samples == 1;
  BandRendering result;
  result.rendering = in_place ? std::move(samples) : gathered(scene, samples);
  std::vector<BandAnswer> answers = band_answers(scene);
  if (options.effects && !options.effects->ambient)
    leave_out_ambient(answers, scene.lights.size() + 1);
  const Contraction with{scene, in_place ? result.rendering : samples, answers};
  std::vector<RowProducts> rows(keep == KeepBands::None ? 0 : std::size_t(scene.height));
  std::atomic<std::int64_t> products = 0;
  tbb::parallel_for(0, scene.height, [&](int y) {
    products +=
        contract_row(with, y, result.rendering, rows.empty() ? nullptr : &rows[std::size_t(y)]);
  });
  if (keep != KeepBands::None) result.pictures = band_pictures_of(scene, rows, keep);
  result.products = products;
  for (const RowProducts& row : rows)
    result.products += std::int64_t(3 * result.pictures.size() * row.terms.size());
  if (!options.layers) result.rendering.layers.clear();
  result.rendering.seconds +=
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
