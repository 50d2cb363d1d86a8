#include "engine/app/capture/screenshot.h"

#include "engine/assets/image/image_import.h"
#include "engine/core/io/files.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <ctime>

namespace plumbline::app {
namespace fs = std::filesystem;

fs::path unused_file(const fs::path& folder,
                     const std::string& scene,
                     const std::string& extension) {
    // The clock may jump back, so the number, not the time, keeps names apart; it begins with one
    // that no other running copy of the program begins with.
    constexpr std::size_t kSceneBytes = 100;  // leaves room for the rest of a file's name
    const std::string stem = fmt::format("{}_{:%Y-%m-%d_%H-%M-%S}",
                                         scene.substr(0, kSceneBytes),
                                         fmt::localtime(std::time(nullptr)));
    std::error_code ignored;
    for (int number = ::getpid();; ++number) {
        fs::path file = folder / fmt::format("{}_{}{}", stem, number, extension);
        if (!fs::exists(file, ignored)) return file;
    }
}

Result<fs::path> save_screenshot(const render::Renderer& renderer,
                                 const fs::path& folder,
                                 const std::string& scene) {
    if (folder.empty())
        return Error{.message = "no folder for screenshots: neither XDG_DATA_HOME nor HOME is set"};
    if (const Result<Done> made = make_folder(folder); !made) return made.error();
    const fs::path file = unused_file(folder, scene, ".png");
    if (const Result<Done> written = assets::write_png(file, renderer.read_pixels()); !written) {
        return written.error();
    }
    return file;
}

}  // namespace plumbline::app
