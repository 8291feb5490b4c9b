// cost_sentences.cpp: what a cost study says, in words.
#include <fmt/format.h>

#include "reports/cost_study.h"
#include "reports/plain_text.h"

namespace litmus {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kInSentences{
    {{"litmus", "litmus"}, {"povray", "POV-Ray"}, {"blender", "Cycles"}}};

const CostSeries* series_of(const CostTopic& topic, std::string_view name) {
  for (const CostSeries& series : topic.series)
    if (series.name == name) return &series;
  return nullptr;
}

const CostPoint* first_within(const CostSeries& series, double error) {
  for (const CostPoint& point : series.points)
    if (point.errors.at(CostRegion::All)[std::size_t(ErrorMetric::Max)] <= error) return &point;
  return nullptr;
}

/// "Max error 2e-3: grid n = 32 at 132x the cost of grid n = 1; certified n = 4 at 11x; ...".
std::string price_of(const CostTopic& topic, double error, const CostPoint& unit) {
  std::string text;
  const auto add = [&](const CostPoint& point, std::string_view who) {
    const std::string ratio = short_number(point.time.least / unit.time.least);
    text += text.empty()
                ? fmt::format("{}{} at {}x the cost of {}", who, point.words, ratio, unit.words)
                : fmt::format("; {}{} at {}x", who, point.words, ratio);
  };
  for (const char* name : {"grid", "certified"}) {
    const CostSeries* series = series_of(topic, name);
    const CostPoint* point = series ? first_within(*series, error) : nullptr;
    if (point) add(*point, "");
  }
  for (const auto& [renderer, title] : kInSentences) {
    if (renderer == "litmus") continue;
    const FrontPoint best = cheapest(topic, renderer, ErrorMetric::Max, error);
    if (best.point) add(*best.point, fmt::format("{} with ", title));
  }
  if (text.empty()) return "";
  return fmt::format("Max error {}: {}.", short_number(error), text);
}

}  // namespace

std::vector<std::string> cost_sentences(const CostStudy& study) {
  std::vector<std::string> sentences;
  for (const CostTopic& topic : study.topics) {
    if (topic.name == "precision" || topic.series.empty()) continue;
    const CostPoint& unit = topic.series[0].points[0];
    for (const double error : {2e-2, 2e-3, 7e-4}) {
      const std::string price = price_of(topic, error, unit);
      if (!price.empty()) sentences.push_back(price);
    }
  }
  return sentences;
}

}  // namespace litmus
