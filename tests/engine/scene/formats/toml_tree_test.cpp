#include "engine/scene/formats/toml_tree.h"

#include <gtest/gtest.h>

#include <memory>

namespace plumbline::scene {
namespace {

TomlNode tree_of(std::string_view text) {
    return std::get<TomlNode>(parse_toml(text, std::make_shared<const std::string>("t")));
}

TEST(TomlTree, KeepsTheOrderAndThePlacesOfTheFile) {
    const TomlNode root = tree_of("b = 1\na = [true, 2.5, 'x', 07:30:00]\n[z]\ny = 1\n");
    ASSERT_EQ(root.table()->size(), 3U);
    EXPECT_EQ(root.table()->at(0).key, "b") << "as written, not as sorted";
    EXPECT_EQ(root.table()->at(1).key_location.line, 2);
    EXPECT_EQ(find_key(*root.table(), "a")->location.column, 5);
    EXPECT_EQ(find_key(*root.table(), "c"), nullptr);
    const TomlArray& items = *find_key(*root.table(), "a")->array();
    EXPECT_EQ(std::get<bool>(items.at(0).value), true);
    EXPECT_EQ(std::get<double>(items.at(1).value), 2.5);
    EXPECT_EQ(*items.at(2).text(), "x");
    EXPECT_TRUE(std::holds_alternative<TomlDate>(items.at(3).value));
}

TEST(TomlTree, OneTableOverAnother) {
    const TomlNode root =
        laid_over(tree_of("n = 1\nlist = [1]\nt = { a = 1, b = 1 }\n[[e]]\nx = 1\n"),
                  tree_of("n = 2\nlist = [2]\nt = { b = 2, c = 2 }\n[[e]]\nx = 2\n"));
    const TomlTable& table = *root.table();
    const auto number = [](const TomlTable& in, std::string_view key) {
        return std::get<std::int64_t>(find_key(in, key)->value);
    };
    EXPECT_EQ(number(table, "n"), 2);
    EXPECT_EQ(find_key(table, "list")->array()->size(), 1U) << "plain arrays are replaced";
    const TomlTable& sub = *find_key(table, "t")->table();
    EXPECT_EQ(number(sub, "a"), 1);
    EXPECT_EQ(number(sub, "b"), 2);
    EXPECT_EQ(number(sub, "c"), 2);
    const TomlArray& tables = *find_key(table, "e")->array();
    ASSERT_EQ(tables.size(), 2U) << "tables come one after the other";
    EXPECT_EQ(number(*tables[0].table(), "x"), 1);
    EXPECT_EQ(number(*tables[1].table(), "x"), 2);
    // A word in the place of a table takes it.
    EXPECT_EQ(*find_key(*laid_over(tree_of("t = { a = 1 }\n"), tree_of("t = 'x'\n")).table(), "t")
                   ->text(),
              "x");
}

TEST(TomlTree, SaysWhereTheParserStopped) {
    const auto fault = parse_toml("a = 1\nb = = 2\n", std::make_shared<const std::string>("t"));
    ASSERT_TRUE(std::holds_alternative<TextFault>(fault));
    EXPECT_EQ(std::get<TextFault>(fault).line, 2);
}

}  // namespace
}  // namespace plumbline::scene
