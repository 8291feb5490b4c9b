// palette.h: the spectra that the colours of a scene may name.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/fields.h"
#include "scene/spectrum.h"

namespace litmus {

struct Palette {
  std::map<std::string, Spectrum> spectra;
  std::map<std::string, std::string> notes;  ///< of those that are only near to what they name

  const Spectrum* find(const std::string& name) const;  ///< nullptr if there is none
  std::vector<std::string> names() const;
};

/// The illuminants and those of `[spectra]`, all read and checked, used or not. Throws Refusal;
/// MissingData (scene/observer.h) for a table of colord that is not installed.
Palette read_palette(const Fields& root);

}  // namespace litmus
