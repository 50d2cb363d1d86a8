// Shader files to the text that the driver compiles: includes expanded, variant defines put in
// front, #line directives so that messages point at the real file. No GL.
#pragma once

#include "engine/core/result.h"
#include "engine/render/shaders/feature_set.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::render {

struct ShaderSource {
    std::string text;
    /// #line numbers these; relative to the shader folder.
    std::vector<std::string> files;
};

/// A `#define` line for the macro of each feature in the set.
std::string defines_of(std::span<const Feature> features, FeatureSet set);

/// `file` relative to `folder`; `#include "x"` is relative to `folder` too, and each file enters
/// once. The error names file and line of an include that is missing or leads out of the folder.
/// Files are numbered on from `first_number`: a driver's message does not say which stage it means,
/// so the stages of a program must not share numbers.
/// `defines` go before the first line of the file.
Result<ShaderSource> load_shader(const std::filesystem::path& folder,
                                 std::string_view file,
                                 std::string_view defines = {},
                                 std::size_t first_number = 0);

/// The driver's messages with its source numbers replaced by names: "mesh.frag:12: …". Knows the
/// forms "0:12(5): …", "0(12) : …" and "ERROR: 0:12: …".
std::string with_file_names(std::string_view driver_log, const std::vector<std::string>& files);

}  // namespace plumbline::render
