// One log for the whole program: four levels, one sink (stderr). Log once, where it is handled.
#pragma once

#include <fmt/format.h>

#include <string_view>

namespace plumbline {

enum class LogLevel { Debug, Note, Warning, Error };

/// --quiet shows errors only, --verbose everything; notes and up otherwise.
void set_log_level(LogLevel lowest_shown);

/// Repeats of the line before are folded into a count.
void log_line(LogLevel level, std::string_view text);

template <class... Args>
void log_debug(fmt::format_string<Args...> format, Args&&... args) {
    log_line(LogLevel::Debug, fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void log_note(fmt::format_string<Args...> format, Args&&... args) {
    log_line(LogLevel::Note, fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void log_warning(fmt::format_string<Args...> format, Args&&... args) {
    log_line(LogLevel::Warning, fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void log_error(fmt::format_string<Args...> format, Args&&... args) {
    log_line(LogLevel::Error, fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace plumbline
