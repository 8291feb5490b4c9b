// web_assets.h: the files of reports/web/, as text inside the program (see CMakeLists.txt).
#pragma once

#include <string_view>

namespace litmus {

extern const std::string_view kPageTemplate;   ///< page.html, a mustache template
extern const std::string_view kCaseTemplate;   ///< case.html, what a scene's fold holds
extern const std::string_view kShellTemplate;  ///< shell.html, of small pages
extern const std::string_view kPageStyle;      ///< page.css
extern const std::string_view kPageScript;     ///< all *.js, one after the other
extern const std::string_view kCostScript;     ///< cost.js
extern const std::string_view kPeersScript;    ///< peers.js
extern const std::string_view kChartScript;    ///< Chart.js

}  // namespace litmus
