// peer_kernels_test.cpp: the operations of a picture are those of the picture that is timed.
#include <gtest/gtest.h>

#include "reports/peer_entrants.h"
#include "reports/rates.h"
#include "reports/stage.h"
#include "tracer/render.h"

namespace litmus {
namespace {

TEST(CountedOperations, AreThoseOfTheSamePictureBitByBit) {
  for (const Scene& scene : {point_stage(32), area_stage(24, 3)}) {
    Picture counted;
    counted_operations(scene, &counted);
    EXPECT_EQ(counted.pixels, render(scene).whole.pixels);
  }
}

TEST(CountedOperations, GrowWithWhatASceneCallsFor) {
  const Operations matte = counted_operations(diffuse_stage(32)),
                   glossy = counted_operations(point_stage(32)),
                   soft = counted_operations(area_stage(32, 4));
  EXPECT_GT(matte.sums, 32u * 32u * 50u) << "a ray meets a floor, three balls and a box";
  EXPECT_GT(glossy.sums, matte.sums);
  EXPECT_GT(glossy.divisions, matte.divisions) << "attenuation divides";
  EXPECT_GT(soft.roots, 4 * glossy.roots) << "16 lamps are 16 distances";
  EXPECT_LT(soft.roots, 16 * glossy.roots) << "but the rays from the eye are the same";
}

TEST(CountedOperations, StartFromNothingEachTime) {
  const Scene scene = diffuse_stage(16);
  const Operations once = counted_operations(scene), again = counted_operations(scene);
  EXPECT_EQ(once.sums, again.sums);
}

TEST(ArithmeticRates, AreThereOnEveryProcessorWithPackets) {
  const ArithmeticRates rates = arithmetic_rates();
  if (rates.sums == 0) GTEST_SKIP() << "no AVX2";
  EXPECT_GT(rates.sums, rates.divisions) << "a division takes many times as long as a sum";
  EXPECT_GT(rates.sums, rates.roots);
}

}  // namespace
}  // namespace litmus
