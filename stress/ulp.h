// ulp.h: errors against quad precision, in units of the last place.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <type_traits>
#include <vector>

#include "stress/stress.h"
#include "tracer/value.h"

namespace litmus {

template <Real R>
constexpr std::string_view kScalarName = std::is_same_v<R, float> ? "float" : "double";

/// |seen - exact| in units of the last place of the exact value in R; infinite if `seen` is not
/// finite. Below the smallest normal number the unit is that number: results so small are as good
/// as 0 in any picture, and no scalar of the kernel claims digits there.
template <Real R>
double ulps(R seen, const Quad& exact) {
  if (!std::isfinite(seen)) return std::numeric_limits<double>::infinity();
  const R near = std::fabs(R(exact));
  const R smallest = std::numeric_limits<R>::min();
  const R unit =
      near < smallest ? smallest : std::ldexp(std::numeric_limits<R>::epsilon(), std::ilogb(near));
  return double(fabs(Quad(seen) - exact) / Quad(unit));
}

/// The largest errors of the robust and the naive form, over all and by the domain's coordinate.
struct UlpTally {
  double low = 0, high = 1;
  double robust = 0, naive = 0;
  std::vector<double> robust_bins = std::vector<double>(48), naive_bins = robust_bins;

  void note(double x, double robust_error, double naive_error) {
    robust = std::max(robust, robust_error), naive = std::max(naive, naive_error);
    const double bins = double(robust_bins.size());
    const double place = std::clamp((x - low) / (high - low) * bins, 0.0, bins - 1);
    double& a = robust_bins[std::size_t(place)];
    double& b = naive_bins[std::size_t(place)];
    a = std::max(a, robust_error), b = std::max(b, naive_error);
  }
  void add(const UlpTally& other) {
    robust = std::max(robust, other.robust), naive = std::max(naive, other.naive);
    for (std::size_t i = 0; i < robust_bins.size(); ++i) {
      robust_bins[i] = std::max(robust_bins[i], other.robust_bins[i]);
      naive_bins[i] = std::max(naive_bins[i], other.naive_bins[i]);
    }
  }
};

}  // namespace litmus
