// hash_test.cpp: the checksum is XXH3-128, of texts and files alike.
#include "reference/hash.h"

#include "scene/refusal.h"
#include "tests/reference/sample_scene.h"

namespace litmus {
namespace {

struct Hash : InFolder {};

TEST_F(Hash, IsXxh3OfTheBytes) {
  // From xxhash's specification: XXH3-128 of nothing, seed 0.
  EXPECT_EQ(hash_text(""), "99aa06d3014798d86001c324468d497f");
}

TEST_F(Hash, OfAFileIsThatOfItsText) {
  const std::string text(1000003, 'x');  // more than one block, and not a whole number of them
  write_text(folder / "file", text);
  EXPECT_EQ(hash_file(folder / "file"), hash_text(text));
  EXPECT_NE(hash_file(folder / "file"), hash_text(text + "x"));
}

TEST_F(Hash, RefusesAMissingFile) { EXPECT_THROW(hash_file(folder / "none"), Refusal); }

}  // namespace
}  // namespace litmus
