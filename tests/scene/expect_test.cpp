// expect_test.cpp: the [expect] table names closed forms, each once and each by its right name.
#include "scene/expect.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/scene/scratch_scene.h"

namespace litmus {
namespace {

using testing::HasSubstr;

std::string with_expect(const std::string& table) {
  const std::size_t at = kScratchScene.find("[image]");
  return kScratchScene.substr(0, at) + table + kScratchScene.substr(at);
}

std::string expect_complaint(const std::string& table) {
  const ScratchFolder folder;
  try {
    load_scene(folder.write("scene.toml", with_expect(table)));
  } catch (const Refusal& refusal) {
    return refusal.what();
  }
  return {};
}

TEST(Expect, IsReadInItsOrder) {
  const ScratchFolder folder;
  const Scene scene = load_scene(folder.write(
      "scene.toml", with_expect("[expect]\noracles = [\"shadow-curves\", \"floor\"]\n")));
  EXPECT_EQ(scene.expect, (std::vector{Oracle::ShadowCurves, Oracle::Floor}));
}

TEST(Expect, MayBeAbsentAndDoesNotDecideThePicture) {
  const ScratchFolder folder;
  const Scene without = load_scene(folder.write("a.toml", kScratchScene)),
              with = load_scene(
                  folder.write("b.toml", with_expect("[expect]\noracles = [\"floor\"]\n")));
  EXPECT_TRUE(without.expect.empty());
  EXPECT_EQ(fingerprint(without), fingerprint(with));
}

TEST(Expect, RefusesWhatItDoesNotKnow) {
  EXPECT_THAT(expect_complaint("[expect]\noracles = [\"flor\"]\n"),
              AllOf(HasSubstr("oracles: "), HasSubstr("did you mean \"floor\"")));
  EXPECT_THAT(expect_complaint("[expect]\noracle = [\"floor\"]\n"),
              HasSubstr("oracle: unknown key"));
  EXPECT_THAT(expect_complaint("[expect]\noracles = [\"floor\", \"floor\"]\n"),
              HasSubstr("listed twice"));
  EXPECT_THAT(expect_complaint("[expect]\noracles = []\n"), HasSubstr("oracles"));
  EXPECT_THAT(expect_complaint("[expect]\n"), HasSubstr("oracles"));
  EXPECT_NE(expect_complaint("[expect]\noracles = \"floor\"\n"), "");
}

TEST(OracleNames, AreInTheOrderOfTheirValuesAndUnique) {
  std::set<std::string_view> names;
  int value = 0;
  for (const OracleName& each : oracle_names()) {
    EXPECT_EQ(int(each.oracle), value++);
    EXPECT_EQ(name_of(each.oracle), each.name);
    EXPECT_TRUE(names.insert(each.name).second);
    EXPECT_TRUE(each.about.ends_with('.'));
  }
}

}  // namespace
}  // namespace litmus
