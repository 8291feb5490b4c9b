// controls.h: known mistakes that are put into our side only, to show that the gates see them.
#pragma once

#include <span>
#include <string_view>

#include "scene/scene.h"
#include "tracer/bands.h"

namespace litmus {

/// A negative control, a mistake or a misreading of the slides: a run with it must fail on the rows
/// that the mistake touches and on no other.
struct Control {
  std::string_view name, about;
  void (*apply)(Scene&, RenderOptions&);
  /// For mistakes that no scene can express: changes the layers that were rendered of a scene
  /// without spectra. Often null.
  void (*alter)(const Scene&, Layers&) = nullptr;
};

/// All controls, in the order of --help.
std::span<const Control> controls();

/// nullptr if there is no such control.
const Control* find_control(std::string_view name);

/// Renders a scene as the control has it (nullptr: as it is), with the layers of every three bands
/// where it has spectra. `scene` and `options` are changed to those that were rendered.
BandRendering render_with(const Control* control, Scene& scene, RenderOptions& options);

}  // namespace litmus
