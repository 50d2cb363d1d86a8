// A model file as a scene: fitted at any size, refused when it cannot be read.
#include "engine/scene/scene_file.h"
#include "tests/support/scene_in_code.h"
#include "tests/support/temporary_folder.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <tuple>

namespace plumbline::scene {
namespace {

namespace fs = std::filesystem;

fs::path write_obj(const fs::path& folder, double size) {
    const fs::path file = folder / "m.obj";
    std::ofstream out(file);
    out << "v 0 " << -size << " 0\nv " << size << " 0 0\nv 0 " << size << " 0\nf 1 2 3\n";
    return file;
}

// FAULTS 29: 1 cm showed nothing, legs stood below the made ground, none was there for 200 units.
TEST(ModelScene, FitsCameraGroundAndShadowsFromAMillimetreToTenKilometres) {
    const test::TemporaryFolder folder;
    for (const double size : {1e-5, 5e-4, 1.0, 10'000.0}) {
        const fs::path file = write_obj(folder.path(), size);
        Diagnostics faults;
        const auto scene = read_description(file, {}, faults);
        ASSERT_TRUE(scene.ok());
        test::Running run(*scene);
        ASSERT_NE(run.simulation, nullptr);
        const SceneDescription& set = run->description();
        // Bounds 1 x 2 times the size: half their diagonal.
        const double radius = std::sqrt(5.0) / 2 * size;
        EXPECT_NEAR(static_cast<double>(set.model_radius_m) / radius, 1, 1e-4) << size;
        const Real distance = glm::distance(set.camera.position_m, set.camera.target_m);
        EXPECT_NEAR(static_cast<double>(distance) / radius, 2, 1e-3) << "half of 60 degrees";
        EXPECT_LT(set.camera.near_m, distance - set.model_radius_m);
        EXPECT_GT(set.camera.far_m, distance + set.model_radius_m);
        EXPECT_GT(set.sun->shadow->distance_m, distance + set.model_radius_m);
        const auto& ground = run->registry.get<Transform>(run->find("ground"));
        EXPECT_NEAR(static_cast<double>(ground.world_from_body.position.y) / size, -1, 1e-4);
    }
}

/// A grid of 2 x columns x rows triangles, as a binary PLY.
fs::path write_grid(const fs::path& folder, std::int32_t columns, std::int32_t rows) {
    const fs::path file = folder / "grid.ply";
    std::ofstream out(file, std::ios::binary);
    const std::int32_t row = columns + 1;
    out << "ply\nformat binary_little_endian 1.0\nelement vertex " << row * (rows + 1)
        << "\nproperty float x\nproperty float y\nproperty float z\nelement face "
        << 2 * columns * rows << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (std::int32_t i = 0; i < row * (rows + 1); ++i) {
        const std::array<float, 3> at{
            static_cast<float>(i % row), 0.0F, static_cast<float>(i / row)};
        out.write(reinterpret_cast<const char*>(at.data()), sizeof(at));
    }
    const auto face = [&](std::array<std::int32_t, 3> corners) {
        out.put(3).write(reinterpret_cast<const char*>(corners.data()), sizeof(corners));
    };
    for (std::int32_t i = 0; i < row * rows; ++i) {
        if (i % row == columns) continue;
        face({i, i + row, i + 1});
        face({i + 1, i + row, i + row + 1});
    }
    return file;
}

// EXPERIENCE G16: up to 200 000 triangles are a collider; more are shown, and collide with nothing.
TEST(ModelScene, OfAMillionTrianglesIsOnlyLookedAt) {
    const test::TemporaryFolder folder;
    for (const auto& [columns, rows, is_solid] :
         {std::tuple{400, 250, true}, {400, 251, false}, {1000, 500, false}}) {
        Diagnostics faults;
        const auto scene = read_description(write_grid(folder.path(), columns, rows), {}, faults);
        ASSERT_TRUE(scene.ok());
        test::Running run(*scene);
        ASSERT_NE(run.simulation, nullptr);
        const ecs::Entity model = run->find("model");
        EXPECT_EQ(run->registry.has<BodyRef>(model), is_solid) << columns << " x " << rows;
        const auto& visual = run->registry.get<Visual>(model);
        EXPECT_EQ(run->library().mesh(visual.mesh).indices.size(),
                  static_cast<std::size_t>(columns * rows) * 6);
    }
}

// FAULTS 17: junk was "good", and simulated and drawn as a box.
TEST(ModelScene, ThatCannotBeReadIsAnErrorEverywhere) {
    const test::TemporaryFolder folder;
    const fs::path file = folder.path() / "junk.glb";
    std::ofstream(file) << "junk";
    Diagnostics faults;
    const auto scene = read_description(file, {}, faults);
    ASSERT_TRUE(scene.ok());
    check_models(*scene, faults);
    ASSERT_TRUE(faults.has_errors());
    EXPECT_NE(faults.list()[0].message.find("its content is not glTF"), std::string::npos);
    assets::AssetLibrary library;
    const auto built = build_simulation(*scene, {}, library, test::plain_surfaces());
    ASSERT_FALSE(built.ok());
    EXPECT_EQ(built.error().exit_code, ExitCode::Refused);
}

}  // namespace
}  // namespace plumbline::scene
