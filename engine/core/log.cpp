#include "engine/core/log.h"

#include <spdlog/sinks/dup_filter_sink.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <memory>

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

}  // namespace

void set_log_level(LogLevel lowest_shown) {
    logger().set_level(level_of(lowest_shown));
}

void log_line(LogLevel level, std::string_view text) {
    logger().log(level_of(level), text);
}

}  // namespace plumbline
