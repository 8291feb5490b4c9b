// provenance_json.cpp: the members of a provenance, one by one.
#include "reports/provenance_json.h"

#include "reports/plain_text.h"

namespace litmus {

nlohmann::ordered_json provenance_fields(const Provenance& p) {
  nlohmann::ordered_json versions = nlohmann::ordered_json::array();
  for (const auto& [name, version] : p.versions)
    versions.push_back({{"name", clean_text(name)}, {"version", clean_text(version)}});
  return {{"litmus_version", p.litmus_version},
          {"commit", p.commit},
          {"compiler", p.compiler},
          {"flags", p.flags},
          {"cpu", clean_text(p.cpu)},
          {"system", clean_text(p.system)},
          {"command", clean_text(p.command)},
          {"started", p.started},
          {"threads", p.threads},
          {"seconds", p.seconds},
          {"versions", versions}};
}

}  // namespace litmus
