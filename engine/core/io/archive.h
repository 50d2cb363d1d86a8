// Fields to bytes and back by one list of them: what saved games are written and read with.
//
//     void serialize(Archive& archive, Rest& rest) { archive(rest.position_m, rest.at_rest_s); }
//
// A type says its fields once, in such a function beside it or in a member `serialize(Archive&)`;
// the archive then writes them or reads them. Integers keep their size, lowest byte first; every
// floating-point number takes eight bytes, so that both precisions read the same file. What is read may
// come from a stranger: a number that is not finite in its own type, an enumerator that is none and a
// list longer than the bytes that are left fail the archive. Of an enumeration that is saved it is said,
// in its own namespace, which is the last one:
//
//     constexpr JointKind last_of(JointKind) { return JointKind::Spring; }
#pragma once

#include "engine/core/id.h"

#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace plumbline {

class Archive {
public:
    /// Writes.
    Archive() = default;
    /// Reads; the bytes must outlive it.
    explicit Archive(std::string_view bytes) : source_(bytes), reads_(true) {}

    bool reads() const { return reads_; }
    /// A number was read beyond the end (it is 0 then), or somebody found what cannot be.
    bool failed() const { return !fault_.empty(); }
    const std::string& fault() const { return fault_; }
    /// Keeps the first fault.
    void fail(std::string_view what) {
        if (fault_.empty()) fault_ = what;
    }
    /// Fails unless it holds; returns whether it did.
    bool expect(bool holds, std::string_view what) {
        if (!holds) fail(what);
        return holds;
    }
    std::size_t left() const { return source_.size(); }
    const std::string& written() const { return written_; }
    std::string take() { return std::move(written_); }

    /// The fields, in this order.
    template <class... Fields>
    void operator()(Fields&... fields) {
        (serialize(*this, fields), ...);
    }

    template <std::unsigned_integral T>
    void number(T& value) {
        if (!reads_) {
            for (std::size_t i = 0; i < sizeof(T); ++i)
                written_ += static_cast<char>(static_cast<std::uint8_t>(value >> (8 * i)));
            return;
        }
        const std::string_view raw = bytes(sizeof(T));
        value = 0;
        for (std::size_t i = raw.size(); i-- > 0;)
            value = static_cast<T>(static_cast<std::uint64_t>(value) << 8U |
                                   static_cast<std::uint8_t>(raw[i]));
    }
    void text(std::string& value);
    /// A number from `low` to `high`; others fail, and are `low`.
    template <class T>
    void within(T& value, T low, T high) {
        (*this)(value);
        if (!expect(value >= low && value <= high, kOutOfRange)) value = low;
    }
    /// How many follow; each takes a byte at least, so a count that cannot be is refused here.
    std::size_t count(std::size_t size);

private:
    static constexpr std::string_view kOutOfRange = "a number is out of its range";
    std::string_view bytes(std::size_t size);

    std::string written_;
    std::string_view source_;
    std::string fault_;
    bool reads_{false};
};

inline std::uint64_t bits_of(double value) {
    return std::bit_cast<std::uint64_t>(value);
}
inline std::uint64_t bits_of(float value) {
    return bits_of(static_cast<double>(value));
}

template <class T>
requires std::is_arithmetic_v<T> || std::is_enum_v<T>
void serialize(Archive& archive, T& value) {
    if constexpr (std::is_floating_point_v<T>) {
        auto bits = bits_of(value);
        archive.number(bits);
        if (!archive.reads()) return;
        const auto number = std::bit_cast<double>(bits);
        const bool fits = std::abs(number) <= static_cast<double>(std::numeric_limits<T>::max());
        value = archive.expect(fits, "a number is not finite") ? static_cast<T>(number) : T{0};
    } else if constexpr (std::is_same_v<T, bool>) {
        auto raw = static_cast<std::uint8_t>(value);
        archive.number(raw);
        if (archive.reads()) value = raw != 0;
    } else {
        using Integer = typename std::
            conditional_t<std::is_enum_v<T>, std::underlying_type<T>, std::type_identity<T>>::type;
        auto raw = static_cast<std::make_unsigned_t<Integer>>(value);
        archive.number(raw);
        if (!archive.reads()) return;
        if constexpr (std::is_enum_v<T>) {
            const bool is_one = std::cmp_less_equal(raw, static_cast<Integer>(last_of(T{})));
            if (!archive.expect(is_one, "a choice is none of those there are")) raw = 0;
        }
        value = static_cast<T>(raw);
    }
}

template <class T>
requires requires(T& value, Archive& archive) {
    value.serialize(archive);
}
void serialize(Archive& archive, T& value) {
    value.serialize(archive);
}

inline void serialize(Archive& archive, std::string& value) {
    archive.text(value);
}

template <class Tag>
void serialize(Archive& archive, Id<Tag>& id) {
    archive(id.index, id.generation);
}

template <class T, std::size_t kSize>
void serialize(Archive& archive, std::array<T, kSize>& values) {
    for (T& value : values) archive(value);
}

/// Of values that can be made from nothing.
template <class T>
void serialize(Archive& archive, std::optional<T>& value) {
    bool is_there = value.has_value();
    archive(is_there);
    if (archive.reads()) value = is_there ? std::optional<T>(T{}) : std::nullopt;
    if (value) archive(*value);
}

template <class A, class B>
void serialize(Archive& archive, std::pair<A, B>& pair) {
    archive(pair.first, pair.second);
}

template <class T>
void serialize(Archive& archive, std::vector<T>& values) {
    const std::size_t size = archive.count(values.size());
    if (!archive.reads()) {
        for (T& value : values) archive(value);
        return;
    }
    values.clear();
    for (std::size_t i = 0; i < size && !archive.failed(); ++i) archive(values.emplace_back());
}

template <class Key>
void serialize(Archive& archive, std::set<Key>& keys) {
    std::vector<Key> list(keys.begin(), keys.end());
    archive(list);
    if (archive.reads()) keys = std::set<Key>(list.begin(), list.end());
}

template <class Key, class Value, class Order>
void serialize(Archive& archive, std::map<Key, Value, Order>& values) {
    const std::size_t size = archive.count(values.size());
    if (!archive.reads()) {
        for (auto& [key, value] : values) {
            Key copy = key;
            archive(copy, value);
        }
        return;
    }
    values.clear();
    for (std::size_t i = 0; i < size && !archive.failed(); ++i) {
        Key key{};
        archive(key);
        archive(values[key]);
    }
}

}  // namespace plumbline
