// sum_test.cpp: sums of many lamps.
#include "tracer/sum.h"

#include <gtest/gtest.h>

#include <random>

namespace litmus {
namespace {

TEST(Total, KeepsWhatPlainAdditionLoses) {
  Total<double> total;
  double plain = 0;
  total.add(1), plain += 1;
  for (int i = 0; i < 4096; ++i) total.add(0x1p-54), plain += 0x1p-54;
  EXPECT_EQ(plain, 1.0);  // the control
  EXPECT_EQ(total.value(), 1 + 0x1p-42);
}

TEST(Total, OfManyFloatsDoesNotDependOnTheirOrder) {
  std::mt19937 random(8);
  std::uniform_real_distribution<float> uniform(0, 1);
  std::vector<float> terms(4096);
  for (float& term : terms) term = uniform(random);
  Total<float> forwards, backwards;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    forwards.add(terms[i]);
    backwards.add(terms[terms.size() - 1 - i]);
  }
  EXPECT_EQ(float(forwards.value()), float(backwards.value()));
}

}  // namespace
}  // namespace litmus
