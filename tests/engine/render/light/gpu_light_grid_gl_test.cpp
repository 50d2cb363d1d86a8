// Ambient light indoors.
#include "tests/engine/render/sky/sky_fixture.h"

namespace plumbline::render {
namespace {

class IndirectGl : public SkyGl {
protected:
    /// A room of 4 x 3 x 4 m whose side at x = 2 is open, under a grey sky.
    RenderFrame open_room() {
        for (const char* name : {"px", "nx", "py", "ny", "pz", "nz"})
            write_face(name, {128, 128, 128});
        RenderFrame frame = looking({-1.0F, 0.0F, 0.0F});
        frame.ambient = Vec3f{0.2F};
        frame.indirect =
            IndirectLight{.min_world = {-2.0F, -1.5F, -2.0F}, .max_world = {2.0F, 1.5F, 2.0F}};
        const auto wall = [&](const Vec3f& size_m, const Vec3f& place) {
            add_box(frame, size_m, place, matt(Vec3f{0.6F}));
            frame.items.back().is_static = true;
        };
        wall({4.4F, 0.2F, 4.4F}, {0.0F, -1.6F, 0.0F});
        wall({4.4F, 0.2F, 4.4F}, {0.0F, 1.6F, 0.0F});
        wall({0.2F, 3.4F, 4.4F}, {-2.1F, 0.0F, 0.0F});
        wall({4.4F, 3.4F, 0.2F}, {0.0F, 0.0F, -2.1F});
        wall({4.4F, 3.4F, 0.2F}, {0.0F, 0.0F, 2.1F});
        return frame;
    }
    int seen(const RenderFrame& frame, const Vec3f& target) {
        RenderFrame turned = frame;
        turned.camera = camera_at(Vec3f{0.0F}, target);
        return pixel_at(draw(turned), 32, 32).g;
    }
};

TEST_F(IndirectGl, TheBackOfARoomIsDarkerThanBesideItsOpenSide) {
    RenderFrame frame = open_room();
    const Vec3f back{-1.7F, 0.0F, 1.99F};
    const Vec3f front{1.7F, 0.0F, 1.99F};
    EXPECT_LT(seen(frame, back) + 20, seen(frame, front));
    EXPECT_GT(bytes_of("indirect_light"), 0U);
    frame.indirect.reset();
    EXPECT_NEAR(seen(frame, back), seen(frame, front), 3) << "flat without it";
    EXPECT_EQ(bytes_of("indirect_light"), 0U);
}

TEST_F(IndirectGl, OutsideOfItsBoxNothingChanges) {
    RenderFrame frame = open_room();
    add_box(frame, Vec3f{1.0F}, {6.0F, 0.0F, 0.0F}, matt(Vec3f{0.6F}));
    const int with = seen(frame, {6.0F, 0.0F, 0.0F});
    frame.indirect.reset();
    EXPECT_EQ(with, seen(frame, {6.0F, 0.0F, 0.0F}));
}

TEST_F(IndirectGl, TheGroundThatARoomStandsOnIsLitAsBefore) {
    RenderFrame frame = open_room();
    // Round the room in its bounds, nowhere in it: a floor below, and a hill far off.
    assets::MeshData ground = assets::box_mesh({40.0F, 0.2F, 40.0F});
    for (assets::Vertex& vertex : ground.vertices) {
        if (vertex.position_body.x > 19.0F && vertex.position_body.y > 0.0F)
            vertex.position_body.y += 6.0F;
    }
    ground.bounds = assets::bounds_of(ground);
    add_item(frame,
             library_.add_mesh("ground", std::move(ground)),
             matt(Vec3f{0.6F}),
             glm::translate(Mat4f{1.0F}, {0.0F, -2.0F, 0.0F}));
    frame.items.back().is_static = true;
    const Vec3f beside{-6.0F, -1.9F, 6.0F};
    frame.camera = camera_at({-6.0F, 1.0F, 9.0F}, beside);
    const int with = pixel_at(draw(frame), 32, 32).g;
    frame.indirect.reset();
    EXPECT_EQ(with, pixel_at(draw(frame), 32, 32).g);
}

TEST_F(IndirectGl, AWallThatComesLaterTakesTheLightAway) {
    RenderFrame frame = open_room();
    const Vec3f back{-1.7F, 0.0F, 1.99F};
    const int open = seen(frame, back);
    add_box(frame, {0.2F, 3.4F, 4.4F}, {2.1F, 0.0F, 0.0F}, matt(Vec3f{0.6F}));
    frame.items.back().is_static = true;
    EXPECT_LT(seen(frame, back), open / 2);
}

}  // namespace
}  // namespace plumbline::render
