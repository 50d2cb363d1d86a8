#include "engine/core/slot_map.h"

#include "engine/core/id.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace plumbline {
namespace {

using ThingId = Id<struct ThingTag>;
using Things = SlotMap<ThingId, std::string>;

TEST(SlotMap, NamesWhatItOwns) {
    Things things;
    const ThingId a = things.insert("a");
    const ThingId b = things.insert("b");
    EXPECT_TRUE(a);
    EXPECT_NE(a, b);
    EXPECT_EQ(things.get(a), "a");
    EXPECT_EQ(*things.find(b), "b");
    EXPECT_EQ(things.size(), 2U);
}

TEST(SlotMap, NullAndForeignIdsFindNothing) {
    Things things;
    things.insert("a");
    EXPECT_FALSE(ThingId{});
    EXPECT_FALSE(things.contains({}));
    EXPECT_FALSE(things.contains({.index = 9, .generation = 1}));
    EXPECT_EQ(things.find({.index = 0, .generation = 2}), nullptr);
}

TEST(SlotMap, ErasedIdsStayStaleWhenTheirSlotIsReused) {
    Things things;
    const ThingId old = things.insert("old");
    things.erase(old);
    things.erase(old);
    EXPECT_EQ(things.size(), 0U);
    EXPECT_FALSE(things.contains(old));
    const ThingId young = things.insert("young");
    EXPECT_EQ(young.index, old.index);
    EXPECT_FALSE(things.contains(old));
    things.erase(old);
    EXPECT_EQ(things.get(young), "young");
}

TEST(SlotMap, ValuesGoWhenTheyAreErased) {
    SlotMap<ThingId, std::shared_ptr<int>> things;
    const auto shared = std::make_shared<int>(1);
    const ThingId id = things.insert(shared);
    EXPECT_EQ(shared.use_count(), 2);
    things.erase(id);
    EXPECT_EQ(shared.use_count(), 1);
}

TEST(SlotMap, WalksInIndexOrderAndTheSameHistoryGivesTheSameIds) {
    const auto history = [](Things& things) {
        std::vector<ThingId> ids;
        for (const char* name : {"a", "b", "c", "d"}) ids.push_back(things.insert(name));
        things.erase(ids[1]);
        things.erase(ids[2]);
        ids.push_back(things.insert("e"));  // into c's slot, freed last
        return ids;
    };
    Things once;
    Things again;
    EXPECT_EQ(history(once), history(again));
    std::string order;
    once.each([&](ThingId id, const std::string& name) {
        EXPECT_EQ(once.get(id), name);
        order += name;
    });
    EXPECT_EQ(order, "aed");
}

TEST(SlotMap, KindsOfIdsAreKindsOfTypes) {
    static_assert(!std::is_convertible_v<ThingId, Id<struct OtherTag>>);
}

TEST(SlotMapDeathTest, StaleIdsAreOurMistake) {
    Things things;
    const ThingId id = things.insert("a");
    things.erase(id);
    EXPECT_DEATH(things.get(id), "an id that is alive");
}

}  // namespace
}  // namespace plumbline
