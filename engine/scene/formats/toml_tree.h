// TOML as plain nested values that know where they stand in which file. The one place where scene
// files meet the TOML parser; everything after reads this tree.
#pragma once

#include "engine/core/result.h"
#include "engine/core/text/source_location.h"
#include "engine/core/text/toml_prescan.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace plumbline::scene {

struct TomlNode;
struct TomlEntry;
using TomlArray = std::vector<TomlNode>;
/// In the order of the file.
using TomlTable = std::vector<TomlEntry>;

/// Dates and times, which scenes have no use for.
struct TomlDate {};

struct TomlNode {
    // No initialiser: it would need TomlEntry, which needs TomlNode. Starts as false all the same.
    std::variant<bool, std::int64_t, double, std::string, TomlDate, TomlArray, TomlTable> value;
    SourceLocation location{};

    const TomlTable* table() const { return std::get_if<TomlTable>(&value); }
    const TomlArray* array() const { return std::get_if<TomlArray>(&value); }
    const std::string* text() const { return std::get_if<std::string>(&value); }
};

struct TomlEntry {
    std::string key;
    SourceLocation key_location{};
    TomlNode node;
};

/// The table's entry under that key, or null.
const TomlNode* find_key(const TomlTable& table, std::string_view key);

/// One table over another: what both have as tables key by key, what both have as arrays of tables one
/// after the other, of the rest the upper one's.
TomlNode laid_over(TomlNode below, const TomlNode& above);

/// The whole text as one table, or the first fault: of the pre-scan, then of the parser. `file` is what
/// the text is called.
std::variant<TomlNode, TextFault> parse_toml(std::string_view text,
                                             const std::shared_ptr<const std::string>& file);

}  // namespace plumbline::scene
