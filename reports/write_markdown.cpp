// write_markdown.cpp: summary.md, for a pull request or a job's page.
#include "reports/write_markdown.h"

#include <fmt/format.h>

#include <map>

#include "compare/whole_file.h"
#include "reports/candidates.h"
#include "reports/overview.h"
#include "reports/plain_text.h"
#include "reports/suspects.h"

namespace litmus {
namespace {

constexpr std::size_t kCell = 300;    // bytes of text in one cell
constexpr std::size_t kListed = 200;  // rows in one list

// Text that Markdown and HTML leave alone, on one line.
std::string cell(std::string_view text, std::size_t limit = kCell) {
  std::string safe;
  for (const char c : clipped(text, limit)) {
    if (c == '\n' || c == '\t') {
      safe += ' ';
    } else if (c == '<') {
      safe += "&lt;";
    } else if (c == '&') {
      safe += "&amp;";
    } else {
      if (std::string_view("\\`*_{}[]()#!|~@>").find(c) != std::string_view::npos) safe += '\\';
      safe += c;
    }
  }
  return safe;
}

std::string number(const Comparison* row, double Comparison::*member) {
  return row == nullptr ? "" : short_number(row->*member);
}

std::string failures_text(const Study& study) {
  const std::vector<const Comparison*> rows = failures_of(study);
  if (rows.empty()) return "";
  std::string text =
      "## What disagrees\n\n| scene | light | reference | region | largest | allowed | pixel | why "
      "|\n"
      "|---|---|---|---|--:|--:|---|---|\n";
  for (std::size_t i = 0; i < std::min(rows.size(), kListed); ++i) {
    const Comparison& row = *rows[i];
    text += fmt::format("| {} | {} | {} ({}) | {} | {} | {} | {}, {} | {} |\n", cell(row.scene),
                        cell(row.light), cell(reference_title(row.reference)), cell(row.source),
                        cell(row.region), short_number(row.max_abs), short_number(row.tolerance),
                        row.max_at[0], row.max_at[1], cell(row.reason));
  }
  if (rows.size() > kListed)
    text += fmt::format("\nand {} more in results.json\n", rows.size() - kListed);
  return text + "\n";
}

// What changed since the baseline; times, which vary, are left to the provenance.
std::string baseline_text(const Study& study) {
  if (!study.baseline) return "";
  std::string text =
      fmt::format("## Against the baseline\n\n{}: {}\n\n", cell(study.baseline->file),
                  cell(baseline_headline(*study.baseline)));
  std::size_t listed = 0;
  for (const BaselineChange& change : study.baseline->changes)
    if (++listed <= kListed)
      text += fmt::format("- {}: {}\n", change.kind, cell(sentence_of(change), 2 * kCell));
  if (listed > kListed) text += fmt::format("- and {} more in results.json\n", listed - kListed);
  for (const VersionChange& change : study.baseline->versions)
    text += fmt::format("- {}\n", cell(sentence_of(change)));
  return text + "\n";
}

std::string broken_text(const Study& study) {
  std::string text;
  std::size_t count = 0;
  for (const Case& one : study.cases)
    for (const CaseReference& reference : one.references)
      if (!reference.failure.empty() && ++count <= kListed)
        text += fmt::format("- {}, {}: {}\n", cell(one.scene),
                            cell(reference_title(reference.reference)), cell(reference.failure));
  if (count > kListed) text += fmt::format("- and {} more\n", count - kListed);
  return text.empty() ? "" : "## Renderers that failed\n\n" + text + "\n";
}

std::string types_text(const Study& study) {
  std::string text =
      "## Worst differences\n\n| light type | reference | | largest, interior | mean, interior | "
      "largest, edges | edge pixels explained | passed | failed | skipped |\n"
      "|---|---|---|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const std::string& type : light_types_of(study))
    for (const std::string& reference : references_of(study)) {
      const Tally rows = tally(study, [&](const Comparison& row) {
        return row.light_type == type && row.reference == reference;
      });
      if (rows.rows == 0) continue;
      text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", cell(type),
                          cell(reference_title(reference)), source_of(rows),
                          number(rows.interior, &Comparison::max_abs),
                          number(rows.mean, &Comparison::mean_abs),
                          number(rows.edge, &Comparison::max_abs),
                          rows.over == 0 ? "" : fmt::format("{} of {}", rows.explained, rows.over),
                          rows.passed, rows.failed, rows.skipped);
    }
  return text + "\n";
}

// Which sources agree: litmus, the references and the closed forms, two by two.
std::string pairs_text(const Study& study) {
  const std::vector<PairLine> lines = pair_lines(study);
  if (study.pairs.empty()) return "";
  std::string text =
      "## Each against each\n\n| | | largest, interior | scene | light | rows | failed |\n"
      "|---|---|--:|---|---|--:|--:|\n";
  for (const PairLine& line : lines)
    text +=
        fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", cell(reference_title(line.against)),
                    cell(reference_title(line.reference)), short_number(line.largest),
                    cell(line.scene), cell(line.light), line.rows, line.failed);
  return text + "\n";
}

// What the verdict does not count, and what the candidates' encodings cannot show.
std::string informative_text(const Study& study) {
  std::string text;
  const std::vector<InformativeLine> lines = informative_lines(study);
  if (!lines.empty())
    text +=
        "## For information, not judged\n\nThe largest interior difference to each.\n\n"
        "| | light type | litmus | POV-Ray | Blender |\n|---|---|--:|--:|--:|\n";
  for (const InformativeLine& line : lines) {
    text +=
        fmt::format("| {} | {} |", cell(reference_title(line.reference)), cell(line.light_type));
    for (const std::optional<double>& largest : line.largest)
      text += fmt::format(" {} |", largest ? short_number(*largest) : "");
    text += "\n";
  }
  if (!lines.empty()) text += "\n";
  for (const CandidateNote& one : study.candidates)
    if (!one.note.empty()) text += fmt::format("{}: {}\n\n", cell(one.name), cell(one.note, 2000));
  return text;
}

// One line per reason, because a missing renderer skips hundreds of rows.
std::string skipped_text(const Study& study) {
  std::map<std::string, int> reasons;
  for (const Comparison& row : study.comparisons)
    if (row.verdict == "skipped") ++reasons[reference_title(row.reference) + ": " + row.reason];
  if (reasons.empty()) return "";
  std::string text = "## Skipped\n\n";
  std::size_t listed = 0;
  for (const auto& [reason, count] : reasons)
    if (++listed <= kListed)
      text += fmt::format("- {}: {}\n", counted(count, "row", "rows"), cell(reason));
  if (listed > kListed) text += fmt::format("- and {} more reasons\n", listed - kListed);
  return text + "\n";
}

std::string provenance_text(const Study& study) {
  const Provenance& p = study.provenance;
  std::string text = "## Provenance\n\n";
  const auto line = [&](std::string_view name, const std::string& value) {
    if (!value.empty()) text += fmt::format("- {}: {}\n", cell(name), cell(value, 2000));
  };
  line("litmus", p.litmus_version + (p.commit.empty() ? "" : " (" + p.commit + ")"));
  line("command", p.command);
  line("started", p.started);
  line("took", short_seconds(p.seconds));
  const std::vector<std::string> references = references_of(study);
  const std::vector<double> seconds = seconds_of(study.cases, references);
  for (std::size_t i = 0; i < std::min(seconds.size(), kListed); ++i)
    if (seconds[i] > 0)
      line("rendering by " + (i == 0 ? "litmus" : reference_title(references[i - 1])),
           short_seconds(seconds[i]));
  line("system", p.system);
  line("processor",
       p.cpu.empty() ? "" : fmt::format("{}, {}", p.cpu, counted(p.threads, "thread", "threads")));
  line("compiler", p.compiler + (p.flags.empty() ? "" : " " + p.flags));
  for (std::size_t i = 0; i < std::min(p.versions.size(), kListed); ++i)
    line(p.versions[i][0], p.versions[i][1]);
  if (study.baseline)
    for (std::size_t i = 0; i < std::min(study.baseline->slower.size(), kListed); ++i)
      line("slower", sentence_of(study.baseline->slower[i]));
  return text;
}

}  // namespace

std::string markdown(const Study& study) {
  const Tally all = tally(study, [](const Comparison&) { return true; });
  const std::string sources = source_of(all).empty() ? "none" : source_of(all);
  std::string text = fmt::format(
      "# litmus: {}\n\n{}: {} over {}; {} passed, {} failed, {} skipped. References: {}.\n\n",
      overall_verdict(study), headline(study), counted(all.rows, "comparison", "comparisons"),
      counted((long long)(study.cases.size()), "scene", "scenes"), all.passed, all.failed,
      all.skipped, sources);
  text += baseline_text(study) + failures_text(study) + broken_text(study) + types_text(study) +
          pairs_text(study) + informative_text(study) + skipped_text(study) +
          provenance_text(study);
  if (text.size() <= kMarkdownLimit) return text;
  constexpr std::string_view kCut = "\n\nThe rest is in results.json.\n";
  text.resize(text.rfind('\n', kMarkdownLimit - kCut.size()));
  return text.append(kCut);
}

void write_markdown(const Study& study, const std::filesystem::path& file) {
  write_whole(file, markdown(study));
}

}  // namespace litmus
