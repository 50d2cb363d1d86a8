#include "engine/core/text/source_location.h"

#include <fmt/format.h>

#include <filesystem>

namespace plumbline {

SourceLocation in_file(std::string file, int line) {
    return {.file = std::make_shared<const std::string>(std::move(file)), .line = line};
}

const std::string& file_of(const SourceLocation& location) {
    static const std::string none;
    return location.file ? *location.file : none;
}

std::string to_string(const SourceLocation& location) {
    return fmt::format(
        "{}:{}", std::filesystem::path(file_of(location)).filename().string(), location.line);
}

}  // namespace plumbline
