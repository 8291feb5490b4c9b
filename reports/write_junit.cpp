// write_junit.cpp: junit.xml, for continuous integration.
#include "reports/write_junit.h"

#include <fmt/format.h>

#include <pugixml.hpp>
#include <sstream>

#include "compare/difference.h"
#include "compare/whole_file.h"
#include "reports/blame.h"
#include "reports/overview.h"
#include "reports/plain_text.h"

namespace litmus {
namespace {

void set(pugi::xml_node node, const char* name, const std::string& value) {
  node.append_attribute(name).set_value(clean_text(value).c_str());
}

struct SuiteCounts {
  int tests = 0, failures = 0, skipped = 0, errors = 0;
};

void set_counts(pugi::xml_node node, const SuiteCounts& counts) {
  set(node, "tests", std::to_string(counts.tests));
  set(node, "failures", std::to_string(counts.failures));
  set(node, "errors", std::to_string(counts.errors));
  set(node, "skipped", std::to_string(counts.skipped));
}

pugi::xml_node add_test(pugi::xml_node suite, const std::string& scene, const std::string& name) {
  pugi::xml_node test = suite.append_child("testcase");
  set(test, "classname", scene);
  set(test, "name", name);
  return test;
}

std::string figures(const Comparison& row) {
  std::string text =
      fmt::format("pixel {}, {}\npixels {}\nnon-finite {}\nover tolerance {}\n", row.max_at[0],
                  row.max_at[1], row.pixels, row.nonfinite, row.over_tolerance);
  for (const auto& metric : kMetrics<Comparison>)
    text += fmt::format("{} {}\n", metric.name, row.*metric.member);
  text += fmt::format("tolerance {}\nmean tolerance {}\n", row.tolerance, row.mean_tolerance);
  if (!row.bands.empty()) text += fmt::format("worst bands {}\n", row.bands);
  if (!row.hint.empty()) text += row.hint + "\n";
  if (row.blame)
    text += "whose error: " + blame_sentence(*row.blame, reference_title(row.reference)) + "\n";
  for (const std::string& cause : row.causes) text += cause + "\n";
  return text;
}

void add_row(pugi::xml_node suite, const Comparison& row, SuiteCounts& counts) {
  std::string name =
      fmt::format("{}: {}, {}", reference_title(row.reference), row.light, row.region);
  if (row.light_type != row.light) name += fmt::format(" ({})", row.light_type);
  if (!row.source.empty()) name += fmt::format(" [{}]", row.source);
  pugi::xml_node test = add_test(suite, row.scene, name);
  ++counts.tests;
  if (row.verdict == "skipped") {
    ++counts.skipped;
    set(test.append_child("skipped"), "message", row.reason);
  } else if (row.verdict != "pass") {
    ++counts.failures;
    pugi::xml_node failure = test.append_child("failure");
    set(failure, "message", row.reason);
    failure.text().set(clean_text(figures(row)).c_str());
  }
}

void add_renderer_failures(pugi::xml_node suite, const Case& one, SuiteCounts& counts) {
  for (const CaseReference& reference : one.references) {
    if (reference.failure.empty()) continue;
    ++counts.tests;
    ++counts.errors;
    pugi::xml_node error =
        add_test(suite, one.scene, reference_title(reference.reference) + ": renders the scene")
            .append_child("error");
    set(error, "message", reference.failure);
    error.text().set(clean_text(reference.command + "\n" + reference.log).c_str());
  }
}

SuiteCounts add_suite(pugi::xml_node root, const Study& study, const Case& one) {
  SuiteCounts counts;
  pugi::xml_node suite = root.append_child("testsuite");
  set(suite, "name", one.scene);
  add_renderer_failures(suite, one, counts);
  for (const Comparison& row : study.comparisons)
    if (row.scene == one.scene) add_row(suite, row, counts);
  set_counts(suite, counts);
  return counts;
}

/// A suite without tests, which holds all that may differ between two runs of identical inputs.
void add_provenance(pugi::xml_node root, const Study& study) {
  pugi::xml_node suite = root.append_child("testsuite");
  set(suite, "name", "provenance");
  set_counts(suite, {});
  pugi::xml_node properties = suite.append_child("properties");
  const auto add = [&](const std::string& name, const std::string& value) {
    pugi::xml_node property = properties.append_child("property");
    set(property, "name", name);
    set(property, "value", value);
  };
  const Provenance& p = study.provenance;
  add("litmus", p.litmus_version + " " + p.commit);
  add("command", p.command);
  add("started", p.started);
  add("seconds", fmt::format("{:.3f}", p.seconds));
  add("processor", p.cpu);
  for (const auto& [name, version] : p.versions) add(name, version);
  for (const Case& one : study.cases)
    add("seconds of " + one.scene, fmt::format("{:.4f}", one.seconds));
}

}  // namespace

void write_junit(const Study& study, const std::filesystem::path& file) {
  pugi::xml_document document;
  pugi::xml_node root = document.append_child("testsuites");
  set(root, "name", "litmus");
  SuiteCounts total;
  for (const Case& one : study.cases) {
    const SuiteCounts counts = add_suite(root, study, one);
    total.tests += counts.tests;
    total.failures += counts.failures;
    total.skipped += counts.skipped;
    total.errors += counts.errors;
  }
  add_provenance(root, study);
  set_counts(root, total);
  std::ostringstream text;
  document.save(text, "  ");
  write_whole(file, text.str());
}

}  // namespace litmus
