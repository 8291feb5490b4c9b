// write_cost_json.cpp: cost.json.
#include <nlohmann/json.hpp>

#include "reports/plain_text.h"
#include "reports/provenance_json.h"
#include "reports/write_cost.h"

namespace litmus {
namespace {

using Json = nlohmann::ordered_json;

Json errors_json(const CostFigures& figures) {
  Json all = Json::object();
  for (const auto& [region, errors] : figures) {
    Json& row = all[std::string(name_of(region))];
    for (const ErrorMetric metric : kErrorMetrics)
      row[std::string(metric_name(metric))] = errors[std::size_t(metric)];
  }
  return all;
}

Json time_json(const CostTime& time) {
  return {{"least", time.least},
          {"median", time.median},
          {"spread", time.spread},
          {"repeats", time.repeats}};
}

Json series_json(const CostSeries& series) {
  Json points = Json::array(), fits = Json::array();
  for (const CostPoint& point : series.points) {
    points.push_back({{"knob", point.knob},
                      {"setting", clean_text(point.words)},
                      {"errors", errors_json(point.errors)},
                      {"seconds", time_json(point.time)}});
  }
  for (const CostFit& fit : series.fits) {
    fits.push_back({{"region", name_of(fit.region)},
                    {"metric", metric_name(fit.metric)},
                    {"order", fit.order},
                    {"low", fit.low},
                    {"high", fit.high},
                    {"points", fit.points}});
  }
  return {{"name", series.name}, {"renderer", series.renderer}, {"title", series.title},
          {"knob", series.knob}, {"exact", series.exact},       {"points", points},
          {"fits", fits}};
}

Json effects_json(const EffectUse& use) {
  Json called_for = Json::array(), left_out = Json::array(), counts = Json::object();
  for (const EffectName& effect : effect_names())
    (use.called_for.*effect.member ? called_for : left_out).push_back(effect.name);
  for (const CountName& count : count_names())
    counts[std::string(count.name)] = {{"needed", use.needed.*count.member},
                                       {"all", use.all.*count.member}};
  return {{"scene", clean_text(use.scene)},
          {"called_for", called_for},
          {"left_out", left_out},
          {"counts", counts},
          {"identical", use.identical},
          {"seconds", {{"needed", time_json(use.needed_time)}, {"all", time_json(use.all_time)}}}};
}

Json topic_json(const CostTopic& topic) {
  Json series = Json::array(), front = Json::object();
  for (const CostSeries& one : topic.series) series.push_back(series_json(one));
  for (const ErrorMetric metric : kErrorMetrics) {
    Json& list = front[std::string(metric_name(metric))] = Json::array();
    for (const FrontPoint& one : pareto_front(topic, metric))
      list.push_back({{"series", one.series->name}, {"knob", one.point->knob}});
  }
  return {{"name", topic.name},
          {"title", topic.title},
          {"aim", topic.aim},
          {"truth", topic.truth},
          {"truth_error", errors_json(topic.truth_error)},
          {"series", series},
          {"front", front}};
}

}  // namespace

std::string cost_json(const CostStudy& study) {
  Json topics = Json::array(), missing = Json::array(), start_up = Json::object();
  for (const CostTopic& topic : study.topics) topics.push_back(topic_json(topic));
  Json effects = Json::array(), effects_left_out = Json::array();
  for (const EffectUse& use : study.effects) effects.push_back(effects_json(use));
  for (const std::string& line : study.effects_left_out)
    effects_left_out.push_back(clean_text(line));
  for (const std::string& line : study.missing) missing.push_back(clean_text(line));
  for (const auto& [renderer, seconds] : study.start_up) start_up[renderer] = seconds;
  const Json all{{"schema_version", 1},
                 {"provenance", provenance_fields(study.provenance)},
                 {"scene",
                  {{"name", clean_text(study.scene)},
                   {"about", clean_text(study.about)},
                   {"width", study.width},
                   {"height", study.height}}},
                 {"quick", study.quick},
                 {"topics", topics},
                 {"effects", effects},
                 {"effects_left_out", effects_left_out},
                 {"sentences", study.sentences},
                 {"missing", missing},
                 {"start_up_seconds", start_up}};
  return all.dump(1);
}

}  // namespace litmus
