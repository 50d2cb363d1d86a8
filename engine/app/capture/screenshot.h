// Images of the program's own screen, as files.
#pragma once

#include "engine/core/result.h"
#include "engine/render/renderer.h"

#include <filesystem>
#include <string>

namespace plumbline::app {

/// Writes the presented frame to FOLDER/SCENE_DATE_TIME_N.png; the folder is made when missing.
Result<std::filesystem::path> save_screenshot(const render::Renderer& renderer,
                                              const std::filesystem::path& folder,
                                              const std::string& scene);

/// FOLDER/SCENE_DATE_TIME_NEXTENSION that no file has yet; `extension` with its dot, or "".
std::filesystem::path unused_file(const std::filesystem::path& folder,
                                  const std::string& scene,
                                  const std::string& extension);

}  // namespace plumbline::app
