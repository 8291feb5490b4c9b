// error_metric.h: how far a picture is from another, as one number.
#pragma once

#include <string_view>
#include <vector>

#include "scene/picture.h"

namespace litmus {

/// Of each pixel the channel that is furthest off counts, absolute, in linear RGB. Max: the worst
/// pixel. P99: the smallest figure that 99 % of the pixels keep. Rms: the root of the mean square.
enum class ErrorMetric { Max, P99, Rms };
inline constexpr ErrorMetric kErrorMetrics[] = {ErrorMetric::Max, ErrorMetric::P99,
                                                ErrorMetric::Rms};

/// "max", "p99", "rms".
std::string_view metric_name(ErrorMetric metric);

/// Each pixel's error. Both pictures have one size.
std::vector<double> pixel_errors(const Picture& ours, const Picture& truth);

/// 0 without pixels.
double error_of(std::vector<double> errors, ErrorMetric metric);

}  // namespace litmus
