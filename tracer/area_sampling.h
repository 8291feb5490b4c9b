// area_sampling.h: the ways to put samples on an area light, and renders that use them.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "tracer/render.h"

namespace litmus {

/// The samplers in order: scene, centres, corners, gauss-legendre, jittered, r2, certified.
inline constexpr Sampler kSamplers[] = {Sampler::Scene,    Sampler::Centres,  Sampler::Corners,
                                        Sampler::Gauss,    Sampler::Jittered, Sampler::R2,
                                        Sampler::Certified};

/// "scene", "centres", "corners", "gauss-legendre", "jittered", "r2" or "certified".
std::string_view sampler_name(Sampler sampler);

/// Whether the scene stands for integrals over area lights, so that their samples may be chosen: it
/// has an area light, and shading is not "sample-code", where each sample counts as a light.
bool integrates_area_lights(const Scene& scene);

/// A sample on a rectangle of sides 1 around (0, 0): u along `right`, v along `up` (slide 20).
struct LightSample {
  double u, v;    ///< -1/2 to 1/2
  double weight;  ///< all of a rectangle's weights add up to 1
};

/// n * n samples of weight 1 / n^2 (Gauss-Legendre: the products of its weights). `pixel` decides
/// about the samples of `jittered` (one uniform in each cell of the grid) and the shift of `r2`
/// (Roberts 2018, modulo 1); the same pixel always has the same. Neither for the scene's own grid
/// nor for the certified sampler, which has no fixed points.
std::vector<LightSample> light_samples(Sampler sampler, int n, std::uint64_t pixel);

/// What render() does where options.sampler or options.area_samples ask for other samples than the
/// scene's own. Throws Refusal for what the samplers off the grid cannot do: precisions other than
/// double, and shading = "sample-code", where each sample of an area light counts as a light.
Rendering render_with_sampler(const Scene& scene, const RenderOptions& options);

}  // namespace litmus
