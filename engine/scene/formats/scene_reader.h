// Reading one TOML table key by key: types, ranges and unknown keys are checked here, once, and
// every fault names its place, its key and what was expected.
#pragma once

#include "engine/core/math.h"
#include "engine/core/text/diagnostics.h"
#include "engine/scene/formats/toml_tree.h"
#include "engine/scene/scene_description.h"

#include <fmt/format.h>

#include <array>
#include <concepts>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::scene {

/// Collects faults and hands them over when it goes, sorted by place as compilers do. The same fault
/// at the same place counts once (a prefab's is met again in every entity that starts from it), and
/// a hostile file cannot make the list endless.
class FaultList {
public:
    explicit FaultList(Diagnostics& out) : out_(out) {}
    ~FaultList();
    FaultList(const FaultList&) = delete;
    FaultList& operator=(const FaultList&) = delete;

    void error(const SourceLocation& location, std::string key, std::string message) {
        add(Severity::Error, location, std::move(key), std::move(message));
    }
    void warning(const SourceLocation& location, std::string key, std::string message) {
        add(Severity::Warning, location, std::move(key), std::move(message));
    }
    /// The message is made as fmt::format() makes it.
    template <class... Parts>
    void error(const SourceLocation& location,
               std::string key,
               fmt::format_string<Parts...> message,
               Parts&&... parts) {
        error(location, std::move(key), fmt::format(message, std::forward<Parts>(parts)...));
    }
    template <class... Parts>
    void warning(const SourceLocation& location,
                 std::string key,
                 fmt::format_string<Parts...> message,
                 Parts&&... parts) {
        warning(location, std::move(key), fmt::format(message, std::forward<Parts>(parts)...));
    }
    bool any_error() const { return any_error_; }
    /// No further fault is listed: who reads a long list may stop.
    bool is_full() const;

private:
    void add(Severity severity,
             const SourceLocation& location,
             std::string key,
             std::string message);

    Diagnostics& out_;
    std::vector<Diagnostic> list_;
    std::set<std::string> seen_;
    bool any_error_{false};
};

/// Bounds of a number, and how a message calls them: "0 or more", "from 0 to 1".
struct Range {
    double min;
    double max;
    std::string_view expected;
};

inline constexpr double kEndless = 1e300;
inline constexpr Range kAnyNumber{-kEndless, kEndless, "a finite number"};
inline constexpr Range kNotNegative{0, 1e9, "a number from 0 to 1e9"};
inline constexpr Range kPositive{1e-9, 1e9, "a number above 0, up to 1e9"};
inline constexpr Range kFraction{0, 1, "a number from 0 to 1"};
inline constexpr Range kSize_m{1e-3, 1e4, "a length from 0.001 to 10000 m"};
inline constexpr Range kCoordinate_m{-1e5, 1e5, "metres from -100000 to 100000"};
inline constexpr Range kTurn_deg{-36'000, 36'000, "degrees from -36000 to 36000"};
inline constexpr Range kHour{0, 24, "an hour from 0 to 24"};
inline constexpr Range kGain{0, 10, "a factor from 0 to 10"};
inline constexpr Range kColor{0, 1e4, "a colour part from 0 to 10000"};

/// One table, or a table laid over others that it starts from (an entity over its prefab): a key
/// is taken from the first layer that has it.
class TableKeys {
public:
    TableKeys(std::vector<const TomlNode*> layers, std::string path, FaultList& faults);

    /// Where the table itself starts.
    const SourceLocation& location() const { return layers_.front()->location; }
    const std::string& path() const { return path_; }
    std::string path_of(std::string_view key) const;
    FaultList& faults() const { return *faults_; }

    /// The value of a key, or null; from now on the key counts as known.
    const TomlNode* find(std::string_view key);
    bool has(std::string_view key) { return find(key) != nullptr; }
    /// Of two keys that say the same in two ways, the one of the upper layer. Both in one layer is
    /// an error. Returns the key, or empty.
    std::string_view either(std::string_view a, std::string_view b);
    /// An error when the key is absent.
    void require(std::string_view key, std::string_view expected) {
        if (!has(key)) error(key, "missing; expected {}", expected);
    }

    /// An error at the value of `key`, or at the table when it is absent.
    void error(std::string_view key, std::string message);
    void warning(std::string_view key, std::string message);
    /// The message is made as fmt::format() makes it.
    template <class... Parts>
    void error(std::string_view key, fmt::format_string<Parts...> message, Parts&&... parts) {
        error(key, fmt::format(message, std::forward<Parts>(parts)...));
    }
    template <class... Parts>
    void warning(std::string_view key, fmt::format_string<Parts...> message, Parts&&... parts) {
        warning(key, fmt::format(message, std::forward<Parts>(parts)...));
    }

    /// Call last: complains about every key that was never asked for.
    void finish();

protected:
    /// Upper first; tables all.
    const std::vector<const TomlNode*>& layers() const { return layers_; }

private:
    std::vector<const TomlNode*> layers_;
    std::string path_;
    FaultList* faults_;
    std::vector<std::string_view> known_;
};

/// What the keys hold.
class TableReader : public TableKeys {
public:
    using TableKeys::TableKeys;
    TableReader(const TomlNode& table, std::string path, FaultList& faults)
        : TableKeys({&table}, std::move(path), faults) {}

    /// Without the uppermost layer; nothing when it is the only one.
    std::optional<TableReader> without_top() const;

    /// Takes the key's value: true or false, a text or several. What is absent or faulty leaves `value` as
    /// it is.
    template <class T>
    void read(std::string_view key, T& value) {
        take(key, value);
    }
    /// A number, which has the precision of Real, or a vector.
    template <class T>
    void read(std::string_view key, T& value, const Range& range) {
        take(key, value, range);
    }
    /// A whole number; an optional one is `min` where it is faulty.
    void read(std::string_view key, int& value, int min, int max);
    void read(std::string_view key, std::optional<int>& value, int min, int max) {
        if (has(key)) read(key, value.emplace(min), min, max);
    }
    /// The file has degrees, `value` is in radians.
    template <std::floating_point T>
    void read_degrees(std::string_view key, T& value, const Range& range) {
        T value_deg = degrees_from_radians(value);
        read(key, value_deg, range);
        value = radians_from_degrees(value_deg);
    }
    void read_degrees(std::string_view key, Vec3& value, const Range& each);
    /// Names of an enumeration's values, or of false and true.
    template <class T>
    void read_choice(std::string_view key, T& value, std::span<const std::string_view> choices) {
        value = static_cast<T>(choice(key, static_cast<std::size_t>(value), choices));
    }
    template <class T>
    void read_choice(std::string_view key,
                     T& value,
                     std::initializer_list<std::string_view> choices) {
        read_choice(key, value, std::span(choices.begin(), choices.size()));
    }
    /// A text that can be nothing but this word.
    void expect(std::string_view key, std::string_view word) { choice(key, 0, {&word, 1}); }
    /// Unit; zero is refused.
    template <class T>
    void read_direction(std::string_view key, glm::vec<3, T>& value) {
        value = glm::vec<3, T>(direction(key, Vec3d(value)));
    }
    /// KEY linear, or KEY_srgb as picked on a screen (parts from 0 to 1), made linear.
    void read_color(std::string_view key, Vec3f& value, const Range& each = kColor);

    std::optional<Real> number(std::string_view key, const Range& range);
    /// Empty when absent or faulty.
    std::string text(std::string_view key) { return taken<std::string>(key); }
    std::vector<std::string> texts(std::string_view key) {
        return taken<std::vector<std::string>>(key);
    }
    /// [a, b]; `expected` says what they are.
    std::optional<std::array<Real, 2>> pair(std::string_view key,
                                            const Range& each,
                                            std::string_view expected);

    /// What fill(table, value, more...) reads from the sub-table; an absent one leaves `value` empty. A
    /// `location` is set, and keys that nothing asked for are errors.
    template <class T, class Read, class... More>
    void read_table(std::string_view key, std::optional<T>& value, Read fill, More&&... more) {
        if (auto sub_table = table(key)) sub_table->read_whole(value.emplace(), fill, more...);
    }
    /// The same, or `true` for one with the usual numbers; false: none.
    template <class T, class Read>
    void read_wish(std::string_view key, std::optional<T>& value, Read fill) {
        const TomlNode* node = find(key);
        if (node == nullptr || !std::holds_alternative<bool>(node->value))
            return read_table(key, value, fill);
        if (std::get<bool>(node->value)) value = T{.location = node->location};
    }
    /// The same for each item of an array of tables.
    template <class T, class Read, class... More>
    void read_tables(std::string_view key, std::vector<T>& values, Read fill, More&&... more) {
        const auto nodes = tables(key);
        for (std::size_t i = 0; i < nodes.size(); ++i)
            item(key, nodes, i).read_whole(values.emplace_back(), fill, more...);
    }
    /// Reader of a sub-table over all layers that have it; absent: none.
    std::optional<TableReader> table(std::string_view key);
    /// The items of an array of tables, or none.
    std::span<const TomlNode> tables(std::string_view key);
    /// Reader of one of them.
    TableReader item(std::string_view key, std::span<const TomlNode> tables, std::size_t i) const {
        return {tables[i], fmt::format("{}[{}]", path_of(key), i), faults()};
    }

private:
    void take(std::string_view key, bool& value);
    void take(std::string_view key, std::string& value);
    void take(std::string_view key, std::vector<std::string>& values);
    template <std::floating_point T>
    void take(std::string_view key, T& value, const Range& range) {
        value = static_cast<T>(number(key, range).value_or(static_cast<Real>(value)));
    }
    template <std::floating_point T>
    void take(std::string_view key, std::optional<T>& value, const Range& range) {
        if (const auto given = number(key, range)) value = static_cast<T>(*given);
    }
    void take(std::string_view key, Vec3& value, const Range& each) {
        if (const auto given = vector(key, each)) value = Vec3(*given);
    }
    void take(std::string_view key, std::optional<Vec3>& value, const Range& each) {
        if (const auto given = vector(key, each)) value = Vec3(*given);
    }
    template <class T>
    T taken(std::string_view key) {
        T value;
        take(key, value);
        return value;
    }
    template <class T, class Read, class... More>
    void read_whole(T& value, Read fill, More&&... more) {
        if constexpr (requires { value.location; }) value.location = location();
        fill(*this, value, more...);
        finish();
    }
    std::size_t choice(std::string_view key,
                       std::size_t fallback,
                       std::span<const std::string_view> choices);
    std::optional<Vec3d> vector(std::string_view key, const Range& each);
    Vec3d direction(std::string_view key, const Vec3d& fallback);
};

/// Readers of single values, for arrays; the fault is reported at the value.
std::optional<double> number_of(const TomlNode& node,
                                const std::string& path,
                                const Range& range,
                                FaultList& faults);
std::optional<Vec3d> vector_of(const TomlNode& node,
                               const std::string& path,
                               const Range& each,
                               FaultList& faults);

/// Letters, digits, _ and - only: what TOML takes without quotes.
bool is_bare_key(std::string_view key);
/// "text "wide"", "the number -3", "an array": what a message says it found.
std::string found(const TomlNode& node);
/// `; did you mean "crate"?` or, with nothing near, `; known: a, b, c`.
std::string suggestion(std::string_view word, std::span<const std::string_view> known);
/// The same with the keys of a map.
template <class Value>
std::string suggestion(std::string_view word, const std::map<std::string, Value>& known) {
    std::vector<std::string_view> names;
    for (const auto& [name, value] : known) names.push_back(name);
    return suggestion(word, names);
}
/// A name as messages show it: short and without control characters.
std::string shown(std::string_view text);

/// "a, b, c", and how many more when there are very many.
std::string listed(const std::vector<std::string>& names);

}  // namespace plumbline::scene
