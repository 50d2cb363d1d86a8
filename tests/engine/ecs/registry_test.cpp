#include "engine/ecs/registry.h"

#include "engine/core/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace plumbline::ecs {
namespace {

struct Place {
    float x{0.0F};
    float y{0.0F};
};
struct Label {
    std::string text;
};
struct Heavy {
    int mass_kg{0};
};

/// Places of a view, in the order in which it gives them.
std::vector<float> xs_of(const View<const Place>& view) {
    std::vector<float> xs;
    for (auto [entity, place] : view) xs.push_back(place.x);
    return xs;
}

TEST(Registry, NullAndUnknownEntitiesAreNotAlive) {
    Registry registry;
    EXPECT_FALSE(registry.alive(Entity{}));
    EXPECT_FALSE(registry.alive(Entity{.index = 7, .generation = 1}));
    const Entity entity = registry.create();
    EXPECT_TRUE(entity);
    EXPECT_TRUE(registry.alive(entity));
    EXPECT_FALSE(registry.alive(Entity{.index = entity.index, .generation = 0}));
}

TEST(Registry, ReusesTheIndexWithANewGeneration) {
    Registry registry;
    const Entity first = registry.create();
    registry.destroy(first);
    const Entity second = registry.create();
    EXPECT_EQ(first.index, second.index);
    EXPECT_NE(first.generation, second.generation);
    EXPECT_FALSE(registry.alive(first));
    EXPECT_TRUE(registry.alive(second));
}

TEST(Registry, NameOfAFreeSlotIsNotAlive) {
    Registry registry;
    const Entity first = registry.create();
    registry.destroy(first);
    EXPECT_FALSE(registry.alive({.index = first.index, .generation = first.generation + 1}));
}

TEST(Registry, StaleNamesReachNothing) {
    Registry registry;
    const Entity stale = registry.create();
    registry.destroy(stale);
    const Entity heir = registry.create();
    registry.add<Place>(heir, 1.0F, 2.0F);

    EXPECT_EQ(registry.find<Place>(stale), nullptr);
    EXPECT_FALSE(registry.has<Place>(stale));
    registry.remove<Place>(stale);
    registry.mark_for_destruction(stale);
    registry.destroy_marked();
    registry.destroy(stale);

    EXPECT_TRUE(registry.alive(heir));
    EXPECT_EQ(registry.get<Place>(heir).y, 2.0F);
    EXPECT_EQ(registry.alive_count(), 1U);
}

TEST(Registry, AddsFindsAndRemovesComponents) {
    Registry registry;
    const Entity entity = registry.create();
    EXPECT_EQ(registry.find<Label>(entity), nullptr);
    registry.add<Label>(entity, "post");
    registry.add<Place>(entity, Place{.x = 3.0F});
    EXPECT_TRUE((registry.has<Label, Place>(entity)));
    EXPECT_FALSE((registry.has<Label, Heavy>(entity)));
    EXPECT_EQ(registry.get<Label>(entity).text, "post");
    registry.remove<Label>(entity);
    EXPECT_FALSE(registry.has<Label>(entity));
    EXPECT_EQ(registry.get<Place>(entity).x, 3.0F);
    registry.add<Label>(entity, "again");
    EXPECT_EQ(registry.get<Label>(entity).text, "again");
}

TEST(Registry, RemovalMovesTheLastValueAndKeepsOwnersRight) {
    Registry registry;
    std::vector<Entity> entities;
    for (int i = 0; i < 4; ++i) {
        entities.push_back(registry.create());
        registry.add<Heavy>(entities.back(), i);
    }
    registry.remove<Heavy>(entities[1]);
    std::vector<int> masses;
    registry.view<const Heavy>().each([&](Entity entity, const Heavy& heavy) {
        EXPECT_EQ(entity, entities[static_cast<std::size_t>(heavy.mass_kg)]);
        masses.push_back(heavy.mass_kg);
    });
    EXPECT_EQ(masses, (std::vector<int>{0, 3, 2}));
}

TEST(Registry, ViewOverATypeNobodyHasIsEmpty) {
    Registry registry;
    registry.add<Place>(registry.create());
    EXPECT_EQ((registry.view<Place, const Label>().count()), 0U);
}

TEST(Registry, ViewGivesOnlyEntitiesWithAllComponents) {
    Registry registry;
    for (int i = 0; i < 10; ++i) {
        const Entity entity = registry.create();
        registry.add<Place>(entity, static_cast<float>(i), 0.0F);
        if (i % 3 == 0) registry.add<Heavy>(entity, i);
    }
    for (auto [entity, place, heavy] : registry.view<Place, const Heavy>()) {
        place.y = static_cast<float>(heavy.mass_kg);
    }
    std::vector<float> ys;
    for (auto [entity, place] : registry.view<const Place>()) ys.push_back(place.y);
    EXPECT_EQ(ys, (std::vector<float>{0, 0, 0, 3, 0, 0, 6, 0, 0, 9}));
}

TEST(Registry, SmallestPoolLeads) {
    Registry registry;
    const Entity first = registry.create();
    const Entity second = registry.create();
    const Entity third = registry.create();
    for (const Entity entity : {first, second, third}) registry.add<Place>(entity);
    registry.add<Heavy>(third);
    registry.add<Heavy>(first);
    // The order is that of Heavy's pool, whichever type is named first.
    std::vector<Entity> place_first;
    for (auto [entity, place, heavy] : registry.view<Place, Heavy>()) place_first.push_back(entity);
    std::vector<Entity> heavy_first;
    for (auto [entity, heavy, place] : registry.view<Heavy, Place>()) heavy_first.push_back(entity);
    EXPECT_EQ(place_first, (std::vector<Entity>{third, first}));
    EXPECT_EQ(heavy_first, place_first);
}

TEST(Registry, ConstGivesConst) {
    using FromConst = decltype(std::declval<const Registry&>().view<Place>());
    static_assert(std::is_same_v<FromConst, View<const Place>>);
    static_assert(
        std::is_same_v<View<const Place, Label>::Row, std::tuple<Entity, const Place&, Label&>>);
    static_assert(std::is_same_v<decltype(std::declval<const Registry&>().get<Place>(Entity{})),
                                 const Place&>);
    static_assert(std::is_same_v<decltype(std::declval<const Registry&>().find<Place>(Entity{})),
                                 const Place*>);
    static_assert(!std::is_copy_constructible_v<Registry>);
    static_assert(!std::is_move_constructible_v<Registry>);
    static_assert(!Component<Place&>);
    static_assert(!Component<void>);
}

TEST(Registry, EntitiesDieByMarkWhileAViewIsWalked) {
    Registry registry;
    for (int i = 0; i < 6; ++i) registry.add<Place>(registry.create(), static_cast<float>(i), 0.0F);
    for (auto [entity, place] : registry.view<const Place>()) {
        if (place.x > 1.5F && place.x < 4.5F) {
            registry.mark_for_destruction(entity);
            registry.mark_for_destruction(entity);  // twice is once
        }
    }
    EXPECT_EQ(registry.alive_count(), 6U);
    registry.destroy_marked();
    EXPECT_EQ(registry.alive_count(), 3U);
    EXPECT_EQ(xs_of(registry.view<const Place>()), (std::vector<float>{0, 1, 5}));
    registry.destroy_marked();
    EXPECT_EQ(registry.alive_count(), 3U);
}

TEST(Registry, OtherTypesMayComeWhileAViewIsWalked) {
    Registry registry;
    for (int i = 0; i < 3; ++i) registry.add<Place>(registry.create());
    for (auto [entity, place] : registry.view<const Place>()) {
        registry.add<Heavy>(entity, 5);
        registry.create();
    }
    EXPECT_EQ(registry.alive_count(), 6U);
    EXPECT_EQ(registry.view<const Heavy>().count(), 3U);
}

TEST(Registry, LocksEndWithTheirView) {
    Registry registry;
    const Entity entity = registry.create();
    registry.add<Place>(entity);
    {
        const auto outer = registry.view<Place>();
        { const auto inner = registry.view<const Place>(); }
        EXPECT_EQ(xs_of(registry.view<const Place>()).size(), 1U);
    }
    registry.remove<Place>(entity);
    EXPECT_FALSE(registry.has<Place>(entity));
}

TEST(RegistryDeathTest, AViewLocksItsPools) {
    Registry registry;
    const Entity with = registry.create();
    const Entity without = registry.create();
    registry.add<Place>(with);
    const auto view = registry.view<const Place>();
    EXPECT_DEATH(registry.add<Place>(without), "no add or remove of a type while a view");
    EXPECT_DEATH(registry.remove<Place>(with), "no add or remove of a type while a view");
    EXPECT_DEATH(registry.destroy(with), "no add or remove of a type while a view");
    registry.destroy(without);  // has nothing that is locked
    EXPECT_EQ(registry.alive_count(), 1U);
}

TEST(RegistryDeathTest, MisuseIsNamed) {
    Registry registry;
    const Entity entity = registry.create();
    EXPECT_DEATH(registry.get<Place>(entity), "a component that the entity has");
    registry.add<Place>(entity);
    EXPECT_DEATH(registry.add<Place>(entity), "a component that the entity does not have yet");
    EXPECT_DEATH(registry.add<Place>(Entity{}), "an entity that is alive");
    registry.on_remove<Heavy>([](Entity, Heavy&) {});
    EXPECT_DEATH(registry.on_remove<Heavy>([](Entity, Heavy&) {}), "one listener a type");
}

TEST(Registry, ListenerHearsEachComponentOnceByRemoveDestroyAndEnd) {
    std::vector<std::string> heard;
    {
        Registry registry;
        registry.on_remove<Label>([&](Entity entity, Label& label) {
            EXPECT_TRUE(registry.alive(entity));
            EXPECT_EQ(registry.find<Label>(entity), &label);
            heard.push_back(label.text);
        });
        const Entity removed = registry.create();
        const Entity destroyed = registry.create();
        const Entity left = registry.create();
        registry.add<Label>(removed, "removed");
        registry.add<Label>(destroyed, "destroyed");
        registry.add<Label>(left, "left at the end");
        registry.add<Place>(left);
        registry.remove<Label>(removed);
        registry.remove<Label>(removed);
        EXPECT_EQ(heard, (std::vector<std::string>{"removed"}));
        registry.mark_for_destruction(destroyed);
        registry.destroy_marked();
        EXPECT_EQ(heard, (std::vector<std::string>{"removed", "destroyed"}));
        registry.destroy(removed);
        EXPECT_EQ(heard.size(), 2U);
    }
    EXPECT_EQ(heard, (std::vector<std::string>{"removed", "destroyed", "left at the end"}));
}

TEST(Registry, EndGoesLowestIndexFirst) {
    std::vector<std::uint32_t> order;
    {
        Registry registry;
        registry.on_remove<Heavy>([&](Entity entity, Heavy&) { order.push_back(entity.index); });
        std::vector<Entity> entities;
        for (int i = 0; i < 4; ++i) entities.push_back(registry.create());
        for (const std::size_t i : {2U, 0U, 3U, 1U}) registry.add<Heavy>(entities[i]);
    }
    EXPECT_EQ(order, (std::vector<std::uint32_t>{0, 1, 2, 3}));
}

TEST(Registry, ListenerMayMarkOthers) {
    Registry registry;
    const Entity parent = registry.create();
    const Entity child = registry.create();
    registry.add<Label>(parent, "parent");
    registry.on_remove<Label>([&](Entity, Label&) { registry.mark_for_destruction(child); });
    registry.mark_for_destruction(parent);
    registry.destroy_marked();
    EXPECT_EQ(registry.alive_count(), 0U);
}

/// Some thousand operations chosen by `seed`; the returned text holds every order a view gives.
std::string history(std::uint64_t seed) {
    Registry registry;
    Random random(seed);
    std::vector<Entity> entities;
    std::string orders;
    for (int i = 0; i < 3'000; ++i) {
        const std::uint32_t choice = random.below(8);
        if (choice < 3 || entities.empty()) {
            entities.push_back(registry.create());
            registry.add<Heavy>(entities.back(), i);
            continue;
        }
        const std::size_t chosen = random.below(static_cast<std::uint32_t>(entities.size()));
        if (choice < 5) {
            registry.destroy(entities[chosen]);
            entities.erase(entities.begin() + static_cast<std::ptrdiff_t>(chosen));
        } else if (registry.has<Place>(entities[chosen])) {
            registry.remove<Place>(entities[chosen]);
        } else {
            registry.add<Place>(entities[chosen]);
        }
        if (i % 500 != 499) continue;
        for (auto [entity, heavy, place] : registry.view<const Heavy, const Place>()) {
            orders += std::to_string(entity.index) + "." + std::to_string(entity.generation) + " ";
        }
    }
    return orders;
}

TEST(Registry, IdenticalHistoriesGiveIdenticalOrders) {
    const std::string once = history(1);
    EXPECT_GT(once.size(), 1'000U);
    EXPECT_EQ(once, history(1));
    EXPECT_NE(once, history(2));
}

TEST(Registry, AgreesWithAMapOver100000Operations) {
    struct Known {
        std::optional<int> mass_kg{};
        std::optional<std::string> label{};
    };
    Registry registry;
    std::map<Entity, Known> model;
    std::vector<Entity> ever;
    Random random(20);
    const auto pick = [&] { return ever[random.below(static_cast<std::uint32_t>(ever.size()))]; };
    for (int i = 0; i < 100'000; ++i) {
        const std::uint32_t choice = random.below(10);
        if (choice < 2 || ever.empty()) {
            const Entity made = registry.create();
            ASSERT_TRUE(model.emplace(made, Known{}).second) << "a name was given twice";
            ever.push_back(made);
            continue;
        }
        const Entity entity = pick();
        const auto known = model.find(entity);
        ASSERT_EQ(registry.alive(entity), known != model.end());
        if (choice < 4) {
            registry.destroy(entity);
            if (known != model.end()) model.erase(known);
        } else if (known == model.end()) {
            ASSERT_EQ(registry.find<Heavy>(entity), nullptr);
        } else if (choice < 7) {
            ASSERT_EQ(registry.has<Heavy>(entity), known->second.mass_kg.has_value());
            if (known->second.mass_kg) {
                ASSERT_EQ(registry.get<Heavy>(entity).mass_kg, *known->second.mass_kg);
                registry.remove<Heavy>(entity);
                known->second.mass_kg.reset();
            } else {
                registry.add<Heavy>(entity, i);
                known->second.mass_kg = i;
            }
        } else if (!known->second.label) {
            registry.add<Label>(entity, std::to_string(i));
            known->second.label = std::to_string(i);
        } else {
            ASSERT_EQ(registry.get<Label>(entity).text, *known->second.label);
        }
    }
    EXPECT_EQ(registry.alive_count(), model.size());
    std::size_t both = 0;
    for (auto [entity, heavy, label] : registry.view<const Heavy, const Label>()) {
        ++both;
        ASSERT_EQ(heavy.mass_kg, model.at(entity).mass_kg);
        ASSERT_EQ(label.text, model.at(entity).label);
    }
    const auto has_both = [](const auto& row) { return row.second.mass_kg && row.second.label; };
    EXPECT_EQ(both, static_cast<std::size_t>(std::ranges::count_if(model, has_both)));
}

}  // namespace
}  // namespace plumbline::ecs
