// What of TOML text never reaches the parser.
#include "engine/core/text/toml_prescan.h"

#include "engine/core/limits.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace plumbline {
namespace {

/// "LINE:COLUMN MESSAGE"; empty where nothing is wrong.
std::string prescan(std::string_view text) {
    const std::optional<TextFault> fault = prescan_toml(text);
    return fault ? fmt::format("{}:{} {}", fault->line, fault->column, fault->message) : "";
}

TEST(TomlPrescan, LetsOrdinaryTextThrough) {
    for (const char* text : {"",
                             "\xEF\xBB\xBFname = \"Gr\xC3\xBCn\" # caf\xC3\xA9\r\n",
                             "[a.b]\n[[c]]\n[ d ]\n[\"e\"]\nx = [[1.5], [{ y = 'z' }]]\n",
                             "t = \"\"\"a \\\n  b \"quoted\" [[[ \"\"\"\"\"\nu = '''[{''''\n",
                             "s = \"[[[[ \\\" ]\"\nkey = 'it # is'\n",
                             "date = 1979-05-27T07:32:00.5\na.b.c.d = 1\n"})
        EXPECT_EQ(prescan(text), "") << text;
}

TEST(TomlPrescan, CountsNestingOutsideTextsAndComments) {
    const std::string open(limits::kTextNesting, '[');
    EXPECT_EQ(prescan("x = " + open), "");
    EXPECT_EQ(prescan("x = " + open + "["), "1:37 nested deeper than 32");
    EXPECT_EQ(prescan("x = " + open + "\n{"), "2:1 nested deeper than 32");
    EXPECT_EQ(prescan("x = " + open + "]["), "") << "closed before";
    EXPECT_EQ(prescan("x = \"" + open + open + "\"\n# " + open + open), "");
}

TEST(TomlPrescan, NamesBracketsThatDoNotClose) {
    EXPECT_EQ(prescan("x = [1}\n"), "1:7 } does not close [");
    EXPECT_EQ(prescan("\nx = {a = 1]\n"), "2:11 ] does not close {");
    EXPECT_EQ(prescan("x = ]\n"), "") << "the parser says so";
}

TEST(TomlPrescan, CountsPartsOfAKeyAndBytesOfALine) {
    EXPECT_EQ(prescan("a.b.c.d.e = 1\n"), "1:8 a dotted key of more than 4 parts");
    EXPECT_EQ(prescan("x = [1.5, 2.5, 3.5, 4.5, 5.5]\n"), "");
    EXPECT_EQ(prescan("\"a.b.c.d.e\" = 1\n"), "");
    const std::string line(limits::kLineBytes, ' ');
    EXPECT_EQ(prescan(line + "\n" + line), "");
    EXPECT_EQ(prescan("\n" + line + " "), "2:16385 the line is longer than 16384 bytes; break it");
    EXPECT_EQ(prescan("# " + line), "1:16385 the line is longer than 16384 bytes; break it");
}

TEST(TomlPrescan, KeepsFromTheParserWhatItWouldStumbleOver) {
    const std::string ascii = "a letter that is not ASCII; only texts and comments may hold them";
    EXPECT_EQ(prescan("gr\xC3\xBCn = 1\n"), "1:3 " + ascii);
    EXPECT_EQ(prescan("x = 1\"\xC3\"\n"), "1:7 " + ascii) << "glued to a number it is no text";
    EXPECT_EQ(prescan("x = \"\\\xC3\xBC\"\n"), "1:6 a backslash before a letter that is not ASCII");
    EXPECT_EQ(prescan("x = \"\"\"\\\n \xC3\xBC\"\"\"\n"),
              "1:8 a backslash before a letter that is not ASCII");
    EXPECT_EQ(prescan("x = '\\\xC3\xBC'\n"), "") << "in single quotes it escapes nothing";
    EXPECT_EQ(prescan("[=]\n"), "1:2 expected a table's name after [");
    EXPECT_EQ(prescan("x = 1\n  [[ #]]\n"), "2:6 expected a table's name after [");
    EXPECT_EQ(prescan("[]\n[ [\n"), "") << "the parser has good words for these";
}

}  // namespace
}  // namespace plumbline
