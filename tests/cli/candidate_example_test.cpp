// candidate_example_test.cpp: the worked example in examples/candidate, right and with its mistake.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "scene/load.h"
#include "test_paths.h"

namespace litmus {
namespace {

namespace fs = std::filesystem;

class CandidateExample : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("python3 -c 'pass' >/dev/null 2>&1") != 0)
      GTEST_SKIP() << "python3 is not installed: apt-get install python3";
    std::string name = fs::temp_directory_path() / "litmus-test-XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder = name;
  }
  void TearDown() override {
    if (!folder.empty()) fs::remove_all(folder);
  }

  /// Runs the example on some scenes; the exit code.
  int run(const std::string& scenes) const {
    const std::string line = "cd '" + folder.string() + "' && XDG_CACHE_HOME='" + folder.string() +
                             "/cache' " LITMUS_PROGRAM " run " + scenes + " --candidates '" +
                             (data_directory() / "examples/candidate/litmus.toml").string() +
                             "' --references stored --out report -q >log 2>&1";
    return WEXITSTATUS(std::system(line.c_str()));
  }
  nlohmann::json rows() const {
    std::ifstream file(folder / "report/results.json");
    return nlohmann::json::parse(file)["comparisons"];
  }

  fs::path folder;
};

TEST_F(CandidateExample, PassesWhenItIsRightAndFailsOnSpotsOnlyWithItsMistake) {
  EXPECT_EQ(run("d2 p4 s5 r1"), 1);
  std::set<std::string> failed, compared;
  for (const auto& row : rows()) {
    compared.insert(row["reference"]);
    if (row["verdict"] == "pass") continue;
    EXPECT_EQ(row["verdict"], "fail") << row;
    EXPECT_EQ(row["reference"], "tiny-full-angle") << row;
    EXPECT_EQ(row["scene"].get<std::string>()[0], 's') << row;
    failed.insert(row["light_type"]);
  }
  EXPECT_TRUE(compared.contains("tiny"));
  EXPECT_EQ(failed, (std::set<std::string>{"spot", "all"}));
}

TEST_F(CandidateExample, DeclinesAMeshAndSaysSo) {
  EXPECT_EQ(run("v3"), 3);
  for (const auto& row : rows()) {
    if (!row["reference"].get<std::string>().starts_with("tiny")) continue;
    EXPECT_EQ(row["verdict"], "skipped");
    EXPECT_NE(row["reason"].get<std::string>().find("spheres and planes only"), std::string::npos);
  }
}

}  // namespace
}  // namespace litmus
