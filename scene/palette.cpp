// palette.cpp: [spectra] of a scene file, one spectrum a table.
#include "scene/palette.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "scene/observer.h"
#include "scene/words.h"

namespace litmus {
namespace {

constexpr Range kKelvin{500, true, "kelvin in 500..100000", 100'000, true};
constexpr std::string_view kPairs =
    "a list of [nm, value] pairs with rising nm > 0 and values >= 0, such as [[400, 0.1], [700, "
    "0.8]]";

// ---- One spectrum ----------------------------------------------------------------------------

double plain_number(const Node& node) {
  if (const auto* integer = std::get_if<std::int64_t>(&node.value)) return double(*integer);
  const auto* number = std::get_if<double>(&node.value);
  return number ? *number : -1;
}

Spectrum read_samples(const Fields& fields) {
  const Node& node = *fields.find("samples");
  const auto* pairs = std::get_if<Node::Array>(&node.value);
  if (!pairs || pairs->empty()) fields.refuse_value("samples", node, kPairs);
  Spectrum spectrum;
  for (const Node& pair : *pairs) {
    const auto* two = std::get_if<Node::Array>(&pair.value);
    if (!two || two->size() != 2) fields.refuse_value("samples", pair, kPairs);
    const double nm = plain_number((*two)[0]), value = plain_number((*two)[1]);
    const double last = spectrum.nm.empty() ? 0 : spectrum.nm.back();
    if (!(Range{last, false}.holds(nm) && kNotNegative.holds(value)))
      fields.refuse_value("samples", pair, kPairs);
    spectrum.nm.push_back(nm), spectrum.values.push_back(value);
  }
  return spectrum;
}

/// The one that `sample` names, or the only one.
Spectrum chosen(const Fields& fields, const std::string& key,
                const std::vector<NamedSpectrum>& spectra) {
  std::vector<std::string> names;
  for (const NamedSpectrum& one : spectra) names.push_back(one.name);
  if (!fields.has("sample")) {
    if (spectra.size() == 1) return spectra.front().spectrum;
    fields.refuse(key, fmt::format("has {} spectra; choose one by sample = \"{}\"", spectra.size(),
                                   names.front()));
  }
  const std::string wanted = fields.text("sample");
  const auto found = std::find(names.begin(), names.end(), wanted);
  if (found == names.end()) fields.refuse_word("sample", wanted, names);
  return spectra[std::size_t(found - names.begin())].spectrum;
}

Spectrum read_measured(const Fields& fields, const std::string& key,
                       const std::filesystem::path& file) {
  std::vector<NamedSpectrum> spectra;
  try {
    spectra = read_spectra_file(file);
  } catch (const std::runtime_error& error) {
    fields.refuse(key, fmt::format("{}: {}", file.string(), error.what()));
  }
  Spectrum spectrum = chosen(fields, key, spectra);
  for (std::size_t i = 0; i < spectrum.values.size(); ++i)
    if (!(spectrum.values[i] >= 0))
      fields.refuse(key, fmt::format("{}: is negative at {} nm ({})", file.string(), spectrum.nm[i],
                                     spectrum.values[i]));
  return spectrum;
}

Spectrum read_colord(const Fields& fields) {
  const std::string name = fields.text("colord");
  const std::filesystem::path file = colord_file(name);
  if (file.empty())
    throw MissingData(fmt::format(
        "{}:{}:{}: colord: there is no share/colord/{}: apt-get install {}, or name another table "
        "of that package",
        fields.file().string(), fields.place("colord").line, fields.place("colord").column, name,
        kColordPackage));
  return read_measured(fields, "colord", file);
}

// ---- The table of spectra --------------------------------------------------------------------

/// The key that says where a spectrum comes from.
std::string kind_of(const Fields& fields) {
  const std::vector<std::string> kinds{"samples", "blackbody_kelvin", "illuminant", "file",
                                       "colord"};
  std::vector<std::string> given;
  for (const std::string& kind : kinds)
    if (fields.has(kind)) given.push_back(kind);
  if (given.empty())
    fields.refuse("spectrum", fmt::format("must have one of {}", listed(kinds, "or")));
  if (given.size() > 1)
    fields.refuse(given[1],
                  fmt::format("a spectrum has one source; leave out {} or this one", given[0]));
  return given.front();
}

Spectrum read_spectrum(const Fields& fields, const std::string& name, Palette& palette) {
  fields.only({"samples", "blackbody_kelvin", "illuminant", "file", "colord", "sample", "scale"});
  const std::string kind = kind_of(fields);
  if (fields.has("sample") && kind != "file" && kind != "colord")
    fields.refuse("sample", "chooses a spectrum of a file; leave it out");
  const double scale = fields.number("scale", kNotNegative, 1);
  Spectrum spectrum;
  if (kind == "samples") spectrum = read_samples(fields);
  if (kind == "blackbody_kelvin") spectrum = blackbody(fields.number(kind, kKelvin));
  if (kind == "illuminant") {
    const std::string word = fields.text(kind);
    if (!std::count(illuminant_names().begin(), illuminant_names().end(), word))
      fields.refuse_word(kind, word, illuminant_names());
    spectrum = *palette.find(word);
    if (palette.notes.contains(word)) palette.notes[name] = palette.notes[word];
  }
  if (kind == "file")
    spectrum = read_measured(fields, kind, fields.file().parent_path() / fields.text(kind));
  if (kind == "colord") spectrum = read_colord(fields);
  for (double& value : spectrum.values) value *= scale;
  return spectrum;
}

}  // namespace

const Spectrum* Palette::find(const std::string& name) const {
  const auto found = spectra.find(name);
  return found == spectra.end() ? nullptr : &found->second;
}

std::vector<std::string> Palette::names() const {
  std::vector<std::string> all;
  for (const auto& [name, spectrum] : spectra) all.push_back(name);
  return all;
}

Palette read_palette(const Fields& root) {
  Palette palette;
  for (const std::string& name : illuminant_names()) {
    Illuminant one = illuminant(name);
    palette.spectra[name] = std::move(one.spectrum);
    if (!one.note.empty()) palette.notes[name] = std::move(one.note);
  }
  const Node* node = root.find("spectra");
  if (!node) return palette;
  const Fields whole(root.file(), *node, "[spectra]");
  for (const Entry& entry : std::get<Node::Table>(node->value)) {
    if (palette.find(entry.key))
      whole.refuse(entry.key, "is an illuminant's name; choose another name");
    const Fields fields(root.file(), entry.node, "spectrum \"" + entry.key + "\"");
    palette.spectra[entry.key] = read_spectrum(fields, entry.key, palette);
  }
  return palette;
}

}  // namespace litmus
