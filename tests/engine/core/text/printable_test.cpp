#include "engine/core/text/printable.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

TEST(Printable, WhatAPersonReadsStays) {
    for (const char* text : {"", "garden.toml", "it's \"50 %\" \\", "grün → 水 🪴"}) {
        EXPECT_EQ(printable(text), text);
        EXPECT_EQ(printable_lines(text), text);
    }
}

TEST(Printable, EscapeSequencesDoNot) {
    EXPECT_EQ(printable("\x1b]0;owned\x07"), "\\x1b]0;owned\\x07");
    EXPECT_EQ(printable("a\rb\x7f"), "a\\x0db\\x7f");
    EXPECT_EQ(printable("\xc2\x9b[2J"), "\\xc2\\x9b[2J") << "the one-character CSI";
}

TEST(Printable, LinesMayBreakWhereSaid) {
    EXPECT_EQ(printable("a\n\tb"), "a\\x0a\\x09b");
    EXPECT_EQ(printable_lines("a\n\tb\x1b"), "a\n\tb\\x1b");
}

TEST(Printable, BytesThatAreNoUtf8AreNamed) {
    EXPECT_EQ(printable("\xff\xfe"), "\\xff\\xfe");
    EXPECT_EQ(printable("a\xc3"), "a\\xc3") << "cut off";
    EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf") << "longer than need be";
    EXPECT_EQ(printable("\xe0\x80\xaf"), "\\xe0\\x80\\xaf");
    EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "half of a pair";
    EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "beyond the last";
}

TEST(Printable, KnowsUtf16WhenItSeesIt) {
    for (const std::string_view text : {std::string_view("\xFF\xFEv\0", 4),
                                        std::string_view("\xFE\xFF\0v", 4),
                                        std::string_view("v\0 \0"
                                                         "1\0",
                                                         6),
                                        std::string_view("\0<\0?", 4)}) {
        EXPECT_TRUE(is_utf16(text)) << text.size();
    }
    for (const std::string_view text : {std::string_view(""),
                                        std::string_view("v 1 2 3"),
                                        std::string_view("\xEF\xBB\xBFv 1"),
                                        std::string_view("glTF\2\0\0\0", 8),
                                        std::string_view("\0\0\0\0", 4),
                                        std::string_view("a\0", 2)}) {
        EXPECT_FALSE(is_utf16(text)) << text;
    }
}

}  // namespace
}  // namespace plumbline
