// Values behind ids.
#pragma once

#include "engine/core/assert.h"
#include "engine/core/slot_list.h"

#include <cstdint>
#include <optional>
#include <utility>

namespace plumbline {

/// Owns values of T and names each by an id that goes stale when the value is erased.
/// The slot freed last is reused first, so the same history gives the same ids.
template <class IdType, class T>
class SlotMap {
public:
    IdType insert(T value) {
        const std::uint32_t index = slots_.take();
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
        slots_.give_back(id.index);
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
        if (id.generation == 0 || !slots_.reserve(id.index)) return false;
        slots_[id.index].generation = id.generation - 1;
        return true;
    }

    /// Which ids come next, as fields of an archive. Those alive must be the same on both sides.
    template <class Archive>
    void serialize_slots(Archive& archive) {
        slots_.serialize(archive, "its ids are others");
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

        bool used() const { return value.has_value(); }
        bool reusable() const { return !used(); }
    };
    SlotList<Slot> slots_;
    std::size_t size_{0};
};

}  // namespace plumbline
