// write_peers_test.cpp: the table of ratios, and peers.json against its schema.
#include "reports/write_peers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/json_schema.h"

namespace litmus {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::vector<PeerTask> tasks() {
  return {{"point",
           "Point light",
           "pixel",
           1e6,
           {{"ours", "", {0.010, 0.020, 0.010}},
            {"theirs", "", {0.040, 0.080, 0.050}},
            {"absent", "not installed", {}}},
           {"A note."}}};
}

TEST(PeersText, PrintsTimeRatioAndSpread) {
  const std::string text = peers_text(tasks());
  EXPECT_THAT(text, HasSubstr("40.00 ms    40.0 ns         4  4 to 5\n"));
  EXPECT_THAT(text, HasSubstr("absent  missing: not installed\n"));
  EXPECT_THAT(text, HasSubstr("  A note.\n"));
}

TEST(PeersText, HasNoRatioToAMissingRow) {
  std::vector<PeerTask> headless = tasks();
  headless[0].rows[0] = {"ours", "no AVX2", {}};
  EXPECT_THAT(peers_text(headless),
              HasSubstr("40.00 ms    40.0 ns   (the first row is missing)\n"));
}

std::vector<std::string> peer_mismatches(const json& peers) {
  return schema_mismatches("reports/peers.schema.json", peers);
}

TEST(PeersJson, FollowsItsSchema) {
  const json peers = json::parse(peers_json(tasks(), {.repeats = 3}, {}));
  EXPECT_THAT(peer_mismatches(peers), IsEmpty());
  EXPECT_EQ(peers["tasks"][0]["rows"][1]["ratio"]["median"], 4);
  json negative = peers, extra = peers;
  negative["tasks"][0]["rows"][0]["seconds"][0] = -1;
  extra["extra"] = 1;
  EXPECT_THAT(peer_mismatches(negative), Not(IsEmpty())) << "a control";
  EXPECT_THAT(peer_mismatches(extra), Not(IsEmpty())) << "a control";
}

}  // namespace
}  // namespace litmus
