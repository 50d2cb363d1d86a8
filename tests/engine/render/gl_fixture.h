// An off-screen context and a renderer for tests, and small scenes to draw.
#pragma once

#include "engine/assets/asset_library.h"
#include "engine/assets/primitives.h"
#include "engine/platform/offscreen.h"
#include "engine/render/renderer.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace plumbline::render {

struct Pixel {
    int r{0};
    int g{0};
    int b{0};
};

inline Pixel pixel_at(const assets::ImageData& image, std::uint32_t x, std::uint32_t y) {
    const std::size_t at = (std::size_t{y} * image.width + x) * 3;
    return {image.bytes[at], image.bytes[at + 1], image.bytes[at + 2]};
}

/// Draws frames off screen. Without a context the tests of the fixture fail: software GL is one of
/// the packages that tests need.
class GlTest : public testing::Test {
protected:
    void SetUp() override {
        auto made = platform::OffscreenContext::create();
        ASSERT_TRUE(made.ok()) << made.error().message;
        context_ = std::move(*made);
        make_renderer(PL_SOURCE_DIR "/shaders");
    }

    void make_renderer(const std::filesystem::path& shaders, const GpuLimits& limits = {}) {
        auto made = Renderer::create(
            context_->gl_loader(), PresentTarget::Offscreen, shaders, library_, limits);
        ASSERT_TRUE(made.ok()) << made.error().message;
        renderer_ = std::move(*made);
    }

    assets::MaterialId unlit(const Vec3f& color) {
        return library_.add_material(
            {.name = "unlit", .shading = assets::Shading::Unlit, .base_color = color});
    }
    assets::MaterialId matt(const Vec3f& color) {
        return library_.add_material({.name = "matt", .base_color = color, .roughness = 1.0F});
    }

    void add_item(RenderFrame& frame,
                  assets::MeshId mesh,
                  assets::MaterialId material,
                  const Mat4f& world_from_body) {
        render::add_item(frame, {.mesh = mesh, .world_from_body = world_from_body}, {&material, 1});
    }
    /// Matt to the letter: no highlight, no mirrored rim.
    assets::MaterialId chalk() {
        return library_.add_material({.name = "chalk",
                                      .shading = assets::Shading::BlinnPhong,
                                      .base_color = Vec3f{1.0F},
                                      .shininess = 1.0F,
                                      .specular = 0.0F});
    }
    void add_box(RenderFrame& frame,
                 const Vec3f& size_m,
                 const Vec3f& center_world,
                 assets::MaterialId material) {
        const std::string name = "box " + std::to_string(size_m.x) + " " +
                                 std::to_string(size_m.y) + " " + std::to_string(size_m.z);
        const auto mesh = library_.add_mesh(name, assets::box_mesh(size_m));
        add_item(frame, mesh, material, glm::translate(Mat4f{1.0F}, center_world));
    }

    assets::ImageData draw(const RenderFrame& frame) {
        render::draw(*renderer_, frame);
        return renderer_->read_pixels();
    }

    std::uint64_t bytes_of(std::string_view owner) const {
        for (const GpuBytes& entry : renderer_->gpu_bytes()) {
            if (entry.owner == owner) return entry.bytes;
        }
        ADD_FAILURE() << "no owner " << owner;
        return 0;
    }

    std::unique_ptr<platform::OffscreenContext> context_;
    assets::AssetLibrary library_;
    std::unique_ptr<Renderer> renderer_;
};

/// Looks from `eye` at `target`.
inline Camera camera_at(const Vec3f& eye_world, const Vec3f& target_world) {
    const Vec3f forward = glm::normalize(target_world - eye_world);
    const Vec3f up =
        std::abs(forward.y) > 0.99F ? Vec3f{0.0F, 0.0F, -1.0F} : Vec3f{0.0F, 1.0F, 0.0F};
    return {.position_world = eye_world,
            .orientation = glm::quatLookAt(forward, up),
            .fov_y_rad = radians_from_degrees(60.0F)};
}

inline RenderFrame empty_frame(std::uint32_t width_px, std::uint32_t height_px) {
    RenderFrame frame;
    frame.width_px = width_px;
    frame.height_px = height_px;
    frame.clear_color = Vec3f{0.0F};
    frame.ambient = Vec3f{0.0F};
    return frame;
}

}  // namespace plumbline::render
