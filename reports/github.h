// github.h: failures as annotations that GitHub shows beside the scene's file.
#pragma once

#include <string>

#include "reports/study.h"

namespace litmus {

/// GitHub shows ten errors of a step and drops the rest without a word; the last one counts them.
inline constexpr std::size_t kAnnotations = 10;

/// Text of a workflow command: % and line ends are escaped, in a property : and , too.
std::string github_text(std::string_view text);
std::string github_property(std::string_view text);

/// One line "::error file=scene/canonical/s5.toml,line=20,title=...::..." for each renderer that
/// failed, each row that is worse than its baseline, and each light that fails, worst first; at
/// most kAnnotations lines, the last of which then says how many more there are. `line` is that of
/// the light's [[light]], if the file can be read. Files are called as in the study, so litmus has
/// to run in the repository's top folder.
std::string github_annotations(const Study& study);

}  // namespace litmus
