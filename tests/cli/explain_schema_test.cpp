// explain_schema_test.cpp: litmus explain --json matches its published schema.
#include <gmock/gmock.h>

#include "tests/cli/program_test.h"
#include "tests/json_schema.h"

namespace litmus {
namespace {
using nlohmann::json;
using ::testing::Contains;
using ::testing::IsEmpty;
using ::testing::StartsWith;

struct ExplainSchema : ProgramTest {
  json explained(const std::string& arguments) const {
    const Ended ended = litmus("explain " + arguments + " --json", "PATH=/nonexistent");
    EXPECT_EQ(ended.code, 0) << ended.text;
    return json::parse(ended.text);
  }
  static std::vector<std::string> errors(const json& value) {
    return schema_mismatches("cli/explain.schema.json", value);
  }
};

TEST_F(ExplainSchema, HoldsForEveryKindOfLightAndForTheBackground) {
  EXPECT_THAT(errors(explained("x5 120 90 --references stored")), IsEmpty());
  EXPECT_THAT(errors(explained("d2 0 0 --references stored")), IsEmpty());
  EXPECT_THAT(errors(explained("m1 60 50 --reference none")), IsEmpty());
}

TEST_F(ExplainSchema, WouldNotHoldForAMissingWrongOrUnknownMember) {
  const json good = explained("x5 120 90 --reference none");
  json bad = good;
  bad["lights"][0]["lamps"][0].erase("reason");
  EXPECT_THAT(errors(bad),
              Contains("<root>[lights][0][lamps][0]: Missing required property 'reason'."));
  bad = good;
  bad["point"][2] = nullptr;
  EXPECT_THAT(errors(bad), Contains(StartsWith("<root>[point][2]: Value type")));
  bad = good;
  bad["extra"] = 1;
  EXPECT_THAT(errors(bad), Contains(StartsWith("<root>: Object contains")));
}

}  // namespace
}  // namespace litmus
