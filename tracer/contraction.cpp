// contraction.cpp: runs of one object, and multiply-adds along them.
#include "tracer/contraction.h"

#include <algorithm>
#include <glm/mat3x3.hpp>

namespace litmus {
namespace {

/// Neighbouring samples of a row that show one object.
struct Run {
  std::size_t first, last;  ///< behind the last one
  std::size_t object;
};

std::vector<Run> runs_of(const std::vector<int>& objects) {
  std::vector<Run> runs;
  for (std::size_t x = 0; x < objects.size(); ++x) {
    if (objects[x] < 0) continue;
    if (x > 0 && objects[x] == objects[x - 1])
      runs.back().last = x + 1;
    else
      runs.push_back({x, x + 1, std::size_t(objects[x])});
  }
  return runs;
}

/// out[i] += factors[i] color. In plain numbers, of which the compiler makes vectors.
void add_products(const double* factors, const glm::dvec3& color, std::size_t count,
                  glm::dvec3* out) {
  const double r = color.r, g = color.g, b = color.b;
  double* const channels = &out->r;
  for (std::size_t i = 0; i < count; ++i) {
    channels[3 * i] += factors[i] * r;
    channels[3 * i + 1] += factors[i] * g;
    channels[3 * i + 2] += factors[i] * b;
  }
}

/// The runs of sample (i, j) of each pixel of row `y`.
std::vector<Run> runs_in(const Contraction& with, int i, int j, int y) {
  const int n = with.scene.samples;
  const Picture& objects = with.geometry.layers.front().picture;
  std::vector<int> seen;
  for (int x = 0; x < with.scene.width; ++x)
    seen.push_back(int(objects.at(x * n + i, y * n + j).x) - 1);
  return runs_of(seen);
}

/// Reads the terms of a layer in a run of sample (i, j): D, S and lamps in view.
void read_terms(const Contraction& with, std::size_t layer, const Run& run, int i, int j, int y,
                std::vector<glm::dvec3>& terms) {
  terms.assign(run.last - run.first, glm::dvec3(0, 0, 1));
  if (layer == 0) return;
  const int n = with.scene.samples;
  const Picture& picture = with.geometry.layers[layer].picture;
  for (std::size_t x = run.first; x < run.last; ++x)
    terms[x - run.first] = picture.at(int(x) * n + i, y * n + j);
}

/// Appends one channel of the terms from pixel `x` on, each times `share`; nothing where terms or
/// colours are 0 all along.
void append(std::size_t layer, std::size_t x, const std::vector<glm::dvec3>& terms, int channel,
            double share, const ThreeBands& colors, RowProducts& products) {
  const auto is_black = [](const glm::dvec3& color) { return color == glm::dvec3(0); };
  const auto is_nothing = [&](const glm::dvec3& term) { return term[channel] == 0; };
  if (std::all_of(terms.begin(), terms.end(), is_nothing) ||
      std::all_of(colors.begin(), colors.end(), is_black))
    return;
  const std::size_t begin = products.terms.size();
  for (const glm::dvec3& term : terms) products.terms.push_back(term[channel] * share);
  products.stretches.push_back({layer, x, begin, products.terms.size(), &colors});
}

}  // namespace

std::int64_t contract_row(const Contraction& with, int y, Rendering& colors,
                          RowProducts* products) {
  const int n = with.scene.samples;
  const std::size_t layers = with.scene.lights.size() + 1;
  const double share = 1.0 / (n * n);
  std::int64_t count = 0;
  std::vector<std::vector<Run>> samples;
  for (int s = 0; s < n * n; ++s) samples.push_back(runs_in(with, s % n, s / n, y));
  std::vector<glm::dvec3> whole(std::size_t(with.scene.width)), shown, terms;
  for (std::size_t layer = 0; layer < layers; ++layer) {
    shown.assign(whole.size(), glm::dvec3(0));
    for (int s = 0; s < n * n; ++s)
      for (const Run& run : samples[std::size_t(s)]) {
        const BandAnswer& answer = with.answers[run.object * layers + layer];
        read_terms(with, layer, run, s % n, s / n, y, terms);
        for (std::size_t x = run.first; x < run.last; ++x)
          shown[x] += answer.colors * terms[x - run.first];
        count += 3 * std::int64_t(terms.size());
        if (!products) continue;
        append(layer, run.first, terms, 0, share, answer.diffuse, *products);
        append(layer, run.first, terms, 1, share, answer.specular, *products);
        append(layer, run.first, terms, 2, share, answer.in_view, *products);
      }
    for (std::size_t x = 0; x < whole.size(); ++x) whole[x] += shown[x] *= share;
    std::copy(shown.begin(), shown.end(), &colors.layers[layer].picture.at(0, y));
  }
  std::copy(whole.begin(), whole.end(), &colors.whole.at(0, y));
  return count;
}

void multiply_row(const RowProducts& row, std::size_t picture, std::span<glm::dvec3> pixels) {
  for (const Stretch& one : row.stretches)
    add_products(&row.terms[one.begin], (*one.colors)[picture], one.end - one.begin,
                 &pixels[one.x]);
}

void multiply_bands(const std::vector<RowProducts>& rows, std::size_t picture, int width,
                    Layers& layers) {
  for (Layer& layer : layers) {
    layer.picture.width = width, layer.picture.height = int(rows.size());
    layer.picture.pixels.reserve(rows.size() * std::size_t(width));
  }
  for (const RowProducts& row : rows) {
    for (Layer& layer : layers)
      layer.picture.pixels.resize(layer.picture.pixels.size() + std::size_t(width));
    for (const Stretch& one : row.stretches) {
      std::vector<glm::dvec3>& pixels = layers[one.layer].picture.pixels;
      add_products(&row.terms[one.begin], (*one.colors)[picture], one.end - one.begin,
                   &pixels[pixels.size() - std::size_t(width) + one.x]);
    }
  }
}

}  // namespace litmus
