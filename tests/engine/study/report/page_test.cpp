#include "engine/study/report/page.h"

#include "tests/engine/study/findings/sample_findings.h"
#include "tests/support/scoped_variable.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace plumbline::study {
namespace {

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

std::string page_of(const std::string& json, std::vector<std::string> peer_scenes = {}) {
    const Result<std::string> page = report_page(json, peer_scenes);
    EXPECT_TRUE(page) << page.error().message;
    return page ? *page : std::string();
}

TEST(Page, HoldsEverythingAndLoadsNothing) {
    const std::string page = page_of("{}");
    for (const char* part : {".js\"", ".css\"", ".csv\" src", "<link", "@import", "url("})
        EXPECT_FALSE(test::holds(page, part)) << part;
    EXPECT_TRUE(test::holds(page, "function diagram("));
    EXPECT_TRUE(test::holds(page, "<style>"));
}

TEST(Page, NoTextOfTheFindingsEndsItsElement) {
    const std::string plain = page_of("{}");
    const std::string page = page_of(R"({"title": "</script><script>alert(1)</script><!-- <b>"})");
    EXPECT_EQ(count_of(page, "<script"), count_of(plain, "<script"));
    EXPECT_EQ(count_of(page, "</script"), count_of(plain, "</script"));
    EXPECT_EQ(count_of(page, "<!--"), count_of(plain, "<!--"));
    EXPECT_TRUE(test::holds(page, R"(\u003c/script>\u003cscript>alert(1))"));
}

TEST(Page, OfOtherEnginesItHasTheScenesThatAreAskedFor) {
    EXPECT_FALSE(test::holds(page_of("{}"), "\nchainv,bullet32,"));
    const std::string page = page_of("{}", {"chainv", "none"});
    EXPECT_TRUE(test::holds(page, "\nchainv,bullet32,1,"));
    EXPECT_FALSE(test::holds(page, "\nchainh,bullet32,"));
    EXPECT_TRUE(test::holds(page, "\nscene,engine,substeps,"));
}

TEST(Page, AFileThatIsMissingIsNamed) {
    const test::TemporaryFolder folder;
    for (const char* name : {"assets/report/page.html", "shaders/a", "config/a"})
        folder.write(name, "<script src=\"gone.js\"></script>\n");
    const test::ScopedVariable data("PLUMBLINE_DATA", folder.path().string().c_str());
    const Result<std::string> page = report_page("{}");
    ASSERT_FALSE(page.ok());
    EXPECT_TRUE(test::holds(page.error().message, "gone.js")) << page.error().message;
}

TEST(Page, OfAStudyHasItsFindings) {
    Findings findings = test::sample_findings();
    findings.subjects[0].peer_scene = "heavy100";
    const Result<std::string> page = study_page(findings);
    ASSERT_TRUE(page.ok());
    EXPECT_TRUE(test::holds(*page, "\"command\": \"plumbline study --only A01\""));
    EXPECT_TRUE(test::holds(*page, "\nheavy100,"));
}

}  // namespace
}  // namespace plumbline::study
