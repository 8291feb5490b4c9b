// refusal.h: the errors that a person can act on. Each names the place, what is wrong and the remedy.
#pragma once

#include <stdexcept>
#include <string>

namespace litmus {

/// Bad input (exit code 2). The message is complete: "file:line:column: field: what and what is allowed".
struct Refusal : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace litmus
