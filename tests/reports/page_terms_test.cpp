// page_terms_test.cpp: the page gets numbers that belong to its pictures, or none.
#include "reports/page_terms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "scene/load.h"

namespace litmus {
namespace {

Study stored_study(const char* scene, const char* control = "") {
  StudyOptions options;
  options.obtain.sources = Sources::Stored;
  options.control = control;
  const std::vector<Scene> scenes{load_scene(find_scene(scene))};
  return run_study(scenes, options);
}

TEST(PageTerms, NameEveryTermThatALightHas) {
  const Study study = stored_study("s1");
  const auto json = nlohmann::json::parse(terms_json(study.cases[0]));
  ASSERT_EQ(json["lights"].size(), 1u);
  std::vector<std::string> names;
  for (const auto& term : json["lights"][0]["terms"]) names.push_back(term["name"]);
  for (const char* name : {"alpha", "decay", "l.n", "visibility", "diffuse"})
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
}

TEST(PageTerms, AreNotThoseOfAnotherPicture) {
  EXPECT_NE(terms_json(stored_study("s1").cases[0]), "");
  EXPECT_EQ(terms_json(stored_study("s1", "cutoff").cases[0]), "");
  Study gone = stored_study("s1");
  gone.cases[0].file = "no such file.toml";
  EXPECT_EQ(terms_json(gone.cases[0]), "");
}

TEST(PageTerms, AreKeptForFailuresAsFarAsTheBudgetGoes) {
  Study study = stored_study("s1");
  EXPECT_EQ(explained_cases(study)[0], "");
  study.comparisons[0].verdict = "fail";
  EXPECT_NE(explained_cases(study)[0], "");
  EXPECT_EQ(explained_cases(study, 1000)[0], "");
}

}  // namespace
}  // namespace litmus
