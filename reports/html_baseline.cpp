// html_baseline.cpp: what report.html says to who decides: the baseline, and what can be approved.
#include "reports/html_baseline.h"

#include "reports/approval.h"
#include "reports/baseline.h"
#include "reports/html_case.h"
#include "reports/plain_text.h"

namespace litmus {
namespace {
using kainjow::mustache::data;

constexpr std::size_t kListedChanges = 6;  // of each kind

std::string title_of(const std::string& kind) {
  if (kind == "new failure") return "New failures";
  if (kind == "worse") return "Worse, beyond noise";
  return kind == "missing" ? "Compared before, and not now" : "Fixed";
}

std::string anchor_of(const Study& study, const BaselineChange& change) {
  for (const Case& one : study.cases)
    if (one.scene == change.scene) return layer_anchor(study, one, change.light);
  return "made-with";
}

data group_data(const Study& study, const std::string& kind) {
  data items{data::type::list};
  std::size_t count = 0;
  for (const BaselineChange& change : study.baseline->changes) {
    if (change.kind != kind || ++count > kListedChanges) continue;
    data item;
    item.set("anchor", anchor_of(study, change));
    item.set("scene", text_data(change.scene));
    item.set("sentence", text_data(sentence_of(change).substr(change.scene.size())));
    items.push_back(item);
  }
  const std::size_t left = count - std::min(count, kListedChanges);
  data group;
  group.set("title", title_of(kind));
  group.set("left", left > 0 ? data(std::to_string(left)) : flag(false));
  set_list(group, "items", items);
  return group;
}

}  // namespace

data baseline_data(const Study& study) {
  if (!study.baseline) return flag(false);
  const BaselineReport& report = *study.baseline;
  data groups{data::type::list}, versions{data::type::list};
  for (const char* kind : {"new failure", "worse", "missing", "fixed"}) {
    data group = group_data(study, kind);
    if (group.get("items")->is_non_empty_list()) groups.push_back(group);
  }
  for (const VersionChange& change : report.versions)
    versions.push_back(text_data(sentence_of(change)));
  data result;
  result.set("look", is_regression(report) ? "alert" : "calm");
  result.set("headline", text_data(baseline_headline(report)));
  result.set("file", text_data(report.file));
  result.set("groups", groups);
  set_list(result, "versions", versions);
  return result;
}

data approvals_data(const Study& study, const Case& one) {
  data list{data::type::list};
  for (const CaseReference& reference : one.references) {
    if (failing_rows(study, one.scene, reference.reference).empty()) continue;
    const std::string refusal = approval_refusal(study, one.scene, reference.reference);
    data item;
    item.set("command",
             refusal.empty() ? text_data(approve_command(one, reference.reference)) : flag(false));
    item.set("refusal", refusal.empty() ? flag(false) : text_data(refusal));
    list.push_back(item);
  }
  return list;
}

data slower_data(const Study& study) {
  data list{data::type::list};
  if (study.baseline)
    for (const SpeedChange& change : study.baseline->slower)
      list.push_back(text_data(sentence_of(change)));
  return list;
}

}  // namespace litmus
