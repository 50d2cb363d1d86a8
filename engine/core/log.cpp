#include "engine/core/log.h"

#include "engine/core/log_tail.h"
#include "engine/core/text/printable.h"

#include <spdlog/sinks/dup_filter_sink.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <string>

namespace plumbline {
namespace {

spdlog::logger& logger() {
    static const std::shared_ptr<spdlog::logger> instance = [] {
        auto folded = std::make_shared<spdlog::sinks::dup_filter_sink_mt>(std::chrono::seconds(5));
        folded->add_sink(std::make_shared<spdlog::sinks::stderr_sink_mt>());
        auto made = std::make_shared<spdlog::logger>("plumbline", folded);
        made->set_pattern("plumbline: %l: %v");
        made->set_level(spdlog::level::info);
        made->flush_on(spdlog::level::debug);
        return made;
    }();
    return *instance;
}

spdlog::level::level_enum level_of(LogLevel level) {
    switch (level) {
        case LogLevel::Debug:
            return spdlog::level::debug;
        case LogLevel::Note:
            return spdlog::level::info;
        case LogLevel::Warning:
            return spdlog::level::warn;
        case LogLevel::Error:
            return spdlog::level::err;
    }
    return spdlog::level::err;
}

/// The last lines, kept where a signal handler can read them.
struct Tail {
    static constexpr std::size_t kLines = 64;
    static constexpr std::size_t kLineBytes = 256;

    std::mutex mutex;
    std::array<std::array<char, kLineBytes>, kLines> lines{};
    std::array<std::atomic<std::size_t>, kLines> lengths{};
    std::atomic<std::size_t> count{0};

    void add(std::string_view text) {
        const std::lock_guard lock(mutex);
        const std::size_t place = count % kLines;
        const std::size_t length = std::min(text.size(), kLineBytes - 1);
        text.copy(lines[place].data(), length);
        lines[place][length] = '\n';
        lengths[place] = length + 1;
        ++count;
    }
};

Tail tail;

}  // namespace

void write_last_log_lines(int file) {
    const std::size_t count = tail.count;
    for (std::size_t i = count - std::min(count, Tail::kLines); i < count; ++i) {
        const std::size_t place = i % Tail::kLines;
        // Nobody is left to hear of a failure.
        [[maybe_unused]] const ssize_t written =
            ::write(file, tail.lines[place].data(), tail.lengths[place]);
    }
}

void set_log_level(LogLevel lowest_shown) {
    logger().set_level(level_of(lowest_shown));
}

void log_line(LogLevel level, std::string_view text) {
    if (!logger().should_log(level_of(level))) return;
    const std::string shown = printable_lines(text);
    tail.add(shown);
    logger().log(level_of(level), shown);
}

}  // namespace plumbline
