// gauss.h: Gauss-Legendre quadrature.
#pragma once

#include <vector>

namespace litmus {

/// Nodes (-1 to 1) and weights (adding up to 1) of n points.
struct GaussRule {
  std::vector<double> nodes, weights;
};

/// n >= 1, by Newton's method on Legendre polynomials (Press et al. 2007, section 4.6).
GaussRule gauss_rule(int n);

inline constexpr int kMostPoints = 4;  ///< along a side of a piece of an area light

/// The same of at most kMostPoints, made once.
const GaussRule& short_rule(int n);

}  // namespace litmus
