// povray.h: writes a scene in POV-Ray's language, exactly, one animation frame per layer.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace litmus {

/// The exact mapping (POV-Ray 3.7). Frame 1 is the ambient light, frame k + 1 is light k alone: the
/// frames are the layers, in order. Where all lights can shine at once, frame 0 (no animation) is
/// the whole picture; else frame 0 is refused by an `#error` in the file. The scene is moved into
/// the envelope (envelope.h).
///
/// A frame's pixels are the layer's times povray_gain(). The file can be included by another one
/// that declares `Layer` (the frame) or `Boost` (a factor on all light) first; it declares `Eye`,
/// `Forward`, `PictureRight` and `PictureUp`, the picture's edges at distance 1.
/// Throws Refusal for `shading = "sample-code"`.
void write_povray(const Scene& scene, std::ostream& out);

/// What a user of POV-Ray would write: spotlight, area_light, fade_distance at best fit, same
/// frames and gains. The header says what differs from the model and by how much.
void write_povray_native(const Scene& scene, std::ostream& out);
/// The same with `adaptive LEVEL` (0 and more) on every area_light: POV-Ray then traces rays to the
/// corners first and more where they disagree.
void write_povray_native_adaptive(const Scene& scene, std::ostream& out, int level);

/// What the exact mapping leaves inexact for this scene; mostly nothing.
std::vector<std::string> povray_caveats(const Scene& scene);

/// The power of two by which a frame is brighter than the layer, so that it fills 16 bits and does
/// not clip: at most 1 / the brightest value that a layer's materials allow. `layer` as in Layers:
/// 0 is ambient, k is light k - 1.
double povray_gain(const Scene& scene, std::size_t layer);

/// The arguments behind `povray` that render all frames of FILE.pov (16-bit linear PNG, the scene's
/// width and height times its samples): FILE1.png, FILE2.png, ..., with zeros before if ten or
/// more; FILE.png, the ambient frame, if there are no lights.
std::vector<std::string> povray_arguments(const Scene& scene, const std::string& stem);

}  // namespace litmus
