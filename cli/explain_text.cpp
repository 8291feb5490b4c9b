// explain_text.cpp: rows of "symbol, numbers, value, remark", aligned block by block.
#include "cli/explain_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace litmus {
namespace {

constexpr std::size_t kShownLamps = 64;  // rows of an area light's table

// ---- Numbers and rows ------------------------------------------------------------------------

/// Six digits, and no minus before a zero.
std::string number(double value) { return fmt::format("{:.6g}", value + 0.0); }

std::string degrees(double radians) { return number(radians * 180 / std::numbers::pi) + " deg"; }

std::string vector(const glm::dvec3& v) {
  return fmt::format("({}, {}, {})", number(v.x), number(v.y), number(v.z));
}

/// One number for a grey.
std::string color(const glm::dvec3& v) {
  return v.x == v.y && v.y == v.z ? number(v.x) : vector(v);
}

std::string residual(const glm::dvec3& ours, const glm::dvec3& theirs) {
  const glm::dvec3 d = ours - theirs;
  return fmt::format("ours - theirs ({:.2g}, {:.2g}, {:.2g})", d.x, d.y, d.z);
}

struct NumberRow {
  std::string symbol, numbers, value, remark;
};

std::string without_trailing_spaces(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

/// "symbol = numbers = value  remark", the equals signs below each other; without numbers "symbol =
/// value  remark".
std::string aligned(const std::vector<NumberRow>& rows) {
  std::size_t symbol = 0, numbers = 0;
  for (const NumberRow& row : rows) {
    symbol = std::max(symbol, row.symbol.size());
    numbers = std::max(numbers, row.numbers.size());
  }
  std::string text;
  for (const NumberRow& row : rows) {
    text += fmt::format("  {:<{}} = ", row.symbol, symbol);
    if (!row.numbers.empty()) text += fmt::format("{:<{}} = ", row.numbers, numbers);
    text += without_trailing_spaces(fmt::format("{}  {}", row.value, row.remark));
  }
  return text;
}

// ---- What the references say -----------------------------------------------------------------

/// The rendered value, where it is a mean of samples, and each reference's.
void add_pictures(std::vector<NumberRow>& rows, const Explanation& pixel, std::size_t layer,
                  std::span<const ReferencePixel> references) {
  const glm::dvec3& ours = pixel.layers[layer];
  if (pixel.samples > 1) {
    rows.push_back(
        {"picture", "", color(ours), fmt::format("mean of {0} x {0} samples", pixel.samples)});
  }
  for (const ReferencePixel& reference : references) {
    if (layer >= reference.layers.size()) continue;
    rows.push_back({reference.title, "", color(reference.layers[layer]),
                    residual(ours, reference.layers[layer])});
  }
}

// ---- The point -------------------------------------------------------------------------------

std::string equation(Shading shading) {
  return shading == Shading::Equation
             ? "  I = ka Ia + sum over the lights of  vis att [ kd Id (l.n) + ks Is (h.n)^ns ]"
               "      slide 5\n"
             : "  I = sum over the lamps in view of  ka Ia + att [ kd Id max(l.n, 0) + ks Id "
               "max(h.n, 0)^ns ]      slide 5, sample code\n";
}

std::string head(const Scene& scene, const Explanation& pixel) {
  std::string text = fmt::format("{}, pixel ({}, {})", scene.name, pixel.x, pixel.y);
  if (!pixel.hit) {
    text += ": nothing is seen at its centre\n";
  } else {
    text += fmt::format(": object \"{}\", material \"{}\"\n",
                        scene.objects[std::size_t(pixel.object)].name, pixel.material.name);
  }
  if (pixel.samples > 1) {
    text += fmt::format(
        "  The picture shows the mean of {0} x {0} samples; explained is the pixel's centre{1}.\n",
        pixel.samples, pixel.samples % 2 ? ", the middle one of them" : ", between them");
  }
  if (!pixel.hit) return text;
  std::vector<NumberRow> rows{
      {"p", "", vector(pixel.point), fmt::format("the point seen, t = {:.6g}", pixel.t)},
      {"n", "", vector(pixel.normal), "its unit normal, towards the eye"}};
  if (pixel.geometric != pixel.normal)
    rows.push_back({"facet", "", vector(pixel.geometric), "the normal before interpolation"});
  rows.push_back({"e", "", vector(pixel.e), "unit, towards the eye"});
  const Material& material = pixel.material;
  rows.push_back({"ka", "", color(material.ambient), ""});
  rows.push_back({"kd", "", color(material.diffuse), ""});
  rows.push_back({"ks", "", color(material.specular), ""});
  if (material.specular != Color(0)) rows.push_back({"ns", "", number(material.shininess), ""});
  return text + aligned(rows) + "\n" + equation(scene.shading);
}

std::string ambient_block(const Scene& scene, const Explanation& pixel,
                          std::span<const ReferencePixel> references) {
  std::vector<NumberRow> rows;
  if (scene.shading == Shading::SampleCode) {
    rows.push_back({"ambient", "", "0", "the sample code adds ka Ia with each lamp"});
  } else {
    rows.push_back({"Ia", "", color(pixel.ambient), "the scene's and the lights' ambient colours"});
    rows.push_back({"ka Ia", color(pixel.material.ambient) + " * " + color(pixel.ambient),
                    color(pixel.ambient_color), ""});
  }
  add_pictures(rows, pixel, 0, references);
  return "\nambient\n" + aligned(rows);
}

// ---- One lamp --------------------------------------------------------------------------------

const PointLight* place_of(const Light& light) {
  if (const auto* point = std::get_if<PointLight>(&light.shape)) return point;
  if (const auto* spot = std::get_if<SpotLight>(&light.shape)) return &spot->point;
  if (const auto* area = std::get_if<AreaLight>(&light.shape)) return &area->point;
  return nullptr;
}

/// Distance, attenuation and decay, as far as the light has them.
void add_arrival(std::vector<NumberRow>& rows, const Light& light, const LampExplanation& lamp) {
  std::string symbols = "1", numbers;
  const auto factor = [&](const char* symbol, double value) {
    symbols = numbers.empty() ? symbol : symbols + " " + symbol;
    numbers += (numbers.empty() ? "" : " * ") + number(value);
  };
  rows.push_back({"vector l", "", vector(lamp.l), "unit, towards the light"});
  if (const PointLight* place = place_of(light)) {
    const Attenuation& a = place->attenuation;
    const std::string x = number(lamp.x);
    rows.push_back({"d", "", number(lamp.distance), ""});
    if (a.linear != 0 || a.quadratic != 0)
      rows.push_back({"x = d / R", number(lamp.distance) + " / " + number(a.range), x, ""});
    if (a.linear != 0) {
      rows.push_back({"l = 1 / (1 + L x)", fmt::format("1 / (1 + {:.6g} * {})", a.linear, x),
                      number(lamp.linear), ""});
      factor("l", lamp.linear);
    }
    if (a.quadratic != 0) {
      rows.push_back({"q = 1 / (1 + Q x^2)", fmt::format("1 / (1 + {:.6g} * {}^2)", a.quadratic, x),
                      number(lamp.quadratic), ""});
      factor("q", lamp.quadratic);
    }
  }
  if (const auto* spot = std::get_if<SpotLight>(&light.shape)) {
    rows.push_back({"alpha", "", degrees(lamp.alpha),
                    fmt::format("off the axis; the cutoff is {}", degrees(spot->cutoff))});
    if (lamp.alpha > spot->cutoff) {
      rows.push_back({"decay", "", number(lamp.decay), "past the cutoff"});
    } else {
      const std::string ratio = number(lamp.alpha / spot->cutoff);
      rows.push_back({"ratio = alpha / cutoff", degrees(lamp.alpha) + " / " + degrees(spot->cutoff),
                      ratio, ""});
      rows.push_back({"decay = 1 - ratio^exponent",
                      fmt::format("1 - {}^{:.6g}", ratio, spot->exponent), number(lamp.decay), ""});
    }
    factor("decay", lamp.decay);
  }
  if (!numbers.empty()) rows.push_back({"att = " + symbols, numbers, number(lamp.intensity), ""});
}

std::string in_between(const Scene& scene, const LampExplanation& lamp) {
  if (!scene.shadows) return "the scene has no shadows";
  if (lamp.blocker < 0) return "nothing is in between";
  return fmt::format("\"{}\" is in between", scene.objects[std::size_t(lamp.blocker)].name);
}

/// How the surface answers one lamp: l.n, (h.n)^ns, visibility, D and S.
void add_answer(std::vector<NumberRow>& rows, const Scene& scene, const Material& material,
                const LampExplanation& lamp) {
  const bool shiny = material.specular != Color(0),
             sample_code = scene.shading != Shading::Equation;
  rows.push_back({"l.n", "", number(lamp.l_dot_n), ""});
  if (shiny) {
    rows.push_back({"vector h = normalize(l + e)", "", vector(lamp.h), ""});
    rows.push_back({"h.n", "", number(lamp.h_dot_n), ""});
    rows.push_back({"power = (h.n)^ns",
                    lamp.h_dot_n > 0
                        ? fmt::format("{:.6g}^{:.6g}", lamp.h_dot_n, material.shininess)
                        : "h.n <= 0",
                    number(lamp.power), ""});
  }
  rows.push_back({"vis", "", number(lamp.visibility), in_between(scene, lamp)});
  if (lamp.gate != Gate::Open) {
    rows.push_back({shiny ? "D = S" : "D", "", "0", std::string(gate_reason(lamp.gate))});
    return;
  }
  const auto product = [&](double factor) {
    return fmt::format("{:.6g} * {:.6g} * {:.6g}", lamp.visibility, lamp.intensity, factor);
  };
  rows.push_back({sample_code ? "D = vis att max(l.n, 0)" : "D = vis att (l.n)",
                  product(sample_code ? std::max(lamp.l_dot_n, 0.0) : lamp.l_dot_n),
                  number(lamp.diffuse), ""});
  if (shiny) rows.push_back({"S = vis att power", product(lamp.power), number(lamp.specular), ""});
}

// ---- The samples of an area light ------------------------------------------------------------

bool concerns_specular(const Term& term) {
  return term.member == &LampExplanation::h_dot_n || term.member == &LampExplanation::power ||
         term.member == &LampExplanation::specular;
}

/// A column of each term, a row of each sample, the mean below.
std::string lamp_table(const Scene& scene, const Light& source, const Explanation& pixel,
                       const LightExplanation& light) {
  std::vector<const Term*> columns;
  for (const Term& term : terms()) {
    const bool shown = !concerns_specular(term) || pixel.material.specular != Color(0);
    if (shown && term.applies(scene, source)) columns.push_back(&term);
  }
  std::string text = "  sample";
  for (const Term* term : columns) text += fmt::format("  {:>11}", term->name);
  text += "  in between\n";
  const auto line = [&](const std::string& name, const auto& value, const std::string& blocker) {
    std::string cells;
    for (const Term* term : columns) cells += fmt::format("  {:>11.6g}", value(*term));
    text += without_trailing_spaces(fmt::format("  {:>6}{}  {}", name, cells, blocker));
  };
  for (std::size_t i = 0; i < std::min(light.lamps.size(), kShownLamps); ++i) {
    const LampExplanation& lamp = light.lamps[i];
    const int blocker = lamp.blocker;
    line(
        std::to_string(i + 1), [&](const Term& term) { return lamp.*term.member; },
        blocker < 0 ? "" : fmt::format("\"{}\"", scene.objects[std::size_t(blocker)].name));
  }
  if (light.lamps.size() > kShownLamps)
    text += fmt::format("     ...  {} more: --json lists them\n", light.lamps.size() - kShownLamps);
  line(
      "mean", [&](const Term& term) { return mean(light, term.member); }, "");
  return text;
}

// ---- One light -------------------------------------------------------------------------------

std::string light_block(const Scene& scene, const Explanation& pixel, std::size_t index,
                        std::span<const ReferencePixel> references) {
  const LightExplanation& light = pixel.lights[index];
  const Light& source = scene.lights[index];
  const Material& material = pixel.material;
  std::string text = fmt::format("\n{} ({})\n", light.name, light.type);
  std::vector<NumberRow> rows;
  if (light.lamps.empty()) {
    rows.push_back({"intensity", "", "0", "it adds nothing"});
  } else if (light.lamps.size() == 1) {
    add_arrival(rows, source, light.lamps[0]);
    add_answer(rows, scene, material, light.lamps[0]);
  } else {
    text += fmt::format("  {} point lights, each of 1/{} of the intensity; D and S are the means\n",
                        light.lamps.size(), light.lamps.size());
    text += lamp_table(scene, source, pixel, light);
  }
  const auto product = [](const Color& k, const Color& i, double factor) {
    return fmt::format("{} * {} * {:.6g}", color(k), color(i), factor);
  };
  if (light.ambient_color != glm::dvec3(0)) {
    rows.push_back({"ka Ia for each lamp in view", "", color(light.ambient_color), ""});
  }
  if (light.diffuse != 0 || light.specular != 0) {
    rows.push_back({"kd Id D", product(material.diffuse, light.light_diffuse, light.diffuse),
                    color(light.diffuse_color), ""});
    if (material.specular != Color(0)) {
      rows.push_back({scene.shading == Shading::Equation ? "ks Is S" : "ks Id S",
                      product(material.specular, light.light_specular, light.specular),
                      color(light.specular_color), ""});
    }
  }
  rows.push_back({light.name, "", color(light.color), "what the light adds"});
  add_pictures(rows, pixel, index + 1, references);
  return text + aligned(rows);
}

// ---- The sum ---------------------------------------------------------------------------------

std::string sum_block(const Explanation& pixel, std::span<const ReferencePixel> references) {
  std::string text = "\nsum\n";
  std::size_t width = 7;
  for (const LightExplanation& light : pixel.lights) width = std::max(width, light.name.size());
  for (const ReferencePixel& reference : references)
    width = std::max(width, reference.title.size());
  const auto line = [&](char sign, const std::string& name, const glm::dvec3& v,
                        const std::string& remark) {
    text += without_trailing_spaces(fmt::format("  {} {:<{}}  {:>12.6g} {:>12.6g} {:>12.6g}  {}",
                                                sign, name, width, v.x, v.y, v.z, remark));
  };
  line(' ', "ambient", pixel.ambient_color, "");
  for (const LightExplanation& light : pixel.lights) line('+', light.name, light.color, "");
  line('=', "I", pixel.whole, "");
  if (pixel.samples > 1) {
    line(' ', "picture", pixel.picture, fmt::format("mean of {0} x {0} samples", pixel.samples));
  }
  for (const ReferencePixel& reference : references) {
    if (reference.layers.empty()) continue;
    glm::dvec3 theirs{0};
    for (const glm::dvec3& layer : reference.layers) theirs += layer;
    line(' ', reference.title, theirs,
         fmt::format("{} {}; {}", reference.source, reference.version,
                     residual(pixel.picture, theirs)));
  }
  for (const ReferencePixel& reference : references) {
    const std::string& why = reference.failure.empty() ? reference.skipped : reference.failure;
    if (!why.empty()) text += fmt::format("    {}: no image: {}\n", reference.title, why);
  }
  return text;
}

}  // namespace

std::string explanation_text(const Scene& scene, const Explanation& pixel,
                             std::span<const ReferencePixel> references, const std::string& light) {
  const bool all = light.empty() || light == "all";
  std::string text = head(scene, pixel);
  if (pixel.hit && (all || light == "ambient")) text += ambient_block(scene, pixel, references);
  for (std::size_t i = 0; i < pixel.lights.size(); ++i) {
    if (all || light == pixel.lights[i].name) text += light_block(scene, pixel, i, references);
  }
  return all ? text + sum_block(pixel, references) : text;
}

}  // namespace litmus
