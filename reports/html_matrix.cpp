// html_matrix.cpp: the matrix of report.html, as data for its template.
#include "reports/html_matrix.h"

#include <fmt/format.h>

#include <algorithm>

#include "reports/html_case.h"
#include "reports/overview.h"
#include "reports/plain_text.h"

namespace litmus {
namespace {
using kainjow::mustache::data;

constexpr const char* kLights = "light";  // the group of all types of lights

std::string group_of(const std::string& type) {
  return type == "ambient" || type == "all" ? type : kLights;
}

std::vector<std::string> groups_of(const Study& study) {
  std::vector<std::string> groups;
  for (const std::string& type : light_types_of(study))
    if (groups.empty() || groups.back() != group_of(type)) groups.push_back(group_of(type));
  return groups;
}

std::string short_title(const std::string& reference) {
  const std::string title = reference_title(reference);
  return title.substr(0, title.find(' '));
}

Tally tally_of(const Study& study, const Case& one, const std::string& type,
               const std::string& reference) {
  return tally(study, [&](const Comparison& row) {
    return row.scene == one.scene && row.light_type == type && row.reference == reference;
  });
}

std::vector<std::string> own_light_types(const Study& study, const Case& one) {
  std::vector<std::string> types;
  for (const std::string& type : light_types_of(study)) {
    const bool lit = std::any_of(
        study.comparisons.begin(), study.comparisons.end(),
        [&](const Comparison& row) { return row.scene == one.scene && row.light_type == type; });
    if (lit && group_of(type) == kLights) types.push_back(type);
  }
  return types;
}

data matrix_cell(const Study& study, const Case& one, const std::string& type,
                 const std::string& reference) {
  const Tally rows = tally_of(study, one, type, reference);
  data cell = chip(rows, reference);
  const Comparison* shown = rows.failure != nullptr    ? rows.failure
                            : rows.interior != nullptr ? rows.interior
                                                       : rows.largest;
  cell.set("zero", flag(shown != nullptr && shown->verdict == "pass" && shown->max_abs == 0));
  cell.set("type", text_data(type));
  cell.set("empty", flag(rows.rows == 0));
  cell.set("filled", flag(rows.rows > 0));
  cell.set("shown", text_data(light_type_title(type)));
  cell.set("label", text_data(short_title(reference)));
  cell.set("anchor",
           shown != nullptr ? layer_anchor(study, one, shown->light) : case_anchor(study, one));
  return cell;
}

}  // namespace

data light_types_data(const Study& study) {
  data list{data::type::list};
  for (const std::string& type : light_types_of(study)) {
    data one;
    one.set("key", text_data(type));
    one.set("type", text_data(light_type_title(type)));
    list.push_back(one);
  }
  return list;
}

data matrix_heads(const Study& study) {
  data heads{data::type::list};
  for (const std::string& group : groups_of(study)) {
    data references{data::type::list};
    for (const std::string& reference : references_of(study)) {
      data one;
      one.set("short", text_data(short_title(reference)));
      one.set("name", text_data(reference));
      references.push_back(one);
    }
    data head;
    head.set("group", group);
    head.set("title", group == kLights     ? "the lights by themselves"
                      : group == "ambient" ? "ambient light"
                                           : "whole picture");
    head.set("references", references);
    heads.push_back(head);
  }
  return heads;
}

data matrix_lines(const Study& study, const Case& one) {
  std::vector<std::string> types = own_light_types(study, one);
  if (types.empty()) types.emplace_back();  // a scene of ambient light alone has its line, too
  const std::vector<std::string> references = references_of(study);
  data lines{data::type::list};
  for (const std::string& type : types) {
    data cells{data::type::list};
    for (const std::string& group : groups_of(study)) {
      const bool once_more = group != kLights && &type != &types.front();
      for (std::size_t i = 0; i < references.size(); ++i) {
        const std::string shown = group == kLights ? type : group;
        data cell = matrix_cell(study, one, once_more ? "" : shown, references[i]);
        cell.set("group", group);
        cell.set("name", text_data(references[i]));
        cell.set("column", std::to_string(i + 1));
        cell.set("first", flag(i == 0));
        cells.push_back(cell);
      }
    }
    data line;
    line.set("type", text_data(type));
    line.set("cells", cells);
    lines.push_back(line);
  }
  return lines;
}

}  // namespace litmus
