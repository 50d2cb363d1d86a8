// Meshes that change from frame to frame, as skins and cloth do: image and shadow follow at once.
#include "tests/engine/render/gl_fixture.h"

namespace plumbline::render {
namespace {

class BendingMeshGl : public GlTest {
protected:
    static constexpr std::uint32_t kSide_px = 300;
    static constexpr float kHalf_m = 6.0F;

    /// A post of 1 x 2 x 1 m on the ground, seen from high above, in a sun from the left at 45
    /// degrees: its shadow reaches from its foot 2 m to the right.
    void SetUp() override {
        GlTest::SetUp();
        frame_ = empty_frame(kSide_px, kSide_px);
        frame_.camera = camera_at({0.0F, 60.0F, 0.0F}, Vec3f{0.0F});
        frame_.camera.fov_y_rad = 2.0F * std::atan(kHalf_m / 60.0F);
        add_box(frame_, {40.0F, 1.0F, 40.0F}, {0.0F, -0.5F, 0.0F}, matt(Vec3f{0.8F}));
        post_ = library_.add_mesh("post", assets::box_mesh({1.0F, 2.0F, 1.0F}));
        add_item(frame_,
                 post_,
                 matt({0.8F, 0.1F, 0.1F}),
                 glm::translate(Mat4f{1.0F}, Vec3f{0.0F, 1.0F, 0.0F}));
        frame_.sun = DirectionalLight{.direction_world = glm::normalize(Vec3f{1.0F, -1.0F, 0.0F}),
                                      .radiance = Vec3f{3.0F}};
        frame_.sun_shadow = SunShadow{.size_px = 2048, .distance_m = 80.0F};
    }

    /// Moves every vertex of the post.
    void shift(const Vec3f& way) {
        assets::MeshData& mesh = library_.change_mesh(post_);
        for (assets::Vertex& vertex : mesh.vertices) vertex.position_body += way;
        mesh.bounds = assets::bounds_of(mesh);
    }
    static int ground(const assets::ImageData& image, float x, float z) {
        const auto pixel = [](float at_m) {
            return static_cast<std::uint32_t>((at_m + kHalf_m) / (2.0F * kHalf_m) * kSide_px);
        };
        return pixel_at(image, pixel(x), pixel(z)).g;
    }

    assets::MeshId post_{};
    RenderFrame frame_;
};

TEST_F(BendingMeshGl, ItsShadowIsThatOfTheFrame) {
    // A model's parts cannot move as far as the scene knows, and can.
    for (const bool is_static : {false, true}) {
        frame_.items[1].is_static = is_static;
        const auto before = draw(frame_);
        EXPECT_LT(ground(before, 1.5F, 0.0F), 20);
        EXPECT_GT(ground(before, 1.5F, 3.0F), 180);
        shift({0.0F, 0.0F, 3.0F});
        const auto after = draw(frame_);
        EXPECT_GT(ground(after, 1.5F, 0.0F), 180);
        EXPECT_LT(ground(after, 1.5F, 3.0F), 20);
        // At rest the map is kept.
        draw(frame_);
        EXPECT_EQ(renderer_->stats().shadow_passes_rendered, 0U);
        shift({0.0F, 0.0F, -3.0F});
    }
}

// FAULTS 29: nothing was seen of 1 mm but its colour.
TEST_F(BendingMeshGl, ShadowsKeepTheirShapeAtEveryScale) {
    const Mat4f places[] = {frame_.items[0].world_from_body, frame_.items[1].world_from_body};
    for (const float scale : {1e-4F, 1e-2F, 1.0F, 1e3F}) {
        for (std::size_t i = 0; i < 2; ++i) {
            frame_.items[i].world_from_body = glm::scale(Mat4f{1.0F}, Vec3f{scale}) * places[i];
        }
        frame_.camera.position_world = {0.0F, 60.0F * scale, 0.0F};
        frame_.camera.near_m = 10.0F * scale;
        frame_.camera.far_m = 100.0F * scale;
        frame_.sun_shadow->distance_m = 80.0F * scale;
        const auto image = draw(frame_);
        for (const float x : {0.7F, 1.5F, 2.3F}) EXPECT_LT(ground(image, x, 0.0F), 20) << scale;
        for (const float x : {-0.7F, 2.7F}) EXPECT_GT(ground(image, x, 0.0F), 180) << scale;
    }
}

}  // namespace
}  // namespace plumbline::render
