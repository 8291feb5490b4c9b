// write_migration.cpp: migration.html.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/whole_file.h"
#include "reports/html_shell.h"
#include "reports/migration.h"
#include "reports/overview.h"
#include "reports/pictures.h"
#include "reports/plain_text.h"

namespace litmus {
namespace {

constexpr int kSide = 200;  // pixels of a shown picture

/// old - new as a share of what is allowed: red where the old one is brighter, blue where darker,
/// white where they are the same.
Picture signed_picture(const Picture& before, const Picture& after, double allowed) {
  Picture result(before.width, before.height);
  for (std::size_t i = 0; i < result.pixels.size(); ++i) {
    const glm::dvec3 d = before.pixels[i] - after.pixels[i];
    double worst = d.x;
    for (const double each : {d.y, d.z})
      if (!(std::abs(each) <= std::abs(worst))) worst = each;
    if (!std::isfinite(worst)) {
      result.pixels[i] = {1, 0, 1};
      continue;
    }
    // Finer near 0, as in the report: most of what changes is far below what is allowed.
    const double size = allowed > 0 ? std::min(std::abs(worst) / allowed, 1.0) : double(worst != 0);
    const double share = std::copysign(std::sqrt(size), worst);
    result.pixels[i] =
        share > 0 ? glm::dvec3(1, 1 - share, 1 - share) : glm::dvec3(1 + share, 1 + share, 1);
  }
  return result;
}

std::string picture(const std::string& caption, const std::string& uri) {
  return fmt::format(
      "<figure><img src=\"{}\" alt=\"{}\" style=\"width:100%\">"
      "<figcaption>{}</figcaption></figure>",
      uri, html_text(caption), html_text(caption));
}

std::string pictures(const Migration& one, const MigrationLayer& layer) {
  const std::string title = reference_title(one.reference);
  return fmt::format(
      "<div class=\"pictures\">{}{}{}</div>",
      picture(title + " " + one.old_version, thumbnail_uri(layer.old_picture, kSide)),
      picture(title + " " + one.new_version, thumbnail_uri(layer.new_picture, kSide)),
      picture("old less new, finer near 0; full colour from " + short_number(layer.allowed),
              thumbnail_uri(signed_picture(layer.old_picture, layer.new_picture, layer.allowed),
                            kSide)));
}

std::string row(const Migration& one, const MigrationLayer& layer) {
  const auto cell = [](const std::string& verdict) {
    return fmt::format("<td class=\"word{}\">{}</td>", verdict == "fail" ? " bad" : "",
                       html_text(verdict));
  };
  return fmt::format(
      "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td>{}<td>{}</td><td>{}</td>{}<td>{}</td>"
      "</tr>",
      html_text(layer.light == "all" ? "whole picture" : layer.light), short_number(layer.old_max),
      short_number(layer.old_mean), cell(layer.old_verdict), short_number(layer.new_max),
      short_number(layer.new_mean), cell(layer.new_verdict),
      one.pictures ? short_number(layer.apart) : "");
}

bool changes_a_verdict(const Migration& one) {
  return std::any_of(one.layers.begin(), one.layers.end(), [](const MigrationLayer& layer) {
    return layer.old_verdict != layer.new_verdict;
  });
}

std::string section(const Migration& one) {
  std::string rows, shown;
  for (const MigrationLayer& layer : one.layers) {
    rows += row(one, layer);
    if (!one.pictures) continue;
    const std::string name = layer.light == "all" ? "whole picture" : layer.light;
    const bool differs = layer.old_verdict != layer.new_verdict;
    shown += fmt::format(
        "<details class=\"layer\"{}><summary><span class=\"what\"><b>{}</b> "
        "<span>{}</span></span></summary>{}</details>",
        layer.light == "all" || differs ? " open" : "", html_text(name),
        html_text(layer.light_type == layer.light ? "" : layer.light_type), pictures(one, layer));
  }
  return fmt::format(
      "<section><h2>{}: {} {} \u2192 {}</h2>{}<div class=\"scroll\"><table "
      "class=\"numbers\"><thead>"
      "<tr><th scope=\"col\">light</th><th scope=\"col\">old, largest</th><th "
      "scope=\"col\">mean</th>"
      "<th scope=\"col\" class=\"word\">verdict</th><th scope=\"col\">new, largest</th><th "
      "scope=\"col\">mean</th>"
      "<th scope=\"col\" class=\"word\">verdict</th><th scope=\"col\">old to new, "
      "largest</th></tr></thead><tbody>{}"
      "</tbody></table></div>{}</section>",
      html_text(one.scene), html_text(reference_title(one.reference)), html_text(one.old_version),
      html_text(one.new_version),
      one.pictures ? ""
                   : "<p class=\"dim\">The old version is the baseline's: its figures are kept, "
                     "its pictures are not.</p>",
      rows, shown);
}

}  // namespace

std::string migration_html(const std::vector<Migration>& migrations) {
  std::vector<const Migration*> order;
  for (const Migration& one : migrations) order.push_back(&one);
  std::stable_sort(order.begin(), order.end(), [](const Migration* a, const Migration* b) {
    return changes_a_verdict(*a) > changes_a_verdict(*b);
  });
  const auto changed = std::count_if(migrations.begin(), migrations.end(), changes_a_verdict);
  std::string body;
  for (const Migration* one : order) body += section(*one);
  return small_page(
      "Another version of a renderer",
      fmt::format("{} rendered by another version than before; verdicts change in {}. Differences "
                  "are those to litmus, in linear RGB, over the whole picture; the last column is "
                  "between the two versions. To keep the new pictures: litmus run SCENE --refresh.",
                  counted((long long)(migrations.size()), "case is", "cases are"), changed),
      body);
}

void write_migration(const std::vector<Migration>& migrations,
                     const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "migration.html";
  if (!migrations.empty()) return write_whole(file, migration_html(migrations));
  std::error_code absent;
  std::filesystem::remove(file, absent);
}

}  // namespace litmus
