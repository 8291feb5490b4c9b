// observer.h: what the eye makes of light: the CIE 1931 2-degree observer, and linear sRGB.
#pragma once

#include <filesystem>
#include <glm/mat3x3.hpp>
#include <string>
#include <vector>

#include "scene/refusal.h"
#include "scene/spectrum.h"

namespace litmus {

/// A scene that is right, but needs data of a package that is not installed; the message names it.
struct MissingData : Refusal {
  using Refusal::Refusal;
};

/// The package of the CIE's tables, which are read where they are installed, never kept here.
inline constexpr const char* kColordPackage = "colord-data";

/// A table of colord, such as "illuminant/CIE-D65.sp", below the first of $XDG_DATA_DIRS (default
/// /usr/local/share:/usr/share) that has it; an empty path if none does.
std::filesystem::path colord_file(const std::string& name);

struct Observer {
  Spectrum x, y, z;
  std::string note;  ///< what it is only near to, and the remedy; empty for the CIE's own table
};

/// The CIE's table from colord, else the fit by Gaussians of Wyman, Sloan and Shirley (Simple
/// Analytic Approximations to the CIE XYZ Color Matching Functions, JCGT 2(2), 2013): within .0138,
/// .0073, .0221 of it. Throws Refusal if the table is damaged.
Observer cie_1931_observer();

/// That fit, whatever is installed.
Observer gaussian_observer();

/// An illuminant with what it is only near to.
struct Illuminant {
  Spectrum spectrum;
  std::string note;
};

/// "A", "D65" or "E", each 1 at 560 nm. D65 is the CIE's table from colord, else a blackbody of its
/// correlated colour temperature, 6504 K. Throws Refusal if the table is damaged.
Illuminant illuminant(const std::string& name);

/// The three names, in that order.
const std::vector<std::string>& illuminant_names();

/// XYZ of each of `bands` bands of 380..780 nm with the value 1, so that D65 has Y = 1 (`white` is
/// its spectrum).
std::vector<glm::dvec3> band_xyz(const Observer& observer, const Spectrum& white, int bands);

/// XYZ where D65 has Y = 1 to linear sRGB: the primaries of Rec. 709 and the white (.3127, .3290),
/// without adaptation. Negative for a colour that no mixture of the primaries shows.
glm::dvec3 linear_srgb(const glm::dvec3& xyz);

}  // namespace litmus
