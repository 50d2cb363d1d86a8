#include "engine/core/io/pose_archive.h"
#include "engine/core/slot_map.h"

#include <gtest/gtest.h>

#include <limits>

namespace plumbline {
namespace {

struct Tag;
using Number = Id<Tag>;
enum class Kind : std::uint8_t { One, Two };
constexpr Kind last_of(Kind) {
    return Kind::Two;
}

struct Everything {
    bool yes{true};
    std::int32_t whole{-7};
    std::uint64_t large{0x0123456789abcdefULL};
    float single{0.1F};
    double twice{1.0 / 3.0};
    Kind kind{Kind::Two};
    std::string text{"a\0b", 3};
    Vec3 place{1, -2, 3};
    Quat turn{0.5_r, 0.5_r, -0.5_r, 0.5_r};
    std::optional<Vec3> maybe{Vec3{4, 5, 6}};
    std::optional<Vec3> none{};
    std::vector<Number> ids{{1, 2}, {3, 4}};
    std::map<std::string, double, std::less<>> named{{"x", 1.5}, {"y", -0.0}};
    std::set<std::uint64_t> keys{9, 3};

    void serialize(Archive& archive) {
        archive(yes, whole, large, single, twice, kind, text, place, turn);
        archive(maybe, none, ids, named, keys);
    }
};

Everything changed() {
    Everything other{.yes = false, .whole = 0, .large = 0, .single = 0, .twice = 0};
    other.kind = Kind::One;
    other.text.clear();
    other.place = {};
    other.maybe.reset();
    other.none = Vec3{1, 1, 1};
    other.ids.clear();
    other.named.clear();
    other.keys.clear();
    return other;
}

TEST(Archive, ReadsBackWhatItWroteFieldByField) {
    Everything written;
    Archive out;
    out(written);
    Everything read = changed();
    Archive in(out.written());
    in(read);
    EXPECT_FALSE(in.failed()) << in.fault();
    EXPECT_EQ(in.left(), 0U);
    EXPECT_TRUE(read.yes);
    EXPECT_EQ(read.whole, -7);
    EXPECT_EQ(read.large, written.large);
    EXPECT_EQ(read.single, 0.1F);
    EXPECT_EQ(read.twice, 1.0 / 3.0);
    EXPECT_EQ(read.kind, Kind::Two);
    EXPECT_EQ(read.text, written.text);
    EXPECT_EQ(read.place, written.place);
    EXPECT_EQ(read.turn, written.turn);
    EXPECT_EQ(read.maybe, written.maybe);
    EXPECT_EQ(read.none, std::nullopt);
    EXPECT_EQ(read.ids, written.ids);
    EXPECT_EQ(read.named, written.named);
    EXPECT_TRUE(std::signbit(read.named["y"]));
    EXPECT_EQ(read.keys, written.keys);
}

TEST(Archive, LowestByteFirstAndNumbersOfEightBytes) {
    std::uint32_t whole = 0x01020304;
    float one = 1.0F;
    Archive out;
    out(whole, one);
    EXPECT_EQ(out.written(), std::string("\x04\x03\x02\x01\0\0\0\0\0\0\xf0\x3f", 12));
}

TEST(Archive, CutAnywhereItFailsAndReadsZeros) {
    Everything written;
    Archive out;
    out(written);
    for (std::size_t size = 0; size < out.written().size(); ++size) {
        Everything read = changed();
        Archive in(std::string_view(out.written()).substr(0, size));
        in(read);
        EXPECT_EQ(in.fault(), "its state ends early") << size;
    }
}

TEST(Archive, RefusesCountsThatCannotBe) {
    std::uint64_t count = std::numeric_limits<std::uint64_t>::max();
    Archive out;
    out(count);
    std::vector<double> values;
    Archive in(out.written());
    in(values);
    EXPECT_TRUE(in.failed());
    EXPECT_TRUE(values.empty());
}

TEST(Archive, SlotsHandOutTheSameIdsAfterwards) {
    SlotMap<Number, int> there;
    const Number first = there.insert(1);
    const Number second = there.insert(2);
    there.insert(3);
    there.erase(first);
    there.erase(second);
    const Number third = there.insert(4);  // second's place
    there.erase(third);
    const Number kept = there.insert(5);
    Archive out;
    there.serialize_slots(out);

    SlotMap<Number, int> here;
    here.insert(0);
    here.insert(0);
    here.insert(3);
    here.erase({0, 1});
    here.erase({1, 1});
    ASSERT_TRUE(here.reserve(kept));
    EXPECT_EQ(here.insert(5), kept);
    Archive in(out.written());
    here.serialize_slots(in);
    EXPECT_FALSE(in.failed()) << in.fault();
    for (int i = 0; i < 3; ++i) EXPECT_EQ(here.insert(i), there.insert(i));
    EXPECT_FALSE(here.reserve(kept));

    SlotMap<Number, int> others;
    others.insert(1);
    Archive again(out.written());
    others.serialize_slots(again);
    EXPECT_EQ(again.fault(), "its ids are others");
}

}  // namespace
}  // namespace plumbline
