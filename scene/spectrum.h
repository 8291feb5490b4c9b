// spectrum.h: quantities per wavelength: formulas, measured files, and means over bands.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace litmus {

inline constexpr double kFirstWavelength = 380, kLastWavelength = 780;  ///< nm, of all bands
inline constexpr int kDefaultBands = 40;                                ///< of 10 nm
inline constexpr int kMostBands = 400;                                  ///< of 1 nm

/// A reflectance or a relative power. Linear between samples; beyond the first and the last one
/// their values hold (as CIE 167:2005 extends measured data). `nm` rises.
struct Spectrum {
  std::vector<double> nm, values;
};

double value_at(const Spectrum& spectrum, double nm);

/// The mean over from..to nm, exact for what lies between the samples.
double mean_over(const Spectrum& spectrum, double from, double to);

/// The means over `count` equal bands of 380..780 nm.
std::vector<double> band_means(const Spectrum& spectrum, int count);

/// The same value everywhere: 1 is the illuminant E.
Spectrum constant_spectrum(double value);

/// Relative power of a blackbody (Planck), 1 at 560 nm; kelvin within 500..100000.
Spectrum blackbody(double kelvin);

/// CIE standard illuminant A by its formula (CIE 15:2004, 3.1), 1 at 560 nm.
Spectrum illuminant_a();

/// One spectrum of a file; the name is empty if the file gives none.
struct NamedSpectrum {
  std::string name;
  Spectrum spectrum;
};

/// Reads a measured file: CGATS with SPECTRAL_START_NM, SPECTRAL_END_NM and SPECTRAL_BANDS (.sp and
/// .cmf of ArgyllCMS and colord), or plain text with a wavelength in nm and a value a line ('#'
/// begins a comment; commas, blanks and tabs separate). Throws std::runtime_error with a reason
/// that fits after "file.sp: ".
std::vector<NamedSpectrum> read_spectra_file(const std::filesystem::path& file);

}  // namespace litmus
