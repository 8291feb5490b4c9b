// area_sampling.cpp: where the samples lie.
#include "tracer/area_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tracer/gauss.h"
#include "tracer/lights.h"

namespace litmus {
namespace {

/// The finaliser of splitmix64 (Steele et al. 2014): a number in [0, 1) for each counter.
double uniform(std::uint64_t counter) {
  std::uint64_t z = (counter + 1) * 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return double((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/// Two numbers in [0, 1) for sample `sample` of a pixel.
std::array<double, 2> uniform_pair(std::uint64_t pixel, std::uint64_t sample) {
  const std::uint64_t counter = (pixel << 24) + 2 * sample;
  return {uniform(counter), uniform(counter + 1)};
}

std::vector<LightSample> grid(int n, Placement placement) {
  std::vector<LightSample> samples;
  for (int row = 0; row < n; ++row)
    for (int column = 0; column < n; ++column)
      samples.push_back({grid_position<double>(column, n, placement),
                         grid_position<double>(row, n, placement), 1.0 / (double(n) * n)});
  return samples;
}

std::vector<LightSample> gauss_legendre(int n) {
  const GaussRule rule = gauss_rule(n);
  std::vector<LightSample> samples;
  for (std::size_t row = 0; row < rule.nodes.size(); ++row)
    for (std::size_t column = 0; column < rule.nodes.size(); ++column)
      samples.push_back(
          {rule.nodes[column] / 2, rule.nodes[row] / 2, rule.weights[column] * rule.weights[row]});
  return samples;
}

std::vector<LightSample> jittered(int n, std::uint64_t pixel) {
  std::vector<LightSample> samples = grid(n, Placement::Centres);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto [x, y] = uniform_pair(pixel, i);
    samples[i].u += (x - 0.5) / n;
    samples[i].v += (y - 0.5) / n;
  }
  return samples;
}

/// Roberts 2018 ("The unreasonable effectiveness of quasirandom sequences"): multiples of the
/// inverse powers of the plastic number, shifted per pixel (Cranley and Patterson 1976).
std::vector<LightSample> r2(int n, std::uint64_t pixel) {
  constexpr double kPlastic = 1.32471795724474602596;
  const auto [shift_x, shift_y] = uniform_pair(pixel, 0);
  const auto fraction = [](double x) { return x - std::floor(x); };
  std::vector<LightSample> samples;
  for (int i = 0; i < n * n; ++i)
    samples.push_back({fraction(shift_x + i / kPlastic) - 0.5,
                       fraction(shift_y + i / (kPlastic * kPlastic)) - 0.5, 1.0 / (double(n) * n)});
  return samples;
}

}  // namespace

bool integrates_area_lights(const Scene& scene) {
  const bool area = std::ranges::any_of(scene.lights, [](const Light& light) {
    return std::holds_alternative<AreaLight>(light.shape);
  });
  return area && scene.shading == Shading::Equation;
}

std::string_view sampler_name(Sampler sampler) {
  static constexpr std::string_view kNames[] = {"scene",    "centres", "corners",  "gauss-legendre",
                                                "jittered", "r2",      "certified"};
  return kNames[std::size_t(sampler)];
}

std::vector<LightSample> light_samples(Sampler sampler, int n, std::uint64_t pixel) {
  switch (sampler) {
    case Sampler::Centres:
      return grid(n, Placement::Centres);
    case Sampler::Corners:
      return grid(n, Placement::Corners);
    case Sampler::Gauss:
      return gauss_legendre(n);
    case Sampler::Jittered:
      return jittered(n, pixel);
    case Sampler::R2:
      return r2(n, pixel);
    case Sampler::Scene:
    case Sampler::Certified:
      break;
  }
  return {};
}

}  // namespace litmus
