// process.h: runs another program under limits and never leaves anything of it behind.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace litmus {

struct Command {
  std::vector<std::string> arguments;  ///< [0] is the program, by path or on PATH; never a shell
  std::filesystem::path directory;     ///< working directory, made if missing; also its HOME
  std::filesystem::path log;           ///< standard output and error, both; overwritten
  std::chrono::milliseconds time_limit = std::chrono::seconds{300};
  /// Address space (RLIMIT_AS) of each of its processes. Measured peaks for a small scene:
  /// Blender 3.4 0.9 GiB, POV-Ray 3.7 under 0.3 GiB.
  std::int64_t memory_limit_bytes = std::int64_t{8} << 30;
  /// Called about ten times a second while the program runs, to follow its log or pick up what is
  /// finished. May be empty. If it throws, the program is ended and the exception goes on.
  std::function<void()> while_running = {};
};

enum class Outcome { Exited, Signalled, TimedOut, NotStarted };

struct ProcessResult {
  Outcome outcome = Outcome::NotStarted;
  int code = 0;        ///< exit code, or signal number
  double seconds = 0;  ///< wall clock
  std::string
      explanation;  ///< one sentence for people: "povray exited with 1", "... stopped after 300 s"
  bool ok() const { return outcome == Outcome::Exited && code == 0; }
};

/// Runs the command in its own process group, waits, and ends the whole group: when the program
/// ends at once, on the time limit by SIGTERM and 2 s later by SIGKILL. Standard input is
/// /dev/null, no other descriptor is inherited, TMPDIR is directory/tmp, the locale is C.UTF-8,
/// XDG_* is unset, no core is written. Several threads may run processes at once. Never throws for
/// what the program does.
///
/// If litmus is killed (even -9), so is the program: a parent-death signal, which Linux ties to the
/// thread that called run_process, and that thread is waiting here. The signal reaches the program
/// itself; processes that it started in turn outlive such a kill (but no other ending). Neither
/// POV-Ray nor Blender starts any.
ProcessResult run_process(const Command& command);

/// From now on SIGINT, SIGTERM and SIGHUP end every running group before they end litmus by the
/// same signal (a shell reports 130 for SIGINT). For main() to call, once; a library user may leave
/// it.
void end_processes_on_interrupt();

/// The last `lines` lines of a log, for messages; progress overwritten by '\r' counts as lines.
/// Empty if there is no such file.
std::string tail(const std::filesystem::path& log, int lines = 20);

/// The full path of a program on PATH (or of a path with a slash), or empty.
std::filesystem::path find_program(const std::string& name);

}  // namespace litmus
