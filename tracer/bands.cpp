// bands.cpp: D and S of each light as a picture, times the colours of each band.
#include "tracer/bands.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <optional>
#include <span>
#include <stdexcept>

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
std::vector<Layers> band_pictures_of(const Scene& scene, const std::vector<RowProducts>& rows) {
  std::vector<Layers> pictures(std::size_t(band_pictures(*scene.spectra)));
  tbb::parallel_for(std::size_t(0), pictures.size(), [&](std::size_t p) {
    pictures[p] = names_of(scene);
    multiply_bands(rows, p, scene.width, pictures[p]);
  });
  return pictures;
}

/// The row of each band, beside the picture's.
void write_bands_of_row(const RowProducts& row, const Spectra& spectra,
                        std::span<const glm::dvec3> colors, std::span<float> values) {
  const std::size_t width = colors.size(), channels = values.size() / width;
  const auto put = [&](std::span<const glm::dvec3> pixels, std::size_t channel, std::size_t count) {
    for (std::size_t x = 0; x < width; ++x)
      for (std::size_t c = 0; c < count; ++c)
        values[x * channels + channel + c] = float(pixels[x][glm::length_t(c)]);
  };
  put(colors, 0, 3);
  std::vector<glm::dvec3> three(width);
  for (std::size_t p = 0; p < std::size_t(band_pictures(spectra)); ++p) {
    std::fill(three.begin(), three.end(), glm::dvec3(0));
    multiply_row(row, p, three);
    put(three, 3 + 3 * p, std::min<std::size_t>(3, channels - 3 - 3 * p));
  }
}

/// The geometry of a spectral scene, rendered, and what turns its rows into colours.
class Stage {
 public:
  BandRendering result;
  std::atomic<std::int64_t> products = 0;

  Stage(const Scene& scene, const RenderOptions& options)
      : scene_(scene), options_(options), samples_(render_geometry(scene, options)) {
    if (options.threads > 0)
      limit_.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(options.threads));
    // With one sample a pixel the colours take the place of the terms.
    in_place_ = scene.samples == 1;
    result.rendering = in_place_ ? std::move(samples_) : gathered(scene, samples_);
    answers_ = band_answers(scene);
    if (options.effects && !options.effects->ambient)
      leave_out_ambient(answers_, scene.lights.size() + 1);
  }

  void contract(int y, RowProducts* row) {
    const Contraction with{scene_, in_place_ ? result.rendering : samples_, answers_};
    products += contract_row(with, y, result.rendering, row);
  }

  BandRendering finish(std::chrono::steady_clock::duration worked) {
    result.products = products;
    if (!options_.layers) result.rendering.layers.clear();
    result.rendering.seconds += std::chrono::duration<double>(worked).count();
    return std::move(result);
  }

 private:
  const Scene& scene_;
  const RenderOptions& options_;
  Rendering samples_;
  std::vector<BandAnswer> answers_;
  std::optional<tbb::global_control> limit_;
  bool in_place_ = false;
};

}  // namespace

BandRendering render_bands(const Scene& scene, const RenderOptions& options, KeepBands keep) {
  if (!scene.spectra) return {render(scene, options), {}, 0};
  Stage stage(scene, options);
  const auto start = std::chrono::steady_clock::now();
  std::vector<RowProducts> rows(keep == KeepBands::None ? 0 : std::size_t(scene.height));
  tbb::parallel_for(0, scene.height, [&](int y) {
    stage.contract(y, rows.empty() ? nullptr : &rows[std::size_t(y)]);
  });
  if (keep != KeepBands::None) stage.result.pictures = band_pictures_of(scene, rows);
  for (const RowProducts& row : rows)
    stage.products += std::int64_t(3 * stage.result.pictures.size() * row.terms.size());
  return stage.finish(std::chrono::steady_clock::now() - start);
}

BandRendering render_band_rows(const Scene& scene, const RenderOptions& options,
                               const BandRows& take) {
  if (!scene.spectra) throw std::invalid_argument(scene.name + " has no spectra");
  constexpr int kRows = 32;  // at a time: whole blocks of a compressed EXR
  Stage stage(scene, options);
  std::chrono::steady_clock::duration worked{};
  const std::size_t stride = std::size_t(scene.width) * std::size_t(3 + scene.spectra->bands);
  std::vector<RowProducts> rows(kRows);
  std::vector<float> values(kRows * stride);
  for (int first = 0; first < scene.height; first += kRows) {
    const auto start = std::chrono::steady_clock::now();
    const int count = std::min(kRows, scene.height - first);
    tbb::parallel_for(0, count, [&](int i) {
      RowProducts& row = rows[std::size_t(i)];
      row.terms.clear(), row.stretches.clear();
      stage.contract(first + i, &row);
      stage.products +=
          3 * std::int64_t(band_pictures(*scene.spectra)) * std::int64_t(row.terms.size());
      write_bands_of_row(
          row, *scene.spectra,
          std::span(stage.result.rendering.whole.pixels)
              .subspan(std::size_t(first + i) * std::size_t(scene.width), std::size_t(scene.width)),
          std::span(values).subspan(std::size_t(i) * stride, stride));
    });
    worked += std::chrono::steady_clock::now() - start;
    take(first, std::span(values).first(std::size_t(count) * stride));
  }
  return stage.finish(worked);
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
