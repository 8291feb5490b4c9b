// process.h: runs another program under limits and never leaves anything of it behind.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace litmus {

struct Command {
  std::vector<std::string> arguments;       ///< [0] is the program; never a shell
  std::filesystem::path directory;          ///< working directory; also its HOME
  std::filesystem::path log;                ///< standard output and error, both
  std::chrono::seconds time_limit{300};
  std::int64_t memory_limit_bytes = std::int64_t{8} << 30;
};

enum class Outcome { Exited, Signalled, TimedOut, NotStarted };

struct ProcessResult {
  Outcome outcome = Outcome::NotStarted;
  int code = 0;         ///< exit code, or signal number
  double seconds = 0;   ///< wall clock
  std::string explanation;  ///< one sentence for people: "povray exited with 1", "was stopped after 300 s"
  bool ok() const { return outcome == Outcome::Exited && code == 0; }
};

/// Runs the command in its own process group, waits, and ends the whole group: on the time limit by
/// SIGTERM, 2 s later by SIGKILL. The child dies with litmus (parent-death signal).
ProcessResult run_process(const Command& command);

/// The last `lines` lines of a log, for messages.
std::string tail(const std::filesystem::path& log, int lines = 20);

/// The full path of a program on PATH, or empty.
std::filesystem::path find_program(const std::string& name);

}  // namespace litmus
