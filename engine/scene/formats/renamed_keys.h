// What scene files said before and say otherwise now: still read, each with a warning that names the new word.
#pragma once

#include "engine/scene/formats/scene_reader.h"

#include <span>
#include <string_view>

namespace plumbline::scene {

struct RenamedKey {
    std::string_view table;  ///< "hard_case.event"
    std::string_view
        key;  ///< empty: `before` and `now` are keys; else words that its value begins with
    std::string_view before;
    std::string_view now;
};

std::span<const RenamedKey> renamed_keys();

/// Puts the new words into a file's tree. Where a table has both keys the old one stays, and is unknown.
void rename_keys(TomlNode& root, FaultList& faults);

}  // namespace plumbline::scene
