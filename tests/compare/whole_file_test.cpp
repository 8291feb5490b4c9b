// whole_file_test.cpp: a file is the old one or the new one, never a part.
#include "compare/whole_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "scene/refusal.h"

namespace litmus {
namespace {
namespace fs = std::filesystem;

struct WholeFile : ::testing::Test {
  fs::path folder;
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "litmus-whole-XXXXXX").string();
    folder = ::mkdtemp(name.data());
  }
  void TearDown() override { fs::remove_all(folder); }
  std::string text() const {
    std::ifstream stream(folder / "x.txt", std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  auto files() const { return std::distance(fs::directory_iterator(folder), {}); }
};

TEST_F(WholeFile, KeepsEveryByte) {
  const std::string bytes("a\0b\r\n\xFF", 6);
  write_whole(folder / "x.txt", bytes);
  EXPECT_EQ(text(), bytes);
  EXPECT_EQ(files(), 1);
}

TEST_F(WholeFile, StaysTheOldOneWhereWritingFails) {
  write_whole(folder / "x.txt", "old");
  const auto write_half = [](const fs::path& temporary) {
    std::ofstream(temporary) << "half";
    throw std::runtime_error("power cut");
  };
  EXPECT_THROW(write_whole(folder / "x.txt", write_half), std::runtime_error);
  EXPECT_EQ(text(), "old");
  EXPECT_EQ(files(), 1) << "the temporary is gone";
}

TEST_F(WholeFile, IsWrittenBesideItsPlaceUnderTheSameExtension) {
  write_whole(folder / "x.txt", [&](const fs::path& temporary) {
    EXPECT_EQ(temporary.parent_path(), folder);
    EXPECT_EQ(temporary.extension(), ".txt");
    EXPECT_FALSE(fs::exists(folder / "x.txt"));
    std::ofstream(temporary) << "new";
  });
  EXPECT_EQ(text(), "new");
}

TEST_F(WholeFile, ThatCannotBeWrittenIsRefusedByName) {
  try {
    write_whole(folder / "missing" / "x.txt", "text");
    FAIL() << "not refused";
  } catch (const Refusal& refusal) {
    EXPECT_EQ(std::string(refusal.what()).find((folder / "missing" / "x.txt").string()), 0u);
  }
}

}  // namespace
}  // namespace litmus
