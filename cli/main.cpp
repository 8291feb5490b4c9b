// main.cpp: the program litmus, a table of subcommands.
#include <cstdio>
#include <exception>
#include <string>

#include "cli/commands.h"
#include "cli/stress.h"
#include "reference/process.h"
#include "tracer/self_check.h"

int main(int argc, char** argv) {
  using namespace litmus;
  end_processes_on_interrupt();
  if (const std::string fault = arithmetic_fault(); !fault.empty()) {
    std::fprintf(stderr, "litmus: this process does not compute as IEEE 754 says: %s\n",
                 fault.c_str());
    return kBadInput;
  }
  void (*const commands[])(Program&) = {add_run,       add_render,  add_explain, add_export,
                                        add_reference, add_compare, add_approve, add_list,
                                        add_stress,    add_cost,    add_doctor};
  try {
    return run_program(
        argc, argv,
        "litmus compares the lighting and shadows of small scenes with POV-Ray and Blender, light "
        "by light.\nScenes are named by path or by canonical name (litmus list).",
        "Exit codes: 0 pass, 1 out of tolerance, 2 bad usage or input, 3 incomplete, 4 a renderer "
        "failed.\nExample: litmus run d2-sun-sphere --references live",
        commands);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "litmus: %s\n", error.what());
    return kBadInput;
  }
}
