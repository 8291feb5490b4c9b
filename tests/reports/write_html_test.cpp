// write_html_test.cpp: the page is complete, self-contained and inert.
#include "reports/write_html.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "compare/statistics.h"
#include "reports/html_case.h"
#include "reports/page_data.h"
#include "reports/write_json.h"
#include "tests/reports/sample_study.h"

namespace litmus {
namespace {
using ::testing::HasSubstr;
using ::testing::Not;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

std::string between(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t start = text.find(from) + from.size();
  return text.substr(start, text.find(to, start) - start);
}

std::set<std::string> matches(const std::string& text, const char* pattern) {
  const std::regex expression(pattern);
  std::set<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at)
    found.insert((*at)[1]);
  return found;
}

// What all folds of the page hold.
std::string folds(const Study& study) {
  std::string text;
  for (const Case& one : study.cases) text += case_html(study, one);
  return text;
}

TEST(Page, SaysTheVerdictFirst) {
  EXPECT_THAT(between(html(passing_study()), "<h1>", "</h1>"), HasSubstr("Everything agrees"));
  EXPECT_THAT(between(html(mixed_study()), "<h1>", "</h1>"),
              HasSubstr("8 of 120 comparisons disagree"));
}

TEST(Page, OfAPassHasNoAlarm) {
  EXPECT_THAT(html(passing_study()), Not(HasSubstr("class=\"alert\"")));
  EXPECT_THAT(html(mixed_study()), HasSubstr("class=\"alert\""));
}

TEST(Page, ListsTheWorstFailureFirstWithItsReason) {
  const std::string alert = between(html(mixed_study()), "<section class=\"alert\"", "</section>");
  EXPECT_LT(alert.find("r2-nan"), alert.find("r1-failing"));
  EXPECT_THAT(alert, HasSubstr("1 of 2712 pixels are NaN or infinite"));
}

TEST(Page, ListsALightOnceAndAtMostTenOfThem) {
  Study study = with_provenance();
  for (int i = 0; i < 13; ++i)
    add_case(study, {"scene-" + std::to_string(i), "key", "point", 3e-4, 3e-3}, 24, 16);
  const std::string alert = between(html(study), "<section class=\"alert\"", "</section>");
  EXPECT_EQ(count(alert, "<li>"), 10u);
  EXPECT_THAT(alert, HasSubstr("\u00b7 1 row more"));
  EXPECT_THAT(alert, HasSubstr("key (point), Blender Cycles, interior"));
  EXPECT_THAT(alert, HasSubstr("and 3 lights more, in the table below"));
}

TEST(Page, SaysWhichLightTypesDisagreeAndWhereToLook) {
  Study study = passing_study();
  add_case(study, {"r1 failing", "grid", "area", 3e-4});
  const std::string alert = between(html(study), "<section class=\"alert\"", "</section>");
  EXPECT_THAT(alert, HasSubstr("In area light only, not in directional, point, spot and ambient."));
  EXPECT_THAT(alert, HasSubstr("#view?scene=r1%20failing&amp;light=grid&amp;with=povray"));
}

TEST(Page, HasAMatrixLineForEverySceneAndLightTypeAndACellForEveryGroupAndReference) {
  const std::string matrix = between(html(mixed_study()), "<tbody>", "</tbody>");
  EXPECT_EQ(count(matrix, "<tr"), 7u);
  EXPECT_EQ(count(matrix, "<td"), 7u * (1 + 3 * 2));
  EXPECT_EQ(count(matrix, "<td class=\"fail\""), 4u);
  EXPECT_EQ(count(matrix, "<td class=\"skipped\""), 3u);
}

TEST(Page, ShowsEveryLayerWithItsDifferencePictures) {
  const std::string inside = folds(passing_study());
  EXPECT_EQ(count(inside, "<details class=\"layer"), 3u * 3);
  EXPECT_EQ(count(inside, "<figure class=\"difference\">"), 3u * 3 * 2);
  EXPECT_EQ(count(inside, "<figure class=\"\">"), 3u * (3 + 2)) << "ours, and theirs of the whole";
}

TEST(Page, FoldsAPassAndUnfoldsTheFirstThatFail) {
  const Study study = mixed_study();
  const std::string page = html(study);
  for (const Case& one : study.cases) {
    const std::string inside = case_html(study, one);
    const bool fails = one.scene == "r1-failing" || one.scene == "r2-nan";
    EXPECT_EQ(count(page, inside), fails ? 1u : 0u) << one.scene;
    EXPECT_EQ(count(page, "\">" + deflated(inside) + "</script>"), fails ? 0u : 1u) << one.scene;
  }
}

TEST(Page, HasATargetForEveryLink) {
  const std::string page = html(mixed_study());
  const std::set<std::string> links = matches(page, "href=\"#([^\"]+)\"");
  std::set<std::string> targets = matches(page, " id=\"([^\"]+)\"");
  targets.merge(matches(folds(mixed_study()), " id=\"([^\"]+)\""));
  EXPECT_GT(links.size(), 7u);
  for (const std::string& link : links)
    EXPECT_TRUE(link.starts_with("view?") || targets.contains(link)) << link;
}

TEST(Page, AsksNothingOfTheNetwork) {
  const std::string page = html(mixed_study());
  for (const std::string& source : matches(page, "src=\"([^\"]{0,22})"))
    EXPECT_EQ(source, "data:image/png;base64,");
  for (const std::string& target : matches(page, "url\\(([^)]{0,22})"))
    EXPECT_EQ(target, "data:image/png;base64,");
  EXPECT_THAT(page, Not(HasSubstr("http://")));
  EXPECT_THAT(page, Not(HasSubstr("https://")));
  EXPECT_THAT(page, Not(HasSubstr("@import")));
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
}

TEST(Page, KeepsHostileTextInert) {
  Study study = mixed_study();
  study.cases.back().references[0].failure = kHostile;
  for (Comparison& row : study.comparisons)
    if (row.scene == kHostile && row.region != "edge") {
      row.verdict = row.reference == "povray" ? "fail" : "skipped";
      row.reason = kHostile;
    }
  const std::string page = html(study), inside = folds(study);
  const std::size_t cases = study.cases.size(), open = 3;
  EXPECT_EQ(count(page, "<script"), 3 + cases + (cases - open))
      << "results, their provenance, the page's own; pictures of each scene, what is folded";
  EXPECT_EQ(count(page, "</script>"), count(page, "<script"));
  EXPECT_EQ(count(inside, "<script"), 0u);
  for (const std::string& text : {page, inside}) {
    EXPECT_THAT(text, Not(HasSubstr("<img src=x")));
    EXPECT_THAT(text, Not(HasSubstr("<script>alert")));
    EXPECT_THAT(text, HasSubstr("&lt;img src=x onerror=alert(1)&gt;&quot;"));
    EXPECT_THAT(text, HasSubstr("{{x}}")) << "text is not taken for a template";
  }
  EXPECT_THAT(inside, HasSubstr("&lt;/script&gt;&lt;script&gt;alert(1)&lt;/script&gt;"));
}

TEST(Page, SaysHowOftenTheTestsOfNoisyPicturesAreRight) {
  const std::string rates =
      between(html(passing_study()), "<table class=\"numbers rates\"", "</table>");
  EXPECT_EQ(count(rates, "<tr>"), 1 + measured_rates().size());
  for (const MeasuredRate& rate : measured_rates()) {
    EXPECT_THAT(rates, HasSubstr(std::string(rate.what)));
    EXPECT_THAT(rates, HasSubstr(fmt::format("<td>{:.1f} %</td>", 100 * rate.rate)));
  }
}

TEST(Page, CarriesItsResults) {
  const Study study = mixed_study();
  const std::string data =
      between(html(study), "<script type=\"text/plain\" id=\"results\">", "</script>");
  EXPECT_EQ(data, deflated(reproducible_json(study)));
  const std::string provenance =
      between(html(study), "<script type=\"application/json\" id=\"provenance\">", "</script>");
  EXPECT_THAT(provenance, HasSubstr("\"started\":\"2020-02-03 04:05 UTC\""));
}

TEST(Page, ShowsARendererThatFailedWithItsLog) {
  Study study = passing_study();
  study.cases[0].references[0].failure = "povray exited with 1";
  study.cases[0].references[0].log = "Parse Error: no camera";
  const std::string page = html(study);
  EXPECT_THAT(between(page, "<h1>", "</h1>"), HasSubstr("A renderer failed"));
  EXPECT_THAT(between(page, "<section class=\"alert\"", "</section>"),
              HasSubstr("POV-Ray: povray exited with 1"));
  EXPECT_THAT(folds(study), HasSubstr("<pre>Parse Error: no camera</pre>"));
}

TEST(Page, OfPicturesOfDifferentSizeShowsNoDifference) {
  Study study = passing_study();
  study.cases[0].layers[2].theirs[0].picture = Picture(3, 2);
  EXPECT_EQ(count(folds(study), "<figure class=\"difference\">"), 3u * 3 * 2 - 1);
}

TEST(Page, OfAnEmptyStudyIsStillAPage) { EXPECT_THAT(html({}), HasSubstr("</html>")); }

TEST(Page, StaysSmall) {
  Study study = with_provenance();
  for (int i = 0; i < 8; ++i)
    add_case(study, {"scene-" + std::to_string(i), "key", "point"}, 160, 120);
  EXPECT_LT(html(study).size(), 8 * 150'000u) << "33 scenes take less than 5 MB";
}

TEST(Page, TellsChangesSinceTheBaselineNearTheTop) {
  Study study = mixed_study();
  EXPECT_THAT(html(study), Not(HasSubstr("id=\"baseline\"")));
  study.baseline = against_baseline(study, passing_study(), kHostile);
  const std::string page = html(study);
  const std::string section =
      between(page, "<section class=\"alert\" aria-label=\"Against", "</section>");
  EXPECT_THAT(section, HasSubstr("<h3>New failures</h3>"));
  EXPECT_THAT(section, Not(HasSubstr("<img")));
  EXPECT_LT(page.find("id=\"baseline\""), page.find("aria-label=\"What disagrees\""));
}

TEST(Page, OfARunNoWorseThanItsBaselineSaysSoCalmly) {
  Study study = passing_study();
  study.baseline = against_baseline(study, study, "old.json");
  EXPECT_THAT(html(study),
              HasSubstr("<section class=\"calm\" aria-label=\"Against the baseline\""));
}

TEST(Page, KeepsWhatIsSlowerInTheProvenance) {
  Study study = passing_study();
  study.baseline = against_baseline(study, study, "old.json");
  study.baseline->slower.push_back({"all", "povray", 0.1, 0.5});
  EXPECT_THAT(between(html(study), "aria-label=\"Provenance\"", "</section>"),
              HasSubstr("5 times as much"));
}

TEST(Page, OffersToApproveWhatMayBeApprovedAndSaysWhyTheRestMayNot) {
  const std::string page = html(mixed_study());
  EXPECT_THAT(page,
              HasSubstr("<code>litmus approve r1-failing/povray --reason &apos;...&apos;</code>"));
  EXPECT_THAT(page, HasSubstr("Cannot be approved: r2-nan/povray"));
  EXPECT_THAT(folds(passing_study()), Not(HasSubstr("litmus approve")));
}

}  // namespace
}  // namespace litmus
