// html_shell_test.cpp: small pages are inert, and the report links those that exist.
#include "reports/html_shell.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "reports/write_html.h"
#include "tests/reports/sample_study.h"

namespace litmus {
namespace {
namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(HtmlText, EscapesWhatEndsAnElementOrAnAttribute) {
  EXPECT_EQ(html_text("a<b> & \"c\" 'd'\x1b[31m"), "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;");
}

TEST(SmallPage, HasItsTextBodyAndScriptAndAsksNoNetwork) {
  const std::string page = small_page("Cost", "What it costs", "<p>table</p>", "let a = 1 < 2;");
  for (const char* part : {"<h1>Cost</h1>", "What it costs", "<p>table</p>",
                           "<script nonce=\"litmus\">let a = 1 < 2;</script>", "default-src 'none'",
                           "href=\"report.html\"", "prefers-color-scheme: dark"})
    EXPECT_THAT(page, HasSubstr(part));
  EXPECT_THAT(page, Not(HasSubstr("://")));
}

TEST(SmallPage, WithoutAScriptHasNone) {
  EXPECT_THAT(small_page("a", "b", "c"), Not(HasSubstr("<script")));
}

TEST(SmallPage, KeepsHostileTextInert) {
  const std::string page = small_page(kHostile, kHostile, "");
  EXPECT_THAT(page, Not(HasSubstr("<img")));
  EXPECT_THAT(page, HasSubstr("{{x}}")) << "text is not taken for a template";
  EXPECT_THROW(small_page("a", "b", "c", "'</script>'"), std::invalid_argument);
}

TEST(Page, LinksWhatLiesBesideIt) {
  std::string name = (fs::temp_directory_path() / "litmus-shell-XXXXXX").string();
  const fs::path folder = ::mkdtemp(name.data());
  EXPECT_THAT(pages_in(folder), ElementsAre());
  std::ofstream(folder / "cost.html") << "x";
  EXPECT_THAT(pages_in(folder), ElementsAre(Field(&PageLink::file, "cost.html")));
  write_html(passing_study(), folder / "report.html");
  std::ostringstream page;
  page << std::ifstream(folder / "report.html").rdbuf();
  EXPECT_THAT(page.str(), HasSubstr("<a href=\"cost.html\""));
  EXPECT_THAT(page.str(), Not(HasSubstr("stress.html")));
  fs::remove_all(folder);
}

}  // namespace
}  // namespace litmus
