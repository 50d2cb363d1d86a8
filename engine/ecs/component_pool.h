// Entities' names, and the sparse set of one component type. Behind registry.h, which is the page to read.
#pragma once

#include "engine/core/assert.h"

#include <atomic>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace plumbline::ecs {

/// Names an entity while it lives. Entity{} names none; a destroyed entity's name stays stale.
struct Entity {
    std::uint32_t index{0};
    std::uint32_t generation{0};  ///< 0 is never alive

    explicit operator bool() const { return generation != 0; }
    friend auto operator<=>(const Entity&, const Entity&) = default;

    void serialize(auto& archive) { archive(index, generation); }
};

/// An object type that moves without throwing. `const T` says: read only.
template <class T>
concept Component = std::is_object_v<T> && !std::is_array_v<T> &&
                    std::is_nothrow_move_constructible_v<std::remove_const_t<T>> &&
                    std::is_nothrow_move_assignable_v<std::remove_const_t<T>>;

namespace detail {

/// What the registry knows of a pool without knowing its type.
class AnyPool {
public:
    AnyPool() = default;
    virtual ~AnyPool() = default;
    AnyPool(const AnyPool&) = delete;
    AnyPool& operator=(const AnyPool&) = delete;

    /// Calls the listener, then removes. Ignores entities that are not in.
    virtual void remove(Entity entity) = 0;

    bool contains(Entity entity) const {
        return entity.index < dense_from_sparse_.size() &&
               dense_from_sparse_[entity.index] != kAbsent &&
               owners_[dense_from_sparse_[entity.index]] == entity;
    }
    const std::vector<Entity>& owners() const { return owners_; }

    void lock() const { ++locks_; }
    void unlock() const { --locks_; }

protected:
    static constexpr std::uint32_t kAbsent = std::numeric_limits<std::uint32_t>::max();

    void assert_unlocked() const {
        PL_ASSERT(locks_ == 0, "no add or remove of a type while a view or its listener uses it");
    }

    std::vector<Entity> owners_;
    std::vector<std::uint32_t> dense_from_sparse_;

private:
    mutable std::uint32_t locks_{0};
};

template <Component T>
class Pool final : public AnyPool {
public:
    std::function<void(Entity, T&)> on_remove;

    template <class... Args>
    T& add(Entity entity, Args&&... args) {
        assert_unlocked();
        PL_ASSERT(!contains(entity), "a component that the entity does not have yet");
        values_.push_back(T{std::forward<Args>(args)...});
        if (entity.index >= dense_from_sparse_.size()) {
            dense_from_sparse_.resize(entity.index + 1, kAbsent);
        }
        dense_from_sparse_[entity.index] = static_cast<std::uint32_t>(owners_.size());
        owners_.push_back(entity);
        return values_.back();
    }

    void remove(Entity entity) override {
        if (!contains(entity)) return;
        assert_unlocked();
        const std::uint32_t hole = dense_from_sparse_[entity.index];
        if (on_remove) {
            lock();
            on_remove(entity, values_[hole]);
            unlock();
        }
        const Entity last = owners_.back();
        if (last != entity) {
            values_[hole] = std::move(values_.back());
            owners_[hole] = last;
            dense_from_sparse_[last.index] = hole;
        }
        dense_from_sparse_[entity.index] = kAbsent;
        values_.pop_back();
        owners_.pop_back();
    }

    T& get(Entity entity) {
        PL_ASSERT(contains(entity), "a component that the entity has");
        return values_[dense_from_sparse_[entity.index]];
    }
    const T& get(Entity entity) const {
        PL_ASSERT(contains(entity), "a component that the entity has");
        return values_[dense_from_sparse_[entity.index]];
    }
    T* find(Entity entity) { return contains(entity) ? &get(entity) : nullptr; }
    const T* find(Entity entity) const { return contains(entity) ? &get(entity) : nullptr; }

    /// False, and nothing happens, unless the owners are those that there are.
    bool put_in_order(const std::vector<Entity>& owners) {
        std::vector<bool> met(owners_.size(), false);
        if (owners.size() != owners_.size()) return false;
        for (const Entity owner : owners) {
            if (!contains(owner) || met[dense_from_sparse_[owner.index]]) return false;
            met[dense_from_sparse_[owner.index]] = true;
        }
        assert_unlocked();
        std::vector<T> values;
        values.reserve(values_.size());
        for (const Entity owner : owners) values.push_back(std::move(get(owner)));
        values_ = std::move(values);
        owners_ = owners;
        for (std::uint32_t i = 0; i < owners_.size(); ++i) dense_from_sparse_[owners_[i].index] = i;
        return true;
    }

private:
    std::vector<T> values_;
};

/// A const component is read through a const pool, so that the compiler keeps the promise.
template <Component T>
using PoolOf = std::conditional_t<std::is_const_v<T>, const Pool<std::remove_const_t<T>>, Pool<T>>;

inline std::atomic<std::size_t> next_type_index{0};

template <class T>
std::size_t type_index() {
    static const std::size_t index = next_type_index++;
    return index;
}

}  // namespace detail

}  // namespace plumbline::ecs
