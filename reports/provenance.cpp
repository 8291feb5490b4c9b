// provenance.cpp: reads off program, compiler and machine.
#include "reports/provenance.h"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <fstream>
#include <thread>

#include "commit.h"
#include "compare/image_io.h"
#include "scene/refusal.h"

namespace litmus {
namespace {

std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

std::string system_name() {
  utsname name{};
  uname(&name);
  std::ifstream file("/etc/os-release");
  for (std::string line; std::getline(file, line);) {
    constexpr std::string_view kKey = "PRETTY_NAME=\"";
    if (line.rfind(kKey, 0) == 0) {
      return fmt::format("{}, {} {}", line.substr(kKey.size(), line.size() - kKey.size() - 1),
                         name.sysname, name.machine);
    }
  }
  return fmt::format("{} {}", name.sysname, name.machine);
}

std::string image_version() {
  try {
    return image_library_version();
  } catch (const Refusal&) {
    return "cannot be opened";
  }
}

std::string version_of(const Driver& driver, bool asked) {
  if (!asked) return "not started: stored images alone";
  const auto installation = driver.find();
  return installation ? installation->version : "not installed";
}

}  // namespace

Provenance provenance_of(std::span<const Driver* const> drivers, bool asked) {
  Provenance provenance;
  provenance.litmus_version = LITMUS_VERSION;
  provenance.commit = LITMUS_COMMIT;
  provenance.compiler = LITMUS_COMPILER;
  provenance.flags = LITMUS_FLAGS;
  provenance.cpu = cpu_model();
  provenance.system = system_name();
  provenance.threads = int(std::thread::hardware_concurrency());
  for (const Driver* driver : drivers)
    provenance.versions.push_back({driver->title, version_of(*driver, asked)});
  provenance.versions.push_back({"OpenImageIO", image_version()});
  return provenance;
}

}  // namespace litmus
