// write_peers.h: litmus beside its peers, for people and for machines.
#pragma once

#include <string>

#include "reports/peers.h"
#include "reports/study.h"

namespace litmus {

/// "12.0 ns", "1.30 us".
std::string short_time(double seconds);

/// A table a task: least time, the same a pixel or ray, and how many times the first row's it is,
/// with the least and the most of any repeat.
std::string peers_text(const std::vector<PeerTask>& tasks);

/// peers.json; its schema is reports/peers.schema.json.
std::string peers_json(const std::vector<PeerTask>& tasks, const PeerOptions& options,
                       const Provenance& provenance);

/// peers.html: the same tables, and how the cost of a ray grows with the triangles of a mesh.
std::string peers_html(const std::vector<PeerTask>& tasks, const PeerOptions& options,
                       const Provenance& provenance);

}  // namespace litmus
