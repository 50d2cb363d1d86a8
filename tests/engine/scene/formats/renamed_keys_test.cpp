#include "engine/scene/formats/renamed_keys.h"

#include "tests/engine/scene/sections/scene_file_fixture.h"

#include <map>

namespace plumbline::scene {
namespace {

using RenamedKeysTest = SceneFileTest;

/// A gallery's scene with one line in its table `table`, all else as it is said today.
std::string scene_with(std::string_view table, const std::string& line) {
    const bool is_rule = table == "hard_case.pass";
    const bool is_event = table == "hard_case.event";
    const bool is_red = table == "hard_case.known_red";
    const bool is_joint = table == "joint";
    return fmt::format(
        "[hard_case]\nid = \"H1\"\nshows = \"it\"\n"
        "[[entity]]\nname = \"a\"\nprimitive = {{ box = [1, 1, 1] }}\nbody = {{ mass_kg = 1 }}\n"
        "[[joint]]\na = \"a\"\nb = \"world\"\nanchor_m = [0, 0, 0]\n{}\n"
        "[[hard_case.pass]]\nbelow = 1\n{}\n"
        "[[hard_case.event]]\nof = \"a\"\n{}\n"
        "[[hard_case.known_red]]\nreached = 2\nwhy = \"so\"\n{}\n",
        is_joint ? line : "kind = \"fixed\"",
        is_rule ? line : "measure = \"sag_m\"",
        is_event ? line : "do = \"remove\"",
        is_red ? line : "rule = \"sag_m at most 1\"");
}

/// The line with the old word or with the new one.
std::string line_of(const RenamedKey& renamed, std::string_view word) {
    static const std::map<std::string_view, std::string_view> values{
        {"spin_radps", "do = \"velocity\"\nvalue = [0, 0, 0]\n{} = [0, 2, 0]"},
        {"for_s", "do = \"force\"\nvalue = [1, 0, 0]\n{} = 0.5"}};
    if (renamed.key.empty()) return fmt::format(fmt::runtime(values.at(renamed.before)), word);
    return fmt::format(
        "{} = \"{}{}\"", renamed.key, word, renamed.key == "rule" ? " at most 1" : "");
}

/// What the description has where the word was.
std::string meant(const SceneDescription& scene) {
    const HardCase& hard = *scene.hard_case;
    return fmt::format("{} | {} {} | {} | {}",
                       hard.rules.at(0).measure,
                       hard.events.at(0).angular_velocity_radps.y,
                       hard.events.at(0).duration_s,
                       hard.known_red.at(0).rule,
                       static_cast<int>(scene.joints.at(0).kind));
}

TEST_F(RenamedKeysTest, EveryOldWordIsReadWithAWarningThatNamesTheNewOne) {
    ASSERT_FALSE(renamed_keys().empty());
    for (const RenamedKey& renamed : renamed_keys()) {
        SCOPED_TRACE(fmt::format("{}.{}{}", renamed.table, renamed.key, renamed.before));
        write("now.toml", scene_with(renamed.table, line_of(renamed, renamed.now)));
        const Outcome now = load_file("now.toml");
        ASSERT_TRUE(now.scene.ok()) << now.faults.front();
        EXPECT_EQ(now.faults, std::vector<std::string>{});
        write("before.toml", scene_with(renamed.table, line_of(renamed, renamed.before)));
        const Outcome before = load_file("before.toml");
        ASSERT_TRUE(before.scene.ok()) << before.faults.front();
        ASSERT_EQ(before.faults.size(), 1U);
        const Diagnostic& said = before.diagnostics.front();
        EXPECT_EQ(said.severity, Severity::Warning);
        EXPECT_GT(said.line, 8);
        EXPECT_EQ(said.key,
                  fmt::format(
                      "{}.{}", renamed.table, renamed.key.empty() ? renamed.before : renamed.key));
        EXPECT_EQ(said.message,
                  fmt::format("\"{}\" is called \"{}\" now", renamed.before, renamed.now));
        EXPECT_EQ(meant(*before.scene), meant(*now.scene));
    }
}

TEST_F(RenamedKeysTest, BothKeysAreOneTooMany) {
    write("both.toml",
          scene_with("hard_case.event",
                     "do = \"force\"\nvalue = [1, 0, 0]\nfor_s = 1\nduration_s = 2"));
    const Outcome both = load_file("both.toml");
    EXPECT_FALSE(both.scene.ok());
    ASSERT_EQ(both.faults.size(), 1U);
    EXPECT_NE(both.faults.front().find("for_s: unknown key"), std::string::npos)
        << both.faults.front();
}

TEST_F(RenamedKeysTest, OnlyWholeWordsInTheirOwnTable) {
    write("other.toml", scene_with("hard_case.pass", "measure = \"joint_gap_mm\""));
    const Outcome other = load_file("other.toml");
    for (const std::string& fault : other.faults)
        EXPECT_EQ(fault.find("is called"), std::string::npos) << fault;
}

}  // namespace
}  // namespace plumbline::scene
