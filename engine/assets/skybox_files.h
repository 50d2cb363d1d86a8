// The six images of a skybox, found by name.
#pragma once

#include <array>
#include <filesystem>
#include <string_view>

namespace plumbline::assets {

/// In the order of OpenGL's cube map faces.
inline constexpr std::array<std::string_view, 6> kSkyboxFaces{"px", "nx", "py", "ny", "pz", "nz"};

/// FOLDER/px.exr, .png or .jpg and so on, in the order of kSkyboxFaces; an empty path for a face
/// that has no regular file.
std::array<std::filesystem::path, 6> skybox_files(const std::filesystem::path& folder);

}  // namespace plumbline::assets
