// write_junit_test.cpp: junit.xml is well formed, counts right and carries the figures.
#include "reports/write_junit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <pugixml.hpp>

#include "tests/reports/sample_study.h"

namespace litmus {
namespace {
namespace fs = std::filesystem;
using ::testing::HasSubstr;

pugi::xml_document written(const Study& study) {
  std::string name = (fs::temp_directory_path() / "litmus-junit-XXXXXX").string();
  const fs::path folder = ::mkdtemp(name.data());
  write_junit(study, folder / "junit.xml");
  pugi::xml_document document;
  EXPECT_TRUE(document.load_file((folder / "junit.xml").c_str()));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1) << "no temporary is left";
  fs::remove_all(folder);
  return document;
}

std::size_t count(const pugi::xml_document& document, const char* path) {
  return document.select_nodes(path).size();
}

TEST(JUnit, HasASuitePerSceneAndATestPerRow) {
  const Study study = mixed_study();
  const pugi::xml_document document = written(study);
  EXPECT_EQ(count(document, "/testsuites/testsuite"), study.cases.size() + 1) << "and provenance";
  EXPECT_EQ(count(document, "//testcase"), study.comparisons.size());
  EXPECT_EQ(count(document, "//testcase/failure"), 8u);
  EXPECT_EQ(count(document, "//testcase/skipped"), 3u);
  EXPECT_EQ(count(document, "//testcase/error"), 0u);
  EXPECT_EQ(document.child("testsuites").attribute("tests").as_int(), 120);
  EXPECT_EQ(document.child("testsuites").attribute("failures").as_int(), 8);
  EXPECT_EQ(document.child("testsuites").attribute("skipped").as_int(), 3);
}

TEST(JUnit, CountsOfASuiteAreItsOwn) {
  const pugi::xml_document document = written(mixed_study());
  const pugi::xml_node suite = document.select_node("//testsuite[@name='r1-failing']").node();
  EXPECT_EQ(suite.attribute("tests").as_int(), 18);
  EXPECT_EQ(suite.attribute("failures").as_int(), 4);
}

TEST(JUnit, FailureSaysWhyWhereAndHowMuch) {
  const Study study = mixed_study();
  const pugi::xml_node failure =
      written(study).select_node("//testsuite[@name='r1-failing']/testcase/failure").node();
  EXPECT_THAT(failure.attribute("message").value(), HasSubstr("is over 8e-07"));
  EXPECT_THAT(failure.text().get(), HasSubstr("pixel 32, 34\n"));
  EXPECT_THAT(failure.text().get(), HasSubstr("max_abs 0.000"));
}

TEST(JUnit, SkippedRowSaysWhy) {
  const auto document = written(mixed_study());
  EXPECT_THAT(document.select_node("//skipped").node().attribute("message").value(),
              HasSubstr("Blender is not installed"));
}

TEST(JUnit, RendererThatFailedIsAnErrorWithItsLog) {
  Study study = passing_study();
  study.cases[1].references[0].failure = "povray exited with 1";
  study.cases[1].references[0].log = "Parse Error\x1b[0m: \xFF ]]>";
  const pugi::xml_document document = written(study);
  EXPECT_EQ(count(document, "//error"), 1u);
  const pugi::xml_node error = document.select_node("//error").node();
  EXPECT_STREQ(error.attribute("message").value(), "povray exited with 1");
  EXPECT_THAT(error.text().get(), HasSubstr("Parse Error: \xEF\xBF\xBD ]]>"));
  EXPECT_EQ(document.child("testsuites").attribute("errors").as_int(), 1);
}

TEST(JUnit, KeepsHostileTextAsText) {
  const pugi::xml_document document = written(mixed_study());
  EXPECT_EQ(count(document, "//img"), 0u);
  EXPECT_EQ(count(document, "//script"), 0u);
  const std::string name =
      document.select_node("//testsuite[last() - 1]").node().attribute("name").value();
  EXPECT_THAT(name, HasSubstr("<img src=x onerror=alert(1)>"));
}

}  // namespace
}  // namespace litmus
