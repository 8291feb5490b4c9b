// panels.cpp: small renderings and differences for figures.
#include "reports/panels.h"

#include <algorithm>
#include <cmath>

#include "reports/pictures.h"
#include "reports/plain_text.h"
#include "scene/load.h"

namespace litmus {

Scene panel_scene(const std::string& name) {
  Scene scene = load_scene(find_scene(name));
  scene.height = scene.height * kPanelWidth / scene.width;
  scene.width = kPanelWidth;
  scene.samples = 2;
  return scene;
}

Rendering rendered(const Scene& scene, int threads) {
  RenderOptions options;
  options.threads = threads;
  return render(scene, options);
}

GalleryPanel panel(const std::string& label, const Picture& picture) {
  return {clean_text(label), picture_uri(picture), ""};
}

Picture apart(const Picture& a, const Picture& b) {
  Picture result(a.width, a.height);
  for (std::size_t i = 0; i < result.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) result.pixels[i][c] = std::abs(a.pixels[i][c] - b.pixels[i][c]);
  return result;
}

double brightest(const Picture& picture) {
  double most = 0;
  for (const glm::dvec3& p : picture.pixels) most = std::max({most, p.x, p.y, p.z});
  return most;
}

}  // namespace litmus
