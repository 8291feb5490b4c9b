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
/// `seconds` is the time of rendering alone, as the renderer prints it.
std::span<const Driver> native_drivers();

/// "povray-native" with `adaptive` on its area lights (-1: without), and with antialiasing by n x n
/// samples in every pixel (`+A0.0 +AM1 +Rn`; 0: without).
Driver povray_native_driver(int adaptive, int antialiasing);

/// "blender-native" with so many samples a pixel where there is an area light.
Driver blender_native_driver(int area_rays);

}  // namespace litmus
