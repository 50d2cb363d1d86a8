// Numbered slots that are used, given back and used again: what SlotMap and ecs::Registry are built on.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

namespace plumbline {

/// A Slot has `generation`, `used()`, and `reusable()` for one that may be given out again. The slot
/// freed last is given out first, so the same history gives the same numbers.
template <class Slot>
class SlotList {
public:
    std::uint32_t size() const { return static_cast<std::uint32_t>(slots_.size()); }
    Slot& operator[](std::uint32_t index) { return slots_[index]; }
    const Slot& operator[](std::uint32_t index) const { return slots_[index]; }

    /// A slot that nobody uses, made where there is none.
    std::uint32_t take() {
        if (free_.empty()) {
            free_.push_back(size());
            slots_.push_back({});
        }
        const std::uint32_t index = free_.back();
        free_.pop_back();
        return index;
    }
    void give_back(std::uint32_t index) { free_.push_back(index); }

    /// The next take() gives this slot. False where it is used, and for numbers that no history gives.
    bool reserve(std::uint32_t index) {
        constexpr std::uint32_t kMost = 1U << 22U;
        if (index >= kMost) return false;
        while (size() <= index) {
            free_.push_back(size());
            slots_.push_back({});
        }
        if (slots_[index].used()) return false;
        std::erase(free_, index);
        free_.push_back(index);
        return true;
    }

    /// Generations and what is given out next, as fields of an archive. The used ones must be the same
    /// on both sides; `fault` is what is said where they are not.
    template <class Archive>
    void serialize(Archive& archive, std::string_view fault) {
        std::vector<std::uint32_t> generations;
        for (const Slot& slot : slots_) generations.push_back(slot.generation);
        archive(generations, free_);
        if (!archive.reads() || archive.failed()) return;
        while (slots_.size() > generations.size() && !slots_.back().used()) slots_.pop_back();
        slots_.resize(std::max(generations.size(), slots_.size()));
        for (std::uint32_t i = 0; i < size(); ++i) {
            const bool same = i < generations.size() &&
                              (!slots_[i].used() || slots_[i].generation == generations[i]);
            if (!archive.expect(same, fault)) return;
            slots_[i].generation = generations[i];
        }
        if (!archive.expect(free_are_sound(), fault)) free_.clear();
    }

private:
    /// Each slot that may be given out is listed, once.
    bool free_are_sound() const {
        std::vector<bool> listed(slots_.size());
        for (const std::uint32_t index : free_) {
            if (index >= size() || listed[index] || !slots_[index].reusable()) return false;
            listed[index] = true;
        }
        return std::cmp_equal(free_.size(), std::ranges::count_if(slots_, &Slot::reusable));
    }

    std::vector<Slot> slots_;
    std::vector<std::uint32_t> free_;
};

}  // namespace plumbline
