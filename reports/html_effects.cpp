// html_effects.cpp: a matrix of scenes and effects.
#include "reports/html_effects.h"

#include <fmt/format.h>

#include <algorithm>

#include "reports/effects_study.h"
#include "reports/html_shell.h"
#include "reports/plain_text.h"

namespace litmus {
namespace {

/// What is counted of an effect; null where that is nothing of its own.
std::uint64_t Counts::*count_of_effect(std::string_view effect) {
  if (effect == "specular") return &Counts::powers;
  if (effect == "shadows") return &Counts::shadow_rays;
  if (effect == "linear") return &Counts::linear;
  if (effect == "quadratic") return &Counts::quadratic;
  return effect == "cone" ? &Counts::cones : nullptr;
}

std::string effect_cell(const EffectUse& use, const EffectName& effect) {
  const bool called_for = use.called_for.*effect.member;
  const auto member = count_of_effect(effect.name);
  if (!member) return called_for ? "<td>\u25cf</td>" : "<td class=\"dim\">\u2013</td>";
  const auto needed = (long long)(use.needed.*member), all = (long long)(use.all.*member);
  const std::string share =
      all > 0 ? short_number(100 * double(needed) / double(all)) + " %" : "0 %";
  return fmt::format("<td title=\"{} of {}\"{}>{}</td>", with_commas(needed), with_commas(all),
                     called_for ? "" : " class=\"dim\"", called_for ? share : "\u2013");
}

std::string effects_row(const EffectUse& use) {
  std::string cells;
  for (const EffectName& effect : effect_names()) cells += effect_cell(use, effect);
  return fmt::format(
      "<tr><th>{}</th><td class=\"word\">{}\u00d7</td><td class=\"word{}\">{}</td>{}</tr>\n",
      html_text(use.scene), short_number(use.saving()), use.identical ? "" : " bad",
      use.identical ? "the same" : "differs", cells);
}

}  // namespace

std::string effects_section(const CostStudy& study) {
  if (study.effects.empty()) return "";
  std::vector<const EffectUse*> uses;
  for (const EffectUse& use : study.effects) uses.push_back(&use);
  std::stable_sort(uses.begin(), uses.end(), [](const EffectUse* a, const EffectUse* b) {
    return a->saving() > b->saving();
  });
  std::string heads, rows, left_out;
  for (const EffectName& effect : effect_names())
    heads += fmt::format("<th title=\"{}\">{}</th>", html_text(std::string(effect.meaning)),
                         effect.name);
  for (const EffectUse* use : uses) rows += effects_row(*use);
  for (const std::string& why : study.effects_left_out)
    left_out += "<p class=\"legend\">Left out: " + html_text(why) + "</p>";
  return fmt::format(
      "<section><h2>Effects: only what a scene calls for</h2><p class=\"legend\">{}</p>"
      "<details><summary>Scene by scene, the largest saving first</summary>"
      "<p class=\"legend\">Time: every effect everywhere over what is called for. \u2013: not "
      "called for and left out. \u25cf: called for. Shares: evaluations (shadows: rays) that are "
      "needed, of those of every effect everywhere; the tips have the counts. "
      "</p>{}<div class=\"scroll\"><table class=\"numbers effects\"><thead><tr><th>scene</th>"
      "<th>time</th><th>picture</th>{}</tr></thead><tbody>\n{}</tbody></table></div>"
      "</details></section>\n",
      html_text(effects_sentence(study.effects)), left_out, heads, rows);
}

}  // namespace litmus
