#include "engine/render/passes/screen/motion_vectors.h"

#include "engine/render/culling/frustum.h"

#include <glad/gl.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::render {
namespace {

// A thing is drawn wherever it was, at moments so far apart.
constexpr float kBetweenMoments_px = 6.0F;
constexpr float kMostMoments = 16.0F;
// What moves less is as sharp as what stands still.
constexpr float kLeastPath_px = 0.5F;

/// How far the corners of the box move across the image at most.
float longest_way_px(const Aabb& box, const Mat4f& now, const Mat4f& before, const Vec2f& size_px) {
    float longest_px = 0.0F;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec4f at{(corner & 1) != 0 ? box.max.x : box.min.x,
                       (corner & 2) != 0 ? box.max.y : box.min.y,
                       (corner & 4) != 0 ? box.max.z : box.min.z,
                       1.0F};
        const Vec4f to = now * at;
        const Vec4f from = before * at;
        const Vec2f way = Vec2f{to} / std::max(to.w, 1e-3F) - Vec2f{from} / std::max(from.w, 1e-3F);
        longest_px = std::max(longest_px, glm::length(way * 0.5F * size_px));
    }
    return longest_px;
}

/// The thing at each moment; as the shutter closes, at last.
void add_moments(const MovedMesh& moved, float path_px, std::vector<Instance>& instances) {
    const Mat4f rows = glm::transpose(moved.world_from_body);
    const float count = std::clamp(std::ceil(path_px / kBetweenMoments_px), 1.0F, kMostMoments);
    for (float moment = count; moment >= 0.0F; moment -= 1.0F) {
        instances.push_back({.row_x = rows[0],
                             .row_y = rows[1],
                             .row_z = rows[2],
                             .tint = Vec4f{moment / count, 0.0F, 0.0F, 0.0F}});
    }
}

}  // namespace

void MotionVectors::find_seen(const MotionBlur& blur,
                              const ShutterView& view,
                              const Vec2f& size_px,
                              const assets::AssetLibrary& library) {
    seen_.clear();
    instances_.clear();
    const Frustum frustum(view.clip_from_world);
    for (const MovedMesh& moved : blur.moved) {
        if (moved.mesh.value == 0) continue;
        const assets::MeshData& mesh = library.mesh(moved.mesh);
        if (!frustum.may_touch(transformed(mesh.bounds, moved.world_from_body))) continue;
        const float path_px =
            longest_way_px(mesh.bounds,
                           view.clip_from_world * moved.world_from_body,
                           view.clip_before_from_world * moved.world_from_body_before,
                           size_px);
        if (path_px < kLeastPath_px) continue;
        const auto first = static_cast<std::uint32_t>(instances_.size());
        add_moments(moved, path_px, instances_);
        seen_.push_back(
            {.moved = &moved,
             .run = {.mesh = moved.mesh,
                     .index_count = static_cast<std::uint32_t>(mesh.indices.size()),
                     .first_instance = first,
                     .instance_count = static_cast<std::uint32_t>(instances_.size()) - first}});
    }
}

bool MotionVectors::make_image(const gl::Texture& depth) {
    framebuffer_ = {};
    if (image_.width() != depth.width() || image_.height() != depth.height())
        image_ = gl::Texture::target(
            gl::TargetFormat::HdrColor, depth.width(), depth.height(), gl::Filter::Nearest);
    framebuffer_ = gl::Framebuffer{&image_, &depth};
    return framebuffer_.complete();
}

const gl::Texture* MotionVectors::render(const MotionBlur& blur,
                                         const ShutterView& view,
                                         const gl::Texture& depth,
                                         PassContext context) {
    const Vec2f size_px{depth.width(), depth.height()};
    find_seen(blur, view, size_px, context.resources.library);
    const gl::Program* program = seen_.empty() ? nullptr : context.program(kVelocityShader);
    if (program == nullptr || !make_image(depth)) {
        *this = {};
        return nullptr;
    }
    gl::draw_into(framebuffer_.name(), depth.width(), depth.height());
    constexpr std::array<float, 4> kNothing{};
    glClearBufferfv(GL_COLOR, 0, kNothing.data());
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_FALSE);
    // Its own depth, computed by another shader, must not hide a thing.
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-1.0F, -4.0F);
    program->use();
    glUniform2f(program->location("size_px"), size_px.x, size_px.y);
    moments_.upload(instances_);
    for (const Seen& seen : seen_) {
        const Mat4f before = view.clip_before_from_world * seen.moved->world_from_body_before;
        glUniformMatrix4fv(
            program->location("clip_before_from_body"), 1, GL_FALSE, glm::value_ptr(before));
        const GpuMesh& mesh = context.resources.meshes.get(seen.run.mesh);
        draw_instances(mesh, MeshDetail::Full, moments_, seen.run);
        count_draw(context.stats, seen.run);
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
    return &image_;
}

}  // namespace plumbline::render
