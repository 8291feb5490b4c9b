// write_peers_html.cpp: peers.html, litmus beside its peers as a page.
#include <fmt/format.h>

#include <algorithm>

#include "reports/html_case.h"
#include "reports/html_shell.h"
#include "reports/plain_text.h"
#include "reports/web_assets.h"
#include "reports/write_peers.h"

namespace litmus {
namespace {

std::string peer_row(const PeerTask& task, const PeerRow& row) {
  if (!row.missing.empty())
    return fmt::format(
        "<tr><th>{}</th><td class=\"word dim\" colspan=\"4\">missing: {}</td></tr>\n",
        html_text(row.name), html_text(row.missing));
  const PeerRatio ratio = task.ratio(row);
  const bool first = &row == &task.rows[0];
  const std::string times = ratio.median > 0 ? short_number(ratio.median) + "\u00d7" : "";
  const std::string spread = first || ratio.median == 0 ? ""
                                                        : short_number(ratio.least) + " to " +
                                                              short_number(ratio.most) + "\u00d7";
  return fmt::format(
      "<tr><th>{}</th><td>{:.2f} ms</td><td>{}</td><td><b>{}</b></td><td class=\"dim\">{}</td>"
      "</tr>\n",
      html_text(row.name), row.least() * 1e3, short_time(row.least() / task.units), times, spread);
}

std::string peer_section(const PeerTask& task) {
  std::string rows, notes;
  for (const PeerRow& row : task.rows) rows += peer_row(task, row);
  for (const std::string& note : task.notes) notes += html_text(note) + " ";
  return fmt::format(
      "<section><h2>{}</h2><p class=\"legend\">{}</p><div class=\"scroll\"><table "
      "class=\"numbers advice\"><thead><tr><th></th><th>time</th><th>a {}</th><th>ratio</th>"
      "<th>spread</th></tr></thead><tbody>\n{}</tbody></table></div></section>\n",
      html_text(task.title), notes, task.unit, rows);
}

/// A plot of the tasks whose rows differ in triangles; nothing without two that were measured.
std::string growth_section(const std::vector<PeerTask>& tasks) {
  const auto grows = [](const PeerTask& task) {
    return std::ranges::count_if(task.rows, [](const PeerRow& row) {
             return row.missing.empty() && row.triangles > 0;
           }) > 1;
  };
  if (std::ranges::none_of(tasks, grows)) return "";
  return "<section><h2>A ray's time by the triangles of a mesh</h2><p class=\"legend\">Triangles "
         "by powers of ten: a straight line grows like their logarithm. Dashed: what the smallest "
         "mesh's time would become, if it grew in proportion to the logarithm.</p><div "
         "class=\"curve\"><canvas id=\"growth\" role=\"img\" aria-label=\"Time of a ray against "
         "triangles; tables below have the figures.\"></canvas></div></section>\n";
}

}  // namespace

std::string peers_html(const std::vector<PeerTask>& tasks, const PeerOptions& options,
                       const Provenance& provenance) {
  std::string body = growth_section(tasks);
  const bool plotted = !body.empty();
  std::string tables;
  for (const PeerTask& task : tasks) tables += peer_section(task);
  body = tables + body;
  body += fmt::format(
      "<section class=\"prose\"><h2>How it was measured</h2><p>One thread each, in turns, {} "
      "times, so that a busy machine slows all alike{}. Times are processor times without "
      "start-up, the least of all turns. A ratio is the median over the turns of the ratio within "
      "a turn to the first row, beside its least and most.</p><p>litmus {}{}. {}. {}. "
      "<code>{}</code></p></section>\n",
      options.repeats, options.quick ? " (--quick: small pictures, not for quoting)" : "",
      html_text(provenance.litmus_version),
      provenance.commit.empty() ? "" : ", commit " + html_text(provenance.commit),
      html_text(provenance.cpu), html_text(provenance.compiler), html_text(provenance.command));
  return small_page(
      "litmus beside its peers",
      "The same pictures and rays through litmus and through other renderers. Trust the ratios: "
      "times depend on the machine.",
      body,
      plotted ? std::string(kChartScript) +
                    "\nconst peers = " + script_safe(peers_json(tasks, options, provenance)) +
                    ";\n" + std::string(kPeersScript)
              : "");
}

}  // namespace litmus
