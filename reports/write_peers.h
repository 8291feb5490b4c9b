// write_peers.h: litmus beside its peers, for people and for machines.
#pragma once

#include <string>

#include "reports/peers.h"
#include "reports/study.h"

namespace litmus {

/// A table a task: least time, the same a pixel or ray, and how many times the first row's it is,
/// with the least and the most of any repeat.
std::string peers_text(const std::vector<PeerTask>& tasks);

/// peers.json; its schema is reports/peers.schema.json.
std::string peers_json(const std::vector<PeerTask>& tasks, const PeerOptions& options,
                       const Provenance& provenance);

}  // namespace litmus
