// observer.cpp: the CIE's tables, their stand-ins, and the way to linear sRGB.
#include "scene/observer.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <glm/matrix.hpp>
#include <stdexcept>

namespace litmus {
namespace {

namespace fs = std::filesystem;

/// A table of colord with so many spectra; none if it is not installed.
std::vector<NamedSpectrum> colord_table(const std::string& name, std::size_t count) {
  const fs::path file = colord_file(name);
  if (file.empty()) return {};
  try {
    std::vector<NamedSpectrum> spectra = read_spectra_file(file);
    if (spectra.size() != count)
      throw std::runtime_error(fmt::format("has {} spectra, not {}", spectra.size(), count));
    return spectra;
  } catch (const std::runtime_error& error) {
    throw Refusal(fmt::format("{}: {}: reinstall {}", file.string(), error.what(), kColordPackage));
  }
}

std::string stand_in(const std::string& what) {
  return fmt::format("{}: for the CIE's table apt-get install {}", what, kColordPackage);
}

/// A Gaussian with one slope (1 / nm) below its centre and another above.
double lobe(double nm, double centre, double below, double above) {
  const double t = (nm - centre) * (nm < centre ? below : above);
  return std::exp(-t * t / 2);
}

}  // namespace

fs::path colord_file(const std::string& name) {
  const char* set = std::getenv("XDG_DATA_DIRS");
  std::string folders = set && *set ? set : "/usr/local/share:/usr/share";
  for (std::size_t at = 0; at <= folders.size();) {
    const std::size_t end = std::min(folders.find(':', at), folders.size());
    const fs::path file = fs::path(folders.substr(at, end - at)) / "colord" / name;
    std::error_code error;
    if (fs::is_regular_file(file, error)) return file;
    at = end + 1;
  }
  return {};
}

Observer cie_1931_observer() {
  std::vector<NamedSpectrum> table = colord_table("cmf/CIE1931-2deg-XYZ.cmf", 3);
  if (table.empty()) return gaussian_observer();
  return {table[0].spectrum, table[1].spectrum, table[2].spectrum, ""};
}

Observer gaussian_observer() {
  Observer observer;
  for (double nm = kFirstWavelength; nm <= kLastWavelength; ++nm) {
    for (Spectrum* one : {&observer.x, &observer.y, &observer.z}) one->nm.push_back(nm);
    observer.x.values.push_back(1.056 * lobe(nm, 599.8, 0.0264, 0.0323) +
                                0.362 * lobe(nm, 442.0, 0.0624, 0.0374) -
                                0.065 * lobe(nm, 501.1, 0.0490, 0.0382));
    observer.y.values.push_back(0.821 * lobe(nm, 568.8, 0.0213, 0.0247) +
                                0.286 * lobe(nm, 530.9, 0.0613, 0.0322));
    observer.z.values.push_back(1.217 * lobe(nm, 437.0, 0.0845, 0.0278) +
                                0.681 * lobe(nm, 459.0, 0.0385, 0.0725));
  }
  observer.note = stand_in("the observer is a fit by Gaussians (Wyman, Sloan and Shirley 2013)");
  return observer;
}

const std::vector<std::string>& illuminant_names() {
  static const std::vector<std::string> kNames{"A", "D65", "E"};
  return kNames;
}

Illuminant illuminant(const std::string& name) {
  if (name == "A") return {illuminant_a(), ""};
  if (name == "E") return {constant_spectrum(1), ""};
  const std::vector<NamedSpectrum> table = colord_table("illuminant/CIE-D65.sp", 1);
  if (!table.empty()) return {table[0].spectrum, ""};
  return {blackbody(6504), stand_in("D65 is a blackbody of 6504 K")};
}

std::vector<glm::dvec3> band_xyz(const Observer& observer, const Spectrum& white, int bands) {
  const std::vector<double> x = band_means(observer.x, bands), y = band_means(observer.y, bands),
                            z = band_means(observer.z, bands), w = band_means(white, bands);
  double luminance = 0;
  for (std::size_t b = 0; b < w.size(); ++b) luminance += y[b] * w[b];
  std::vector<glm::dvec3> xyz;
  for (std::size_t b = 0; b < w.size(); ++b)
    xyz.push_back(glm::dvec3(x[b], y[b], z[b]) / luminance);
  return xyz;
}

glm::dvec3 linear_srgb(const glm::dvec3& xyz) {
  static const glm::dmat3 kFromXyz = [] {
    const auto at = [](double x, double y) { return glm::dvec3(x, y, 1 - x - y) / y; };
    glm::dmat3 primaries(at(.64, .33), at(.30, .60), at(.15, .06));
    const glm::dvec3 shares = glm::inverse(primaries) * at(.3127, .3290);
    for (int i = 0; i < 3; ++i) primaries[i] *= shares[i];
    return glm::inverse(primaries);
  }();
  return kFromXyz * xyz;
}

}  // namespace litmus
