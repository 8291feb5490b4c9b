// compare_scene.h: one scene of a study, against everything that was obtained for it.
#pragma once

#include <cstddef>
#include <vector>

#include "reports/candidates.h"
#include "reports/study.h"
#include "tracer/bands.h"

namespace litmus {

/// Our side of one scene: what was rendered, perhaps with a control's mistake, and how.
struct RenderedScene {
  Scene scene;
  RenderOptions options;
  BandRendering bands;
};

/// The other sides of all scenes, each with a result per scene.
struct ObtainedSources {
  std::vector<std::vector<ObtainedReference>> references;
  std::vector<ExtraSource> extras;
};

/// The study of `scene` alone, without provenance: its case, its rows, and who is to blame for those
/// that fail. `index` is its place among the results of `sources`; `ours` is the scene as it was
/// rendered. Scenes do not depend on each other, and calls may run at the same time.
Study compare_scene(const Scene& scene, std::size_t index, RenderedScene ours,
                    const ObtainedSources& sources, const StudyOptions& options);

}  // namespace litmus
