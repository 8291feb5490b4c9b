// expect.h: the words of a scene's [expect] table.
#pragma once

#include <span>
#include <string_view>

#include "scene/scene.h"

namespace litmus {

struct OracleName {
  Oracle oracle;
  std::string_view name;   ///< in scene files and reports
  std::string_view about;  ///< one sentence: what it says of a picture
};

/// All closed forms, in the order of Oracle.
std::span<const OracleName> oracle_names();

std::string_view name_of(Oracle oracle);

}  // namespace litmus
