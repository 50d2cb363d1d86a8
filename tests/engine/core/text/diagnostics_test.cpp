#include "engine/core/text/diagnostics.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

TEST(Diagnostics, PrintAsCompilersDo) {
    EXPECT_EQ(to_string({.severity = Severity::Error,
                         .file = "garden.toml",
                         .line = 14,
                         .column = 9,
                         .key = "entity[3].body.mass_kg",
                         .message = "-1 is below 0.001"}),
              "garden.toml:14:9: error: entity[3].body.mass_kg: -1 is below 0.001");
}

TEST(Diagnostics, LeaveOutWhatIsNotKnown) {
    EXPECT_EQ(
        to_string(
            {.severity = Severity::Warning, .file = "a.toml", .line = 3, .message = "unknown key"}),
        "a.toml:3: warning: unknown key");
    // A column means nothing without its line.
    EXPECT_EQ(to_string({.file = "a.toml", .column = 5, .key = "scene", .message = "is missing"}),
              "a.toml: error: scene: is missing");
}

TEST(Diagnostics, WarningsAloneAreNoErrors) {
    Diagnostics list;
    EXPECT_FALSE(list.has_errors());
    list.add({.severity = Severity::Warning, .file = "a", .message = "first"});
    EXPECT_FALSE(list.has_errors());
    list.add({.severity = Severity::Error, .file = "a", .message = "second"});
    EXPECT_TRUE(list.has_errors());
    ASSERT_EQ(list.list().size(), 2U);
    EXPECT_EQ(list.list()[0].message, "first");
}

}  // namespace
}  // namespace plumbline
