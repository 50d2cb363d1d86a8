// Stability tables of several machines as one.
#include "engine/study/gallery/stability.h"

#include <gtest/gtest.h>

namespace plumbline::study {
namespace {

std::vector<CaseEntry> cases() {
    std::vector<CaseEntry> made(3);
    made[0].hard.id = "H01";
    made[1].hard.id = "H02";
    made[2].hard.id = "H03";
    return made;
}

/// A table that shard `index` of `of` has made; 0: all of it.
StabilityTable table_of(int index, int of) {
    StabilityTable table =
        plan_table(cases(), {physics::Solver::SmallStep, physics::Solver::BulletSi}, {60, 240});
    table.command = "plumbline stability";
    table.build = "1.0";
    if (index > 0) table.shard = Shard{.index = index, .of = of, .what = table.command};
    for (std::size_t i = 0; i < table.runs.size(); ++i) {
        if (table.shard && !table.shard->has(i)) continue;
        table.runs[i].result = CaseResult{.ran = true,
                                          .passed = i % 3 != 0,
                                          .simulated_s = static_cast<double>(i),
                                          .rules = {{.text = "sag_m at most 1",
                                                     .allowed = {Allowed::Kind::Below, 1, 0},
                                                     .value = 0.1 * static_cast<double>(i),
                                                     .margin = 0.5}}};
    }
    return table;
}

TEST(StabilityMerge, AllShardsAreTheWholeToTheLastByte) {
    for (const int of : {1, 2, 4, 20}) {
        std::vector<std::string> parts;
        for (int index = of; index >= 1; --index)
            parts.push_back(stability_json(table_of(index, of)));
        const Result<StabilityTable> whole = merged_tables(parts, cases());
        ASSERT_TRUE(whole.ok()) << whole.error().message;
        EXPECT_EQ(stability_json(*whole), stability_json(table_of(0, 0))) << of;
        EXPECT_EQ(stability_text(*whole), stability_text(table_of(0, 0))) << of;
        EXPECT_EQ(*stability_page(*whole), *stability_page(table_of(0, 0))) << of;
    }
}

TEST(StabilityMerge, WhatIsNoWholeIsRefused) {
    const auto refusal = [](const std::vector<std::string>& parts) {
        const Result<StabilityTable> made = merged_tables(parts, cases());
        EXPECT_FALSE(made.ok());
        return made ? "" : made.error().message;
    };
    const std::string first = stability_json(table_of(1, 2));
    const std::string second = stability_json(table_of(2, 2));
    EXPECT_EQ(refusal({first}), "shard 2 is missing");
    EXPECT_EQ(refusal({first, first, second}), "shard 1 is there twice");
    EXPECT_NE(refusal({"{}"}).find("not what `plumbline stability` writes"), std::string::npos);
    EXPECT_NE(refusal({"nonsense"}).find("not what `plumbline stability` writes"),
              std::string::npos);
    StabilityTable cut = table_of(2, 2);
    cut.runs[1].result.reset();
    EXPECT_NE(refusal({first, stability_json(cut)})
                  .find("no shard has made H01 with small_step at 240 Hz"),
              std::string::npos);
    const Result<StabilityTable> elsewhere =
        merged_tables(std::vector{first, second}, {cases()[0]});
    ASSERT_FALSE(elsewhere.ok());
    EXPECT_NE(elsewhere.error().message.find("there is no case \"H02\" here"), std::string::npos);
}

}  // namespace
}  // namespace plumbline::study
