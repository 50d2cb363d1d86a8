#include "engine/core/text/source_location.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

TEST(SourceLocation, NamesTheFileWithoutItsFolderAndTheLine) {
    EXPECT_EQ(to_string(in_file("scenes/hard/H05.toml", 14)), "H05.toml:14");
    EXPECT_EQ(file_of(in_file("scenes/hard/H05.toml", 14)), "scenes/hard/H05.toml");
}

TEST(SourceLocation, OfNoFileIsEmpty) {
    EXPECT_EQ(file_of({}), "");
    EXPECT_EQ(to_string(SourceLocation{}), ":0");
}

TEST(SourceLocation, CopiesShareTheName) {
    const SourceLocation one = in_file("garden.toml", 3);
    const SourceLocation other = one;
    EXPECT_EQ(one.file.get(), other.file.get());
}

}  // namespace
}  // namespace plumbline
