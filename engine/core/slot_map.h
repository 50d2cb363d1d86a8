// Values behind ids.
#pragma once

#include "engine/core/assert.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace plumbline {

/// Owns values of T and names each by an id that goes stale when the value is erased.
/// The slot freed last is reused first, so the same history gives the same ids.
template <class IdType, class T>
class SlotMap {
public:
    IdType insert(T value) {
        std::uint32_t index = 0;
        if (free_.empty()) {
            index = static_cast<std::uint32_t>(slots_.size());
            slots_.push_back({});
        } else {
            index = free_.back();
            free_.pop_back();
        }
        Slot& slot = slots_[index];
        slot.value.emplace(std::move(value));
        ++slot.generation;
        ++size_;
        return IdType{index, slot.generation};
    }

    /// Stale ids are ignored.
    void erase(IdType id) {
        if (!contains(id)) return;
        slots_[id.index].value.reset();
        free_.push_back(id.index);
        --size_;
    }

    bool contains(IdType id) const {
        return id.generation != 0 && id.index < slots_.size() &&
               slots_[id.index].generation == id.generation && slots_[id.index].value.has_value();
    }

    T& get(IdType id) {
        PL_ASSERT(contains(id), "an id that is alive");
        return *slots_[id.index].value;
    }
    const T& get(IdType id) const {
        PL_ASSERT(contains(id), "an id that is alive");
        return *slots_[id.index].value;
    }
    T* find(IdType id) { return contains(id) ? &*slots_[id.index].value : nullptr; }
    const T* find(IdType id) const { return contains(id) ? &*slots_[id.index].value : nullptr; }

    std::size_t size() const { return size_; }

    /// The next insert() returns this id, the first of those that are not alive. False where one of
    /// its index is, and for indices that no history gives.
    bool reserve(IdType id) {
        constexpr std::uint32_t kMost = 1U << 22U;
        if (id.generation == 0 || id.index >= kMost) return false;
        while (slots_.size() <= id.index) {
            free_.push_back(static_cast<std::uint32_t>(slots_.size()));
            slots_.push_back({});
        }
        if (slots_[id.index].value) return false;
        std::erase(free_, id.index);
        free_.push_back(id.index);
        slots_[id.index].generation = id.generation - 1;
        return true;
    }

    /// Which ids come next, as fields of an archive. Those alive must be the same on both sides.
    template <class Archive>
    void serialize_slots(Archive& archive) {
        std::vector<std::uint32_t> generations;
        for (const Slot& slot : slots_) generations.push_back(slot.generation);
        archive(generations, free_);
        if (!archive.reads() || archive.failed()) return;
        while (slots_.size() > generations.size() && !slots_.back().value) slots_.pop_back();
        slots_.resize(std::max(generations.size(), slots_.size()));
        std::size_t empty = 0;
        for (std::size_t i = 0; i < slots_.size(); ++i) {
            const bool same = i < generations.size() &&
                              (!slots_[i].value || slots_[i].generation == generations[i]);
            if (!archive.expect(same, "its ids are others")) return;
            slots_[i].generation = generations[i];
            if (!slots_[i].value) ++empty;
        }
        const bool sound = free_.size() == empty && std::ranges::all_of(free_, [&](auto index) {
                               return index < slots_.size() && !slots_[index].value;
                           });
        if (!archive.expect(sound, "its ids are others")) free_.clear();
    }

    /// Calls fn(id, value) in index order.
    template <class Fn>
    void each(Fn&& fn) {
        for (std::uint32_t i = 0; i < slots_.size(); ++i) {
            if (slots_[i].value) fn(IdType{i, slots_[i].generation}, *slots_[i].value);
        }
    }
    template <class Fn>
    void each(Fn&& fn) const {
        for (std::uint32_t i = 0; i < slots_.size(); ++i) {
            if (slots_[i].value) fn(IdType{i, slots_[i].generation}, *slots_[i].value);
        }
    }

private:
    struct Slot {
        std::optional<T> value{};
        std::uint32_t generation{0};
    };
    std::vector<Slot> slots_;
    std::vector<std::uint32_t> free_;
    std::size_t size_{0};
};

}  // namespace plumbline
