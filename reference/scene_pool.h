// scene_pool.h: renders many scenes, some at a time, each with a call of its own.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>

#include "reference/drivers.h"

namespace litmus {

/// Calls `render_one` for each scene with a folder of its own below options.work, in
/// options.threads threads; reports "title: scene" as progress and gives each result to the sink,
/// one at a time. If the sink throws, no further scene is begun and the exception goes on.
void render_in_pool(
    std::span<const Scene> scenes, const ReferenceOptions& options, const std::string& title,
    const std::function<ReferenceResult(const Scene&, const std::filesystem::path& folder)>&
        render_one,
    const ResultSink& sink);

}  // namespace litmus
