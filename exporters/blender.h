// blender.h: writes a scene as a Python script for Blender 3.4 and its renderer Cycles.
//
// The exact export builds the scene of the model out of Cycles' own parts: SUN and POINT lamps, the
// Diffuse BSDF, true spheres (points of a point cloud), meshes. Attenuation and cones are lamp
// nodes, the specular term is the colour of a BSDF. One frame of the timeline is one lamp, because
// with several lamps Cycles picks one at random; the frames are to be added up.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace litmus {

/// What one frame of an export shows; frame number k of the timeline (from 1) is element k - 1.
struct BlenderFrame {
  int light = -1;  ///< index into Scene::lights, -1: ambient light alone
  int sample = 0;  ///< of an area light, in the order of area_samples()
};

/// Frame 1 is ambient, then each light in order, an area light with a frame for each sample.
std::vector<BlenderFrame> blender_frames(const Scene& scene);

/// The exact mapping. The script saves a .blend that renders without Python, and renders every
/// frame to a 32-bit float EXR: `samples` times larger than the scene says, so the mean of samples
/// x samples pixels is one pixel of the scene. Throws Refusal for shading = "sample-code" and for
/// pictures of fewer than 4 pixels a side, which Blender does not render.
void write_blender(const Scene& scene, std::ostream& out);

/// What a user of Blender would write, at best fit: SPOT, AREA, Diffuse and Glossy BSDF. The same
/// frames, but an area light has one. The header comment says what is not the model's.
void write_blender_native(const Scene& scene, std::ostream& out);
/// The same with so many samples a pixel, where there is an area light.
void write_blender_native_sampled(const Scene& scene, std::ostream& out, int area_rays);

/// What the exact export cannot express exactly in this scene; empty where it is exact.
std::vector<std::string> blender_caveats(const Scene& scene);

/// The name without folder and ending of the files that a scene's script writes: letters, digits,
/// '-', '_' and '.' of its name, "scene" if nothing is left.
std::string blender_stem(const Scene& scene);

/// The Python functions that the exact (the native) scripts begin with.
extern const std::string_view kBlenderPrelude;
extern const std::string_view kBlenderNativePrelude;

}  // namespace litmus
