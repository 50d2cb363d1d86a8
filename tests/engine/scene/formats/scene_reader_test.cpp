#include "engine/scene/formats/scene_reader.h"

#include "tests/engine/scene/sections/scene_file_fixture.h"

namespace plumbline::scene {
namespace {

/// The text's table, and what is said while `read` reads it, line by line.
template <class Read>
std::vector<std::string> said_of_table(const std::string& text, Read read) {
    const auto file = std::make_shared<const std::string>("t");
    const auto tree = parse_toml(text, file);
    Diagnostics said;
    {
        FaultList faults(said);
        TableReader table(std::get<TomlNode>(tree), "", faults);
        read(table);
    }
    std::vector<std::string> lines;
    for (const Diagnostic& fault : said.list()) lines.push_back(to_string(fault));
    return lines;
}

using Lines = std::vector<std::string>;

TEST_F(SceneFileTest, APrefabsFaultIsToldOnce) {
    std::string text = "[[prefab]]\nname = \"p\"\nprimitive = { sphere = -1 }\n";
    for (int i = 0; i < 50; ++i) text += "[[entity]]\nprefab = \"p\"\n";
    EXPECT_EQ(load(text).faults.size(), 1U);
}

TEST_F(SceneFileTest, AHostileFileCannotFloodTheList) {
    std::string text;
    for (int i = 0; i < 5000; ++i) text += fmt::format("key_{} = 1\n", i);
    const Outcome outcome = load(text);
    EXPECT_EQ(outcome.faults.size(), 201U);
    EXPECT_NE(outcome.faults.back().find("further faults are not listed"), std::string::npos);
    EXPECT_FALSE(outcome.scene.ok());
}

TEST_F(SceneFileTest, FaultsComeInTheOrderOfTheFile) {
    const Outcome outcome = load("[fog]\ndensity_per_m = -1\n[world]\nx = 1\n[[entity]]\ny = 2\n");
    ASSERT_EQ(outcome.diagnostics.size(), 3U);
    EXPECT_EQ(outcome.diagnostics[0].line, 2);
    EXPECT_EQ(outcome.diagnostics[1].line, 4);
    EXPECT_EQ(outcome.diagnostics[2].line, 6);
    // The error that the program ends with is the first of them.
    EXPECT_NE(outcome.scene.error().message.find("scene.toml:2:17: error: fog.density_per_m: -1"),
              std::string::npos);
}

TEST(TableReader, GivesValuesOrTheFallbackAndAFault) {
    const Lines said = said_of_table(
        "on = true\nno = 1\nn = 7\nm = 8\nx = 2.5\ny = inf\nword = \"b\"\nother = \"bb\"\n"
        "list = [\"a\", 1]\nup = [0, 0, 2]\nnone = [0, 0, 0]\nday = 2000-01-01\n",
        [](TableReader& table) {
            constexpr std::array<std::string_view, 2> kWords{"a", "b"};
            const auto value_of = [&](std::string_view key, auto value, auto... bounds) {
                table.read(key, value, bounds...);
                return value;
            };
            EXPECT_TRUE(value_of("on", false));
            EXPECT_TRUE(value_of("no", true));
            EXPECT_TRUE(value_of("absent", true));
            EXPECT_EQ(value_of("n", 1, 0, 7), 7);
            EXPECT_EQ(value_of("m", 1, 0, 7), 1);
            EXPECT_EQ(value_of("x", Real{1}, kNotNegative), 2.5_r);
            EXPECT_EQ(value_of("y", Real{1}, kAnyNumber), Real{1});
            std::size_t word = 0;
            table.read_choice("word", word, kWords);
            EXPECT_EQ(word, 1U);
            word = 0;
            table.read_choice("other", word, kWords);
            EXPECT_EQ(word, 0U);
            EXPECT_EQ(table.texts("list"), Lines{"a"});
            Vec3d up{1, 0, 0};
            table.read_direction("up", up);
            EXPECT_EQ(up, (Vec3d{0, 0, 1}));
            Vec3d none{3, 0, 0};
            table.read_direction("none", none);
            EXPECT_EQ(none, (Vec3d{1, 0, 0}));
            EXPECT_EQ(value_of("day", std::string("-")), "-");
            table.finish();
        });
    const Lines wanted{"t:2:6: error: no: 1; expected true or false",
                       "t:4:5: error: m: 8; expected a whole number from 0 to 7",
                       "t:6:5: error: y: inf; expected a finite number",
                       "t:8:9: error: other: \"bb\"; expected one of a, b; did you mean \"b\"?",
                       "t:9:14: error: list[1]: 1; expected a text in quotes",
                       "t:11:8: error: none: [0, 0, 0] has no direction; expected a vector of some "
                       "length",
                       "t:12:7: error: day: a date or time; expected a text in quotes"};
    EXPECT_EQ(said, wanted);
}

TEST(TableReader, LayersLieOverEachOtherKeyByKey) {
    const auto file = std::make_shared<const std::string>("t");
    const auto below = parse_toml("a = 1\nb = 2\nboth = 1\nsub = { x = 1, y = 1 }\n", file);
    const auto above = parse_toml("b = 3\nalso = 1\nsub = { y = 2 }\nodd = 1\n", file);
    Diagnostics said;
    {
        FaultList faults(said);
        TableReader table(
            {&std::get<TomlNode>(above), &std::get<TomlNode>(below)}, "thing", faults);
        const auto digit_of = [](TableReader& of, std::string_view key) {
            int digit = 0;
            of.read(key, digit, 0, 9);
            return digit;
        };
        EXPECT_EQ(digit_of(table, "a"), 1);
        EXPECT_EQ(digit_of(table, "b"), 3);
        EXPECT_EQ(table.either("both", "also"), "also") << "the upper layer's";
        auto sub = table.table("sub");
        ASSERT_TRUE(sub);
        EXPECT_EQ(digit_of(*sub, "x"), 1);
        EXPECT_EQ(digit_of(*sub, "y"), 2);
        EXPECT_EQ(sub->path(), "thing.sub");
        auto lower = table.without_top();
        ASSERT_TRUE(lower);
        EXPECT_EQ(digit_of(*lower, "b"), 2);
        EXPECT_FALSE(table.without_top()->without_top());
        table.finish();
    }
    ASSERT_EQ(said.list().size(), 1U);
    EXPECT_EQ(to_string(said.list()[0]),
              "t:4:1: error: thing.odd: unknown key; known: a, also, b, both, sub");
}

TEST(TableReader, ColoursAreLinearOrOfTheScreen) {
    const Lines said = said_of_table(
        "color_srgb = [1, 0.5, 0]\nemissive = [5, 0, 0]\nclear_color = [1, 1, 1]\n"
        "clear_color_srgb = [0, 0, 0]\nbase_color_srgb = [5, 0, 0]\n",
        [](TableReader& table) {
            // IEC 61966-2-1: 0.5 is 0.21404 of the light.
            const auto color_of = [&](std::string_view key) {
                Vec3f color{0.5F};
                table.read_color(key, color);
                return color;
            };
            expect_near_f(color_of("color"), {1.0F, 0.2140411F, 0.0F});
            EXPECT_EQ(color_of("emissive"), Vec3f(5, 0, 0));
            EXPECT_EQ(color_of("clear_color"), Vec3f(1, 1, 1));
            EXPECT_EQ(color_of("base_color"), Vec3f{0.5F});
        });
    EXPECT_EQ(said,
              (Lines{"t:4:20: error: clear_color_srgb: given beside clear_color; they say the same "
                     "thing, keep one",
                     "t:5:20: error: base_color_srgb[0]: 5; expected a number from 0 to 1"}));
}

TEST(SceneReader, WhatMessagesShow) {
    EXPECT_EQ(shown(std::string(60, 'x')), std::string(60, 'x'));
    EXPECT_EQ(shown(std::string(61, 'x')), std::string(60, 'x') + "…");
    // The 60th byte is the first half of a letter: it goes as a whole.
    EXPECT_EQ(shown(std::string(59, 'x') + "äy"), std::string(59, 'x') + "…");
    EXPECT_EQ(listed(Lines(100, "n")).find("more"), std::string::npos);
    EXPECT_TRUE(listed(Lines(102, "n")).ends_with("n, n and 2 more"));
    EXPECT_EQ(suggestion("x", {}), "; none is known here");
    std::vector<std::string> names;
    for (int i = 0; i < 41; ++i) names.push_back(fmt::format("name_{:02}", i));
    const std::vector<std::string_view> known(names.begin(), names.end());
    EXPECT_TRUE(suggestion("q", known).ends_with("name_38, name_39, …"));
}

}  // namespace
}  // namespace plumbline::scene
