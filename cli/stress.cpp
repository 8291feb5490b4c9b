// stress.cpp: litmus stress, hard cases as an experiment that anybody can repeat.
#include "cli/stress.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "cli/commands.h"
#include "cli/work_folder.h"
#include "reports/provenance.h"
#include "reports/stress_report.h"

namespace litmus {
namespace {

struct StressArguments {
  double samples = 2e6, rays = 1e7;
  std::filesystem::path out = "litmus-report";
  bool json = false, quiet = false, references = false;
  std::string command;
};

std::string figure(double value) {
  return std::isfinite(value) ? fmt::format("{:.3g}", value) : "NaN, inf";
}

void print_table(const StressReport& report) {
  fmt::print("{:<26} {:<27} {:>10} {:>8} {:>9} {:>10}  {}\n", "case", "counted", "samples", "bound",
             "seen", "control", "");
  for (const StressRow& row : report.rows) {
    fmt::print("{:<26} {:<27} {:>10} {:>8} {:>9} {:>10}  {}\n", row.id, row.metric, row.samples,
               row.judged ? figure(row.bound) : "", figure(row.seen), figure(row.control_seen),
               !row.judged  ? ""
               : holds(row) ? "ok"
                            : "FAIL");
  }
}

/// A line per renderer: the percentages of changed pixels by scale and by offset.
void print_envelopes(const StressReport& report) {
  std::string line;
  for (const EnvelopePoint& point : report.envelopes) {
    const std::string head = fmt::format("{}, by {}", point.renderer, point.axis);
    if (head != line) fmt::print("{}{}, pixels changed:", line.empty() ? "" : "\n", head);
    line = head;
    fmt::print("  {:g}: {}", point.value,
               point.failure.empty() ? fmt::format("{:.2g} %", point.differing) : "no picture");
  }
  if (!line.empty()) fmt::print("\n");
  for (const std::string& failure : envelope_failures(report.envelopes))
    fmt::print("no picture: {}\n", failure);
}

/// Says of each failure whether litmus or the control is to blame.
void print_failures(const StressReport& report) {
  for (const StressRow& row : report.rows) {
    if (holds(row)) continue;
    if (!(row.seen <= row.bound))
      fmt::print("{}: {} in {} exceeds the bound\n", row.id, row.metric, row.what);
    else
      fmt::print(
          "{}: the control ({}) keeps the bound, so the figure shows nothing; more samples "
          "may help\n",
          row.id, row.control);
  }
}

int run_stress(const StressArguments& options) {
  const auto start = std::chrono::steady_clock::now();
  StressOptions stress;
  stress.samples = std::uint64_t(options.samples), stress.rays = std::uint64_t(options.rays);
  if (!options.quiet)
    stress.progress = [](const std::string& part) { fmt::print(stderr, "{}\n", part); };
  StressReport report{provenance_of({}), stress.samples, stress.rays, run_stress(stress), {}};
  if (options.references) {
    const WorkFolder work;
    ReferenceOptions reference;
    reference.work = work.path, reference.progress = stress.progress;
    report.envelopes = run_envelope_study(reference);
  }
  report.provenance.command = options.command;
  report.provenance.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  write_stress(report, options.out);
  if (options.json) {
    fmt::print("{}\n", stress_json(report));
  } else {
    print_table(report);
    print_failures(report);
    print_envelopes(report);
    fmt::print(
        "page: {}\n",
        (std::filesystem::absolute(options.out) / "stress.html").lexically_normal().string());
  }
  return passes(report) ? kPass : kOutOfTolerance;
}

}  // namespace

void add_stress(Program& program) {
  auto options = std::make_shared<StressArguments>();
  options->command = program.command_line;
  Subcommand command = program.add(
      "stress", "Put formulas and rays to hard cases, beside usual code that must fail there");
  command.option("--samples", options->samples, "Samples of each formula, in float and in double")
      .between(1e3, 1e12)
      .with_default();
  command
      .option("--rays", options->rays,
              "Rays of each experiment, in float and in double; 1e9 takes a night")
      .between(1e4, 1e12)
      .with_default();
  command.option("--out", options->out, "Folder for stress.html and stress.json").with_default();
  command.flag("--references", options->references,
               "Also render one scene at scales 1e-6..1e6 and offsets to 1e8 with every renderer");
  command.flag("--json", options->json, "Print stress.json instead of a table");
  command.flag("-q,--quiet", options->quiet, "No progress");
  command.footer(
      "Exit code 0: every bound is kept and every control breaks its bound; 1: not so.\n"
      "Example: litmus stress --samples 1e5 --rays 1e6");
  command.on_run([options] { return run_stress(*options); });
}

}  // namespace litmus
