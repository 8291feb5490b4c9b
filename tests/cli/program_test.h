// program_test.h: the program in a folder of its own, as a person runs it.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "test_paths.h"

namespace litmus {

struct Ended {
  int code = -1;
  std::string text;  ///< standard output and error
};

class ProgramTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = std::filesystem::temp_directory_path() / "litmus-test-XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  /// Runs litmus in the test's folder, with a store of its own and outside of any CI.
  Ended litmus(const std::string& arguments, const std::string& environment = "") const {
    return run(LITMUS_PROGRAM, arguments, environment);
  }

  /// The same of another copy of the program.
  Ended run(const std::string& program, const std::string& arguments,
            const std::string& environment = "") const {
    const std::string line = "cd '" + folder.string() + "' && env -u GITHUB_ACTIONS " +
                             "XDG_CACHE_HOME='" + folder.string() + "/cache' " + environment + " " +
                             program + " " + arguments + " 2>&1";
    FILE* pipe = popen(line.c_str(), "r");
    Ended ended;
    std::array<char, 4096> buffer;
    while (const std::size_t n = fread(buffer.data(), 1, buffer.size(), pipe))
      ended.text.append(buffer.data(), n);
    const int status = pclose(pipe);
    ended.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return ended;
  }

  std::string text_of(const std::string& name) const {
    std::ifstream file(folder / name, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name, std::ios::binary) << text;
  }

  nlohmann::json results(const std::string& out) const {
    return nlohmann::json::parse(text_of(out + "/results.json"));
  }

  std::filesystem::path folder;
};

}  // namespace litmus
