// The renderer alone on the peer scene's boxes: no physics, no scene files. Prints CPU ms a frame
// of all threads, and of each pass.
//
//   render_boxes [--boxes N] [--frames N] [--size WxH] [--still] [--image F.png] …
//   --no-sun-shadow --no-flashlight --no-sky --blinn: leave one out, to see what it costs
#include "engine/assets/asset_library.h"
#include "engine/assets/image/image_import.h"
#include "engine/assets/primitives.h"
#include "engine/core/process/process_memory.h"
#include "engine/core/time/stopwatch.h"
#include "engine/platform/offscreen.h"
#include "engine/render/renderer.h"
#include "tests/benchmarks/box_places.h"

#include <fmt/format.h>

#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace plumbline;

struct Options {
    int boxes{1000};
    int frames{60};
    std::uint32_t width_px{1280};
    std::uint32_t height_px{720};
    bool still{false};
    bool sun_shadow{true};
    bool flashlight{true};
    bool sky{true};
    bool blinn_phong{false};
    std::string image{};
};

Options parse(int argc, char** argv) {
    Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string_view option = argv[i];
        const char* value = i + 1 < argc ? argv[i + 1] : "";
        if (option == "--boxes") options.boxes = std::atoi(value);
        if (option == "--frames") options.frames = std::atoi(value);
        if (option == "--image") options.image = value;
        if (option == "--size") {
            const std::string size{value};
            options.width_px = static_cast<std::uint32_t>(std::atoi(size.c_str()));
            options.height_px =
                static_cast<std::uint32_t>(std::atoi(size.substr(size.find('x') + 1).c_str()));
        }
        if (option == "--still") options.still = true;
        if (option == "--no-sun-shadow") options.sun_shadow = false;
        if (option == "--no-flashlight") options.flashlight = false;
        if (option == "--no-sky") options.sky = false;
        if (option == "--blinn") options.blinn_phong = true;
    }
    return options;
}

Mat4f box_pose(int i, int frame) {
    const Vec4f place = bench::box_place(i, frame);
    return glm::rotate(glm::translate(Mat4f{1.0F}, Vec3f{place}), place.w, Vec3f{0.0F, 1.0F, 0.0F});
}

render::RenderFrame make_frame(const Options& options) {
    render::RenderFrame frame;
    frame.width_px = options.width_px;
    frame.height_px = options.height_px;
    frame.camera.position_world = {0.0F, 9.0F, 24.0F};
    frame.camera.orientation =
        glm::quatLookAt(glm::normalize(Vec3f{0.0F, -5.0F, -24.0F}), Vec3f{0.0F, 1.0F, 0.0F});
    frame.camera.fov_y_rad = radians_from_degrees(60.0F);
    frame.ambient = Vec3f{0.1F};
    frame.sun = render::DirectionalLight{
        .direction_world = glm::normalize(Vec3f{-16.0F, -40.0F, -12.0F}), .radiance = Vec3f{3.0F}};
    if (options.sun_shadow) frame.sun_shadow = render::SunShadow{2048, 60.0F};
    if (options.flashlight) {
        frame.flashlight =
            render::Flashlight{.position_world = {0.3F, 8.7F, 24.0F},
                               .direction_world = glm::normalize(Vec3f{0.0F, -5.0F, -24.0F}),
                               .intensity = Vec3f{600.0F},
                               .radius_m = 60.0F,
                               .outer_rad = radians_from_degrees(22.0F)};
    }
    if (options.sky) frame.sky = render::Sky{PL_SOURCE_DIR "/assets/skies/garden"};
    return frame;
}

int run(const Options& options) {
    auto context = platform::OffscreenContext::create();
    if (!context) {
        fmt::print(stderr, "{}\n", context.error().message);
        return 3;
    }
    assets::AssetLibrary library;
    auto created = render::Renderer::create((*context)->gl_loader(),
                                            render::PresentTarget::Offscreen,
                                            PL_SOURCE_DIR "/shaders",
                                            library);
    if (!created) {
        fmt::print(stderr, "{}\n", created.error().message);
        return 3;
    }
    render::Renderer& renderer = **created;
    const auto shading = options.blinn_phong ? assets::Shading::BlinnPhong : assets::Shading::Pbr;
    const auto box = library.add_mesh("box", assets::box_mesh(Vec3f{1.0F}));
    const auto ground = library.add_mesh("ground", assets::box_mesh(Vec3f{120.0F, 1.0F, 120.0F}));
    const std::array box_look{library.add_material(
        {.name = "box", .shading = shading, .base_color = {0.7F, 0.45F, 0.25F}})};
    const std::array ground_look{library.add_material(
        {.name = "ground", .shading = shading, .base_color = {0.35F, 0.4F, 0.3F}})};

    render::RenderFrame frame = make_frame(options);
    std::map<std::string_view, double> pass_cpu_ms;
    std::map<std::string_view, double> pass_gpu_ms;
    double start_cpu_s = 0.0;
    constexpr int kWarmUp = 3;
    for (int i = -kWarmUp; i < options.frames; ++i) {
        if (i == 0) start_cpu_s = process_cpu_s();
        frame.items.clear();
        frame.material_ids.clear();
        const Mat4f ground_pose = glm::translate(Mat4f{1.0F}, Vec3f{0.0F, -0.5F, 0.0F});
        add_item(frame, {.mesh = ground, .world_from_body = ground_pose}, ground_look);
        for (int b = 0; b < options.boxes; ++b) {
            const Mat4f pose = box_pose(b, options.still ? 0 : i);
            add_item(frame, {.mesh = box, .world_from_body = pose}, box_look);
        }
        if (i == -kWarmUp) renderer.prepare(frame);
        draw(renderer, frame);
        if (i == -kWarmUp) {
            renderer.read_pixels();  // waits for the image
            fmt::print("first frame after {:.0f} ms\n", seconds_since_process_start() * 1e3);
        }
        for (const auto& pass : renderer.stats().passes) {
            if (i < 0) continue;
            pass_cpu_ms[pass.name] += pass.cpu_ms / options.frames;
            pass_gpu_ms[pass.name] += pass.gpu_ms / options.frames;
        }
    }
    const auto image = renderer.read_pixels();
    const double cpu_ms = (process_cpu_s() - start_cpu_s) * 1e3 / options.frames;
    if (!options.image.empty()) {
        const auto written = assets::write_png(options.image, image);
        if (!written) fmt::print(stderr, "{}\n", written.error().message);
    }
    const auto& stats = renderer.stats();
    fmt::print("{}\n{} boxes: {:.1f} CPU ms a frame; {} draws, {} instances; peak {:.0f} MiB\n",
               renderer.gl().renderer,
               options.boxes,
               cpu_ms,
               stats.draw_calls,
               stats.instances,
               static_cast<double>(peak_resident_bytes()) / (1024.0 * 1024.0));
    for (const auto& [name, ms] : pass_cpu_ms) {
        fmt::print(
            "  {:<18} calling thread {:6.2f} ms, GPU {:6.2f} ms\n", name, ms, pass_gpu_ms[name]);
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    return run(parse(argc, argv));
}
