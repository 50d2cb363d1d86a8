// Entities and their components: the whole store on one page (a sparse set per component type;
// Briggs and Torczon 1993, "An Efficient Representation for Sparse Sets").
//
// A component type needs no registration: its pool appears with its first add. A pool is a dense
// array of values, a parallel array of owners and a sparse index; removal moves the last value into
// the hole. References are good until the next add or remove of that type: keep the Entity.
//
// A view walks the smallest pool it names and tests the others. While it lives those pools are
// locked: adding or removing their types asserts. Other types, and mark_for_destruction(), are free.
//
// Order is the order of addition as removals changed it: no hashing, no addresses. The same history
// gives the same order, and so the same replay. Not thread-safe, not even for two readers.
#pragma once

#include "engine/core/assert.h"
#include "engine/core/slot_list.h"
#include "engine/ecs/component_pool.h"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace plumbline::ecs {

/// The entities that have all of Ts, with those components:
/// `for (auto [entity, pose, body] : registry.view<Pose, const BodyRef>())`.
/// Handed on by value or reference, never stored: it locks its pools while it lives.
template <Component... Ts>
class View {
    static_assert(sizeof...(Ts) > 0, "a view names at least one component");

public:
    using Row = std::tuple<Entity, Ts&...>;
    struct End {};

    class Iterator {
    public:
        explicit Iterator(const View& view) : view_(&view) { skip_to_match(); }

        Row operator*() const { return view_->row((*view_->leading_)[next_]); }
        Iterator& operator++() {
            ++next_;
            skip_to_match();
            return *this;
        }
        bool operator==(End) const { return next_ == view_->walk_length(); }

    private:
        void skip_to_match() {
            while (next_ < view_->walk_length() && !view_->contains((*view_->leading_)[next_])) {
                ++next_;
            }
        }

        const View* view_;
        std::size_t next_{0};
    };

    ~View() {
        const auto unlock = [](const auto* pool) {
            if (pool != nullptr) pool->unlock();
        };
        std::apply([&](const auto*... pool) { (unlock(pool), ...); }, pools_);
    }
    View(const View&) = delete;
    View& operator=(const View&) = delete;

    Iterator begin() const { return Iterator(*this); }
    End end() const { return {}; }

    /// Calls fn(entity, component&...) for each match.
    template <class Fn>
    requires std::invocable<Fn&, Entity, Ts&...>
    void each(Fn&& fn) const {
        for (const Row& row : *this) std::apply(fn, row);
    }

    /// How many match; walks to know.
    std::size_t count() const {
        std::size_t found = 0;
        each([&](Entity, Ts&...) { ++found; });
        return found;
    }

    /// True when the entity has all the components; row() then gives them.
    bool contains(Entity entity) const {
        return std::apply(
            [&](const auto*... pool) {
                return ((pool != nullptr && pool->contains(entity)) && ...);
            },
            pools_);
    }
    Row row(Entity entity) const {
        return std::apply([&](auto*... pool) { return Row{entity, pool->get(entity)...}; }, pools_);
    }

private:
    friend class Registry;

    /// A null pool stands for a type that nobody has: the view is then empty.
    explicit View(detail::PoolOf<Ts>*... pools) : pools_(pools...) {
        const bool all_there = ((pools != nullptr) && ...);
        const auto take = [&](const detail::AnyPool* pool) {
            if (pool == nullptr) return;
            pool->lock();
            if (!all_there) return;
            if (leading_ == nullptr || pool->owners().size() < leading_->size()) {
                leading_ = &pool->owners();
            }
        };
        (take(pools), ...);
    }

    std::size_t walk_length() const { return leading_ == nullptr ? 0 : leading_->size(); }

    std::tuple<detail::PoolOf<Ts>*...> pools_;
    const std::vector<Entity>* leading_{nullptr};  ///< owners in the smallest pool
};

/// Stays where it was made: views and listeners point into it.
class Registry {
public:
    Registry() = default;
    /// Destroys every entity, lowest index first: the listeners hear of each component.
    ~Registry() {
        for (std::uint32_t index = 0; index < slots_.size(); ++index) {
            if (slots_[index].alive) destroy({index, slots_[index].generation});
        }
    }
    Registry(const Registry&) = delete;
    Registry& operator=(const Registry&) = delete;

    Entity create() {
        const std::uint32_t index = slots_.take();
        slots_[index].alive = true;
        ++alive_count_;
        return {index, slots_[index].generation};
    }

    /// Removes its components in the order in which their types were first used here, then the
    /// entity. Stale names are ignored.
    void destroy(Entity entity) {
        if (!alive(entity)) return;
        for (std::size_t i = 0; i < pools_.size(); ++i) pools_[i]->remove(entity);
        Slot& slot = slots_[entity.index];
        slot.alive = false;
        --alive_count_;
        ++slot.generation;
        if (slot.reusable()) slots_.give_back(entity.index);
    }

    /// The way to die while a view is walked: destroy_marked() does it. Once marked, it stays so.
    void mark_for_destruction(Entity entity) {
        if (alive(entity)) marked_.push_back(entity);
    }

    /// Destroys what was marked, in that order, and what listeners mark meanwhile. Once a step.
    void destroy_marked() {
        for (std::size_t i = 0; i < marked_.size(); ++i) destroy(marked_[i]);
        marked_.clear();
    }

    bool alive(Entity entity) const {
        return entity.index < slots_.size() && slots_[entity.index].alive &&
               slots_[entity.index].generation == entity.generation;
    }
    std::size_t alive_count() const { return alive_count_; }

    /// The next create() gives this name, the first of those that nobody has. False where somebody has
    /// its place, and for places that no history gives.
    bool reserve(Entity entity) {
        if (!entity || !slots_.reserve(entity.index)) return false;
        slots_[entity.index].generation = entity.generation;
        return true;
    }

    /// Which names come next, as fields of an archive. Those alive must be the same on both sides.
    template <class Archive>
    void serialize_slots(Archive& archive) {
        slots_.serialize(archive, "its entities are others");
    }

    /// The order in which views meet those that have a T. They must be the same on both sides.
    template <Component T, class Archive>
    void serialize_order(Archive& archive) {
        auto* pool = pool_of<T>();
        std::vector<Entity> owners = pool != nullptr ? pool->owners() : std::vector<Entity>();
        archive(owners);
        if (!archive.reads() || archive.failed() || (pool == nullptr && owners.empty())) return;
        const bool same = pool != nullptr && pool->put_in_order(owners);
        archive.expect(same, "its entities are others");
    }

    /// T{args...}. Asserts that the entity lives and has no T.
    template <Component T, class... Args>
    T& add(Entity entity, Args&&... args) {
        PL_ASSERT(alive(entity), "an entity that is alive");
        return pool_made<T>().add(entity, std::forward<Args>(args)...);
    }

    /// Ignores entities without a T.
    template <Component T>
    void remove(Entity entity) {
        if (auto* pool = pool_of<T>()) pool->remove(entity);
    }

    /// Asserts that the entity has a T.
    template <Component T>
    T& get(Entity entity) {
        T* found = find<T>(entity);
        PL_ASSERT(found != nullptr, "a component that the entity has");
        return *found;
    }
    template <Component T>
    const T& get(Entity entity) const {
        const T* found = find<T>(entity);
        PL_ASSERT(found != nullptr, "a component that the entity has");
        return *found;
    }

    /// Null when the entity has no T or is no longer alive.
    template <Component T>
    T* find(Entity entity) {
        auto* pool = pool_of<T>();
        return pool == nullptr ? nullptr : pool->find(entity);
    }
    template <Component T>
    const T* find(Entity entity) const {
        const auto* pool = pool_of<T>();
        return pool == nullptr ? nullptr : pool->find(entity);
    }

    /// True when the entity has all of Ts.
    template <Component... Ts>
    bool has(Entity entity) const {
        return ((find<Ts>(entity) != nullptr) && ...);
    }

    template <Component... Ts>
    View<Ts...> view() {
        return View<Ts...>(pool_of<std::remove_const_t<Ts>>()...);
    }
    template <Component... Ts>
    View<const Ts...> view() const {
        return View<const Ts...>(pool_of<std::remove_const_t<Ts>>()...);
    }

    /// For components that hold the id of something outside: whoever owns that something sets the
    /// one listener of the type and lets go of it there. Called once for each component, just
    /// before it goes: by remove(), by destroy() and at the registry's own end. The entity is still
    /// alive then. The listener must not add components to it nor remove a T, and must know when
    /// what it reaches for is gone.
    template <Component T>
    void on_remove(std::function<void(Entity, T&)> listener) {
        auto& pool = pool_made<T>();
        PL_ASSERT(!pool.on_remove, "one listener a type");
        pool.on_remove = std::move(listener);
    }

private:
    struct Slot {
        std::uint32_t generation{1};
        bool alive{false};

        bool used() const { return alive; }
        /// Where generations are used up it is not, so that no stale name comes alive.
        bool reusable() const { return !alive && generation != 0; }
    };
    static constexpr std::size_t kNoPool = std::numeric_limits<std::size_t>::max();

    template <Component T>
    const detail::Pool<T>* pool_of() const {
        const std::size_t type = detail::type_index<T>();
        if (type >= pool_from_type_.size() || pool_from_type_[type] == kNoPool) return nullptr;
        return static_cast<const detail::Pool<T>*>(pools_[pool_from_type_[type]].get());
    }
    template <Component T>
    detail::Pool<T>* pool_of() {
        return const_cast<detail::Pool<T>*>(std::as_const(*this).template pool_of<T>());
    }

    template <Component T>
    detail::Pool<T>& pool_made() {
        if (auto* pool = pool_of<T>()) return *pool;
        const std::size_t type = detail::type_index<T>();
        pool_from_type_.resize(std::max(pool_from_type_.size(), type + 1), kNoPool);
        pool_from_type_[type] = pools_.size();
        pools_.push_back(std::make_unique<detail::Pool<T>>());
        return *pool_of<T>();
    }

    SlotList<Slot> slots_;
    std::vector<Entity> marked_;
    std::size_t alive_count_{0};
    /// In the order of first use here. Type indices depend on what else the process has done, so
    /// nothing is ever walked in their order.
    std::vector<std::unique_ptr<detail::AnyPool>> pools_;
    std::vector<std::size_t> pool_from_type_;
};

}  // namespace plumbline::ecs
