// compare_scene.h: one scene of a study, against everything that was obtained for it.
#pragma once

#include <cstddef>
#include <span>
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

/// The other sides of one scene.
struct SceneSources {
  std::vector<ObtainedReference> references;  ///< one per driver
  std::span<const ExtraSource> extras;        ///< of all scenes
  std::size_t index = 0;                      ///< the scene's place among the results of `extras`
};

/// The study of `scene` alone, without provenance: its case, its rows, and who is to blame for
/// those that fail. `ours` is the scene as it was rendered. Scenes do not depend on each other, and
/// calls may run at the same time.
Study compare_scene(const Scene& scene, RenderedScene ours, const SceneSources& sources,
                    const StudyOptions& options);

}  // namespace litmus
