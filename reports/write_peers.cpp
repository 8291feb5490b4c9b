// write_peers.cpp: tables of ratios, and peers.json.
#include "reports/write_peers.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "reports/plain_text.h"
#include "reports/provenance_json.h"

namespace litmus {
namespace {

using Json = nlohmann::ordered_json;

std::string row_text(const PeerTask& task, const PeerRow& row, std::size_t width) {
  if (!row.missing.empty())
    return fmt::format("  {:<{}}  missing: {}\n", row.name, width, clean_text(row.missing));
  const PeerRatio ratio = task.ratio(row);
  std::string text = fmt::format("  {:<{}} {:>10.2f} ms {:>10}", row.name, width, row.least() * 1e3,
                                 short_time(row.least() / task.units));
  if (&row == &task.rows[0]) return text + fmt::format(" {:>9}\n", "1");
  if (ratio.median == 0) return text + "   (the first row is missing)\n";
  return text + fmt::format(" {:>9.3g}  {:.3g} to {:.3g}\n", ratio.median, ratio.least, ratio.most);
}

Json row_json(const PeerTask& task, const PeerRow& row) {
  const PeerRatio ratio = task.ratio(row);
  return {{"name", row.name},
          {"missing", clean_text(row.missing)},
          {"triangles", row.triangles},
          {"seconds", row.seconds},
          {"ratio", {{"median", ratio.median}, {"least", ratio.least}, {"most", ratio.most}}}};
}

}  // namespace

std::string short_time(double seconds) {
  return seconds < 1e-6 ? fmt::format("{:.1f} ns", seconds * 1e9)
                        : fmt::format("{:.2f} us", seconds * 1e6);
}

std::string peers_text(const std::vector<PeerTask>& tasks) {
  std::size_t width = 0;
  for (const PeerTask& task : tasks)
    for (const PeerRow& row : task.rows) width = std::max(width, row.name.size());
  std::string text =
      "Processor time on one thread, without start-up: the least of the repeats, the same for one\n"
      "pixel or ray, and how many times that of the first row it is: the median over the repeats\n"
      "of the ratio within a repeat, and its least and most.\n";
  for (const PeerTask& task : tasks) {
    text += fmt::format("\n{}\n  {:<{}} {:>13} {:>10} {:>9}  spread\n", task.title, "", width,
                        "time", "a " + task.unit, "ratio");
    for (const PeerRow& row : task.rows) text += row_text(task, row, width);
    for (const std::string& note : task.notes) text += fmt::format("  {}\n", note);
  }
  return text;
}

std::string peers_json(const std::vector<PeerTask>& tasks, const PeerOptions& options,
                       const Provenance& provenance) {
  Json all = Json::array();
  for (const PeerTask& task : tasks) {
    Json rows = Json::array();
    for (const PeerRow& row : task.rows) rows.push_back(row_json(task, row));
    all.push_back({{"name", task.name},
                   {"title", task.title},
                   {"unit", task.unit},
                   {"units", task.units},
                   {"rows", rows},
                   {"notes", task.notes}});
  }
  return Json{{"schema_version", 1},
              {"provenance", provenance_fields(provenance)},
              {"quick", options.quick},
              {"repeats", options.repeats},
              {"tasks", all}}
      .dump(1);
}

}  // namespace litmus
