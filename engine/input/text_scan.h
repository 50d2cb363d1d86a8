// A linear look at TOML text before the parser sees it: toml++ 3.3 recurses over nesting and dotted
// keys, and deep ones end the process.
#pragma once

#include "engine/core/result.h"

#include <string>
#include <string_view>

namespace plumbline::input {

/// What is wrong with a text and where.
struct ScanFault {
    int line{0};
    int column{0};
    std::string message;  ///< empty: nothing
};

/// Checks size, line length, nesting of brackets and parts of dotted keys against core/limits.h.
ScanFault scan_text(std::string_view text);

}  // namespace plumbline::input
