// A folder for files that nobody needs once its owner is gone.
#pragma once

#include "engine/core/result.h"

#include <filesystem>
#include <string_view>

namespace plumbline {

/// Removed with all that is in it on destruction.
class ScratchFolder {
public:
    /// plumbline-WHAT- and six letters, in the system's folder for such things; nobody else may look into it.
    static Result<ScratchFolder> make(std::string_view what);
    ScratchFolder(ScratchFolder&& other) noexcept;
    ScratchFolder& operator=(ScratchFolder&& other) noexcept;
    ~ScratchFolder();

    const std::filesystem::path& path() const { return path_; }

private:
    explicit ScratchFolder(std::filesystem::path path) : path_(std::move(path)) {}

    std::filesystem::path path_;  ///< empty: moved away
};

}  // namespace plumbline
