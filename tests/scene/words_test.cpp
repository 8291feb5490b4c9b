// words_test.cpp: distances between words, suggestions and lists.
#include "scene/words.h"

#include <gtest/gtest.h>

#include <cmath>

namespace litmus {
namespace {

const std::vector<std::string> kKeys{"cutoff_degrees", "range", "radius", "rows"};

TEST(EditDistance, CountsChangesWhateverTheCase) {
  EXPECT_EQ(edit_distance("range", "Range"), 0);
  EXPECT_EQ(edit_distance("rnage", "range"), 1);
  EXPECT_EQ(edit_distance("cutof", "cutoff"), 1);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
}

TEST(Suggestion, NamesTheNearestOrNothing) {
  EXPECT_EQ(suggestion("cutof_degree", kKeys), "; did you mean \"cutoff_degrees\"?");
  EXPECT_EQ(suggestion("falloff", kKeys), "");
}

TEST(Listed, JoinsWords) {
  EXPECT_EQ(listed(kKeys, "or"), "cutoff_degrees, range, radius or rows");
  EXPECT_EQ(listed({}), "none");
}

TEST(NumberText, IsTheShortestThatReadsBack) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(-2), "-2");
  EXPECT_EQ(number_text(NAN), "nan");
}

}  // namespace
}  // namespace litmus
