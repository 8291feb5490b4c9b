// exact_probe.cpp: the pixel loop of one pixel in quad precision.
#include "tracer/exact_probe.h"

#include <memory>

#include "tracer/pixels.h"

namespace litmus {

Probe exact_probe(const Scene& scene) {
  const auto plan = std::make_shared<const Plan<Quad>>(lower<Quad>(scene));
  return [plan](double x, double y) {
    const View<Quad>& view = plan->view;
    const std::size_t layers = plan->sources.size() + 1;
    const int n = view.samples;
    std::vector<Vec<Quad>> totals(layers);
    for (int sample = 0; sample < n * n; ++sample) {
      const Quad dx = (Quad(sample % n) + 0.5) / n - 0.5, dy = (Quad(sample / n) + 0.5) / n - 0.5;
      look(*plan, Quad(2 * (x + dx) / view.width - 1), Quad(1 - 2 * (y + dy) / view.height),
           [&](std::size_t k, const Seen<Quad>& seen) { totals[k] = totals[k] + seen.color; });
    }
    std::vector<glm::dvec3> colors;
    for (const Vec<Quad>& total : totals) colors.push_back(to_double(total / Quad(n * n)));
    return colors;
  };
}

}  // namespace litmus
