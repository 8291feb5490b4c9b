// candidates_file.h: reads litmus.toml, the list of candidates.
//
//     [[candidate]]
//     name = "mine"                # letters, digits, - _ and . ; the column's head in the report
//     command = ["./my-tracer", "{scene}", "{light}", "{output}.pfm"]
//     encoding = "float"           # default; or png16-linear, png8-linear, png16-srgb, png8-srgb
//     exposure = 1                 # default; the image's values are exposure times linear light
//     time_limit = 300             # seconds for one process; default: --time-limit
//     expect = "equal"             # default; "differs": measured, never judged
//
//     [[candidate]]
//     name = "rendered-before"
//     images = "my-images"         # my-images/SCENE/LIGHT.exr, .pfm or .png; LIGHT may be ambient
//
// Paths are relative to the file.
#pragma once

#include <filesystem>
#include <vector>

#include "reference/candidate.h"

namespace litmus {

/// Reads and checks the file. Throws Refusal "file:line:column: field: what is wrong and what is
/// allowed", also for a file without candidates, a folder that does not exist and a command that
/// does not mention {scene}, {light} and {output}.
std::vector<Candidate> load_candidates(const std::filesystem::path& file);

}  // namespace litmus
