// page_data.cpp: the pictures of a scene as JSON for the page.
#include "reports/page_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "compare/difference.h"
#include "reports/overview.h"
#include "reports/plain_text.h"

namespace litmus {
namespace {
using nlohmann::ordered_json;

// Differences are kept to this part of the tolerance where a row of the scene fails, else to that.
constexpr double kStepsOfFailures = 256, kStepsOfPasses = 32;
constexpr double kStepsOfLargest = 64;  // Detail::Coarse

ordered_json packed_json(const PackedPicture& picture) {
  return {
      {"exponent", picture.exponent}, {"guess", name_of(picture.guess)}, {"data", picture.data}};
}

const Comparison* row_of(const std::vector<Comparison>& rows, const Case& one,
                         const CaseLayer& layer, const std::string& reference, Region region) {
  for (const Comparison& row : rows)
    if (row.scene == one.scene && row.light == layer.light && row.reference == reference &&
        row.region == name_of(region) && row.against == "litmus")
      return &row;
  return nullptr;
}

bool scene_fails(const Study& study, const Case& one) {
  return tally(study, [&](const Comparison& row) { return row.scene == one.scene; }).failed > 0;
}

ordered_json theirs_json(const Study& study, const Case& one, const CaseLayer& layer,
                         const CaseLayer::Theirs& theirs, bool judged, Detail detail) {
  const std::vector<Comparison>& rows = judged ? study.comparisons : study.informative;
  ordered_json result{{"reference", clean_text(theirs.reference)},
                      {"title", clean_text(reference_title(theirs.reference))},
                      {"source", theirs.source},
                      {"judged", judged}};
  double inside = 0;
  for (const Region region : {Region::Interior, Region::Edge}) {
    const Comparison* row = row_of(rows, one, layer, theirs.reference, region);
    const double allowed = row != nullptr ? row->tolerance : 0;
    result["allowed"].push_back(allowed);
    if (region == Region::Interior) inside = allowed;
  }
  const double steps = scene_fails(study, one) ? kStepsOfFailures : kStepsOfPasses;
  double finest = inside / steps;
  const Picture difference = packed_difference(layer.ours, theirs.picture);
  if (detail == Detail::Coarse)
    finest = std::max(finest, largest_finite(difference) / kStepsOfLargest);
  const double step = finest > 0 ? std::exp2(std::floor(std::log2(finest))) : 0;
  result["step"] = step;
  result["difference"] = packed_json(packed(difference, step));
  return result;
}

// What closed forms say of a layer, as one more reference. Where they say nothing the difference is
// 0, and so is `known`, which is left out where they say something of all pixels.
ordered_json exact_json(const Study& study, const Case& one, const CaseLayer& layer,
                        Detail detail) {
  CaseLayer::Theirs theirs{kClosedForm, "computed", layer.exact.picture};
  for (std::size_t i = 0; i < theirs.picture.pixels.size(); ++i)
    if (!layer.exact.known[i]) theirs.picture.pixels[i] = layer.ours.pixels[i];
  ordered_json result = theirs_json(study, one, layer, theirs, true, detail);
  const std::string known(layer.exact.known.begin(), layer.exact.known.end());
  if (known.find('\0') != std::string::npos) result["known"] = deflated(known);
  return result;
}

ordered_json layer_json(const Study& study, const Case& one, const CaseLayer& layer,
                        Detail detail) {
  const std::string edge(layer.edge.begin(), layer.edge.end());
  const std::string flags(layer.flags.begin(), layer.flags.end());
  ordered_json result{{"light", clean_text(layer.light)},
                      {"type", layer.light_type},
                      {"ours", packed_json(packed(layer.ours))},
                      {"edge", deflated(edge)},
                      {"flags", deflated(flags)},
                      {"theirs", ordered_json::array()}};
  for (const CaseLayer::Theirs& theirs : layer.theirs)
    if (same_size(layer.ours, theirs.picture))
      result["theirs"].push_back(theirs_json(study, one, layer, theirs, true, detail));
  if (same_size(layer.ours, layer.exact.picture))
    result["theirs"].push_back(exact_json(study, one, layer, detail));
  for (const CaseLayer::Theirs& theirs : layer.aside)
    if (same_size(layer.ours, theirs.picture))
      result["theirs"].push_back(theirs_json(study, one, layer, theirs, false, detail));
  return result;
}

// A picture that the scene has shown before is named by its place instead: the whole of one light
// is that light.
void name_repeated(ordered_json& layers) {
  std::map<std::string, std::string> seen;
  const auto once = [&](ordered_json& picture, const std::string& place) {
    const auto [known, fresh] = seen.emplace(picture.dump(), place);
    if (!fresh) picture = ordered_json{{"same", known->second}};
  };
  for (std::size_t k = 0; k < layers.size(); ++k) {
    once(layers[k]["ours"], fmt::format("{}", k));
    ordered_json& theirs = layers[k]["theirs"];
    for (std::size_t r = 0; r < theirs.size(); ++r)
      once(theirs[r]["difference"], fmt::format("{},{}", k, r));
  }
}

// Whether the whole is the sum of its parts as the page has them, to a half float's rounding.
bool is_sum(std::span<const CaseLayer> layers) {
  const Picture& whole = layers.back().ours;
  Picture sum(whole.width, whole.height);
  for (const CaseLayer& part : layers.first(layers.size() - 1)) {
    const Picture known = as_unpacked(part.ours);
    if (!same_size(known, sum)) return false;
    for (std::size_t i = 0; i < sum.pixels.size(); ++i) sum.pixels[i] += known.pixels[i];
  }
  const double smallest = std::ldexp(largest_finite(whole), -38);
  for (std::size_t i = 0; i < sum.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double is = whole.pixels[i][c];
      if (!(std::abs(sum.pixels[i][c] - is) <= std::ldexp(std::abs(is), -11) + smallest))
        return false;
    }
  return true;
}

}  // namespace

Picture packed_difference(const Picture& ours, const Picture& theirs) {
  Picture result(ours.width, ours.height);
  for (std::size_t i = 0; i < result.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double own = ours.pixels[i][c];
      result.pixels[i][c] = (std::isfinite(own) ? own : 0) - theirs.pixels[i][c];
    }
  return result;
}

std::string shell_word(const std::string& text) {
  const std::string word = clean_text(text);
  const bool plain = !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) ||
           std::string_view("/._-").find(c) != std::string_view::npos;
  });
  if (plain) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string scene_word(const Case& one) {
  const std::filesystem::path file(one.file);
  const bool canonical = file.parent_path().filename() == "canonical" && file.stem() == one.scene;
  return shell_word(canonical || one.file.empty() ? one.scene : one.file);
}

std::string pictures_json(const Study& study, const Case& one, Detail detail) {
  ordered_json result{{"scene", clean_text(one.scene)},
                      {"word", scene_word(one)},
                      {"width", one.width},
                      {"height", one.height},
                      {"layers", ordered_json::array()}};
  for (const CaseLayer& layer : one.layers)
    result["layers"].push_back(layer_json(study, one, layer, detail));
  name_repeated(result["layers"]);
  ordered_json& whole = result["layers"].back()["ours"];
  if (whole.contains("data") && is_sum(one.layers)) whole = ordered_json{{"sum", true}};
  return result.dump();
}

std::vector<std::string> pictures_within(const Study& study, std::size_t budget) {
  // All scenes at the same time: packing them takes most of the page's time.
  std::vector<std::future<std::string>> running;
  for (const Case& one : study.cases)
    running.push_back(
        std::async(std::launch::async, [&study, &one] { return pictures_json(study, one); }));
  std::vector<std::string> pictures;
  std::size_t total = 0;
  for (auto& each : running) total += pictures.emplace_back(each.get()).size();
  const std::vector<const Case*> worst_first = cases_by_verdict(study);
  for (auto one = worst_first.rbegin(); one != worst_first.rend() && total > budget; ++one) {
    if (!scene_fails(study, **one)) continue;
    std::string& picture = pictures[std::size_t(*one - study.cases.data())];
    total -= picture.size();
    picture = pictures_json(study, **one, Detail::Coarse);
    total += picture.size();
  }
  return pictures;
}

}  // namespace litmus
