// commands.h: the subcommands. Each adds itself to the program, with its options.
#pragma once

#include <memory>

#include "cli/options.h"

namespace litmus {

/// What a command ends with. Bad usage and bad input (Refusal) are 2, an interrupt is 130.
enum ExitCode {
  kPass = 0,
  kOutOfTolerance = 1,
  kBadInput = 2,
  kIncomplete = 3,  ///< something was skipped, nothing failed
  kRendererFailed = 4,
};

void add_run(Program& program);
void add_render(Program& program);
void add_explain(Program& program);
void add_export(Program& program);
void add_reference(Program& program);
void add_compare(Program& program);
void add_approve(Program& program);
void add_cost(Program& program);
void add_list(Program& program);
void add_doctor(Program& program);

}  // namespace litmus
