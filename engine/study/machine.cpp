#include "engine/study/machine.h"

#include "engine/study/workers/worker_pool.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <fstream>

namespace plumbline::study {

std::string machine_text() {
    std::string processor = "unknown processor";
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const std::size_t colon = line.find(": ");
        if (!line.starts_with("model name") || colon == std::string::npos) continue;
        processor = line.substr(colon + 2);
        break;
    }
    return fmt::format("{}, {} cores", processor, default_workers());
}

std::string build_text() {
#if defined(__clang__)
    constexpr const char* kCompiler = "clang " __clang_version__;
#else
    constexpr const char* kCompiler = "g++ " __VERSION__;
#endif
#if defined(__OPTIMIZE__)
    constexpr const char* kHow = "optimised";
#else
    constexpr const char* kHow = "not optimised";
#endif
    return fmt::format("{}, {}", kCompiler, kHow);
}

std::string today_text() {
    return fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr)));
}

}  // namespace plumbline::study
