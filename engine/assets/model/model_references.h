// The files that a model file names: where they are, and whether they may be opened at all.
// Private to engine/assets.
#pragma once

#include "engine/core/result.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace plumbline::assets {

/// Resolves references of one model file and counts them against limits::kReferencedFiles.
class ModelReferences {
public:
    ModelReferences(const std::filesystem::path& model_file, std::filesystem::path root)
        : folder_(model_file.parent_path()), root_(std::move(root)) {}

    /// `reference` is decoded already and has forward slashes. Relative to `folder` (the model's
    /// own when empty), not out of it, links followed and still inside the root, and a regular
    /// file if it exists. `field` is named in the error: "images[3].uri".
    Result<std::filesystem::path> resolve(std::string_view reference,
                                          std::string_view field,
                                          const std::filesystem::path& folder = {});

    const std::filesystem::path& folder() const { return folder_; }

    /// From now on find_image() takes the place of resolve() for images.
    void expect_paths_of_another_machine() { paths_are_of_another_machine_ = true; }
    bool paths_are_of_another_machine() const { return paths_are_of_another_machine_; }
    /// The image that a material means: where the file says, or else beside the model, since exporters
    /// write down the folders of the machine that they ran on. Empty when it is nowhere.
    std::filesystem::path find_image(std::string_view reference);

private:
    std::filesystem::path folder_;
    std::filesystem::path root_;
    std::size_t count_{0};
    bool paths_are_of_another_machine_{false};
};

/// %41 to A, once. Nothing when an escape is broken or stands for NUL.
std::optional<std::string> percent_decoded(std::string_view text);

/// Standard alphabet, padding required, nothing else allowed. Nothing when it is not that.
std::optional<std::string> base64_decoded(std::string_view text);

}  // namespace plumbline::assets
