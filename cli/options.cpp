// options.cpp: the one file that sees CLI11.
#include "cli/options.h"

#include <CLI/CLI.hpp>

namespace litmus {

Option Option::required() { return {option->required()}; }

Option Option::one_of(const std::vector<std::string>& words) {
  return {option->check(CLI::IsMember(words))};
}

Option Option::between(double low, double high) { return {option->check(CLI::Range(low, high))}; }

Option Option::separated_by(char delimiter) { return {option->delimiter(delimiter)}; }

Option Option::at_least(int values) { return {option->expected(values, 1 << 20)}; }

Option Option::with_default() { return {option->capture_default_str()}; }

Option Subcommand::option(const std::string& names, std::string& value, const std::string& help) {
  return {app->add_option(names, value, help)};
}

Option Subcommand::option(const std::string& names, std::filesystem::path& value,
                          const std::string& help) {
  return {app->add_option(names, value, help)};
}

Option Subcommand::option(const std::string& names, int& value, const std::string& help) {
  return {app->add_option(names, value, help)};
}

Option Subcommand::option(const std::string& names, double& value, const std::string& help) {
  return {app->add_option(names, value, help)};
}

Option Subcommand::option(const std::string& names, std::vector<std::string>& values,
                          const std::string& help) {
  return {app->add_option(names, values, help)};
}

void Subcommand::flag(const std::string& names, bool& value, const std::string& help) {
  app->add_flag(names, value, help);
}

void Subcommand::footer(const std::string& text) { app->footer(text); }

void Subcommand::on_run(std::function<int()> run) {
  app->callback([run = std::move(run), code = exit_code] { *code = run(); });
}

Subcommand Program::add(const std::string& name, const std::string& about) {
  return {app->add_subcommand(name, about), exit_code};
}

int run_program(int argc, char** argv, const std::string& about, const std::string& footer,
                std::span<void (*const)(Program&)> commands) {
  CLI::App app{about};
  app.name("litmus");
  app.set_version_flag("--version", LITMUS_VERSION);
  app.require_subcommand(1);
  app.footer(footer);
  int exit_code = 0;
  std::string command_line = "litmus";
  for (int i = 1; i < argc; ++i) command_line += std::string(" ") + argv[i];
  Program program{&app, &exit_code, command_line};
  for (const auto add : commands) add(program);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return exit_code;
}

}  // namespace litmus
