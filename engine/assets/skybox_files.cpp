#include "engine/assets/skybox_files.h"

#include <string>
#include <system_error>

namespace plumbline::assets {

std::array<std::filesystem::path, 6> skybox_files(const std::filesystem::path& folder) {
    std::array<std::filesystem::path, 6> files;
    for (std::size_t i = 0; i < files.size(); ++i) {
        for (const char* extension : {".exr", ".png", ".jpg"}) {
            const std::filesystem::path file = folder / (std::string(kSkyboxFaces[i]) + extension);
            std::error_code error;
            if (!std::filesystem::is_regular_file(file, error)) continue;
            files[i] = file;
            break;
        }
    }
    return files;
}

}  // namespace plumbline::assets
