// frames_test.cpp: a renderer on PATH is asked for its version as often as needed.
#include "reference/frames.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>

namespace litmus {
namespace {

namespace fs = std::filesystem;

/// A program `sketch` alone on PATH, which counts its starts.
class FindInstallation : public testing::Test {
 protected:
  FindInstallation() {
    fs::create_directories(folder_);
    ::setenv("PATH", (folder_.string() + ":/usr/bin:/bin").c_str(), 1);
  }
  ~FindInstallation() override {
    ::setenv("PATH", path_.c_str(), 1);
    fs::remove_all(folder_);
  }

  /// As if written `seconds` after now.
  void write_program(const std::string& last_line, int seconds) {
    const fs::path program = folder_ / "sketch";
    write_text(program, "#!/bin/sh\necho start >> " + starts_.string() + "\n" + last_line + "\n");
    fs::permissions(program, fs::perms::owner_all);
    fs::last_write_time(program, fs::file_time_type::clock::now() + std::chrono::seconds(seconds));
  }
  std::string version() const {
    const auto found = find_installation("sketch", "Sketch ");
    return found ? found->version : "none";
  }
  int starts() const {
    const std::string text = read_text(starts_);
    return int(std::count(text.begin(), text.end(), '\n'));
  }

 private:
  const fs::path folder_ =
      fs::temp_directory_path() / ("litmus-find-installation-" + std::to_string(::getpid()));
  const fs::path starts_ = folder_ / "starts";
  const std::string path_ = std::getenv("PATH");
};

TEST_F(FindInstallation, TakesDigitsAndDotsBehindTheTitle) {
  write_program("echo 'Sketch 4.5.6.unofficial'", 0);
  EXPECT_EQ(version(), "4.5.6");
}

TEST_F(FindInstallation, AsksAProgramOnce) {
  write_program("echo Sketch 1.2", 1);
  EXPECT_EQ(version(), "1.2");
  EXPECT_EQ(version(), "1.2");
  EXPECT_EQ(starts(), 1);
}

TEST_F(FindInstallation, AsksAgainWhenItsFileWasWritten) {
  write_program("echo Sketch 1.2", 2);
  EXPECT_EQ(version(), "1.2");
  write_program("echo Sketch 1.3", 3);
  EXPECT_EQ(version(), "1.3");
}

TEST_F(FindInstallation, AsksAgainAfterAFailure) {
  write_program("exit 1", 4);
  EXPECT_EQ(version(), "none");
  EXPECT_EQ(version(), "none");
  EXPECT_EQ(starts(), 2);
}

}  // namespace
}  // namespace litmus
