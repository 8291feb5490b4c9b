// text_test.cpp: numbers, strings, comments and names survive the way to another language.
#include "exporters/text.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>

namespace litmus {
namespace {

double read_back(const std::string& text) { return std::stod(text); }

TEST(Number, ReadsBackBitEqual) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t bits = random();
    double value;
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isnormal(value)) continue;
    ASSERT_EQ(read_back(number(value)), value) << number(value);
  }
}

TEST(Number, IsShortestText) {
  EXPECT_EQ(number(0.1), "0.1");
  EXPECT_EQ(number(-3), "-3");
  EXPECT_EQ(number(1.0 / 3), "0.3333333333333333");
  EXPECT_EQ(number(-0.0), "0");
  EXPECT_EQ(number(1e-300), "1e-300");
}

TEST(Number, KeepsThePointInEveryLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8")) GTEST_SKIP() << "no de_DE.UTF-8 locale here";
  const std::string text = number(1.5);
  std::setlocale(LC_ALL, before.c_str());
  EXPECT_EQ(text, "1.5");
}

TEST(PovrayString, CannotBeLeft) {
  EXPECT_EQ(povray_string("a\"b\\"), "\"a\\\"b\\\\\"");
  EXPECT_EQ(povray_string("a\nb\xc3\xa4"), "\"a?b??\"");
}

TEST(PythonString, CannotBeLeft) {
  EXPECT_EQ(python_string("a\"b\\\n"), "\"a\\\"b\\\\\\n\"");
  EXPECT_EQ(python_string("\xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80"), "\"\\xe4\\u20ac\\U0001f600\"");
}

TEST(PythonString, ReplacesWhatIsNotUtf8) {
  EXPECT_EQ(python_string("\xff"), "\"\\ufffd\"");
  EXPECT_EQ(python_string("\xc0\xaf"), "\"\\ufffd\\ufffd\"") << "overlong";
  EXPECT_EQ(python_string("\xed\xa0\x80").substr(0, 7), "\"\\ufffd") << "surrogate";
  EXPECT_EQ(python_string("\xe2\x82"), "\"\\ufffd\\ufffd\"") << "cut off";
}

TEST(Comment, StaysOnItsLine) {
  EXPECT_EQ(comment("a\nb\r\x0c c\xe2\x80\xa8z"), "a b   c z");
  EXPECT_EQ(comment("ends in \\"), "ends in");
}

TEST(Comment, KeepsLetters) {
  EXPECT_EQ(comment("Gr\xc3\xb6\xc3\x9f"
                    "e"),
            "Gr\xc3\xb6\xc3\x9f"
            "e");
}

TEST(CommentBlock, BreaksBetweenWords) {
  EXPECT_EQ(comment_block("one two  three", "// ", 7), "// one two\n// three\n");
  EXPECT_EQ(comment_block("unbreakable", "# ", 3), "# unbreakable\n");
  EXPECT_EQ(comment_block("", "# "), "");
}

TEST(CommentBlock, PrefixesEveryLineOfHostileText) {
  const std::string block = comment_block("a\n#include \"/etc/passwd\"\n*/ b", "// ");
  EXPECT_EQ(block, "// a #include \"/etc/passwd\" */ b\n");
}

TEST(Identifier, IsReadable) {
  std::set<std::string> taken;
  EXPECT_EQ(identifier("Material", "red floor", taken), "Material_RedFloor");
  EXPECT_EQ(identifier("Lamp", "key-light 2", taken), "Lamp_KeyLight2");
}

TEST(Identifier, IsUniqueAndSafeForHostileNames) {
  std::set<std::string> taken;
  EXPECT_EQ(identifier("M", "a;b", taken), "M_AB");
  EXPECT_EQ(identifier("M", "a b", taken), "M_AB_2");
  EXPECT_EQ(identifier("M", "\"); import os", taken), "M_ImportOs");
  EXPECT_EQ(identifier("M", "", taken), "M");
  EXPECT_EQ(identifier("M", "\xc3\xa4", taken), "M_2");
  EXPECT_LE(identifier("M", std::string(1000, 'x'), taken).size(), 64u);
}

}  // namespace
}  // namespace litmus
