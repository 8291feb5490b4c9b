// alignment.cpp: a registration, confirmed by a second rendering.
#include "reports/alignment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/regions.h"

namespace litmus {

Registration align(const Scene& scene, const RenderOptions& options, const Case& entry,
                   const Picture& theirs, double noise) {
  const CaseLayer& whole = entry.layers.back();
  Registration found = registration(whole.ours, theirs, whole.edge, noise);
  if (!found.determined || std::hypot(found.dx, found.dy) <= kLargestShift) return found;

  RenderOptions moved_options = options;
  moved_options.shift_x += found.dx, moved_options.shift_y += found.dy;
  const Rendering moved = render(scene, moved_options);

  // What an object's outline says, where it was or where it would be. An ambient layer's edges are
  // the outlines.
  std::vector<std::uint8_t> outlines = edge_mask(moved.signatures.front());
  for (std::size_t i = 0; i < outlines.size(); ++i) outlines[i] |= entry.layers.front().edge[i];
  const std::vector<std::uint8_t> everywhere(outlines.size(), 1);
  const double over_all = explained_by_moving(whole.ours, moved.whole, theirs, everywhere, noise);
  if (std::count(outlines.begin(), outlines.end(), 1) > 0) {
    found.explained =
        std::min(over_all, explained_by_moving(whole.ours, moved.whole, theirs, outlines, noise));
    return found;
  }
  Registration unclear;
  unclear.pixels = found.pixels;
  unclear.why = fmt::format(
      "a shift of ({:.3g}, {:.3g}) px explains {:.0f} % of the difference, but no outline of an "
      "object is in the picture, and lamps that are off would look the same",
      found.dx, found.dy, 100 * std::min(over_all, found.explained));
  return unclear;
}

void blame_the_camera(std::span<Comparison> rows, const Registration& registration) {
  const std::string reason = unregistered(registration);
  if (reason.empty()) return;
  for (Comparison& row : rows) {
    const bool stands_for_all = row.light == "all" && row.region == "all";
    if (row.verdict == "skipped" || row.nonfinite > 0) continue;
    if (row.verdict == "pass" && !stands_for_all) continue;
    row.verdict = "fail";
    row.reason = reason;
    row.hint.clear();
  }
}

}  // namespace litmus
