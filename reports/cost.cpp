// cost.cpp: reading a cost study.
#include "reports/cost.h"

#include <algorithm>

namespace litmus {
namespace {

double own_error(const CostTopic& topic, ErrorMetric metric) {
  const auto all = topic.truth_error.find(CostRegion::All);
  return all == topic.truth_error.end() ? 0 : 3 * all->second[std::size_t(metric)];
}

double error_of(const CostPoint& point, ErrorMetric metric) {
  return point.errors.at(CostRegion::All)[std::size_t(metric)];
}

}  // namespace

std::string_view name_of(CostRegion region) {
  static constexpr std::string_view kNames[] = {"all", "lit", "penumbra", "umbra"};
  return kNames[std::size_t(region)];
}

std::vector<FrontPoint> pareto_front(const CostTopic& topic, ErrorMetric metric) {
  std::vector<FrontPoint> all;
  for (const CostSeries& series : topic.series)
    for (const CostPoint& point : series.points) all.push_back({&series, &point});
  const double floor = own_error(topic, metric);
  const auto error = [&](const FrontPoint& p) {
    return std::max(error_of(*p.point, metric), floor);
  };
  std::stable_sort(all.begin(), all.end(), [&](const FrontPoint& a, const FrontPoint& b) {
    if (a.point->time.least != b.point->time.least)
      return a.point->time.least < b.point->time.least;
    return error(a) < error(b);
  });
  std::vector<FrontPoint> front;
  for (const FrontPoint& one : all)
    if (front.empty() || error(one) < error(front.back())) front.push_back(one);
  return front;
}

FrontPoint cheapest(const CostTopic& topic, std::string_view renderer, ErrorMetric metric,
                    double error) {
  FrontPoint best{nullptr, nullptr};
  if (error < own_error(topic, metric)) return best;
  for (const CostSeries& series : topic.series) {
    if (!renderer.empty() && series.renderer != renderer) continue;
    for (const CostPoint& point : series.points) {
      if (error_of(point, metric) > error) continue;
      if (!best.point || point.time.least < best.point->time.least) best = {&series, &point};
    }
  }
  return best;
}

}  // namespace litmus
