#include "engine/scene/formats/scene_reader.h"

#include "engine/core/assert.h"
#include "engine/core/color.h"
#include "engine/core/text/nearest_name.h"
#include "engine/core/text/printable.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <tuple>

namespace plumbline::scene {
namespace {

constexpr std::size_t kFaultsListed = 200;

/// Never as a whole number looks: 1.0 where 1 was wanted is "1.0".
std::string decimal(double number) {
    std::string text = fmt::format("{}", number);
    if (text.find_first_not_of("-0123456789") == std::string::npos) text += ".0";
    return text;
}

}  // namespace

bool is_bare_key(std::string_view key) {
    return !key.empty() && std::ranges::all_of(key, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '-';
    });
}

FaultList::~FaultList() {
    // Files in the order of their first fault, the scene's own before what it includes.
    std::vector<std::string_view> files;
    for (const Diagnostic& fault : list_) {
        if (std::ranges::find(files, fault.file) == files.end()) files.push_back(fault.file);
    }
    const auto order = [&](const Diagnostic& fault) {
        const auto file = std::ranges::find(files, std::string_view(fault.file)) - files.begin();
        return std::tuple(file, fault.line, fault.column);
    };
    std::ranges::stable_sort(list_, std::less{}, order);
    for (Diagnostic& fault : list_) out_.add(std::move(fault));
    if (is_full())
        out_.add({any_error_ ? Severity::Error : Severity::Warning,
                  {},
                  0,
                  0,
                  {},
                  "further faults are not listed"});
}

bool FaultList::is_full() const {
    return seen_.size() > kFaultsListed;
}

void FaultList::add(Severity severity,
                    const SourceLocation& location,
                    std::string key,
                    std::string message) {
    if (severity == Severity::Error) any_error_ = true;
    const std::string& file = file_of(location);
    if (is_full()) return;
    if (!seen_.insert(fmt::format("{}:{}:{}:{}", file, location.line, location.column, message))
             .second)
        return;
    if (is_full()) return;
    list_.push_back(
        {severity, file, location.line, location.column, std::move(key), std::move(message)});
}

std::string shown(std::string_view text) {
    constexpr std::size_t kShownBytes = 60;
    if (text.size() <= kShownBytes) return printable(text);
    std::size_t end = kShownBytes;  // never half of a UTF-8 character
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
    return printable(text.substr(0, end)) + "…";
}

std::string found(const TomlNode& node) {
    if (const auto* flag = std::get_if<bool>(&node.value)) return *flag ? "true" : "false";
    if (const auto* integer = std::get_if<std::int64_t>(&node.value))
        return fmt::format("{}", *integer);
    if (const auto* number = std::get_if<double>(&node.value)) return decimal(*number);
    if (const auto* text = node.text()) return fmt::format("\"{}\"", shown(*text));
    if (const auto* array = node.array()) return fmt::format("an array of {}", array->size());
    if (node.table() != nullptr) return "a table";
    return "a date or time";
}

std::string suggestion(std::string_view word, std::span<const std::string_view> known) {
    const std::string_view nearest = nearest_name(word, known);
    if (!nearest.empty()) return fmt::format("; did you mean \"{}\"?", nearest);
    if (known.empty()) return "; none is known here";
    std::vector<std::string_view> sorted(known.begin(), known.end());
    std::ranges::sort(sorted);
    constexpr std::size_t kNamesListed = 40;
    const bool all = sorted.size() <= kNamesListed;
    if (!all) sorted.resize(kNamesListed);
    return fmt::format("; known: {}{}", fmt::join(sorted, ", "), all ? "" : ", …");
}

std::string listed(const std::vector<std::string>& names) {
    constexpr std::size_t kListed = 100;
    if (names.size() <= kListed) return fmt::format("{}", fmt::join(names, ", "));
    return fmt::format("{} and {} more",
                       fmt::join(names.begin(), names.begin() + kListed, ", "),
                       names.size() - kListed);
}

std::optional<double> number_of(const TomlNode& node,
                                const std::string& path,
                                const Range& range,
                                FaultList& faults) {
    double value = 0;
    if (const auto* integer = std::get_if<std::int64_t>(&node.value)) {
        value = static_cast<double>(*integer);
    } else if (const auto* number = std::get_if<double>(&node.value)) {
        value = *number;
    } else {
        faults.error(
            node.location, path, fmt::format("{}; expected {}", found(node), range.expected));
        return {};
    }
    if (!std::isfinite(value) || value < range.min || value > range.max) {
        faults.error(
            node.location, path, fmt::format("{}; expected {}", found(node), range.expected));
        return {};
    }
    return value;
}

std::optional<Vec3d> vector_of(const TomlNode& node,
                               const std::string& path,
                               const Range& each,
                               FaultList& faults) {
    const TomlArray* array = node.array();
    if (array == nullptr || array->size() != 3) {
        faults.error(node.location, path, fmt::format("{}; expected [x, y, z]", found(node)));
        return {};
    }
    Vec3d value{0, 0, 0};
    bool good = true;
    for (int i = 0; i < 3; ++i) {
        const auto part = number_of(
            (*array)[static_cast<std::size_t>(i)], fmt::format("{}[{}]", path, i), each, faults);
        good = good && part.has_value();
        value[i] = part.value_or(0);
    }
    if (!good) return {};
    return value;
}

TableKeys::TableKeys(std::vector<const TomlNode*> layers, std::string path, FaultList& faults)
    : layers_(std::move(layers)), path_(std::move(path)), faults_(&faults) {
    PL_ASSERT(!layers_.empty(), "at least one layer");
}

std::string TableKeys::path_of(std::string_view key) const {
    const std::string part = is_bare_key(key) ? shown(key) : "\"" + shown(key) + "\"";
    return path_.empty() ? part : path_ + "." + part;
}

std::optional<TableReader> TableReader::without_top() const {
    if (layers().size() < 2) return {};
    return TableReader({layers().begin() + 1, layers().end()}, path(), faults());
}

const TomlNode* TableKeys::find(std::string_view key) {
    if (std::ranges::find(known_, key) == known_.end()) known_.push_back(key);
    for (const TomlNode* layer : layers_) {
        if (const TomlNode* node = find_key(*layer->table(), key)) return node;
    }
    return nullptr;
}

std::string_view TableKeys::either(std::string_view a, std::string_view b) {
    find(a);
    find(b);
    for (const TomlNode* layer : layers_) {
        const bool has_a = find_key(*layer->table(), a) != nullptr;
        const TomlNode* second = find_key(*layer->table(), b);
        if (has_a && second != nullptr) {
            faults_->error(second->location,
                           path_of(b),
                           fmt::format("given beside {}; they say the same thing, keep one", a));
        }
        if (has_a) return a;
        if (second != nullptr) return b;
    }
    return {};
}

void TableReader::take(std::string_view key, bool& value) {
    const TomlNode* node = find(key);
    if (node == nullptr) return;
    const auto* flag = std::get_if<bool>(&node->value);
    if (flag == nullptr) return error(key, "{}; expected true or false", found(*node));
    value = *flag;
}

void TableReader::read(std::string_view key, int& value, int min, int max) {
    const TomlNode* node = find(key);
    if (node == nullptr) return;
    const auto* given = std::get_if<std::int64_t>(&node->value);
    if (given == nullptr || *given < min || *given > max)
        return error(key, "{}; expected a whole number from {} to {}", found(*node), min, max);
    value = static_cast<int>(*given);
}

void TableReader::take(std::string_view key, std::string& value) {
    const TomlNode* node = find(key);
    if (node == nullptr) return;
    if (node->text() == nullptr) return error(key, "{}; expected a text in quotes", found(*node));
    value = *node->text();
}

void TableReader::take(std::string_view key, std::vector<std::string>& values) {
    const TomlNode* node = find(key);
    if (node == nullptr) return;
    const TomlArray* array = node->array();
    if (array == nullptr) return error(key, "{}; expected an array of texts", found(*node));
    for (std::size_t i = 0; i < array->size(); ++i) {
        if (const std::string* value = (*array)[i].text()) {
            values.push_back(*value);
        } else {
            faults().error((*array)[i].location,
                           fmt::format("{}[{}]", path_of(key), i),
                           "{}; expected a text in quotes",
                           found((*array)[i]));
        }
    }
}

void TableReader::read_degrees(std::string_view key, Vec3& value, const Range& each) {
    const auto given_deg = vector(key, each);
    if (!given_deg) return;
    for (int i = 0; i < 3; ++i) value[i] = radians_from_degrees(static_cast<Real>((*given_deg)[i]));
}

std::optional<Real> TableReader::number(std::string_view key, const Range& range) {
    const TomlNode* node = find(key);
    if (node == nullptr) return {};
    const auto value = number_of(*node, path_of(key), range, faults());
    if (!value) return {};
    return static_cast<Real>(*value);
}

std::size_t TableReader::choice(std::string_view key,
                                std::size_t fallback,
                                std::span<const std::string_view> choices) {
    const TomlNode* node = find(key);
    if (node == nullptr) return fallback;
    std::string hint;
    if (const std::string* value = node->text()) {
        const auto at = std::ranges::find(choices, std::string_view(*value));
        if (at != choices.end()) return static_cast<std::size_t>(at - choices.begin());
        const std::string_view nearest = nearest_name(*value, choices);
        if (!nearest.empty()) hint = fmt::format("; did you mean \"{}\"?", nearest);
    }
    error(key, "{}; expected one of {}{}", found(*node), fmt::join(choices, ", "), hint);
    return fallback;
}

std::optional<std::array<Real, 2>> TableReader::pair(std::string_view key,
                                                     const Range& each,
                                                     std::string_view expected) {
    const TomlNode* node = find(key);
    if (node == nullptr) return {};
    const TomlArray* array = node->array();
    if (array == nullptr || array->size() != 2) {
        error(key, "{}; expected {}", found(*node), expected);
        return {};
    }
    const auto first = number_of(array->front(), path_of(key) + "[0]", each, faults());
    const auto second = number_of(array->back(), path_of(key) + "[1]", each, faults());
    if (!first || !second) return {};
    return std::array<Real, 2>{static_cast<Real>(*first), static_cast<Real>(*second)};
}

std::optional<Vec3d> TableReader::vector(std::string_view key, const Range& each) {
    const TomlNode* node = find(key);
    if (node == nullptr) return {};
    return vector_of(*node, path_of(key), each, faults());
}

Vec3d TableReader::direction(std::string_view key, const Vec3d& fallback) {
    constexpr Range kPart{-1e6, 1e6, "a number from -1000000 to 1000000"};
    const auto value = vector(key, kPart);
    if (!value) return glm::normalize(fallback);
    if (glm::length(*value) < 1e-6) {
        error(key, "[0, 0, 0] has no direction; expected a vector of some length");
        return glm::normalize(fallback);
    }
    return glm::normalize(*value);
}

void TableReader::read_color(std::string_view key, Vec3f& value, const Range& each) {
    // Names of keys must outlive the reader; the few that colours have are spelt out.
    static constexpr std::string_view kSrgbNames[] = {
        "color_srgb", "base_color_srgb", "emissive_srgb", "clear_color_srgb"};
    const auto srgb_name = std::ranges::find_if(kSrgbNames, [&](std::string_view name) {
        return name.size() == key.size() + 5 && name.substr(0, key.size()) == key;
    });
    PL_ASSERT(srgb_name != std::end(kSrgbNames), "a colour's key");
    const std::string_view used = either(key, *srgb_name);
    if (used.empty()) return;
    auto given = vector(used, used == key ? each : kFraction);
    if (!given) return;
    if (used != key) {
        for (int i = 0; i < 3; ++i) (*given)[i] = linear_from_srgb((*given)[i]);
    }
    value = Vec3f(*given);
}

std::optional<TableReader> TableReader::table(std::string_view key) {
    find(key);
    std::vector<const TomlNode*> parts;
    for (const TomlNode* layer : layers()) {
        const TomlNode* node = find_key(*layer->table(), key);
        if (node == nullptr) continue;
        if (node->table() == nullptr) {
            faults().error(node->location, path_of(key), found(*node) + "; expected a table");
            continue;
        }
        parts.push_back(node);
    }
    if (parts.empty()) return {};
    return TableReader(std::move(parts), path_of(key), faults());
}

std::span<const TomlNode> TableReader::tables(std::string_view key) {
    const TomlNode* node = find(key);
    if (node == nullptr) return {};
    const TomlArray* array = node->array();
    const bool all_tables =
        array != nullptr &&
        std::ranges::all_of(*array, [](const TomlNode& item) { return item.table() != nullptr; });
    if (all_tables) return *array;
    error(key, fmt::format("{}; expected tables headed [[{}]]", found(*node), key));
    return {};
}

void TableKeys::error(std::string_view key, std::string message) {
    const TomlNode* node = key.empty() ? nullptr : find(key);
    faults_->error(node != nullptr ? node->location : location(),
                   key.empty() ? path_ : path_of(key),
                   std::move(message));
}

void TableKeys::warning(std::string_view key, std::string message) {
    const TomlNode* node = key.empty() ? nullptr : find(key);
    faults_->warning(node != nullptr ? node->location : location(),
                     key.empty() ? path_ : path_of(key),
                     std::move(message));
}

void TableKeys::finish() {
    for (const TomlNode* layer : layers_) {
        for (const TomlEntry& entry : *layer->table()) {
            if (std::ranges::find(known_, std::string_view(entry.key)) != known_.end()) continue;
            faults_->error(entry.key_location,
                           path_of(entry.key),
                           "unknown key" + suggestion(entry.key, known_));
        }
    }
}

}  // namespace plumbline::scene
