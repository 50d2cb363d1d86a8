#include "game/command_line/threads_option.h"

#include "engine/scene/accuracy.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <charconv>

namespace plumbline::game {

int threads_from(const std::string& text) {
    if (text == "auto") return scene::kAutoThreads;
    int threads = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), threads);
    if (error == std::errc{} && end == text.data() + text.size() && threads >= 1 &&
        threads <= scene::kMostThreads)
        return threads;
    throw CLI::ValidationError(
        fmt::format("--threads: \"{}\"; expected auto or a whole number from 1 to {}",
                    text,
                    scene::kMostThreads));
}

}  // namespace plumbline::game
