// The user's bindings file over the built-in table, and what was said of it.
#pragma once

#include "engine/input/bindings.h"

#include <string>
#include <string_view>
#include <vector>

namespace plumbline::input {

inline std::string joined_words(const Bindings& bindings, Action action) {
    std::string text;
    for (const Input& input : bindings.of(action)) text += (text.empty() ? "" : " ") + input.word;
    return text;
}

/// The user's file over the built-in table.
struct Loaded {
    explicit Loaded(std::string_view text, const std::vector<std::string>& options = {})
        : bindings(load_bindings({{"bindings.toml", std::string{text}}}, options, faults)) {}

    std::string messages() const {
        std::string text;
        for (const Diagnostic& fault : faults.list()) text += to_string(fault) + "\n";
        return text;
    }

    Diagnostics faults;
    Bindings bindings;
};

}  // namespace plumbline::input
