// stress_page.cpp: the page of litmus stress.
#include "reports/stress_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "reports/html_shell.h"
#include "reports/plain_text.h"
#include "reports/stress_plot.h"

namespace litmus {
namespace {

/// Plots side by side; the control's curve is told apart by its dashes, too.
constexpr std::string_view kStyle =
    "<style>.plots{display:grid;grid-template-columns:repeat(auto-fill,minmax(270px,1fr));"
    "gap:1rem;margin-top:1rem}.plots figcaption{font-size:.85rem}.plots figcaption "
    "small{color:var(--dim)}.plot .naive{stroke:var(--fail);stroke-dasharray:5 2}"
    ".plot .ours{stroke-width:2}.plot .allowed{stroke:var(--ink);stroke-dasharray:1 3}"
    ".numbers .long{text-align:left;white-space:normal;min-width:11rem}"
    ".numbers thead th.right{text-align:right}"
    ".numbers tbody tr:nth-child(even)>*{border-bottom:1px solid var(--line)}"
    "@media(max-width:40rem){.numbers th.long{min-width:8.5rem}}</style>";

struct Group {
  std::string_view name, title, lead;
};
constexpr Group kGroups[] = {
    {"formulas", "Formulas",
     "The slides' formulas over their whole domain, against the slides' own forms in quad "
     "precision. An ulp is one unit in the last place."},
    {"rays", "Shadow rays",
     "Surfaces that shadow themselves and occluders that are missed are counted at the same "
     "settings: a larger offset buys fewer of one with more of the other. u is half a unit in the "
     "last place of 1, |p| the largest coordinate of the point and the eye."},
    {"meshes", "Closed meshes",
     "Rays from inside of a closed mesh, aimed at shared edges and vertices. The contracted build "
     "lets the compiler fuse multiplications and additions."},
    {"pictures", "Pictures", "Whole renders at the limits, and in four rounding modes."}};

std::string number(double value) { return std::isfinite(value) ? short_number(value) : "NaN, inf"; }

/// A group's rows, those of one case beside each other: float, then double.
std::vector<const StressRow*> rows_of(const std::vector<StressRow>& rows, std::string_view group) {
  std::vector<const StressRow*> result;
  for (const StressRow& row : rows) {
    if (row.group != group) continue;
    const auto same = std::find_if(result.rbegin(), result.rend(),
                                   [&](const StressRow* other) { return other->what == row.what; });
    result.insert(same == result.rend() ? result.end() : same.base(), &row);
  }
  return result;
}

/// The figures first: on a narrow screen the words are out of sight.
std::string row_html(const StressRow& row) {
  const bool kept = row.seen <= row.bound;
  const char* verdict = !row.judged ? "" : holds(row) ? "✓" : "✗";
  return fmt::format(
      "<tr class=\"{}\"><th class=\"long\">{}</th><td class=\"word\">{}</td><td{}>{}</td>"
      "<td>{}</td><td>{}</td><td class=\"verdict\">{}</td><td class=\"word\">{}</td><td>{}</td>"
      "<td class=\"long\">{}</td><td class=\"long\">{}</td></tr>\n",
      holds(row) ? "pass" : "fail", html_text(row.what), row.scalar,
      kept || !row.judged ? "" : " class=\"bad\"", number(row.seen),
      row.judged ? number(row.bound) : "not judged", number(row.control_seen), verdict,
      html_text(row.metric), with_commas((long long)(row.samples)), html_text(row.domain),
      html_text(row.control));
}

std::string plots_html(const std::vector<const StressRow*>& rows) {
  std::string figures;
  for (const StressRow* row : rows) {
    if (!row->curve) continue;
    figures += fmt::format(
        "<figure>{}<figcaption>{}, {} <small>({})</small></figcaption></figure>\n",
        stress_plot(*row), html_text(row->what), row->scalar, html_text(row->curve->y_label));
  }
  if (figures.empty()) return "";
  return fmt::format(
      "<p class=\"legend\">Solid: litmus. Dashed: the control. Dotted line: the bound.</p>"
      "<div class=\"plots\">{}</div>\n",
      figures);
}

std::string group_html(const std::vector<StressRow>& all, const Group& group) {
  const std::vector<const StressRow*> rows = rows_of(all, group.name);
  std::string lines;
  for (const StressRow* row : rows) lines += row_html(*row);
  if (lines.empty()) return "";
  return fmt::format(
      "<section><h2>{}</h2><p class=\"legend\">{}</p><div class=\"scroll\"><table "
      "class=\"numbers\"><thead><tr><th>Case</th><th>Scalar</th><th class=\"right\">Seen</th>"
      "<th>Bound</th><th>Control sees</th><th></th><th class=\"word\">Counted</th>"
      "<th>Samples</th><th class=\"long\">Domain</th><th class=\"long\">Control</th></tr>"
      "</thead><tbody>\n{}</tbody></table></div>\n{}</section>\n",
      group.title, group.lead, lines, plots_html(rows));
}

std::string percent(const EnvelopePoint& point) {
  if (!point.failure.empty()) return "none";
  return point.differing == 0 ? "0" : fmt::format("{:.2g} %", point.differing);
}

/// A line per renderer, a column per scale or offset.
std::string envelope_table(const std::vector<EnvelopePoint>& points, std::string_view axis) {
  std::string head, lines, renderer;
  for (const EnvelopePoint& point : points) {
    if (point.axis != axis) continue;
    if (point.renderer != renderer) {
      lines += fmt::format("{}<tr><th>{}</th>", lines.empty() ? "" : "</tr>\n",
                           html_text(point.renderer));
      renderer = point.renderer;
    }
    if (renderer == points[0].renderer) head += fmt::format("<th>{:g}</th>", point.value);
    lines += fmt::format(
        "<td{}{}>{}</td>", point.differing > 0 ? " class=\"bad\"" : "",
        point.failure.empty() ? "" : fmt::format(" title=\"{}\"", html_text(point.failure)),
        percent(point));
  }
  return fmt::format(
      "<div class=\"scroll\"><table class=\"numbers\"><thead><tr><th>{}</th>{}</tr></thead>"
      "<tbody>{}</tr></tbody></table></div>\n",
      axis == "scale" ? "All lengths times" : "Moved by", head, lines);
}

/// Why cells say "none".
std::string failures_html(const std::vector<EnvelopePoint>& points) {
  std::string items;
  for (const std::string& failure : envelope_failures(points))
    items += "<li>" + html_text(failure) + "</li>";
  return items.empty() ? "" : "<p class=\"legend\">No picture:</p><ul>" + items + "</ul>\n";
}

std::string envelopes_html(const std::vector<EnvelopePoint>& points) {
  if (points.empty()) return "";
  return "<section><h2>Where each renderer leaves its envelope</h2><p class=\"legend\">One small "
         "scene, scaled and moved, exported as it stands. Each cell: the pixels that are off by "
         "more than 1/255 from the same renderer's picture at scale 1 and the origin. In a "
         "comparison the exporters move every scene to where both renderers are accurate.</p>" +
         envelope_table(points, "scale") + envelope_table(points, "offset") +
         failures_html(points) + "</section>\n";
}

std::string lead_of(const StressReport& report) {
  long long judged = 0, failed = 0;
  for (const StressRow& row : report.rows) judged += row.judged, failed += !holds(row);
  if (failed > 0)
    return fmt::format("{} of {} figures fail: the bound is exceeded, or the control keeps it.",
                       failed, judged);
  return fmt::format(
      "All {} figures keep their bounds, and each control breaks its bound on the "
      "same samples.",
      judged);
}

}  // namespace

std::string stress_page(const StressReport& report) {
  std::string body(kStyle);
  for (const Group& group : kGroups) body += group_html(report.rows, group);
  body += envelopes_html(report.envelopes);
  const Provenance& p = report.provenance;
  body += fmt::format(
      "<section class=\"prose\"><h2>Repeat it</h2><p><code>{}</code> took {} on {}. The same "
      "options give the same figures on any number of threads; <code>--samples</code> and "
      "<code>--rays</code> make it longer.</p><p>litmus {} ({}), {}, {}.</p></section>\n",
      html_text(p.command), html_text(short_seconds(p.seconds)), html_text(p.cpu),
      html_text(p.litmus_version), html_text(p.commit), html_text(p.compiler), html_text(p.flags));
  return small_page("Hard cases", lead_of(report), body);
}

}  // namespace litmus
