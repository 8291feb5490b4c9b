// ssim_test.cpp: SSIM against closed forms and the definition written out.
#include "compare/ssim.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "compare/difference.h"
#include "tests/compare/pictures.h"

namespace litmus {
namespace {

double encoded(double v) {
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

Picture textured(int width, int height, int seed) {
  Picture picture(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      picture.at(x, y) = glm::dvec3(0.5 + 0.4 * std::sin(1.3 * x + 0.7 * y * seed + seed));
  return picture;
}

TEST(Ssim, OfEqualPicturesIsOne) { EXPECT_EQ(ssim(textured(20, 15, 1), textured(20, 15, 1)), 1); }

TEST(Ssim, OfConstantsComparesTheirMeans) {
  const double a = encoded(0.2), b = encoded(0.7);
  EXPECT_NEAR(ssim(flat(20, 20, 0.2), flat(20, 20, 0.7)),
              (2 * a * b + 1e-4) / (a * a + b * b + 1e-4), 1e-12);
}

TEST(Ssim, OfOneWindowIsTheDefinition) {
  const Picture p = textured(11, 11, 1), q = textured(11, 11, 2);
  double total = 0, ma = 0, mb = 0, aa = 0, bb = 0, ab = 0;
  for (int pass = 0; pass < 2; ++pass)
    for (int y = 0; y < 11; ++y)
      for (int x = 0; x < 11; ++x) {
        const double w = std::exp(-((x - 5) * (x - 5) + (y - 5) * (y - 5)) / (2 * 1.5 * 1.5));
        const double a = encoded(p.at(x, y).x), b = encoded(q.at(x, y).x);
        if (pass == 0) {
          total += w, ma += w * a, mb += w * b;
          continue;
        }
        const double da = a - ma / total, db = b - mb / total;
        aa += w * da * da, bb += w * db * db, ab += w * da * db;
      }
  ma /= total, mb /= total, aa /= total, bb /= total, ab /= total;
  const double expected =
      (2 * ma * mb + 1e-4) * (2 * ab + 9e-4) / ((ma * ma + mb * mb + 1e-4) * (aa + bb + 9e-4));
  EXPECT_NEAR(ssim(p, q), expected, 1e-12);
}

TEST(Ssim, OfAnInvertedTextureIsNegative) {
  Picture inverted = textured(30, 30, 1);
  for (glm::dvec3& pixel : inverted.pixels) pixel = glm::dvec3(1) - pixel;
  EXPECT_LT(ssim(textured(30, 30, 1), inverted), -0.5);
}

TEST(Ssim, IsDefinedForPicturesSmallerThanAWindow) {
  EXPECT_EQ(ssim(flat(3, 2, 0.4), flat(3, 2, 0.4)), 1);
  EXPECT_LT(ssim(flat(1, 1, 0.1), flat(1, 1, 0.9)), 0.8);
  EXPECT_EQ(ssim({}, {}), 1);
}

TEST(Ssim, IsFiniteWhateverThePixels) {
  for (const double value : {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(), 1e308, -1e308}) {
    Picture odd = flat(12, 12, 0.5);
    odd.at(6, 6) = glm::dvec3(value);
    const double similarity = ssim(odd, flat(12, 12, 0.5));
    EXPECT_GE(similarity, -1) << value;
    EXPECT_LE(similarity, 1) << value;
  }
}

TEST(Ssim, RefusesDifferentSizes) {
  EXPECT_THROW(ssim(flat(2, 3, 0), flat(3, 2, 0)), SizeMismatch);
}

}  // namespace
}  // namespace litmus
