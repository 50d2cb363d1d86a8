// Reading one TOML table key by key: types, ranges and unknown keys are checked here, once, and
// every fault names its place, its key and what was expected.
#pragma once

#include "engine/core/math.h"
#include "engine/core/text/diagnostics.h"
#include "engine/scene/formats/toml_tree.h"
#include "engine/scene/scene_description.h"

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

    void error(const SourceLocation& location, std::string key, std::string message);
    void warning(const SourceLocation& location, std::string key, std::string message);
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
inline constexpr Range kHour{0, 24, "an hour from 0 to 24"};
inline constexpr Range kColor{0, 1e4, "a colour part from 0 to 10000"};

/// One table, or a table laid over others that it starts from (an entity over its prefab): a key
/// is taken from the first layer that has it.
class TableReader {
public:
    TableReader(std::vector<const TomlNode*> layers, std::string path, FaultList& faults);
    TableReader(const TomlNode& table, std::string path, FaultList& faults);

    /// Where the table itself starts.
    const SourceLocation& location() const;
    const std::string& path() const { return path_; }
    std::string path_of(std::string_view key) const;
    FaultList& faults() const { return *faults_; }

    /// Without the uppermost layer; nothing when it is the only one.
    std::optional<TableReader> without_top() const;

    /// The value of a key, or null; from now on the key counts as known.
    const TomlNode* find(std::string_view key);
    bool has(std::string_view key) { return find(key) != nullptr; }
    /// Of two keys that say the same in two ways, the one of the upper layer. Both in one layer is
    /// an error. Returns the key, or empty.
    std::string_view either(std::string_view a, std::string_view b);

    /// Values; absent or faulty ones are `fallback`.
    bool flag(std::string_view key, bool fallback);
    int integer(std::string_view key, int fallback, int min, int max);
    Real number(std::string_view key, Real fallback, const Range& range);
    float single(std::string_view key, float fallback, const Range& range);
    std::optional<Real> optional_number(std::string_view key, const Range& range);
    std::string text(std::string_view key, std::string fallback);
    /// Index into `choices`.
    std::size_t choice(std::string_view key,
                       std::size_t fallback,
                       std::span<const std::string_view> choices);
    Vec3 vector(std::string_view key, const Vec3& fallback, const Range& each);
    std::optional<Vec3> optional_vector(std::string_view key, const Range& each);
    /// Unit; zero is refused.
    Vec3d direction(std::string_view key, const Vec3d& fallback);
    /// KEY linear, or KEY_srgb as picked on a screen (parts from 0 to 1), made linear.
    Vec3f color(std::string_view key, const Vec3f& fallback, const Range& each = kColor);
    std::vector<std::string> texts(std::string_view key);
    /// Reader of a sub-table over all layers that have it; absent: none.
    std::optional<TableReader> table(std::string_view key);
    /// The items of an array of tables, or none.
    std::span<const TomlNode> tables(std::string_view key);

    /// An error at the value of `key`, or at the table when it is absent.
    void error(std::string_view key, std::string message);
    void warning(std::string_view key, std::string message);

    /// Call last: complains about every key that was never asked for.
    void finish();

private:
    std::optional<Vec3d> exact_vector(std::string_view key, const Range& each);

    std::vector<const TomlNode*> layers_;  // upper first; tables all
    std::string path_;
    FaultList* faults_;
    std::vector<std::string_view> known_;
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

/// "text "wide"", "the number -3", "an array": what a message says it found.
std::string found(const TomlNode& node);
/// `; did you mean "crate"?` or, with nothing near, `; known: a, b, c`.
std::string suggestion(std::string_view word, std::span<const std::string_view> known);
/// A name as messages show it: short and without control characters.
std::string shown(std::string_view text);

/// "a, b, c", and how many more when there are very many.
std::string listed(const std::vector<std::string>& names);

}  // namespace plumbline::scene
