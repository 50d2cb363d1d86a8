// Text between quotation marks, as TOML reads it back.
#include "engine/core/text/toml_text.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

TEST(TomlText, EscapesWhatWouldEndOrBreakIt) {
    EXPECT_EQ(toml_text("plain"), "\"plain\"");
    EXPECT_EQ(toml_text("a \"b\" \\ c"), "\"a \\\"b\\\" \\\\ c\"");
    EXPECT_EQ(toml_text("line\nend\x7F"), "\"line\\u000aend\\u007f\"");
    EXPECT_EQ(toml_text("Grüße"), "\"Grüße\"");
}

}  // namespace
}  // namespace plumbline
