// Lines, words and numbers of text formats.
#include "engine/assets/mesh_files/text_words_impl.h"

#include <gtest/gtest.h>

#include <vector>

namespace plumbline::assets::test {
namespace {

std::vector<std::string> lines_of(std::string_view text) {
    LineReader reader(text);
    std::vector<std::string> lines;
    while (const auto line = reader.next()) lines.emplace_back(*line);
    EXPECT_TRUE(reader.ended());
    return lines;
}

using Lines = std::vector<std::string>;

TEST(TextWords, are_cut_into_lines_without_blanks_around_them) {
    EXPECT_EQ(lines_of(""), Lines{});
    EXPECT_EQ(lines_of("\n"), Lines{""});
    EXPECT_EQ(lines_of(" a b \r\n\n\tc"), (Lines{"a b", "", "c"}));
}

TEST(TextWords, go_on_behind_a_backslash_at_a_lines_end) {
    EXPECT_EQ(lines_of("f 1 \\\n 2 \\\r\n 3\nnext\n"), (Lines{"f 1  2  3", "next"}));
    EXPECT_EQ(lines_of("last \\"), Lines{"last"}) << "nothing follows";
    EXPECT_EQ(lines_of("a\\b\n"), Lines{"a\\b"}) << "not at the end";
}

TEST(TextWords, come_off_a_line_one_by_one) {
    std::string_view line = "  map_Kd\t my  file.png ";
    EXPECT_EQ(next_word(line), "map_Kd");
    EXPECT_EQ(line, "my  file.png") << "blanks within stay";
    EXPECT_EQ(next_word(line), "my");
    EXPECT_EQ(next_word(line), "file.png");
    EXPECT_EQ(next_word(line), "");
}

TEST(TextWords, are_numbers_only_as_a_whole_and_where_a_float_holds_them) {
    EXPECT_EQ(finite_number("1.5"), 1.5F);
    EXPECT_EQ(finite_number("+2e3"), 2000.0F);
    EXPECT_EQ(finite_number("-.25"), -0.25F);
    for (const char* word : {"", "+", "-", "1x", "x", "1 ", "0x10", "nan", "inf", "++1"})
        EXPECT_EQ(finite_number(word), std::nullopt) << word;
    EXPECT_EQ(finite_number("1e39"), std::nullopt);
    EXPECT_EQ(finite_number("-1e999"), std::nullopt);
    // What lies below the smallest float is nothing, not wrong.
    EXPECT_EQ(finite_number("1e-60"), 0.0F);
    EXPECT_EQ(finite_number("-1e-999"), 0.0F);
}

}  // namespace
}  // namespace plumbline::assets::test
