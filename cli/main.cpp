// main.cpp: the program litmus, a table of subcommands.
#include <cstdio>
#include <exception>

#include "cli/commands.h"
#include "reference/process.h"

int main(int argc, char** argv) {
  using namespace litmus;
  end_processes_on_interrupt();
  void (*const commands[])(Program&) = {add_run,       add_render,  add_explain, add_export,
                                        add_reference, add_compare, add_approve, add_cost,
                                        add_list,      add_doctor};
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
