// catalogue_test.cpp: docs/hard-cases.md names every case, and every test that it names exists.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>

#include "test_paths.h"

namespace litmus {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Case by case, what the table says: "| L-01 | case | tests or reason |".
std::map<std::string, std::string> table() {
  std::map<std::string, std::string> rows;
  const std::string text = text_of(LITMUS_SOURCE "/docs/hard-cases.md");
  const std::regex row("\n\\| ([A-Z]-\\d\\d) \\| ([^|\n]+) \\| ([^|\n]+) \\|");
  for (auto it = std::sregex_iterator(text.begin(), text.end(), row); it != std::sregex_iterator();
       ++it)
    EXPECT_TRUE(rows.emplace((*it)[1], (*it)[3]).second) << (*it)[1] << " twice";
  return rows;
}

/// "Suite.Name" of every test in tests/, and "Refuses.Name" of every spoiled scene.
std::set<std::string> existing_tests() {
  std::set<std::string> names;
  const std::regex test("\nTEST(?:_F|_P)?\\((\\w+), (\\w+)\\)"), spoiled("\n    \\{\"(\\w+)\",");
  for (const auto& entry : fs::recursive_directory_iterator(LITMUS_SOURCE "/tests")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = text_of(entry.path());
    for (auto it = std::sregex_iterator(text.begin(), text.end(), test);
         it != std::sregex_iterator(); ++it)
      names.insert((*it)[1].str() + "." + (*it)[2].str());
    if (entry.path().filename() != "load_test.cpp") continue;
    for (auto it = std::sregex_iterator(text.begin(), text.end(), spoiled);
         it != std::sregex_iterator(); ++it)
      names.insert("Refuses." + (*it)[1].str());
  }
  return names;
}

/// The tests that a row names in backticks.
std::vector<std::string> named(const std::string& row) {
  std::vector<std::string> tests;
  const std::regex name("`(\\w+\\.\\w+)`");
  for (auto it = std::sregex_iterator(row.begin(), row.end(), name); it != std::sregex_iterator();
       ++it)
    tests.push_back((*it)[1]);
  return tests;
}

TEST(HardCases, AreAllInTheTable) {
  const std::map<char, int> count{{'L', 30}, {'B', 15}, {'A', 14}, {'I', 24},
                                  {'S', 16}, {'X', 14}, {'C', 16}};
  std::map<char, int> found;
  for (const auto& [id, row] : table()) ++found[id[0]];
  EXPECT_EQ(found, count);
  int total = 0;
  for (const auto& [letter, n] : found) total += n;
  EXPECT_EQ(total, 129);
}

TEST(HardCases, HaveATestThatExistsOrAReason) {
  const std::set<std::string> tests = existing_tests();
  ASSERT_GT(tests.size(), 300u);
  for (const auto& [id, row] : table()) {
    const std::vector<std::string> names = named(row);
    if (names.empty()) {
      EXPECT_TRUE(row.starts_with("No test: ") && row.size() > 40) << id << ": " << row;
    }
    for (const std::string& name : names) EXPECT_TRUE(tests.contains(name)) << id << ": " << name;
  }
}

TEST(HardCases, ThatTestsAreNamedAfterAreInTheTable) {
  const auto rows = table();
  for (const std::string& name : existing_tests()) {
    std::smatch match;
    if (!std::regex_match(name, match, std::regex("HardCase([A-Z])(\\d\\d)\\.\\w+"))) continue;
    const std::string id = match[1].str() + "-" + match[2].str();
    ASSERT_TRUE(rows.contains(id)) << name;
    EXPECT_THAT(named(rows.at(id)), testing::Contains(name));
  }
}

TEST(HardCases, WouldMissATestThatDoesNotExist) {
  EXPECT_FALSE(existing_tests().contains("HardCaseL03.Nothing"));
  EXPECT_THAT(named("`A.B` and `C.D`"), ElementsAre("A.B", "C.D"));
}

}  // namespace
}  // namespace litmus
