// cost_test.cpp: litmus cost and litmus render --max-error as a person uses them.

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "compare/image_io.h"
#include "tests/cli/program_test.h"

namespace litmus {
namespace {

namespace fs = std::filesystem;

/// Without a renderer in sight.
class CostProgram : public ProgramTest {
 protected:
  Ended litmus(const std::string& arguments) const {
    return ProgramTest::litmus(arguments, "PATH=/nonexistent");
  }
};

TEST_F(CostProgram, WritesAPageAndJsonAndSaysWhatIsMissing) {
  const Ended plain = litmus("cost r2 --quick --width 16 --out cost");
  EXPECT_EQ(plain.code, 0) << plain.text;
  EXPECT_TRUE(fs::exists(folder / "cost/cost.html"));
  EXPECT_NE(plain.text.find("Max error 0.02: "), std::string::npos) << plain.text;
  const Ended without = litmus("cost d2 --quick --width 16 --references --out cost");
  EXPECT_EQ(without.code, 3) << "the renderers are not on the path";
  std::ifstream file(folder / "cost/cost.json");
  const nlohmann::json cost = nlohmann::json::parse(file);
  EXPECT_EQ(cost["scene"]["name"], "d2-sun-sphere");
  EXPECT_FALSE(cost["missing"].empty());
  EXPECT_EQ(litmus("cost no-such-scene").code, 2);
}

TEST_F(CostProgram, HasPicturesOfItsOwnForPeers) {
  const Ended refused = litmus("cost --peers --width 16");
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.text.find("--peers has pictures of its own"), std::string::npos)
      << refused.text;
}

TEST_F(CostProgram, RendersTheCheapestPictureThatKeepsAnError) {
  const Ended kept = litmus("render r2 -o kept.exr --max-error 0.01 --width 24 --height 24");
  EXPECT_EQ(kept.code, 0) << kept.text;
  EXPECT_NE(kept.text.find("max error at most 0.00"), std::string::npos) << kept.text;
  ASSERT_EQ(litmus("render r2 -o exact.exr --sampler certified --area-samples 64 --width 24 "
                   "--height 24")
                .code,
            0);
  const Picture picture = read_picture(folder / "kept.exr"),
                exact = read_picture(folder / "exact.exr");
  for (std::size_t i = 0; i < exact.pixels.size(); ++i)
    ASSERT_NEAR(picture.pixels[i].x, exact.pixels[i].x, 0.01);

  const Ended not_kept = litmus("render m1 -o m1.exr --max-error 1e-7 --width 16 --height 16");
  EXPECT_EQ(not_kept.code, 1) << not_kept.text;
  EXPECT_NE(not_kept.text.find("cannot be kept"), std::string::npos) << not_kept.text;
  EXPECT_EQ(litmus("render r2 -o x.exr --max-error 0.01 --precision quad").code, 2);
  EXPECT_EQ(litmus("render r2 -o x.exr --max-error -1").code, 2);
  EXPECT_EQ(litmus("render r2 -o x.exr --max-error 0.1 --metric worst").code, 2);
}

}  // namespace
}  // namespace litmus
