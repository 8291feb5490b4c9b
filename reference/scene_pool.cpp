// scene_pool.cpp: threads that take scenes from a common counter.
#include "reference/scene_pool.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace litmus {

void render_in_pool(
    std::span<const Scene> scenes, const ReferenceOptions& options, const std::string& title,
    const std::function<ReferenceResult(const Scene&, const std::filesystem::path& folder)>&
        render_one,
    const ResultSink& sink) {
  std::atomic<std::size_t> next = 0;
  std::mutex reporting;
  std::exception_ptr broken;  // thrown by the sink
  const auto worker = [&] {
    for (std::size_t i = next++; i < scenes.size(); i = next++) {
      ReferenceResult result = render_one(scenes[i], options.work / fmt::format("{:04}", i));
      const std::lock_guard lock(reporting);
      try {
        if (options.progress)
          options.progress(fmt::format("{}: {}{}", title, result.scene,
                                       result.failure.empty() ? "" : ": " + result.failure));
        sink(std::move(result));
      } catch (...) {
        broken = std::current_exception();
        next = scenes.size();
      }
    }
  };
  {
    std::vector<std::jthread> pool;
    const int workers = std::min(std::max(options.threads, 1), int(scenes.size()));
    for (int i = 0; i < workers; ++i) pool.emplace_back(worker);
  }
  if (broken) std::rethrow_exception(broken);
}

}  // namespace litmus
