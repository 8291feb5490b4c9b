// povray_driver.h: renders scenes with POV-Ray, far below the steps of its own file formats.
#pragma once

#include <string>

#include "reference/drivers.h"

namespace litmus {

/// POV-Ray as a record for the table of drivers.
///
/// Each scene is one animation (one frame per layer), rendered twice: first as 16-bit linear PNG,
/// then as half-float EXR of what that left out. In the second pass all light is 65536 times as
/// strong and a screen before the camera takes the first picture off, times 65536. Their sum has
/// the accuracy of POV-Ray's own arithmetic (single-precision colours, about 1e-7), where the PNG
/// alone has 7.6e-6 and the EXR alone 2.4e-4.
///
/// POV-Ray sleeps for most of a start (0.65 s) and of a frame (0.23 s), so several processes run at
/// once, each with one scene: one that fails takes no other with it.
///
/// `seconds` is the CPU time of tracing in both passes, as POV-Ray prints it.
Driver povray_driver();

/// The file of the second pass, which includes the scene's own from "scene.pov" and the first
/// pass's pictures from "scene1.png", "scene2.png", ...
std::string povray_residual(const Scene& scene);

/// CPU seconds of tracing in a log of POV-Ray, all frames together.
double povray_trace_seconds(const std::string& log);

}  // namespace litmus
