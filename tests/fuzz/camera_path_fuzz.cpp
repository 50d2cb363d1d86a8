// Camera paths: docs/SCENE-FORMAT.md, "Camera paths".
#include "engine/scene/camera_path.h"
#include "tests/fuzz/fuzz_target.h"

#include <cstdlib>
#include <string_view>

namespace plumbline::fuzz {

std::vector<std::string> seeds() {
    scene::CameraPath path;
    for (int i = 0; i < 20; ++i) {
        const auto turn = static_cast<Real>(i) * 0.1_r;
        path.add(0.1 * i, {.position = {turn, 2, -turn}, .orientation = Quat(0.6_r, 0, 0.8_r, 0)});
    }
    return {path.text(), "# a report\n1 0 0 0 1 0\n0.6 0 0.8 0 1 0.1\n0 0 -1 5 1 0.2\n"};
}

}  // namespace plumbline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using plumbline::scene::CameraPath;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as libFuzzer gives them
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const plumbline::Result<CameraPath> path = CameraPath::parse(text, "mutant");
    if (!path) return path.error().message.empty() ? 1 : 0;
    plumbline::fuzz::note_taken();
    for (int i = -1; i <= 20; ++i) {
        const plumbline::Pose pose = path->at(path->length_s() * i / 19.0);
        if (!plumbline::is_finite(pose.position) || !plumbline::is_finite(pose.orientation))
            std::abort();
    }
    return 0;
}
