// gauss.cpp: the roots of Legendre polynomials.
#include "tracer/gauss.h"

#include <array>
#include <cmath>
#include <numbers>

namespace litmus {

GaussRule gauss_rule(int n) {
  GaussRule rule;
  for (int i = 0; i < n; ++i) {
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5)), slope = 0, step = 1;
    while (std::fabs(step) > 1e-16) {
      double p = 1, previous = 0;
      for (int k = 1; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * p - (k - 1) * previous) / k;
        previous = p, p = next;
      }
      slope = n * (x * p - previous) / (x * x - 1);
      step = p / slope;
      if (x == x - step) break;
      x -= step;
    }
    rule.nodes.push_back(x);
    rule.weights.push_back(1 / ((1 - x * x) * slope * slope));
  }
  return rule;
}

const GaussRule& short_rule(int n) {
  static const std::array rules{gauss_rule(1), gauss_rule(2), gauss_rule(3), gauss_rule(4)};
  static_assert(rules.size() == kMostPoints);
  return rules[std::size_t(n - 1)];
}

}  // namespace litmus
