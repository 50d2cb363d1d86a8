// What the book's lessons show, against closed forms: depth tests, flat shading, the parts of the
// textbook's light.
#include "tests/engine/render/image_fixture.h"

namespace plumbline::render {
namespace {

class BookGl : public ImageGl {
protected:
    /// Looks along -Z at a small red box, a large blue one behind it and a green ball behind both, of
    /// which a part stands out; drawn in this order.
    RenderFrame three_in_a_row() {
        RenderFrame frame = empty_frame(90, 90);
        frame.clear_color = Vec3f{1.0F};
        frame.camera = camera_at({0.0F, 0.0F, 10.0F}, Vec3f{0.0F});
        add_box(frame, Vec3f{1.0F}, {0.0F, 0.0F, 3.0F}, unlit({1.0F, 0.0F, 0.0F}));
        add_box(frame, Vec3f{4.0F}, {0.0F, 0.0F, -1.0F}, unlit({0.0F, 0.0F, 1.0F}));
        const auto ball = library_.add_mesh("ball", assets::sphere_mesh(4.0F));
        add_item(frame,
                 ball,
                 unlit({0.0F, 1.0F, 0.0F}),
                 glm::translate(Mat4f{1.0F}, {1.0F, 0.0F, -8.0F}));
        return frame;
    }
    /// What is seen in the middle: of the small box; beside it: of the large one; and of the ball.
    std::string seen(DepthTest test) {
        RenderFrame frame = three_in_a_row();
        frame.depth_test = test;
        const auto image = draw(frame);
        std::string names;
        for (const std::uint32_t x : {45U, 55U, 65U}) {
            const Pixel pixel = pixel_at(image, x, 45);
            names += pixel.r + pixel.g + pixel.b > 700 ? '-'
                     : pixel.r > 200                   ? 'r'
                     : pixel.b > 200                   ? 'b'
                                                       : 'g';
        }
        return names;
    }
    /// A wall that faces a light along its normal, from which the eye looks at it too.
    Pixel lit_wall(const assets::MaterialData& material) {
        RenderFrame frame = wall(library_.add_material(material));
        frame.ambient = Vec3f{0.1F};
        frame.sun = DirectionalLight{.direction_world = {0.0F, 0.0F, -1.0F},
                                     .radiance = Vec3f{0.3F} * glm::pi<float>()};
        return center(frame);
    }
};

// SOURCES A18.
TEST_F(BookGl, TheDepthTestDecidesWhoIsSeen) {
    EXPECT_EQ(seen(DepthTest::Less), "rbg") << "what is in front";
    EXPECT_EQ(seen(DepthTest::Always), "ggg") << "what is drawn last";
    EXPECT_EQ(seen(DepthTest::Off), "ggg") << "what is drawn last";
    EXPECT_EQ(seen(DepthTest::Never), "---");
    EXPECT_EQ(seen(DepthTest::Greater), "---") << "nothing lies behind the farthest";
    EXPECT_EQ(seen(DepthTest::Less), "rbg") << "and back";
}

TEST_F(BookGl, TheDepthTestsGoRoundByName) {
    DepthTest test = DepthTest::Less;
    for (const char* name : {"less", "always", "never", "greater", "off", "less"}) {
        EXPECT_EQ(name_of(test), name);
        test = next(test, 1);
    }
    EXPECT_EQ(next(DepthTest::Off, 7), DepthTest::Always);
}

// SOURCES A13, A14, A15, A20: ambient 0.1, diffuse 0.3, a highlight of 0.3 where the eye is mirrored.
TEST_F(BookGl, TheTextbooksLightAddsUpPartByPart) {
    assets::MaterialData red{.name = "red",
                             .shading = assets::Shading::BlinnPhong,
                             .base_color = {1.0F, 0.5F, 0.0F},
                             .shininess = 15.0F,
                             .specular = 0.0F,
                             .diffuse = 0.0F};
    Pixel pixel = lit_wall(red);
    EXPECT_NEAR(pixel.r, code_of(0.1F), 1) << "ambient alone";
    EXPECT_NEAR(pixel.g, code_of(0.05F), 1);
    red.diffuse = 1.0F;
    pixel = lit_wall(red);
    EXPECT_NEAR(pixel.r, code_of(0.4F), 1) << "and diffuse";
    EXPECT_NEAR(pixel.g, code_of(0.2F), 1);
    EXPECT_EQ(pixel.b, 0);
    red.specular = 1.0F;
    red.white_highlight = true;
    pixel = lit_wall(red);
    EXPECT_NEAR(pixel.r, code_of(0.7F), 1) << "and a white highlight";
    EXPECT_NEAR(pixel.g, code_of(0.5F), 1);
    EXPECT_NEAR(pixel.b, code_of(0.3F), 1);
    red.white_highlight = false;
    pixel = lit_wall(red);
    EXPECT_NEAR(pixel.g, code_of(0.35F), 1) << "in the surface's colour";
    EXPECT_EQ(pixel.b, 0);
}

// SOURCES A17: one triangle whose corners' normals differ. Flat, all of it has the first one's light.
TEST_F(BookGl, FlatShadingTakesTheFirstVertexsNormal) {
    assets::MeshData mesh;
    const std::array<Vec3f, 3> places{
        Vec3f{-3.0F, -3.0F, 0.0F}, Vec3f{3.0F, -3.0F, 0.0F}, Vec3f{0.0F, 3.0F, 0.0F}};
    const std::array<Vec3f, 3> normals{
        Vec3f{0.0F, 0.0F, 1.0F}, glm::normalize(Vec3f{1.0F, 0.0F, 1.0F}), Vec3f{1.0F, 0.0F, 0.0F}};
    for (std::size_t i = 0; i < 3; ++i)
        mesh.vertices.push_back({.position_body = places[i], .normal_body = normals[i]});
    mesh.indices = {0, 1, 2};
    mesh.sub_meshes = {{.first_index = 0, .index_count = 3}};
    mesh.bounds = assets::bounds_of(mesh);
    const auto id = library_.add_mesh("triangle", mesh);
    const auto image = [&](bool flat) {
        RenderFrame frame = empty_frame(61, 61);
        frame.camera = camera_at({0.0F, 0.0F, 6.0F}, Vec3f{0.0F});
        frame.sun = DirectionalLight{.direction_world = {0.0F, 0.0F, -1.0F},
                                     .radiance = Vec3f{0.5F} * glm::pi<float>()};
        add_item(frame,
                 id,
                 library_.add_material({.name = flat ? "flat" : "smooth",
                                        .shading = assets::Shading::BlinnPhong,
                                        .shininess = 15.0F,
                                        .specular = 0.0F,
                                        .flat = flat}),
                 Mat4f{1.0F});
        return draw(frame);
    };
    const auto flat = image(true);
    const auto smooth = image(false);
    for (const std::array<std::uint32_t, 2>& at :
         {std::array{20U, 44U}, std::array{30U, 30U}, std::array{40U, 44U}, std::array{30U, 20U}})
        EXPECT_NEAR(pixel_at(flat, at[0], at[1]).r, code_of(0.5F), 1) << at[0] << " " << at[1];
    EXPECT_GT(pixel_at(smooth, 20, 44).r, pixel_at(smooth, 30, 30).r + 8);
    EXPECT_GT(pixel_at(smooth, 30, 30).r, pixel_at(smooth, 30, 20).r + 8);
}

}  // namespace
}  // namespace plumbline::render
