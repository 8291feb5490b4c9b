// options.h: what the subcommands need of CLI11, which takes ten seconds to compile in each file
// that includes it. Only options.cpp does.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace litmus {

/// One option of a subcommand; each call returns the option itself. A value that does not fit is
/// refused with the option's name, exit code 2.
struct Option {
  CLI::Option* option;

  Option required();
  Option one_of(const std::vector<std::string>& words);
  Option between(double low, double high);  ///< both included
  Option separated_by(char delimiter);      ///< lists: also within one argument
  Option at_least(int values);              ///< lists
  Option with_default();                    ///< --help shows the value it has now
};

/// A subcommand. The variables that options write to must live as long as the program.
struct Subcommand {
  CLI::App* app;
  int* exit_code;

  /// `names` as "-o,--output", or a bare word for an argument by its position.
  Option option(const std::string& names, std::string& value, const std::string& help);
  Option option(const std::string& names, std::filesystem::path& value, const std::string& help);
  Option option(const std::string& names, int& value, const std::string& help);
  Option option(const std::string& names, double& value, const std::string& help);
  Option option(const std::string& names, std::vector<std::string>& values,
                const std::string& help);
  void flag(const std::string& names, bool& value, const std::string& help);

  void footer(const std::string& text);  ///< the example below --help
  /// Calls `run` if the command was chosen; what it returns is the program's exit code.
  void on_run(std::function<int()> run);
};

/// The program that subcommands add themselves to.
struct Program {
  CLI::App* app;
  int* exit_code;
  std::string command_line;  ///< as it was given, "litmus" for the program's own path

  Subcommand add(const std::string& name, const std::string& about);
};

/// Lets each function of `commands` add its subcommand, then parses the arguments and runs the one
/// chosen. Returns its exit code, 0 after --help and --version, 2 for arguments that do not fit.
int run_program(int argc, char** argv, const std::string& about, const std::string& footer,
                std::span<void (*const)(Program&)> commands);

}  // namespace litmus
