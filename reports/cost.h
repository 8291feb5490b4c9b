// cost.h: what accuracy costs in time, measured for one scene.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "reports/study.h"
#include "tracer/effects.h"
#include "tracer/error_metric.h"

namespace litmus {

/// The pixels that a figure is about. Lit: every light is fully seen. Umbra: a light is wholly
/// hidden, and none partly. Penumbra: a light is partly hidden. `All` holds the rest as well.
enum class CostRegion { All, Lit, Penumbra, Umbra };
inline constexpr std::array kCostRegions{CostRegion::All, CostRegion::Lit, CostRegion::Penumbra,
                                         CostRegion::Umbra};
/// "all", "lit", "penumbra", "umbra".
std::string_view name_of(CostRegion region);

/// A figure for each ErrorMetric, in its order.
using CostErrors = std::array<double, 3>;
/// Per region; regions without pixels are left out.
using CostFigures = std::map<CostRegion, CostErrors>;

/// Seconds for one picture, without any start-up.
struct CostTime {
  double least = 0, median = 0;
  double spread = 0;  ///< median absolute deviation
  int repeats = 0;
};

/// One setting.
struct CostPoint {
  double knob = 0;    ///< the number that the series turns
  std::string words;  ///< the setting, for people
  CostFigures errors;
  CostTime time;
};

/// error ~ knob^order, fitted to log error over log knob.
struct CostFit {
  CostRegion region = CostRegion::All;
  ErrorMetric metric = ErrorMetric::Max;
  double order = 0, low = 0, high = 0;  ///< with its 95 % bootstrap interval
  int points = 0;
};

/// One thing that is turned.
struct CostSeries {
  std::string name;      ///< "grid", "certified", "povray-grid", ...
  std::string renderer;  ///< "litmus", "povray" or "blender"
  std::string title;     ///< "litmus, grid of cell centres"
  std::string knob;      ///< what the number counts: "samples a side"
  bool exact = true;     ///< false: it shows something else in the limit, see `title`
  std::vector<CostPoint> points;
  std::vector<CostFit> fits;
};

/// Series with one aim.
struct CostTopic {
  std::string name;  ///< "area", "pixel", "precision", "skipping"
  std::string title, aim;
  std::string truth;        ///< what stands for the aim
  CostFigures truth_error;  ///< how far that is off, estimated
  std::vector<CostSeries> series;
};

/// One scene rendered with what it calls for, and with every effect everywhere.
struct EffectUse {
  std::string scene;
  Effects called_for;
  Counts needed, all;      ///< rays and evaluations with the one and with the other
  bool identical = false;  ///< both pictures, and each light's, bit by bit
  CostTime needed_time, all_time;

  double saving() const;  ///< how many times longer every effect takes
};

struct CostStudy {
  std::string scene, about;
  int width = 0, height = 0;
  bool quick = false;
  std::vector<CostTopic> topics;
  std::vector<EffectUse> effects;             ///< of many scenes; may be empty
  std::vector<std::string> effects_left_out;  ///< scenes without such a row, and why
  std::vector<std::string> sentences;         ///< what follows, for people
  std::vector<std::string> missing;           ///< what could not be measured, and why
  std::map<std::string, double> start_up;  ///< seconds of wall clock per renderer, not in any time
  Provenance provenance;
};

/// A setting that no other one beats in both time and error: neither as exact and faster, nor as
/// fast and more exact. `All` and the metric decide; errors below three times the truth's own are
/// equal. In order of time.
struct FrontPoint {
  const CostSeries* series;
  const CostPoint* point;
};
std::vector<FrontPoint> pareto_front(const CostTopic& topic, ErrorMetric metric);

/// The cheapest setting of a renderer ("": any) with at most that error over all pixels, nullptrs
/// if there is none. No answer is given below three times the truth's own error.
FrontPoint cheapest(const CostTopic& topic, std::string_view renderer, ErrorMetric metric,
                    double error);

/// The errors that a reader asks for.
inline constexpr double kAskedErrors[] = {1e-1, 3e-2, 1e-2, 3e-3, 2e-3, 1e-3,
                                          7e-4, 3e-4, 1e-4, 1e-6, 1e-9, 1e-12};

}  // namespace litmus
