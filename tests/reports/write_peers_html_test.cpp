// write_peers_html_test.cpp: the tables and the plot of peers.html.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/write_peers.h"

namespace litmus {
namespace {

using testing::HasSubstr;
using testing::Not;

PeerTask beside() {
  return {"point",
          "Point light",
          "pixel",
          1e6,
          {{"ours", "", {0.010, 0.020, 0.010}},
           {"theirs", "", {0.040, 0.080, 0.050}},
           {"<absent>", "not installed", {}}},
          {"A note."}};
}

PeerTask growing() {
  return {"growth-litmus",
          "By triangles",
          "ray",
          100,
          {{"few", "", {1e-5}, 1000}, {"many", "", {3e-5}, 1e6}},
          {}};
}

TEST(PeersPage, HasARowForEachPeer) {
  const std::string page = peers_html({beside()}, {.repeats = 3}, {});
  EXPECT_THAT(page, HasSubstr("<tr><th>theirs</th><td>40.00 ms</td><td>40.0 ns</td>"
                              "<td><b>4\u00d7</b></td><td class=\"dim\">4 to 5\u00d7</td></tr>"));
  EXPECT_THAT(page, HasSubstr("<th>&lt;absent&gt;</th><td class=\"word dim\" "
                              "colspan=\"4\">missing: not installed</td>"));
  EXPECT_THAT(page, HasSubstr("A note."));
}

TEST(PeersPage, PlotsGrowthWhereTwoSizesWereMeasured) {
  EXPECT_THAT(peers_html({beside(), growing()}, {}, {}), HasSubstr("<canvas id=\"growth\""));
  EXPECT_THAT(peers_html({beside()}, {}, {}), Not(HasSubstr("<canvas")));
  PeerTask alone = growing();
  alone.rows[1].missing = "no memory";
  EXPECT_THAT(peers_html({beside(), alone}, {}, {}), Not(HasSubstr("<canvas")));
}

}  // namespace
}  // namespace litmus
