// Where in a text something was said.
#pragma once

#include <memory>
#include <string>

namespace plumbline {

struct SourceLocation {
    std::shared_ptr<const std::string> file{};  ///< as the person named it; one for all its lines
    int line{0};                                ///< from 1; 0 when the whole file is meant
    int column{0};                              ///< from 1; 0 when unknown
};

SourceLocation in_file(std::string file, int line = 0);
/// Empty where no file is known.
const std::string& file_of(const SourceLocation& location);
/// "garden.toml:14", without the file's folder.
std::string to_string(const SourceLocation& location);

}  // namespace plumbline
