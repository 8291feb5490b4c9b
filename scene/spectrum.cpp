// spectrum.cpp: formulas of spectra and their means over bands.
#include "scene/spectrum.h"

#include <algorithm>
#include <cmath>

namespace litmus {
namespace {

/// Planck's law relative to 560 nm. c2 is the second radiation constant, nm K.
double planck(double nm, double kelvin, double c2) {
  return std::pow(560 / nm, 5) * std::expm1(c2 / (kelvin * 560)) / std::expm1(c2 / (kelvin * nm));
}

/// A formula at every nanometre.
template <class Formula>
Spectrum sampled(Formula formula) {
  Spectrum spectrum;
  for (double nm = kFirstWavelength; nm <= kLastWavelength; ++nm) {
    spectrum.nm.push_back(nm);
    spectrum.values.push_back(formula(nm));
  }
  return spectrum;
}

}  // namespace

double value_at(const Spectrum& spectrum, double nm) {
  const std::vector<double>& x = spectrum.nm;
  const auto above = std::upper_bound(x.begin(), x.end(), nm);
  if (above == x.begin()) return spectrum.values.front();
  if (above == x.end()) return spectrum.values.back();
  const std::size_t i = std::size_t(above - x.begin()) - 1;
  const double part = (nm - x[i]) / (x[i + 1] - x[i]);
  return spectrum.values[i] + part * (spectrum.values[i + 1] - spectrum.values[i]);
}

double mean_over(const Spectrum& spectrum, double from, double to) {
  // Trapezia between the samples inside and the two borders.
  double area = 0, left = from, value = value_at(spectrum, from);
  const auto step_to = [&](double right) {
    const double next = value_at(spectrum, right);
    area += (value + next) / 2 * (right - left);
    left = right, value = next;
  };
  for (const double nm : spectrum.nm)
    if (nm > from && nm < to) step_to(nm);
  step_to(to);
  return area / (to - from);
}

std::vector<double> band_means(const Spectrum& spectrum, int count) {
  const double width = (kLastWavelength - kFirstWavelength) / count;
  std::vector<double> means;
  for (int band = 0; band < count; ++band)
    means.push_back(mean_over(spectrum, kFirstWavelength + band * width,
                              kFirstWavelength + (band + 1) * width));
  return means;
}

Spectrum constant_spectrum(double value) { return {{560}, {value}}; }

Spectrum blackbody(double kelvin) {
  constexpr double kC2 = 1.438776877e7;  // nm K, CODATA 2018
  return sampled([=](double nm) { return planck(nm, kelvin, kC2); });
}

Spectrum illuminant_a() {
  // The standard keeps the c2 of 1931, with which its source has 2848 K.
  return sampled([](double nm) { return planck(nm, 2848, 1.435e7); });
}

}  // namespace litmus
