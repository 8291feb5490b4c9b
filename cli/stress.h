// stress.h: the subcommand that puts formulas and rays to hard cases.
#pragma once

#include "cli/options.h"

namespace litmus {

void add_stress(Program& program);

}  // namespace litmus
