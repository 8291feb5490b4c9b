// stress_plot.cpp: one curve against another, drawn without a script.
#include "reports/stress_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/html_shell.h"

namespace litmus {
namespace {

constexpr double kCurveWidth = 320, kCurveHeight = 156, kCurveLeft = 46, kCurveRight = 8,
                 kCurveTop = 22, kCurveBottom = 30;

/// Where values stand in the plot.
struct Scale {
  double x_low, x_high;
  bool logarithmic;
  double low, high;  ///< of the errors, or of their logarithms

  double x(double value) const {
    return kCurveLeft +
           (value - x_low) / (x_high - x_low) * (kCurveWidth - kCurveLeft - kCurveRight);
  }
  /// What is not finite stands above the plot.
  double y(double value) const {
    if (!std::isfinite(value)) return kCurveTop - 12;
    const double v = logarithmic ? std::log10(std::max(value, 1e-300)) : value;
    const double share = std::clamp((v - low) / (high - low), 0.0, 1.0);
    return kCurveHeight - kCurveBottom - share * (kCurveHeight - kCurveBottom - kCurveTop);
  }
};

/// Decades, or 0 to the largest, that hold all finite values.
Scale scale_of(const StressRow& row) {
  const StressCurve& curve = *row.curve;
  double largest = row.bound, smallest = row.bound;
  for (const auto* values : {&curve.robust, &curve.naive}) {
    for (const double value : *values) {
      if (!std::isfinite(value) || value <= 0) continue;
      largest = std::max(largest, value), smallest = std::min(smallest, value);
    }
  }
  if (!curve.logarithmic) return {curve.low, curve.high, false, 0, std::max(largest, 1e-300)};
  // Errors under a hundredth of the bound are as good as none.
  smallest = std::max(smallest, row.bound / 100);
  return {curve.low, curve.high, true, std::floor(std::log10(smallest)),
          std::ceil(std::log10(largest) + 0.01)};
}

std::string path(const Scale& scale, const std::vector<double>& values, const char* name) {
  const double step = (scale.x_high - scale.x_low) / double(values.size());
  std::string steps;
  for (std::size_t i = 0; i < values.size(); ++i) {
    // Each value holds over its whole part of the domain.
    const double y = scale.y(values[i]);
    steps += fmt::format("{}{:.1f} {:.1f}H{:.1f}", i == 0 ? "M" : "L",
                         scale.x(scale.x_low + double(i) * step), y,
                         scale.x(scale.x_low + double(i + 1) * step));
  }
  return fmt::format("<path class=\"{}\" d=\"{}\"/>", name, steps);
}

std::string text(double x, double y, const char* anchor, const std::string& words) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>", x, y, anchor,
                     html_text(words));
}

/// 1, 2 or 5 times a power of ten: the smallest that is not below `least`.
double round_step(double least) {
  const double decade = std::pow(10, std::floor(std::log10(least)));
  for (const double part : {1, 2, 5})
    if (part * decade >= least) return part * decade;
  return 10 * decade;
}

std::string grid(const Scale& scale) {
  std::string lines;
  const auto level = [&](double value, const std::string& label) {
    const double y = scale.y(value);
    lines += fmt::format("<line class=\"grid\" x1=\"{}\" x2=\"{}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>",
                         kCurveLeft, kCurveWidth - kCurveRight, y, y) +
             text(kCurveLeft - 4, y + 3, "end", label);
  };
  if (scale.logarithmic) {
    const double step = std::max(1.0, std::ceil((scale.high - scale.low) / 5));
    for (double decade = scale.low; decade <= scale.high; decade += step)
      level(std::pow(10, decade), decade >= 0 && decade < 4
                                      ? fmt::format("{:.0f}", std::pow(10, decade))
                                      : fmt::format("1e{:.0f}", decade));
  } else {
    for (const double part : {0.0, 0.5, 1.0})
      level(part * scale.high, fmt::format("{:.3g}", part * scale.high));
  }
  const double step = round_step((scale.x_high - scale.x_low) / 4);
  for (double at = std::ceil(scale.x_low / step) * step; at <= scale.x_high; at += step)
    lines += text(scale.x(at), kCurveHeight - kCurveBottom + 12, "middle",
                  fmt::format("{:.3g}", at + 0.0));
  return lines;
}

}  // namespace

std::string stress_plot(const StressRow& row) {
  const Scale scale = scale_of(row);
  const bool broken = std::any_of(row.curve->naive.begin(), row.curve->naive.end(),
                                  [](double value) { return !std::isfinite(value); });
  std::string svg = fmt::format(
      "<svg class=\"plot\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">", kCurveWidth,
      kCurveHeight,
      html_text(fmt::format("{} of {} over {}", row.curve->y_label, row.what, row.curve->x_label)));
  svg += grid(scale);
  if (broken) svg += text(kCurveLeft - 4, kCurveTop - 9, "end", "NaN, inf");
  svg += fmt::format("<line class=\"allowed\" x1=\"{}\" x2=\"{}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>",
                     kCurveLeft, kCurveWidth - kCurveRight, scale.y(row.bound), scale.y(row.bound));
  svg += path(scale, row.curve->naive, "naive") + path(scale, row.curve->robust, "ours");
  svg += text((kCurveLeft + kCurveWidth - kCurveRight) / 2, kCurveHeight - 4, "middle",
              row.curve->x_label);
  return svg + "</svg>";
}

}  // namespace litmus
