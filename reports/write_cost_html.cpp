// write_cost_html.cpp: cost.html, which setting to use for which error.
#include <fmt/format.h>

#include <algorithm>

#include "reports/html_case.h"
#include "reports/html_effects.h"
#include "reports/html_shell.h"
#include "reports/plain_text.h"
#include "reports/web_assets.h"
#include "reports/write_cost.h"

namespace litmus {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kColumns{
    {{"litmus", "litmus"}, {"povray", "POV-Ray"}, {"blender", "Blender Cycles"}}};

double least_time(const CostTopic& topic) {
  double least = 0;
  for (const CostSeries& series : topic.series)
    for (const CostPoint& point : series.points)
      if (least == 0 || point.time.least < least) least = point.time.least;
  return least;
}

std::string ratio(const CostTopic& topic, const CostPoint& point) {
  return short_number(point.time.least / least_time(topic)) + "\u00d7";
}

bool has_renderer(const CostTopic& topic, std::string_view renderer) {
  return std::any_of(topic.series.begin(), topic.series.end(),
                     [&](const CostSeries& s) { return s.renderer == renderer; });
}

std::string setting_words(const FrontPoint& one) {
  return html_text(one.series->exact ? one.point->words : one.point->words + " (its own light)");
}

/// Which setting for which error: one row per error, one column per renderer.
std::string advice(const CostTopic& topic) {
  std::string heads, rows;
  for (const auto& [name, title] : kColumns) {
    if (has_renderer(topic, name))
      heads += fmt::format("<th class=\"word\">{}</th><th>time</th>", title);
  }
  for (const double error : kAskedErrors) {
    std::string cells;
    bool any = false;
    for (const auto& [name, title] : kColumns) {
      if (!has_renderer(topic, name)) continue;
      const FrontPoint best = cheapest(topic, name, ErrorMetric::Max, error);
      any = any || best.point;
      cells += best.point ? fmt::format("<td class=\"word\">{}</td><td>{}</td>",
                                        setting_words(best), ratio(topic, *best.point))
                          : "<td class=\"word dim\">none measured</td><td></td>";
    }
    if (any) rows += fmt::format("<tr><th>{}</th>{}</tr>\n", short_number(error), cells);
  }
  return fmt::format(
      "<div class=\"scroll\"><table class=\"numbers advice\"><thead><tr><th>largest error you "
      "accept</th>{}</tr></thead><tbody>\n{}</tbody></table></div>\n",
      heads, rows);
}

std::string plots(const CostTopic& topic) {
  std::string html = fmt::format(
      "<div class=\"curve\"><canvas data-topic=\"{}\" data-region=\"all\" role=\"img\" "
      "aria-label=\"Error against time; the table below has the figures.\"></canvas></div>\n",
      topic.name);
  std::string parts;
  for (const CostRegion region : {CostRegion::Lit, CostRegion::Penumbra, CostRegion::Umbra}) {
    const auto shown = [&](const CostSeries& series) {
      return std::any_of(series.points.begin(), series.points.end(), [&](const CostPoint& point) {
        const auto errors = point.errors.find(region);
        return errors != point.errors.end() && errors->second[0] > 0;
      });
    };
    if (std::none_of(topic.series.begin(), topic.series.end(), shown)) continue;
    parts += fmt::format(
        "<div><canvas data-topic=\"{}\" data-region=\"{}\" role=\"img\" aria-label=\"The same, "
        "{} pixels alone.\"></canvas></div>\n",
        topic.name, name_of(region), name_of(region));
  }
  if (!parts.empty()) html += "<div class=\"curves\">" + parts + "</div>\n";
  return html;
}

std::string orders(const CostTopic& topic) {
  std::string rows;
  for (const CostSeries& series : topic.series) {
    for (const CostFit& fit : series.fits) {
      if (fit.metric == ErrorMetric::P99) continue;
      rows += fmt::format(
          "<tr><th>{}</th><td class=\"word\">{}</td><td class=\"word\">{}</td><td>{:.2f}</td>"
          "<td>{:.2f} to {:.2f}</td><td>{}</td></tr>\n",
          html_text(series.title), name_of(fit.region), metric_name(fit.metric), fit.order, fit.low,
          fit.high, fit.points);
    }
  }
  if (rows.empty()) return "";
  return fmt::format(
      "<details><summary>Fitted orders: how fast the error falls</summary><p "
      "class=\"legend\">error "
      "~ n<sup>p</sup>, fitted for n of 4 and more above three times the truth's own error; 95 % "
      "bootstrap interval.</p><div class=\"scroll\"><table "
      "class=\"numbers\"><thead><tr><th>series</th><th>pixels</th><th>error</th><th>p</th>"
      "<th>interval</th><th>points</th></tr></thead><tbody>\n{}</tbody></table></div></details>\n",
      rows);
}

std::string figures_table(const CostTopic& topic) {
  const std::vector<FrontPoint> front = pareto_front(topic, ErrorMetric::Max);
  std::vector<FrontPoint> all;
  for (const CostSeries& series : topic.series)
    for (const CostPoint& point : series.points) all.push_back({&series, &point});
  std::stable_sort(all.begin(), all.end(), [](const FrontPoint& a, const FrontPoint& b) {
    return a.point->time.least < b.point->time.least;
  });
  std::string rows;
  for (const FrontPoint& one : all) {
    const bool best = std::any_of(front.begin(), front.end(),
                                  [&](const FrontPoint& f) { return f.point == one.point; });
    const CostErrors& errors = one.point->errors.at(CostRegion::All);
    const CostTime& time = one.point->time;
    rows += fmt::format(
        "<tr><th>{} {}</th><td class=\"word\">{}</td><td>{}</td><td>{}</td><td>{:.0f} %</td>"
        "<td>{}</td><td>{}</td><td>{}</td></tr>\n",
        best ? "\u25cf" : "\u2003", html_text(one.series->title), html_text(one.point->words),
        ratio(topic, *one.point), short_number(time.least),
        time.least > 0 ? 100 * time.spread / time.least : 0, short_number(errors[0]),
        short_number(errors[1]), short_number(errors[2]));
  }
  return fmt::format(
      "<details><summary>All figures, the cheapest first</summary><p class=\"legend\">\u25cf: no "
      "other setting is both as cheap and as exact.</p><div "
      "class=\"scroll\"><table class=\"numbers\"><thead><tr><th>series</th>"
      "<th>setting</th><th>time</th><th>seconds</th><th>spread</th><th>max</th><th>p99</th>"
      "<th>rms</th></tr></thead><tbody>\n{}</tbody></table></div></details>\n",
      rows);
}

std::string topic_section(const CostTopic& topic) {
  const auto own = topic.truth_error.find(CostRegion::All);
  const std::string truth =
      own == topic.truth_error.end()
          ? ""
          : fmt::format(
                " (at most {}; below three times that nothing is claimed, and points are "
                "hollow)",
                short_number(own->second[0]));
  std::string html = fmt::format(
      "<section><h2>{}</h2><p class=\"legend\">Errors against {}. What stands for it: "
      "{}{}.</p>\n{}",
      html_text(topic.title), html_text(topic.aim), html_text(topic.truth), truth, advice(topic));
  if (topic.name != "precision") html += plots(topic) + orders(topic);
  return html + figures_table(topic) + "</section>\n";
}

std::string list(const std::vector<std::string>& lines) {
  std::string html;
  for (const std::string& line : lines) html += "<li>" + html_text(line) + "</li>";
  return html;
}

std::string about_section(const CostStudy& study) {
  std::string start_up;
  for (const auto& [renderer, seconds] : study.start_up)
    start_up +=
        fmt::format("{}{} {}", start_up.empty() ? "" : ", ", renderer, short_seconds(seconds));
  const Provenance& p = study.provenance;
  return fmt::format(
      "<section class=\"prose\"><h2>How it was measured</h2>"
      "<p>The picture is {} x {} pixels of {}. Errors were measured once, times apart from them: "
      "each setting once for warming up, then all in turn, {}. The least processor time counts; "
      "one "
      "thread. Trust the ratios: seconds depend on the machine.</p>"
      "<p>POV-Ray's seconds are the processor time of tracing that it prints (in steps of 1 ms; "
      "the "
      "exact exports trace twice, for 32 bits), Cycles' the rendering time that it prints. "
      "Starting "
      "a renderer is in no figure{}.</p>"
      "<p>A light of a renderer's own (POV-Ray's area_light, Cycles' AREA) has another limit than "
      "the model: its error stops falling there.</p>"
      "<p>litmus {}{}. {}. {}. <code>{}</code></p></section>\n",
      study.width, study.height, html_text(study.scene),
      study.quick ? "3 times (--quick: not for quoting)"
                  : "7 times (3 where one takes over a second)",
      start_up.empty() ? "" : ": " + html_text(start_up), html_text(p.litmus_version),
      p.commit.empty() ? "" : ", commit " + html_text(p.commit), html_text(p.cpu),
      html_text(p.compiler), html_text(p.command));
}

}  // namespace

std::string cost_html(const CostStudy& study) {
  std::string body;
  if (!study.sentences.empty())
    body += "<section class=\"prose\"><h2>In short</h2><ul>" + list(study.sentences) +
            "</ul></section>\n";
  if (!study.missing.empty())
    body += "<section><div class=\"note\"><b>Not measured</b><ul>" + list(study.missing) +
            "</ul></div></section>\n";
  body +=
      "<section><p class=\"filters\"><label>Error in the plots: <select id=\"metric\"><option "
      "value=\"max\">largest of all pixels</option><option value=\"p99\">what 99 % of the pixels "
      "keep</option><option value=\"rms\">root mean "
      "square</option></select></label></p></section>\n";
  for (const CostTopic& topic : study.topics) body += topic_section(topic);
  body += effects_section(study) + about_section(study);
  return small_page(
      fmt::format("What accuracy costs: {}", study.scene),
      "Pick the largest error that you accept; the tables name the cheapest setting that keeps it. "
      "Errors are absolute, in linear RGB, where a fully lit white surface is 1; times are "
      "multiples "
      "of the cheapest setting's.",
      body,
      std::string(kChartScript) + "\nconst study = " + script_safe(cost_json(study)) + ";\n" +
          std::string(kCostScript));
}

}  // namespace litmus
