// The table of stability as a page.
#include "tests/engine/study/gallery/sample_table.h"

#include <string>

namespace plumbline::study {
namespace {

TEST_F(StabilityTableTest, ThePageShowsEveryCellAndEscapes) {
    table.images[0] = "Man";  // "TWFu" in base 64
    table.cases[1].hard.known_red = {{.rule = "sag_m", .reached = 2, .why = "not <yet>"}};
    table.runs[0].result->interventions = {.braked_J = 0.25, .braked_islands = 2};
    const std::string page = stability_page(table);
    for (const char* wanted : {"<tr id=\"H01\">",
                               "<tr id=\"H02\">",
                               "data:image/png;base64,TWFu\"",
                               "a &lt;tower&gt;",
                               "not &lt;yet&gt;",
                               "class=\"pass\"",
                               "class=\"fail\"",
                               "class=\"none\">not run",
                               "<br>0.25 J braked in 2 islands</td>",
                               "1 of 2 pass"}) {
        EXPECT_NE(page.find(wanted), std::string::npos) << wanted;
    }
    EXPECT_EQ(page.find("a <tower>"), std::string::npos);
    EXPECT_EQ(page.find("http"), std::string::npos) << "one file, nothing loaded";
}

TEST_F(StabilityTableTest, PaddingOfImagesIsRight) {
    table.images[0] = "Ma";
    EXPECT_NE(stability_page(table).find("base64,TWE=\""), std::string::npos);
    table.images[0] = "M";
    EXPECT_NE(stability_page(table).find("base64,TQ==\""), std::string::npos);
}

TEST_F(StabilityTableTest, ThePageSaysWhatIsMissing) {
    table.no_images = "no images: <why>";
    table.complete = false;
    table.runs[0].result = CaseResult{.why = "its worker crashed"};
    table.cases[1].hard.known_red = {{.rule = "sag_m", .gone = true, .why = "so"}};
    table.cases[1].hard.nightly = true;
    const std::string page = stability_page(table);
    for (const char* wanted : {"<b>no images: &lt;why&gt;</b>",
                               "interrupted: what was done by then",
                               "its worker crashed</td>",
                               "it reaches nothing: a body is gone: so",
                               ", nightly.",
                               "0 of 2 pass"}) {
        EXPECT_NE(page.find(wanted), std::string::npos) << wanted;
    }
    EXPECT_EQ(page.find("<img"), std::string::npos);
}

}  // namespace
}  // namespace plumbline::study
