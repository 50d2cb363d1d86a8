#include "engine/core/hash.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace plumbline {
namespace {

std::string hash_of(const std::string& bytes) {
    Hasher hasher;
    hasher.add(bytes.data(), bytes.size());
    return hex_of(hasher.digest());
}

// The value for no bytes and seed 0 in xxHash's own test vectors.
TEST(Hash, IsXxh3) {
    EXPECT_EQ(hash_of(""), "2d06800538d394c2");
}

TEST(Hash, DoesNotDependOnHowTheBytesArePortioned) {
    std::string bytes;
    for (int i = 0; i < 5'000; ++i) bytes.push_back(static_cast<char>(i * 7));
    Hasher portions;
    for (std::size_t at = 0, size = 1; at < bytes.size(); at += size, size = size % 300 + 7) {
        portions.add(bytes.data() + at, std::min(size, bytes.size() - at));
    }
    EXPECT_EQ(hex_of(portions.digest()), hash_of(bytes));
}

TEST(Hash, SeesEveryBitAndTheOrder) {
    EXPECT_NE(hash_of("ab"), hash_of("ba"));
    EXPECT_NE(hash_of(std::string("a\0", 2)), hash_of("a"));
    EXPECT_NE(hash_of("a"), hash_of("q")) << "one bit apart";
}

TEST(Hash, HexIsPadded) {
    EXPECT_EQ(hex_of(0xAB), "00000000000000ab");
}

}  // namespace
}  // namespace plumbline
