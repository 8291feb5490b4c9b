// native_drivers.h: POV-Ray and Blender with lights of their own kinds, as a user would set them
// up.
#pragma once

#include <span>

#include "reference/drivers.h"

namespace litmus {

/// "povray-native" and "blender-native": the exports of `litmus export --native`, rendered. They
/// are not the model's pictures and are not meant to be: how far they are is what they are for.
///
/// One process per scene, several at a time. POV-Ray's frames are 16-bit linear PNG (steps of
/// 1.5e-5 of a frame's brightest value), Blender's 32-bit EXR, area lights sampled at random.
/// `seconds` is the wall clock of the process, its start included.
std::span<const Driver> native_drivers();

}  // namespace litmus
