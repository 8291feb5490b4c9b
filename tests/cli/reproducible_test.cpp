// reproducible_test.cpp: identical inputs give byte-identical reports but for their provenance.
#include "tests/cli/program_test.h"

namespace litmus {
namespace {

/// The text without what stands between the marks, which must be there once.
std::string without(std::string text, const std::string& from, const std::string& to) {
  const std::size_t start = text.find(from);
  EXPECT_NE(start, std::string::npos) << from;
  if (start == std::string::npos) return text;
  EXPECT_EQ(text.find(from, start + 1), std::string::npos) << from << " stands there twice";
  const std::size_t end = to.empty() ? text.size() : text.find(to, start);
  return text.erase(start, end - start);
}

struct Reports {
  std::string json, markdown, junit, html;
};

class Reproducible : public ProgramTest {
 protected:
  Reports reports_of(const std::string& out) const {
    return {text_of(out + "/results.json"), text_of(out + "/summary.md"),
            text_of(out + "/junit.xml"), text_of(out + "/report.html")};
  }

  static Reports without_provenance(const Reports& all) {
    return {without(all.json, "\n  \"provenance\": {", "\n  \"warnings\": ["),
            without(all.markdown, "## Provenance", ""),
            without(all.junit, "<testsuite name=\"provenance\"", "</testsuite>"),
            without(all.html, "<section aria-label=\"Provenance\"", "</section>")};
  }
};

TEST_F(Reproducible, ReportsOfOneRunTwiceDifferInTheirProvenanceAlone) {
  // Failures have the most to say: figures of visibility, hints, causes, an order by size.
  for (const char* out : {"first", "second"})
    ASSERT_EQ(
        litmus(std::string("run d3 s5 r2 --references stored --control shininess -q --out ") + out)
            .code,
        1);
  const Reports first = reports_of("first"), second = reports_of("second");
  EXPECT_NE(first.json, second.json) << "the commands differ, so something does";
  EXPECT_NE(first.html, second.html);
  const Reports one = without_provenance(first), two = without_provenance(second);
  EXPECT_EQ(one.json, two.json);
  EXPECT_EQ(one.markdown, two.markdown);
  EXPECT_EQ(one.junit, two.junit);
  EXPECT_TRUE(one.html == two.html) << "report.html differs outside of its provenance";
}

}  // namespace
}  // namespace litmus
