// html_case.h: one scene of report.html, as data for the page's template.
#pragma once

#include <kainjow/mustache.hpp>
#include <string>

#include "reports/overview.h"
#include "reports/study.h"

namespace litmus {

/// Clean text as template data; the template escapes it.
kainjow::mustache::data text_data(std::string_view text);

/// A condition for a section of the template.
kainjow::mustache::data flag(bool value);

/// A list for a section of the template, and whether it has anything under "has_NAME".
void set_list(kainjow::mustache::data& data, const std::string& name, kainjow::mustache::data list);

/// JSON for a script element: no "<" may end the element.
std::string script_safe(const std::string& json);

/// The anchor of a scene, or of one of its layers: "s3", "s3-l1". Made of numbers, so that no name
/// gets into it.
std::string case_anchor(const Study& study, const Case& one);
std::string layer_anchor(const Study& study, const Case& one, const std::string& light);

/// A short statement on some rows: verdict, mark, worst interior figure and its share of what is
/// allowed, source, and a sentence for the tooltip.
kainjow::mustache::data chip(const Tally& rows, const std::string& reference);

/// What the page shows of one scene's fold before it is opened.
kainjow::mustache::data case_data(const Study& study, const Case& one, bool open);

/// What a scene's fold holds: its layers with their pictures and rows, the renderers and their
/// logs, as HTML in which all text is escaped.
std::string case_html(const Study& study, const Case& one);

}  // namespace litmus
