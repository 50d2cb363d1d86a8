// Boxes and the like have shaders of their own, which must show the same.
#include "engine/assets/primitives.h"
#include "tests/engine/render/image_fixture.h"

#include <algorithm>

namespace plumbline::render {
namespace {

/// The same box to the eye; a triangle without area, whose normals differ, keeps it from being faceted.
assets::MeshData with_smooth_triangle(assets::MeshData mesh) {
    const auto last = std::ranges::max_element(
        mesh.vertices, {}, [](const assets::Vertex& v) { return v.normal_body.x; });
    const auto index = static_cast<std::uint32_t>(last - mesh.vertices.begin());
    mesh.indices.insert(mesh.indices.end(), {0U, 0U, index});
    mesh.sub_meshes.back().index_count += 3;
    return mesh;
}

TEST_F(ImageGl, AFacetedBoxLooksLikeASmoothOneOfTheSameNormals) {
    assets::MeshData box = assets::box_mesh({1.0F, 2.0F, 1.0F});
    for (std::size_t i = 0; i < box.vertices.size(); ++i)
        box.vertices[i].color = i / 4 % 2 == 0 ? Vec3f{0.9F, 0.3F, 0.1F} : Vec3f{0.2F, 0.4F, 0.9F};
    const auto faceted = library_.add_mesh("faceted", box);
    const auto smooth = library_.add_mesh("smooth", with_smooth_triangle(box));
    const auto material =
        library_.add_material({.name = "colours", .roughness = 0.35F, .vertex_colors = true});
    const auto image = [&](assets::MeshId mesh, bool at_eye) {
        RenderFrame frame = empty_frame(121, 121);
        frame.camera = camera_at({2.0F, 2.5F, 4.0F}, Vec3f{0.0F});
        frame.sun = DirectionalLight{.direction_world = glm::normalize(Vec3f{-1.0F, -1.0F, -0.4F}),
                                     .radiance = Vec3f{1.5F}};
        frame.sun_shadow = SunShadow{.size_px = 512, .distance_m = 20.0F};
        frame.flashlight = Flashlight{
            .position_world = frame.camera.position_world + Vec3f{at_eye ? 0.0F : 0.3F, 0.0F, 0.0F},
            .direction_world = glm::normalize(-frame.camera.position_world),
            .intensity = Vec3f{9.0F, 8.0F, 7.0F},
            .radius_m = 20.0F,
            .inner_rad = 0.1F,
            .outer_rad = 0.3F};
        for (const float turn_rad : {0.0F, 0.7F}) {
            const Mat4f place =
                glm::rotate(glm::translate(Mat4f{1.0F}, {2.0F * turn_rad, 0.0F, 0.0F}),
                            turn_rad,
                            {0.3F, 1.0F, 0.0F});
            add_item(frame, mesh, material, place);
        }
        return draw(frame);
    };
    for (const bool at_eye : {true, false}) {
        const auto a = image(faceted, at_eye);
        const auto b = image(smooth, at_eye);
        int colored = 0;
        for (std::uint32_t y = 0; y < 121; ++y) {
            for (std::uint32_t x = 0; x < 121; ++x) {
                const Pixel p = pixel_at(a, x, y);
                const Pixel q = pixel_at(b, x, y);
                colored += std::abs(p.r - p.b) > 20;
                ASSERT_NEAR(p.r, q.r, 1) << x << ' ' << y;
                ASSERT_NEAR(p.g, q.g, 1) << x << ' ' << y;
                ASSERT_NEAR(p.b, q.b, 1) << x << ' ' << y;
            }
        }
        EXPECT_GT(colored, 121 * 121 / 10);
    }
}

}  // namespace
}  // namespace plumbline::render
