// plain_text_test.cpp: any text is fit to print, and numbers read well.
#include "reports/plain_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace litmus {
namespace {

TEST(CleanText, KeepsWellFormedTextAndLineBreaks) {
  const std::string text = "a\tb\n\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x98\x80 \x7E";
  EXPECT_EQ(clean_text(text), text);
}

TEST(CleanText, DropsControlCharactersAndEscapeSequences) {
  EXPECT_EQ(clean_text(std::string("a\0b\rc\x7F", 6)), "abc");
  EXPECT_EQ(clean_text("\x1b[1;31mred\x1b[0m."), "red.");
  EXPECT_EQ(clean_text("cut\x1b["), "cut");
}

TEST(CleanText, ReplacesEveryBadByte) {
  const std::string bad = "\xEF\xBF\xBD";
  EXPECT_EQ(clean_text("\xFF"), bad);
  EXPECT_EQ(clean_text("\xC0\xAF"), bad + bad) << "overlong";
  EXPECT_EQ(clean_text("\xED\xA0\x80"), bad + bad + bad) << "a surrogate";
  EXPECT_EQ(clean_text("\xE2\x82"), bad + bad) << "cut short";
  EXPECT_EQ(clean_text("\xF4\x90\x80\x80"), bad + bad + bad + bad) << "above U+10FFFF";
}

TEST(Clipped, CutsBetweenCharactersOnly) {
  EXPECT_EQ(clipped("abc", 3), "abc");
  EXPECT_EQ(clipped("abcd", 3), "abc ...");
  EXPECT_EQ(clipped("ab\xC3\xA9", 3), "ab ...");
}

TEST(ShortNumber, HasTwoDigitsAndNoPadding) {
  EXPECT_EQ(short_number(0), "0");
  EXPECT_EQ(short_number(-0.0), "0");
  EXPECT_EQ(short_number(1.23456e-7), "1.2e-7");
  EXPECT_EQ(short_number(-2e-6), "-2e-6");
  EXPECT_EQ(short_number(1.04e-12), "1e-12");
  EXPECT_EQ(short_number(1e-310), "1e-310");
  EXPECT_EQ(short_number(0.25), "0.25");
  EXPECT_EQ(short_number(0.00999), "0.01");
  EXPECT_EQ(short_number(3), "3");
  EXPECT_EQ(short_number(9.999), "10");
  EXPECT_EQ(short_number(1234.4), "1234");
  EXPECT_EQ(short_number(3.04e8), "3e+8");
  EXPECT_EQ(short_number(std::numeric_limits<double>::quiet_NaN()), "not finite");
}

TEST(ShortSeconds, ChoosesItsUnit) {
  EXPECT_EQ(short_seconds(0), "0 s");
  EXPECT_EQ(short_seconds(0.0042), "4.2 ms");
  EXPECT_EQ(short_seconds(0.25), "0.25 s");
  EXPECT_EQ(short_seconds(12.4), "12 s");
  EXPECT_EQ(short_seconds(200.2), "3 min 20 s");
}

TEST(Counted, SetsCommasAndTheNoun) {
  EXPECT_EQ(counted(1, "pixel", "pixels"), "1 pixel");
  EXPECT_EQ(counted(0, "pixel", "pixels"), "0 pixels");
  EXPECT_EQ(counted(999, "pixel", "pixels"), "999 pixels");
  EXPECT_EQ(counted(1234567, "pixel", "pixels"), "1,234,567 pixels");
  EXPECT_EQ(with_commas(-1000), "-1,000");
  EXPECT_EQ(with_commas(-100), "-100");
}

TEST(Nearby, IsRelativeOnlyBelowTheWorkingFolder) {
  const std::filesystem::path here = std::filesystem::current_path();
  EXPECT_EQ(nearby(here / "scene" / "x.toml"), "scene/x.toml");
  EXPECT_EQ(nearby("scene/../x.toml"), "x.toml");
  EXPECT_EQ(nearby(here.parent_path() / "x.toml"), (here.parent_path() / "x.toml").string());
  EXPECT_EQ(nearby(""), "");
}

}  // namespace
}  // namespace litmus
