#include "game/commands/shader_worker.h"

#include "engine/core/hash.h"
#include "engine/core/io/files.h"
#include "engine/core/log.h"
#include "engine/render/resources/gpu_materials.h"
#include "game/command_line/refuse.h"
#include "game/offscreen/offscreen_studio.h"

#include <algorithm>
#include <array>
#include <bit>
#include <set>
#include <span>
#include <utility>

namespace plumbline::game {
namespace {

constexpr std::uint32_t kWidth_px = 64;
constexpr std::uint32_t kHeight_px = 36;
constexpr std::uint32_t kShadow_px = 64;
constexpr Vec3f kPlace{0.0F, 0.0F, -3.0F};  // from a camera at the origin
constexpr Vec3f kHand{0.2F, -0.2F, 0.0F};

struct Light {
    bool flashlight{false};
    bool lamp{false};
};
/// Likeliest first; only the first few at levels that take over from low.
constexpr std::array<Light, 4> kLights{
    {{.flashlight = true}, {}, {.lamp = true}, {.flashlight = true, .lamp = true}}};
constexpr std::size_t kLightsOfAll = 2;

/// Items that look each in a way of its own to the shaders.
std::vector<const render::DrawItem*> looks_of(const render::RenderFrame& frame,
                                              const assets::AssetLibrary& library) {
    std::vector<const render::DrawItem*> looks;
    std::set<std::pair<render::FeatureSet, bool>> seen;
    for (const render::DrawItem& item : frame.items) {
        if (item.mesh.value == 0) continue;
        bool is_new = false;
        const bool sways = assets::sways(library.mesh(item.mesh));
        for (const assets::MaterialId id : render::materials_of(frame, item)) {
            const render::FeatureSet features =
                id.value == 0 ? 0 : render::features_of(library.material(id));
            is_new = seen.emplace(features, sways).second || is_new;
        }
        if (is_new) looks.push_back(&item);
    }
    return looks;
}

/// The item alone, a metre large, in that light.
render::RenderFrame image_of(const render::RenderFrame& scene,
                             const render::DrawItem& item,
                             const Aabb& bounds,
                             const Light& light) {
    render::RenderFrame frame;
    frame.width_px = kWidth_px;
    frame.height_px = kHeight_px;
    frame.camera.far_m = scene.camera.far_m;
    frame.ambient = scene.ambient;
    frame.sun = scene.sun;
    frame.sun_shadow = scene.sun_shadow;
    // As it is sampled, but quick to clear.
    if (frame.sun_shadow && std::has_single_bit(frame.sun_shadow->size_px))
        frame.sun_shadow->size_px = kShadow_px;
    frame.sky = scene.sky;
    frame.wind = scene.wind;
    frame.post = scene.post;
    frame.refraction = scene.refraction;
    frame.drops = scene.drops;
    frame.water_rings = scene.water_rings;
    if (light.flashlight)
        frame.flashlight =
            render::Flashlight{.position_world = kHand, .shadow_size_px = kShadow_px};
    if (light.lamp) {
        frame.lights.push_back({.position_world = kPlace, .radius_m = 3.0F, .casts_shadow = true});
        frame.light_shadows = scene.light_shadows;
    }
    const float size_m = std::max(glm::length(bounds.size()), 1e-3F);
    render::DrawItem alone = item;
    alone.world_from_body = glm::translate(
        glm::scale(glm::translate(Mat4f{1.0F}, kPlace), Vec3f{1.0F / size_m}), -bounds.center());
    render::add_item(frame, alone, render::materials_of(scene, item));
    return frame;
}

Result<Done> draw_all(OffscreenStudio& studio) {
    const render::RenderFrame scene = studio.run->frame();
    const assets::AssetLibrary& library = studio.session->library;
    const std::vector<const render::DrawItem*> looks = looks_of(scene, library);
    for (const auto level :
         {render::QualityLevel::Low, render::QualityLevel::Medium, render::QualityLevel::High}) {
        const bool is_low = level == render::QualityLevel::Low;
        for (const Light& light :
             std::span{kLights}.first(is_low ? kLights.size() : kLightsOfAll)) {
            // Only the driver keeps them.
            studio.run->forget_programs();
            for (const render::DrawItem* item : looks) {
                render::RenderFrame frame =
                    image_of(scene, *item, library.mesh(item->mesh).bounds, light);
                frame.quality = render::quality_of(level);
                frame.quality.lod_error_px = 0.0F;  // coarser meshes have the same shaders
                frame.quality.smallest_px = 0.0F;
                if (const Result<Done> drawn = studio.run->draw(frame); !drawn) return drawn;
            }
        }
    }
    return Done{};
}

/// Empty: there is no folder for it.
std::filesystem::path done_file(const app::Session& session,
                                const std::filesystem::path& shader_folder,
                                const render::GlInfo& gl) {
    const std::filesystem::path folder = user_cache_folder();
    if (folder.empty()) return {};
    Hasher hasher;
    const auto add = [&](const std::string& text) { hasher.add(text.c_str(), text.size() + 1); };
    add(gl.renderer);
    add(gl.version);
    std::vector<scene::FileStamp> files = session.files();
    std::error_code failed;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(shader_folder, failed))
        files.push_back(scene::stamp_of(entry.path(), scene::FileUse::Scene));
    std::ranges::sort(files, {}, &scene::FileStamp::path);
    for (const scene::FileStamp& file : files) {
        add(file.path.string());
        hasher.add(&file.bytes, sizeof(file.bytes));
        hasher.add(&file.written, sizeof(file.written));
    }
    return folder / "shaders" / hex_of(hasher.digest());
}

}  // namespace

ExitCode run_shader_worker(const std::filesystem::path& scene, const std::filesystem::path& done) {
    end_with_parent();  // nobody would draw with them
    Result<OffscreenStudio> studio = OffscreenStudio::open_undrawn(scene);
    if (!studio) return refuse(studio.error());
    if (const Result<Done> drawn = draw_all(*studio); !drawn) return refuse(drawn.error());
    if (const Result<Done> written = write_file_and_folder(done, ""); !written)
        return refuse(written.error());
    return ExitCode::Good;
}

void ShadersAhead::start(const app::Session& session,
                         const std::filesystem::path& shader_folder,
                         const render::GlInfo& gl) {
    worker_.reset();
    const std::filesystem::path done = done_file(session, shader_folder, gl);
    std::error_code failed;
    if (done.empty() || std::filesystem::exists(done, failed)) return;
    if (!make_folder(done.parent_path())) return;
    Result<ChildProcess> started = ChildProcess::start(
        {.program = std::filesystem::read_symlink("/proc/self/exe", failed),
         .arguments = {"shader-worker", session.description().file.string(), done.string()},
         .own_group = true,
         .silent = true,
         .priority = Priority::Low});
    if (started) worker_ = std::move(*started);
}

}  // namespace plumbline::game
