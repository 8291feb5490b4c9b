// page_terms_test.cpp: the page gets numbers that belong to its pictures, or none.
#include "reports/page_terms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "scene/load.h"
#include "tests/reports/stored_study.h"

namespace litmus {
namespace {

TEST(PageTerms, NameEveryTermThatALightHas) {
  const Study study = stored_study("s1");
  const auto json = nlohmann::json::parse(terms_json(study.cases[0]));
  ASSERT_EQ(json["lights"].size(), 1u);
  std::vector<std::string> names;
  for (const auto& term : json["lights"][0]["terms"]) names.push_back(term["name"]);
  for (const char* name : {"alpha", "decay", "l.n", "visibility", "diffuse"})
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
}

TEST(PageTerms, HoldAPlantedMistakeAndNameIt) {
  const auto json = nlohmann::json::parse(terms_json(stored_study("s1", "cutoff").cases[0]));
  EXPECT_EQ(json["planted"], "every spot's cutoff 0.5 degrees too wide");
}

TEST(PageTerms, AreNotThoseOfAnotherPicture) {
  EXPECT_NE(terms_json(stored_study("s1").cases[0]), "");
  EXPECT_EQ(terms_json(stored_study("s1", "half-pixel").cases[0]), "");
  Study other = stored_study("s1", "cutoff");
  other.cases[0].control = "";
  EXPECT_EQ(terms_json(other.cases[0]), "");
  Study gone = stored_study("s1");
  gone.cases[0].file = "no such file.toml";
  EXPECT_EQ(terms_json(gone.cases[0]), "");
}

TEST(PageTerms, AreKeptForFailuresFirstAsFarAsTheBudgetGoes) {
  Study study = stored_study("s1");
  Study second = stored_study("d1");
  study.cases.push_back(second.cases[0]);
  for (Comparison& row : second.comparisons) study.comparisons.push_back(row);
  const std::vector<std::string> all = explained_cases(study, 1'000'000);
  EXPECT_NE(all[0], "");
  EXPECT_NE(all[1], "");
  const std::size_t room = std::max(all[0].size(), all[1].size());
  EXPECT_EQ(explained_cases(study, room)[1], "");
  study.comparisons.back().verdict = "fail";
  EXPECT_EQ(explained_cases(study, room)[0], "");
  EXPECT_EQ(explained_cases(study, room)[1], all[1]);
}

}  // namespace
}  // namespace litmus
