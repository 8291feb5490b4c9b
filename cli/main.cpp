// main.cpp: the program litmus, a table of subcommands.
#include <cstdio>

#include "cli/commands.h"
#include "reference/process.h"
#include "scene/refusal.h"

int main(int argc, char** argv) {
  using namespace litmus;
  end_processes_on_interrupt();
  CLI::App program{
      "litmus compares the lighting and shadows of small scenes with POV-Ray and Blender, light by "
      "light.\n"
      "Scenes are named by path or by canonical name (litmus list)."};
  program.name("litmus");
  program.set_version_flag("--version", LITMUS_VERSION);
  program.require_subcommand(1);
  program.footer(
      "Exit codes: 0 pass, 1 out of tolerance, 2 bad usage or input, 3 incomplete, 4 a renderer "
      "failed.\n"
      "Example: litmus run d2-sun-sphere --references live");
  int exit_code = kPass;
  for (const auto add :
       {add_run, add_render, add_export, add_reference, add_compare, add_list, add_doctor}) {
    add(program, exit_code);
  }
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? kPass : kBadInput;
  } catch (const Refusal& refusal) {
    std::fprintf(stderr, "litmus: %s\n", refusal.what());
    return kBadInput;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "litmus: %s\n", error.what());
    return kBadInput;
  }
  return exit_code;
}
