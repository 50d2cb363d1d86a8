#include "engine/core/io/saved_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace plumbline {
namespace {

const std::string kContent = "what was saved";

std::string fault_of(std::string_view bytes) {
    const auto content = unshelled(bytes, "one.save");
    return content ? "" : content.error().message;
}

TEST(SavedFile, GivesBackWhatWasPutIn) {
    const std::string bytes = shelled(kContent);
    const auto content = unshelled(bytes, "one.save");
    ASSERT_TRUE(content.ok());
    EXPECT_EQ(*content, kContent);
}

TEST(SavedFile, CutAtEveryLengthItSaysHowMuchIsThere) {
    const std::string bytes = shelled(kContent);
    EXPECT_EQ(bytes.size(), 42U);
    EXPECT_EQ(fault_of(""), "one.save: no saved game: it does not begin with \"PLUMSAVE\"");
    for (std::size_t size = 1; size < 28; ++size)
        EXPECT_EQ(fault_of(bytes.substr(0, size)),
                  "one.save: a saved game cut short: " + std::to_string(size) +
                      " bytes, its head alone has 28");
    for (std::size_t size = 28; size < bytes.size(); ++size)
        EXPECT_EQ(fault_of(bytes.substr(0, size)),
                  "one.save: a saved game cut short: " + std::to_string(size) + " bytes of 42");
    EXPECT_EQ(fault_of(bytes + "!"), "one.save: a damaged saved game: 43 bytes, it should have 42");
}

TEST(SavedFile, NoticesEveryFlippedBit) {
    const std::string good = shelled(kContent);
    const std::string other = "; this program reads format " + std::to_string(kSavedFormat);
    for (std::size_t i = 0; i < good.size() * 8; ++i) {
        std::string bad = good;
        bad[i / 8] = static_cast<char>(bad[i / 8] ^ (1 << i % 8));
        const std::string fault = fault_of(bad);
        EXPECT_TRUE(fault.starts_with("one.save: ")) << i;
        const std::size_t byte = i / 8;
        const std::string_view said = byte < 8    ? "no saved game"
                                      : byte < 12 ? std::string_view{other}
                                      : byte < 20 ? "a "
                                                  : "a damaged saved game: its checksum is ";
        EXPECT_NE(fault.find(said), std::string::npos) << fault;
    }
}

TEST(SavedFile, NamesTheOtherFormat) {
    std::string bytes = shelled(kContent);
    for (const int format : {1, 2, 3, 4}) {
        bytes[8] = static_cast<char>(format);
        EXPECT_EQ(fault_of(bytes),
                  "one.save: a saved game of format " + std::to_string(format) +
                      "; this program reads format " + std::to_string(kSavedFormat));
    }
}

// The page said 5 when it was 7.
TEST(SavedFile, TheirPageNamesTheFormat) {
    std::ifstream page(std::string(PL_SOURCE_DIR) + "/docs/SAVED-GAMES.md");
    const std::string text{std::istreambuf_iterator<char>(page), {}};
    EXPECT_NE(text.find("format, now " + std::to_string(kSavedFormat) + " |"), std::string::npos);
}

}  // namespace
}  // namespace plumbline
