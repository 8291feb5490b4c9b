// peers.h: litmus beside other renderers and beside what its arithmetic allows, in one run.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace litmus {

/// One way to do a task, or a bound on it.
struct PeerRow {
  std::string name;
  std::string missing;          ///< why it was not measured; empty if it was
  std::vector<double> seconds;  ///< of each repeat: processor time, without any start-up
  double triangles = 0;         ///< of its mesh, where the rows of a task differ in it

  double least() const;
};

/// How many times the first row's time another takes.
struct PeerRatio {
  double median = 0, least = 0, most = 0;  ///< over the repeats, of the ratio within a repeat
};

/// One task, done by all rows. The others are compared with the first.
struct PeerTask {
  std::string name;   ///< "point", for machines
  std::string title;  ///< "Point light, 1024 x 1024"
  std::string unit;   ///< what is counted: "pixel", "ray"
  double units = 0;   ///< of them in what is timed
  std::vector<PeerRow> rows;
  std::vector<std::string> notes;  ///< what else there is to say, a sentence each

  /// Zeros if either row is missing.
  PeerRatio ratio(const PeerRow& row) const;
};

struct PeerOptions {
  int repeats = 7;
  bool quick = false;          ///< pictures of a sixteenth of the size, without the largest meshes
  std::filesystem::path work;  ///< a folder for what other programs read and write
  std::function<void(const std::string&)> progress = {};  ///< may be empty
};

/// A point light and an 8 x 8 area light (POV-Ray, Cycles, the arithmetic limit); primary and
/// shadow rays of meshes (Embree); how both grow with the number of triangles. One thread each,
/// every row once a repeat, in turns, so that a busy machine slows all alike.
std::vector<PeerTask> measure_peers(const PeerOptions& options);

/// Whether every row was measured.
bool complete(const std::vector<PeerTask>& tasks);

}  // namespace litmus
