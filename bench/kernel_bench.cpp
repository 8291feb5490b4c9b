// kernel_bench.cpp: pictures per second by kernel, effects, area grid and size of a mesh.
//
// build/litmus_bench --benchmark_filter=... ; compare the lines of one run, not those of two.
#include <benchmark/benchmark.h>

#include "reports/stage.h"
#include "scene/load.h"
#include "scene/observer.h"
#include "tracer/bands.h"
#include "tracer/kernel.h"
#include "tracer/pixels.h"
#include "tracer/render.h"

namespace litmus {
namespace {

/// Renders row by row on this thread; the scene is lowered before. Rendering the whole alone: no
/// layers, no signatures.
template <Real R>
void add(const std::string& name, const Scene& scene, const Effects& effects, RowRenderer<R> row) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
    Plan<R> plan = lower<R>(scene, effects);
    plan.edges = false;
    RenderOptions options;
    options.layers = options.edges = false;
    Rendering picture;
    picture.whole = Picture(plan.view.width, plan.view.height);
    for (auto _ : state) {
      for (int y = 0; y < plan.view.height; ++y) row(plan, options, y, picture, nullptr);
      benchmark::ClobberMemory();
    }
  })->Unit(benchmark::kMillisecond);
}

/// The widest kernel's rows, or the scalar ones.
RowRenderer<double> fastest() {
  return packet_kernels().empty() ? render_row<double, double> : packet_kernels()[0].double_row;
}

void add_kernels(const std::string& name, const Scene& scene) {
  const Effects effects = effects_of(scene);
  add<double>(name + "/scalar", scene, effects, render_row<double, double>);
  for (const PacketKernel& kernel : packet_kernels()) {
    const std::string target(kernel.target);
    add<double>(name + "/" + target, scene, effects, kernel.double_row);
    add<float>(name + "/" + target + "-float", scene, effects, kernel.float_row);
  }
}

/// A whole render() on so many threads; its time is that of the pixels, by the clock on the wall.
void add_threads(const std::string& name, const Scene& scene, int threads) {
  benchmark::RegisterBenchmark(name.c_str(),
                               [=](benchmark::State& state) {
                                 RenderOptions options;
                                 options.threads = threads, options.layers = options.edges = false;
                                 for (auto _ : state)
                                   state.SetIterationTime(render(scene, options).seconds);
                               })
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}

/// A scene in 40 bands, each of them its red.
Scene in_bands(Scene scene) {
  const auto all = [](const Color& color) { return std::vector<double>(kDefaultBands, color.r); };
  Spectra& spectra = scene.spectra.emplace();
  spectra.bands = kDefaultBands, spectra.ambient = all(scene.ambient);
  spectra.xyz = band_xyz(gaussian_observer(), constant_spectrum(1), kDefaultBands);
  for (const Material& one : scene.materials)
    spectra.materials.push_back({all(one.ambient), all(one.diffuse), all(one.specular)});
  for (const Light& one : scene.lights)
    spectra.lights.push_back({all(one.ambient), all(one.diffuse), all(one.specular)});
  return scene;
}

/// A spectral scene in all its bands against the same scene in plain colours, on one thread.
void add_bands(const std::string& name, const Scene& spectral) {
  Scene plain = spectral;
  plain.spectra.reset();
  const RenderOptions options{.precision = Precision::Double, .threads = 1};
  benchmark::RegisterBenchmark((name + "/plain").c_str(), [=](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(render(plain, options));
  })->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark((name + "/bands").c_str(), [=](benchmark::State& state) {
    for (auto _ : state)
      benchmark::DoNotOptimize(render_band_rows(spectral, options, [](int, auto) {}));
  })->Unit(benchmark::kMillisecond);
}

}  // namespace
}  // namespace litmus

int main(int argc, char** argv) {
  using namespace litmus;
  add_kernels("point/1024", point_stage(1024));
  add_kernels("area8x8/512", area_stage(512, 8));
  const Scene diffuse = diffuse_stage(1024);
  add<double>("diffuse/1024/every-effect", diffuse, all_effects(), fastest());
  add<double>("diffuse/1024/needed-effects", diffuse, effects_of(diffuse), fastest());
  for (const int threads : {1, 2}) {
    add_threads("threads/" + std::to_string(threads), area_stage(512, 8), threads);
  }
  for (const int triangles : {1'000, 10'000, 100'000, 200'000, 2'000'000}) {
    Scene mesh = mesh_stage(512, triangles);
    const std::string name = "mesh/512/" + std::to_string(triangles);
    add<double>(name + "/shaded", mesh, effects_of(mesh), fastest());
    mesh.lights.clear();
    add<double>(name + "/primary", mesh, effects_of(mesh), fastest());
  }
  for (const std::string name : {"w1", "w2", "w3", "w4"})
    add_bands(name, load_scene(find_scene(name)));
  for (const std::string name : {"d2", "x2"})
    add_bands(name, in_bands(load_scene(find_scene(name))));
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
