// shift_equations.cpp: normal equations, with the terms of shading eliminated.
#include "compare/shift_equations.h"

#include <algorithm>
#include <cmath>

namespace litmus {
namespace {

/// Takes a term out of all others (Gauss and Jordan, on the symmetric matrix). One that is nothing
/// but those taken out before is skipped.
void eliminate(ShiftMatrix& m, std::size_t term, double original) {
  if (!(m[term][term] > 1e-12 * original)) {
    for (std::size_t i = 0; i < kShiftTerms; ++i) m[i][term] = m[term][i] = 0;
    return;
  }
  const ShiftTerms pivot = m[term];
  for (std::size_t i = 0; i < kShiftTerms; ++i) {
    if (i == term) continue;
    const double factor = m[i][term] / pivot[term];
    for (std::size_t j = 0; j < kShiftTerms; ++j) m[i][j] -= factor * pivot[j];
  }
}

}  // namespace

ShiftEquations shift_equations(std::span<const ShiftObservation> seen) {
  std::array<ShiftMatrix, 3> sums{};
  ShiftEquations result;
  for (const ShiftObservation& one : seen) {
    result.weight += one.weight;
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < kShiftTerms; ++i)
        for (std::size_t j = i; j < kShiftTerms; ++j)
          sums[c][i][j] += one.weight * one.channels[c][i] * one.channels[c][j];
  }
  for (std::size_t c = 0; c < 3; ++c) {
    ShiftMatrix& m = sums[c];
    for (std::size_t i = 0; i < kShiftTerms; ++i)
      for (std::size_t j = 0; j < i; ++j) m[i][j] = m[j][i];
    const double squares = m[1][1];
    eliminate(m, 0, m[0][0]);
    eliminate(m, 1, squares);
    for (std::size_t i = 0; i < kFirstOfShift; ++i)
      result.shading[c][i] = m[i][i] > 0 ? m[i][kShiftTerms - 1] / m[i][i] : 0;
    for (std::size_t i = kFirstOfShift; i < kShiftTerms; ++i)
      for (std::size_t j = kFirstOfShift; j < kShiftTerms; ++j) result.m[i][j] += m[i][j];
  }
  return result;
}

std::optional<std::array<double, 3>> shift_step(const ShiftEquations& normal, std::size_t count) {
  ShiftMatrix m = normal.m;
  std::array<double, 3> result{};
  for (std::size_t i = kFirstOfShift; i < kFirstOfShift + count; ++i) {
    if (!(m[i][i] > 1e-10 * normal.m[i][i])) return {};
    eliminate(m, i, 0);
  }
  for (std::size_t i = 0; i < count; ++i)
    result[i] = -m[kFirstOfShift + i][kShiftTerms - 1] / m[kFirstOfShift + i][kFirstOfShift + i];
  return result;
}

std::array<double, 2> gradient_strengths(const ShiftEquations& normal) {
  const double xx = normal.m[kFirstOfShift][kFirstOfShift],
               yy = normal.m[kFirstOfShift + 1][kFirstOfShift + 1];
  const double xy = normal.m[kFirstOfShift][kFirstOfShift + 1];
  const double middle = (xx + yy) / 2, apart = std::hypot((xx - yy) / 2, xy);
  return {std::max(0.0, middle - apart), middle + apart};
}

void reweigh(std::vector<ShiftObservation>& seen, const ShiftEquations& normal, double noise) {
  std::vector<double> errors, gradients, telling;
  double mean = 0;
  for (const ShiftObservation& one : seen) {
    double error = 0, gradient = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const ShiftTerms& t = one.channels[c];
      const double left = t[5] - normal.shading[c][0] - normal.shading[c][1] * t[1];
      error += left * left, gradient += t[2] * t[2] + t[3] * t[3];
    }
    errors.push_back(error), gradients.push_back(gradient);
    mean += gradient / double(seen.size());
  }
  for (std::size_t i = 0; i < seen.size(); ++i)
    if (gradients[i] >= mean / 2) telling.push_back(errors[i]);
  if (telling.empty()) return;
  const auto middle = telling.begin() + std::ptrdiff_t(telling.size() / 2);
  std::nth_element(telling.begin(), middle, telling.end());
  const double scale =
      std::max({36 * *middle, 27 * noise * noise, 300 * kFloatNoise * kFloatNoise});
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const double root = 1 / (1 + errors[i] / scale);
    seen[i].weight = root * root;
  }
}

}  // namespace litmus
