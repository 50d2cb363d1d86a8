#include "game/commands/render_command.h"

#include "engine/assets/image/image_import.h"
#include "engine/core/io/files.h"
#include "engine/core/io/output.h"
#include "engine/core/process/interrupt.h"
#include "engine/core/process/process_memory.h"
#include "engine/core/text/printable.h"
#include "engine/scene/camera_path.h"
#include "engine/scene/scene_file.h"
#include "engine/scene/simulation/sun_hour.h"
#include "game/command_line/camera_text.h"
#include "game/command_line/hour_option.h"
#include "game/command_line/refuse.h"
#include "game/offscreen/contact_sheet.h"
#include "game/offscreen/frame_files.h"
#include "game/offscreen/offscreen_studio.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iostream>

namespace plumbline::game {
namespace {

Error bad_option(std::string message) {
    return {.message = std::move(message), .exit_code = ExitCode::BadUsage};
}

constexpr const char* kSheet = "contact_sheet.png";

/// Of a size as the command line has it; empty: the scene's own.
Result<OffscreenStudio> open_studio(const std::string& scene_name,
                                    const std::string& size,
                                    app::OffscreenDef def) {
    const Result<DataFolders> folders = find_data_folders();
    if (!folders) return folders.error();
    const Result<std::filesystem::path> scene =
        scene::find_scene(scene_name, scene::scene_folders(folders->assets));
    if (!scene) return scene.error();
    int width = 0;
    int height = 0;
    if (!size.empty() && !parse_size(size, width, height)) {
        return bad_option(fmt::format("--size {}: expected WIDTHxHEIGHT, 1 to 16384 each", size));
    }
    def.width_px = static_cast<std::uint32_t>(width);
    def.height_px = static_cast<std::uint32_t>(height);
    return OffscreenStudio::open_undrawn(*scene, def);
}

Result<std::optional<assets::Shading>> parse_shading(const std::string& name) {
    if (name.empty()) return std::optional<assets::Shading>{};
    if (name == "pbr") return std::optional{assets::Shading::Pbr};
    if (name == "blinn_phong") return std::optional{assets::Shading::BlinnPhong};
    if (name == "unlit") return std::optional{assets::Shading::Unlit};
    return bad_option(fmt::format("--shading {}: expected pbr, blinn_phong or unlit", name));
}

/// A name without an ending, of a folder or of nothing yet.
bool wants_folder(const RenderOptions& options) {
    if (options.frames < 2 || options.out.empty() || options.out.has_extension() ||
        is_standard_output(options.out))
        return false;
    std::error_code failed;
    const auto type = std::filesystem::status(options.out, failed).type();
    return type == std::filesystem::file_type::directory ||
           type == std::filesystem::file_type::not_found;
}

/// The view after a share of the way round what is looked at, about the scene's up.
scene::ViewPoint turned(scene::ViewPoint view,
                        const scene::SceneDescription& scene,
                        Real angle_rad) {
    if (angle_rad == 0) return view;
    const Vec3 middle = scene.viewer ? scene.viewer->center_m : scene.camera.target_m;
    const Quat turn = glm::angleAxis(angle_rad, scene.viewer ? scene.viewer->up : Vec3{0, 1, 0});
    for (Pose* pose : {&view.world_from_camera, &view.world_from_hand}) {
        pose->position = middle + turn * (pose->position - middle);
        pose->orientation = turn * pose->orientation;
    }
    return view;
}

/// Where the image goes; empty when only a report, a film or all frames are asked for. Found to be writable.
Result<std::filesystem::path> image_file(const RenderOptions& options) {
    std::filesystem::path file = wants_folder(options) ? std::filesystem::path() : options.out;
    if (options.out.empty() && options.report.empty() && options.video.empty()) {
        const std::string name = std::filesystem::path(options.scene).stem().string();
        const Result<std::filesystem::path> unnamed = default_output("shots", name, ".png");
        if (!unnamed) return unnamed;
        file = *unnamed;
    }
    for (const std::filesystem::path& each : {file, options.report}) {
        if (const Result<Done> open = check_output(each); !open) return open.error();
    }
    return file;
}

void switch_on(const RenderOptions& options, scene::LiveSwitches& switches) {
    if (options.textures) switches.textures = true;
    if (options.shadows) switches.turn("sun_shadow", true);
    if (options.flashlight) switches.turn("flashlight", true);
    if (options.fog) switches.turn("fog", true);
    if (options.sun_degps != 0)
        switches.sun_rotation_radps = static_cast<float>(radians_from_degrees(options.sun_degps));
}

std::uint64_t steps_in(double seconds, const scene::Simulation& simulation) {
    return static_cast<std::uint64_t>(std::llround(std::max(0.0, seconds) / simulation.step_s()));
}

Result<Done> draw_frames(const RenderOptions& options,
                         OffscreenStudio& studio,
                         const scene::ViewPoint& view,
                         const std::optional<scene::CameraPath>& path) {
    scene::Simulation& simulation = *studio.session->simulation;
    Result<FrameFiles> files =
        FrameFiles::open({.folder = wants_folder(options) ? options.out : std::filesystem::path(),
                          .video = options.video,
                          .width_px = studio.width_px,
                          .height_px = studio.height_px,
                          .frames_per_s = simulation.description().accuracy.step_hz});
    if (!files) return files.error();
    switch_on(options, simulation.switches);
    if (const Result<Done> set = set_hour(options.hour, simulation); !set) return set.error();
    app::OffscreenRun& run = *studio.run;
    run.simulate(steps_in(options.at_s, simulation));
    for (std::uint64_t frame = 0; frame < std::max<std::uint64_t>(options.frames, 1); ++frame) {
        if (interrupted()) return Done{};
        if (frame > 0) run.simulate(1);
        const double share = static_cast<double>(frame) / static_cast<double>(options.frames);
        const double angle_rad = radians_from_degrees(options.orbit_deg * share);
        const scene::ViewPoint seen =
            path ? view_at(path->at(static_cast<double>(frame) * simulation.step_s()),
                           view.fov_y_rad)
                 : turned(view, simulation.description(), static_cast<Real>(angle_rad));
        if (const Result<Done> drawn = run.draw(seen); !drawn) return drawn;
        if (const Result<Done> kept = files->take(run); !kept) return kept;
    }
    const PollsInterrupts closing;  // a film takes as long as ffmpeg needs
    return files->close();
}

}  // namespace

ExitCode run_render(const RenderOptions& options, const CommonOptions&) {
    return_large_blocks_early();
    const Result<std::optional<assets::Shading>> shading = parse_shading(options.shading);
    if (!shading) return refuse(shading.error());
    std::optional<scene::CameraPath> path;
    if (!options.camera_path.empty()) {
        Result<scene::CameraPath> read = scene::CameraPath::read(options.camera_path);
        if (!read) return refuse(read.error());
        path = std::move(*read);
    }
    const Result<std::filesystem::path> image = image_file(options);
    if (!image) return refuse(image.error());
    Result<OffscreenStudio> studio =
        open_studio(options.scene,
                    options.size,
                    {.shader_folder = {},
                     .shading = *shading,
                     .level = render::quality_level_named(options.level),
                     .render_scale = options.render_scale});
    if (!studio) return refuse(studio.error());

    scene::ViewPoint view = first_view(studio->session->simulation->description());
    if (!options.camera.empty()) {
        const std::optional<scene::ViewPoint> asked = parse_camera(options.camera, view.fov_y_rad);
        if (!asked)
            return refuse(
                bad_option(fmt::format("--camera {}: expected x,y,z,yaw,pitch", options.camera)));
        view = *asked;
    }
    if (const Result<Done> drawn = draw_frames(options, *studio, view, path); !drawn)
        return refuse(drawn.error());
    if (interrupted()) return ExitCode::Interrupted;
    const app::OffscreenRun& run = *studio->run;
    if (!image->empty()) {
        if (const Result<Done> written = assets::write_png(*image, run.pixels()); !written)
            return refuse(written.error());
    }
    if (options.out.empty() && !image->empty()) std::cout << printable(image->string()) << '\n';
    if (!options.report.empty()) {
        if (const Result<Done> written = write_output(options.report, run.report_json());
            !written) {
            return refuse(written.error());
        }
    }
    return ExitCode::Good;
}

ExitCode run_tour(const TourOptions& options, const CommonOptions&) {
    return_large_blocks_early();
    const Result<Done> open = make_output_folder(options.out, {kSheet});
    if (!open) return refuse(open.error());
    Result<OffscreenStudio> studio = open_studio(options.scene, options.size, {});
    if (!studio) return refuse(studio.error());

    const scene::SceneDescription& scene = studio->session->simulation->description();
    std::vector<assets::ImageData> images;
    for (const scene::ViewDescription& stop : tour_stops(scene)) {
        if (interrupted()) return ExitCode::Interrupted;
        scene::LiveSwitches& switches = studio->session->simulation->switches;
        switches.turn("flashlight", stop.flashlight);
        switches.light_scale = stop.light_scale;
        if (scene.time)
            set_hour(*studio->session->simulation, stop.hour.value_or(scene.time->hour));
        studio->run->simulate(
            steps_in(static_cast<double>(stop.wait_s), *studio->session->simulation));
        const Result<Done> drawn =
            studio->run->draw(view_from(stop.position_m, stop.target_m, scene.camera.fov_y_rad));
        if (!drawn) return refuse(drawn.error());
        images.push_back(studio->run->pixels());
        const std::filesystem::path file =
            options.out / fmt::format("{:02}_{}.png", images.size(), stop.name);
        if (const Result<Done> written = assets::write_png(file, images.back()); !written) {
            return refuse(written.error());
        }
        std::cout << printable(file.string()) << '\n';
    }
    const std::filesystem::path sheet = options.out / kSheet;
    if (const Result<Done> written = assets::write_png(sheet, contact_sheet(images)); !written) {
        return refuse(written.error());
    }
    std::cout << "contact sheet: " << printable(sheet.string()) << '\n';
    return ExitCode::Good;
}

}  // namespace plumbline::game
