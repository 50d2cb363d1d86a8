// What helps to look at a model by itself: grid, axes, normals, backgrounds, no ground.
#include "engine/effects/effect_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace plumbline::effects {
namespace {

constexpr int kGridHalf = 10;
constexpr std::size_t kMostNormals = 50'000;
constexpr float kNormalShare = 0.02F;  // of the model's radius
constexpr std::string_view kGroundName = "ground";

/// A tenth of the radius or more, as people count: 1, 2 or 5 times a power of ten.
float grid_step_m(float radius_m) {
    const float least = radius_m * 0.2F;
    const float power = std::pow(10.0F, std::floor(std::log10(least)));
    for (const float factor : {1.0F, 2.0F, 5.0F}) {
        if (factor * power >= least) return factor * power;
    }
    return 10.0F * power;
}

/// For the sake of what is far, to half the distance of the nearest thing: the corners of the
/// image lie closer to the plane of the eye than to the eye.
void push_near_plane(const assets::AssetLibrary& library,
                     float floor_m,
                     render::RenderFrame& frame) {
    const Vec3f& eye = frame.camera.position_world;
    float nearest_m = std::abs(eye.y - floor_m);  // the grid
    for (const render::DrawItem& item : frame.items) {
        const Aabb box = transformed(library.mesh(item.mesh).bounds, item.world_from_body);
        nearest_m = std::min(nearest_m, glm::distance(eye, glm::clamp(eye, box.min, box.max)));
    }
    frame.camera.near_m = std::max(frame.camera.near_m, 0.5F * nearest_m);
}

void hide(assets::MeshId mesh, render::RenderFrame& frame) {
    std::erase_if(frame.items, [&](const render::DrawItem& item) { return item.mesh == mesh; });
}

void add_grid(const Vec3f& center, float radius_m, LineList& lines) {
    const float step_m = grid_step_m(radius_m);
    const float half_m = step_m * kGridHalf;
    const float x = std::round(center.x / step_m) * step_m;
    const float z = std::round(center.z / step_m) * step_m;
    for (int i = -kGridHalf; i <= kGridHalf; ++i) {
        const float at_m = step_m * static_cast<float>(i);
        const Vec3f color{i == 0 ? 0.6F : 0.3F};
        lines.add({x + at_m, center.y, z - half_m}, {x + at_m, center.y, z + half_m}, color);
        lines.add({x - half_m, center.y, z + at_m}, {x + half_m, center.y, z + at_m}, color);
    }
}

void add_axes(float radius_m, LineList& lines) {
    for (int axis = 0; axis < 3; ++axis) {
        Vec3f direction{0.0F};
        direction[axis] = 1.0F;
        lines.add(Vec3f{0.0F}, direction * (radius_m * 1.2F), direction);
    }
}

/// As the mesh is drawn now; of fine meshes every so many.
void add_normals(const assets::MeshData& mesh,
                 const Mat4f& world_from_body,
                 float radius_m,
                 render::RenderFrame& frame) {
    const Mat3f normals = glm::transpose(glm::inverse(Mat3f{world_from_body}));
    const std::size_t step = std::max<std::size_t>(1, mesh.vertices.size() / kMostNormals);
    for (std::size_t i = 0; i < mesh.vertices.size(); i += step) {
        const assets::Vertex& vertex = mesh.vertices[i];
        const Vec3f from{world_from_body * Vec4f{vertex.position_body, 1.0F}};
        const Vec3f along = normalize_or(normals * vertex.normal_body, Vec3f{0.0F});
        frame.lines.add(from, from + along * (radius_m * kNormalShare), {0.1F, 0.4F, 1.0F});
    }
}

void show_aids(const scene::Simulation& simulation, render::RenderFrame& frame) {
    const scene::LiveSwitches& switches = simulation.switches;
    const auto radius_m = static_cast<float>(simulation.description().model_radius_m);
    // The bottom of what may be far from the origin, lifted a hair so that both are seen.
    const Vec3f center(simulation.description().camera.target_m);
    float floor_m = 0.0F;
    assets::MeshId ground{};
    for (auto [entity, name, visual, transform] :
         simulation.registry
             .view<const scene::Name, const scene::Visual, const scene::Transform>()) {
        if (name.text != kGroundName) continue;
        floor_m = static_cast<float>(transform.world_from_body.position.y);
        ground = visual.mesh;
    }
    if (!switches.ground) hide(ground, frame);
    if (switches.normals) {
        for (const render::DrawItem& item : frame.items) {
            if (item.mesh != ground)
                add_normals(
                    simulation.library().mesh(item.mesh), item.world_from_body, radius_m, frame);
        }
    }
    push_near_plane(simulation.library(), floor_m, frame);
    if (switches.grid)
        add_grid({center.x, floor_m + radius_m * 1e-3F, center.z}, radius_m, frame.lines);
    if (switches.axes) add_axes(radius_m, frame.lines);
    constexpr std::array<Vec3f, 4> kBackgrounds{
        Vec3f{0.0F}, Vec3f{1.0F}, Vec3f{0.18F}, Vec3f{0.0F}};
    const auto chosen = static_cast<std::size_t>(switches.background) % kBackgrounds.size();
    if (chosen != 0) frame.clear_color = kBackgrounds[chosen];
}

Callers callers_of_viewer_aids(const scene::Simulation& simulation) {
    if (!simulation.description().shows_model) return {};
    return {"a model by itself"};
}

}  // namespace

EffectRow viewer_aids() {
    return with_effect<FrameEffect<&show_aids>>({.called_for_by = &callers_of_viewer_aids});
}

}  // namespace plumbline::effects
