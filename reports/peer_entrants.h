// peer_entrants.h: who takes part in which task (peers.h).
#pragma once

#include "reports/counted.h"
#include "reports/peers.h"
#include "reports/rates.h"
#include "scene/picture.h"
#include "scene/scene.h"

namespace litmus {

struct Entrant {
  std::string name;
  std::function<double()> measure;  ///< does it once: seconds of processor time; throws if it fails
  std::string missing = {};         ///< why it cannot, or empty
  double triangles = 0;             ///< as in PeerRow
};

/// Lets all do the task once a repeat, one after the other. One that fails is missing from then on.
PeerTask take_turns(PeerTask task, const std::vector<Entrant>& entrants,
                    const PeerOptions& options);

/// The least of several measurements, for about a tenth of a second.
double least_of(const std::function<double()>& measure);

/// litmus in packets of doubles, in packets of floats, and pixel by pixel: rows of pixels, the
/// scene ready. A picture each, without layers and signatures.
std::vector<Entrant> kernel_entrants(const Scene& scene);

/// The operations of the pixels of a picture without triangles, in double precision. Writes the
/// picture, which is that of the other kernels bit by bit, where one is given.
Operations counted_operations(const Scene& scene, Picture* picture = nullptr);

/// The least time for the operations of the picture in double precision, counted (counted.h), at
/// the rates that this processor reaches (rates.h): nothing waits for anything, comparisons and
/// memory are free. Multiplications and additions are fused only where the formulas ask for it.
Entrant limit_entrant(const Operations& operations, const ArithmeticRates& rates);
/// The operations of a pixel and the rates, in words; nothing where there are no rates.
std::vector<std::string> limit_notes(const Operations& operations, const ArithmeticRates& rates,
                                     double pixels);

/// POV-Ray, a square stage (stage.h) under light_source blocks, one thread: the processor time of
/// tracing that it prints, in steps of a millisecond, without parsing and start-up.
Entrant povray_entrant(const std::string& name, const Scene& scene, const std::string& lights,
                       const PeerOptions& options);
/// The spheres, boxes and planes of a stage and its first material, as somebody would write them
/// for POV-Ray; `right -x` makes its coordinates right-handed.
std::string povray_stage(const Scene& scene);
/// A light_source for each sample of the scene's light, which is a point or an area.
std::string povray_lamps(const Scene& scene);
/// The scene's area light as one light_source with area_light.
std::string povray_area_light(const Scene& scene);

/// Cycles, the native export (exporters/blender.h), one thread: what a sample a pixel more costs.
/// Measured as a quarter of the difference between 5 samples and 1, so that neither start-up nor
/// preparing the scene counts.
Entrant cycles_entrant(const Scene& scene, const PeerOptions& options);

/// A mesh of about that many triangles seen and lit: primary rays, then shadow rays.
std::vector<PeerTask> mesh_tasks(int triangles, int size, const PeerOptions& options);

/// A primary ray by the number of triangles, litmus and Embree: rows are compared with their own
/// smallest mesh.
std::vector<PeerTask> growth_tasks(const std::vector<int>& triangles, int size,
                                   const PeerOptions& options);

}  // namespace litmus
