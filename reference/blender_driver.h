// blender_driver.h: renders scenes with Blender's Cycles, all of them in one process.
#pragma once

#include <string>

#include "reference/drivers.h"

namespace litmus {

/// Blender as a record for the table of drivers.
///
/// One process runs the exported script of each scene in turn (a start takes 1.3 s, a small frame
/// 10 ms). A script that fails loses its own scene only; if the process itself ends early or meets
/// the time limit, a new one goes on with the scene it was busy with, and that scene has failed if
/// this ends the new one, too.
///
/// Frames are 32-bit float EXR, rendered with `samples` x `samples` pixels for each of the picture
/// and averaged in double; the frames of an area light are added up in double.
///
/// `seconds` is what Cycles prints as "Total render time" (--debug-cycles), all frames together:
/// synchronising the scene, building its acceleration structure and tracing; not Python, not files.
Driver blender_driver();

/// Seconds of rendering in a log of Blender, between the lines "litmus begin N" and "litmus end N".
double blender_render_seconds(const std::string& log, std::size_t scene);
/// Seconds of rendering in a whole log.
double cycles_render_seconds(const std::string& log);

/// The script that runs the scripts 0000.py, 0001.py, ... of a folder one after the other, each
/// with OUTDIR 0000, 0001, ...; behind "--" it expects the numbers of the scenes to do.
std::string blender_batch();

}  // namespace litmus
