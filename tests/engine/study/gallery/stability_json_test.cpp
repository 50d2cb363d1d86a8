// The stability table as JSON, and what its page holds.
#include "tests/engine/study/gallery/sample_table.h"

#include <nlohmann/json.hpp>

namespace plumbline::study {
namespace {

TEST(StabilityJson, HasEveryCaseAndRun) {
    const StabilityTable table = awkward_table();
    const nlohmann::json json = nlohmann::json::parse(stability_json(table));
    EXPECT_FALSE(json.at("complete"));
    EXPECT_EQ(json.at("cases").at(1).at("id"), "H02");
    EXPECT_EQ(json.at("cases").at(1).at("known_to_fail"), "most & all");
    EXPECT_EQ(json.at("cases").at(1).at("nightly"), true);
    ASSERT_EQ(json.at("runs").size(), table.runs.size());
    EXPECT_EQ(json.at("runs").at(0).at("result").at("interventions").at("braked_islands"), 2);
    EXPECT_EQ(json.at("runs").at(1).at("result").at("why"), "its worker <crashed>");
    EXPECT_FALSE(json.at("runs").at(1).contains("known_red")) << "bullet_si has none";
    EXPECT_EQ(json.at("runs").at(2).at("known_red").at(0).at("reached"), 2.0);
    EXPECT_TRUE(json.at("runs").at(2).at("known_red").at(1).at("reached").is_null());
    EXPECT_TRUE(json.at("runs").at(3).at("result").is_null());
    EXPECT_FALSE(json.contains("images")) << "those are the page's";
}

TEST(StabilityJson, ThePageHasTheImagesInBase64) {
    StabilityTable table = sample_table();
    for (const auto& [bytes, text] : {std::pair{"Man", "TWFu"}, {"Ma", "TWE="}, {"M", "TQ=="}}) {
        table.images[0] = bytes;
        const Result<std::string> page = stability_page(table);
        ASSERT_TRUE(page.ok()) << page.error().message;
        EXPECT_NE(page->find(std::string("\"H01\":\"") + text + "\""), std::string::npos) << text;
        EXPECT_EQ(page->find("\"H02\":\""), std::string::npos);
    }
}

}  // namespace
}  // namespace plumbline::study
