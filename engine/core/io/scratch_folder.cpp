#include "engine/core/io/scratch_folder.h"

#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <utility>

namespace plumbline {

namespace fs = std::filesystem;

Result<ScratchFolder> ScratchFolder::make(std::string_view what) {
    std::error_code ignored;
    fs::path above = fs::temp_directory_path(ignored);
    if (above.empty()) above = "/tmp";
    std::string name = (above / fmt::format("plumbline-{}-XXXXXX", what)).string();
    if (mkdtemp(name.data()) == nullptr)
        return Error{.message = fmt::format("cannot make the folder {}", name)};
    return ScratchFolder(fs::path(name));
}

ScratchFolder::ScratchFolder(ScratchFolder&& other) noexcept
    : path_(std::exchange(other.path_, {})) {}

ScratchFolder& ScratchFolder::operator=(ScratchFolder&& other) noexcept {
    std::swap(path_, other.path_);
    return *this;
}

ScratchFolder::~ScratchFolder() {
    if (path_.empty()) return;
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

}  // namespace plumbline
