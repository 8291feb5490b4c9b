// triage_test.cpp: the three figures are each where their name says.
#include "compare/triage.h"

#include <gtest/gtest.h>

#include "compare/flip.h"
#include "compare/ssim.h"

namespace litmus {
namespace {

TEST(Triage, HoldsFlipAndSsimOfOursAgainstTheirs) {
  Picture ours(16, 16), theirs(16, 16);
  for (std::size_t i = 0; i < ours.pixels.size(); ++i) {
    ours.pixels[i] = glm::dvec3(0.01 * double(i));
    theirs.pixels[i] = glm::dvec3(0.004 * double(i));
  }
  const Triage figures = triage(ours, theirs);
  EXPECT_EQ(figures.ldr_flip, ldr_flip(ours, theirs));
  EXPECT_EQ(figures.hdr_flip, hdr_flip(ours, theirs));
  EXPECT_EQ(figures.ssim, ssim(ours, theirs));
  EXPECT_NE(figures.hdr_flip, hdr_flip(theirs, ours)) << "theirs is the reference";
}

}  // namespace
}  // namespace litmus
