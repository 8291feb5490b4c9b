// commands.h: the subcommands. Each adds itself to the program with its options and stores its exit
// code.
#pragma once

#include <CLI/CLI.hpp>

namespace litmus {

/// What a command ends with. Bad usage and bad input (Refusal) are 2, an interrupt is 130.
enum ExitCode {
  kPass = 0,
  kOutOfTolerance = 1,
  kBadInput = 2,
  kIncomplete = 3,  ///< something was skipped, nothing failed
  kRendererFailed = 4,
};

void add_run(CLI::App& program, int& exit_code);
void add_render(CLI::App& program, int& exit_code);
void add_export(CLI::App& program, int& exit_code);
void add_reference(CLI::App& program, int& exit_code);
void add_compare(CLI::App& program, int& exit_code);
void add_list(CLI::App& program, int& exit_code);
void add_doctor(CLI::App& program, int& exit_code);

}  // namespace litmus
