// --shard and --merge.
#include "game/command_line/shard_option.h"

#include "tests/support/temporary_folder.h"

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

namespace plumbline::game {
namespace {

class ShardOption : public testing::Test {
protected:
    ShardOption() {
        CLI::Option* out = app_.add_option("--out", out_);
        add_shard_options(app_, *out, shard_, merge_);
    }
    /// Empty, or what is wrong.
    std::string parse(std::vector<std::string> words) {
        std::reverse(words.begin(), words.end());
        try {
            app_.parse(words);
        } catch (const CLI::ParseError& error) {
            return error.what();
        }
        return {};
    }

    CLI::App app_;
    std::string out_;
    std::optional<study::Shard> shard_;
    std::vector<std::filesystem::path> merge_;
    test::TemporaryFolder folder_;
};

TEST_F(ShardOption, NamesAPartOfAWhole) {
    EXPECT_EQ(parse({"--out", "x", "--shard", "2/4"}), "");
    ASSERT_TRUE(shard_.has_value());
    EXPECT_EQ(shard_->index, 2);
    EXPECT_EQ(shard_->of, 4);
}

TEST_F(ShardOption, OtherWordsAreNoPart) {
    for (const char* bad : {"", "2", "0/4", "5/4", "-1/4", "1/0", "1/4/2", "a/b", "1/10001"}) {
        const std::string said = parse({"--out", "x", "--shard", bad});
        EXPECT_NE(said.find("expected I/N, for example 2/4 for the second of four parts"),
                  std::string::npos)
            << bad << ": " << said;
    }
}

TEST_F(ShardOption, BothNeedAPlaceToWriteAndOneExcludesTheOther) {
    EXPECT_NE(parse({"--shard", "1/2"}), "");
    EXPECT_NE(parse({"--merge", "a"}), "");
    EXPECT_NE(parse({"--out", "x", "--shard", "1/2", "--merge", "a"}), "");
    EXPECT_EQ(parse({"--out", "x", "--merge", "a", "b"}), "");
    EXPECT_EQ(merge_, (std::vector<std::filesystem::path>{"a", "b"}));
}

TEST_F(ShardOption, ReadsTheFileOfEveryFolderInTheirOrder) {
    folder_.write("a/table.csv", "one");
    folder_.write("b/table.csv", "two");
    const auto texts = read_shards({folder_ / "b", folder_ / "a"}, "table.csv");
    ASSERT_TRUE(texts.ok());
    EXPECT_EQ(*texts, (std::vector<std::string>{"two", "one"}));
    EXPECT_TRUE(read_shards({}, "table.csv")->empty());
    EXPECT_FALSE(read_shards({folder_ / "a", folder_ / "none"}, "table.csv").ok());
}

}  // namespace
}  // namespace plumbline::game
