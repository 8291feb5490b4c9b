// github.cpp: failures as annotations that GitHub shows beside the scene's file.
#include "reports/github.h"

#include <fmt/format.h>

#include <set>

#include "reports/baseline.h"
#include "reports/overview.h"
#include "reports/plain_text.h"
#include "scene/fields.h"
#include "scene/load.h"

namespace litmus {
namespace {

constexpr std::size_t kMessage = 1000;  // bytes

std::string escaped(std::string_view text, std::string_view characters) {
  std::string safe;
  for (const char c : text) {
    if (characters.find(c) == characters.npos)
      safe += c;
    else
      safe += fmt::format("%{:02X}", unsigned(static_cast<unsigned char>(c)));
  }
  return safe;
}

/// Where the scene's file heads a light; 1 for its ambient light, all lights and a file that cannot
/// be read again.
std::uint32_t line_of(const Case& one, const std::string& light) {
  if (light == "ambient" || light == "all") return 1;
  try {
    const Scene scene = load_scene(one.file);
    const Node document = read_document(one.file);
    const Fields root(scene.file, document, "a scene");
    const Node::Array& tables = root.tables("light");
    for (std::size_t i = 0; i < std::min(tables.size(), scene.lights.size()); ++i)
      if (scene.lights[i].name == light) return tables[i].at.line;
  } catch (const std::exception&) {
  }
  return 1;
}

std::string annotation(const Case* one, const std::string& light, const std::string& title,
                       const std::string& message) {
  std::string properties = "title=" + github_property(clipped(title, kMessage));
  if (one != nullptr && !one->file.empty())
    properties = fmt::format("file={},line={},{}", github_property(clean_text(one->file)),
                             line_of(*one, light), properties);
  return fmt::format("::error {}::{}\n", properties, github_text(clipped(message, kMessage)));
}

/// What to annotate, before any file is read for its line.
struct Annotated {
  std::string scene, light, title, message;
};

std::vector<Annotated> findings_of(const Study& study) {
  std::vector<Annotated> findings;
  for (const Case& one : study.cases)
    for (const CaseReference& reference : one.references)
      if (!reference.failure.empty())
        findings.push_back({one.scene, "all", reference_title(reference.reference) + " failed",
                            reference.failure});
  std::set<std::pair<std::string, std::string>> told;
  std::set<std::string> told_scenes;
  for (const Comparison* row : failures_of(study)) {
    // The whole picture says once more what a light says; lights come first.
    if (row->source.empty() || (row->light == "all" && told_scenes.contains(row->scene))) continue;
    if (!told.insert({row->scene, row->light}).second) continue;
    told_scenes.insert(row->scene);
    const std::string why = row->hint.empty() ? row->reason : row->reason + "; " + row->hint;
    findings.push_back({row->scene, row->light,
                        fmt::format("{}: {} differs from {} ({})", row->scene,
                                    row->light == "all" ? "the whole picture" : row->light,
                                    reference_title(row->reference), row->region),
                        why});
  }
  if (study.baseline)
    for (const BaselineChange& change : study.baseline->changes)
      if (change.kind == "worse" && told.insert({change.scene, change.light}).second)
        findings.push_back(
            {change.scene, change.light,
             fmt::format("{}: {} is worse than the baseline", change.scene, change.light),
             sentence_of(change)});
  return findings;
}

}  // namespace

std::string github_text(std::string_view text) { return escaped(text, "%\r\n"); }

std::string github_property(std::string_view text) { return escaped(text, "%\r\n:,"); }

std::string github_annotations(const Study& study) {
  const std::vector<Annotated> findings = findings_of(study);
  const std::size_t shown = findings.size() > kAnnotations ? kAnnotations - 1 : findings.size();
  std::string text;
  for (std::size_t i = 0; i < shown; ++i)
    text += annotation(find_case(study, findings[i].scene), findings[i].light, findings[i].title,
                       findings[i].message);
  if (shown < findings.size())
    text += annotation(
        nullptr, "", "litmus",
        fmt::format("and {} more: see summary.md and report.html", findings.size() - shown));
  return text;
}

}  // namespace litmus
