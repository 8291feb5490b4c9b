// drivers.cpp: the table of reference renderers. A fourth renderer is one row here.
#include "reference/drivers.h"

#include <array>

#include "reference/blender_driver.h"
#include "reference/povray_driver.h"

namespace litmus {

std::span<const Driver> drivers() {
  static const std::array table{povray_driver(), blender_driver()};
  return table;
}

const Driver* find_driver(std::string_view name) {
  for (const auto& driver : drivers())
    if (driver.name == name) return &driver;
  return nullptr;
}

}  // namespace litmus
