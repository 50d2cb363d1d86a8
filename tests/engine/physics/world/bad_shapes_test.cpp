// Shapes and places that no careful person would write: refused with a message, or a motion that stays bounded.
#include "engine/core/random.h"
#include "engine/physics/totals.h"
#include "tests/engine/physics/bullet/shape/shape_rig.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::physics {
namespace {

WorldDef as_players_step() {
    WorldDef def = in_small_steps(1);
    def.substeps_max = 16;
    return def;
}

/// A world in which nothing may come off the ground faster than it fell.
struct BadWorld : TestWorld {
    BadWorld() : TestWorld(as_players_step()) {}

    /// `most_mps`: what a fall, or being pushed out of another body, explains.
    void expect_bounded(double seconds, double most_mps, const std::string& what) {
        for (int i = 0; i < static_cast<int>(seconds * 60); ++i) {
            world.step();
            ASSERT_TRUE(world.report().isolated.empty()) << what << ", step " << i;
            for (const BodyId id : moving) {
                const Vec3d here = at(id);
                ASSERT_TRUE(std::isfinite(glm::dot(here, here))) << what << ", step " << i;
                ASSERT_LT(glm::length(velocity(id)), most_mps) << what << ", step " << i;
                ASSERT_LT(glm::length(here - Vec3d{home_m}), 20) << what << ", step " << i;
            }
        }
    }
    BodyId drop(const ShapeDef& def,
                const Vec3& place,
                BodyDef body = {.kind = BodyKind::Dynamic}) {
        moving.push_back(add(def, place + home_m, body));
        return moving.back();
    }

    Vec3 home_m{0, 0, 0};
    std::vector<BodyId> moving;
};

std::vector<Vec3> corners_of(const Vec3& half_m) {
    return corners_of_box(-half_m, half_m);
}

/// One of each kind that moves, about half a metre wide.
std::vector<ShapeDef> one_of_each() {
    HullShape wedge{{{-0.3_r, -0.2_r, -0.2_r},
                     {0.3_r, -0.2_r, -0.2_r},
                     {-0.3_r, -0.2_r, 0.2_r},
                     {0.3_r, -0.2_r, 0.2_r},
                     {-0.3_r, 0.3_r, 0}}};
    CompoundShape hammer{
        {{.shape = BoxShape{{0.1_r, 0.5_r, 0.1_r}}},
         {.shape = CylinderShape{0.1_r, 0.3_r}, .body_from_child = {.position = {0, 0.25_r, 0}}}}};
    return {BoxShape{{0.5_r, 0.4_r, 0.3_r}},
            SphereShape{0.25_r},
            CylinderShape{0.2_r, 0.4_r},
            CapsuleShape{0.15_r, 0.3_r},
            ConeShape{0.25_r, 0.5_r},
            wedge,
            hammer};
}

TEST(BadShapes, HullsOfDoubledPointsNeedlesAndSheetsFallAndLie) {
    Random random(3);
    std::vector<std::pair<std::string, HullShape>> hulls;
    std::vector<Vec3> doubled = corners_of({0.2_r, 0.2_r, 0.2_r});
    for (int i = 0; i < 3; ++i) {
        const auto once = corners_of({0.2_r, 0.2_r, 0.2_r});
        doubled.insert(doubled.end(), once.begin(), once.end());
    }
    hulls.emplace_back("each point four times", HullShape{doubled});
    hulls.emplace_back("needle", HullShape{corners_of({1, 0.001_r, 0.001_r})});
    hulls.emplace_back("sheet", HullShape{{{-1, 0, -1}, {1, 0, -1}, {-1, 0, 1}, {1, 0, 1}}});
    hulls.emplace_back("line", HullShape{{{-1, 0, 0}, {-0.5_r, 0, 0}, {0.5_r, 0, 0}, {1, 0, 0}}});
    hulls.emplace_back("one place", HullShape{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}});
    HullShape ball;
    for (int i = 0; i < 10000; ++i) {
        const Vec3 any{
            random.uniform(-1.0F, 1.0F), random.uniform(-1.0F, 1.0F), random.uniform(-1.0F, 1.0F)};
        ball.points_m.push_back(glm::normalize(any) * 0.3_r);
    }
    hulls.emplace_back("10 000 points", ball);
    HullShape hairy{corners_of({0.3_r, 0.1_r, 0.3_r})};
    for (int i = 0; i < 2000; ++i)
        hairy.points_m.push_back({random.uniform(-0.3F, 0.3F), 0.1_r, random.uniform(-0.3F, 0.3F)});
    hulls.emplace_back("2000 points in one face", hairy);
    for (const auto& [what, hull] : hulls) {
        BadWorld test;
        test.ground();
        if (auto made = test.world.create_shape(hull); !made.ok()) {
            EXPECT_TRUE(made.error().message.starts_with("shape: hull: ")) << what;
            continue;
        }
        const BodyId id = test.drop(hull, {0, 1, 0});
        test.expect_bounded(4, 6, what);
        EXPECT_GT(test.at(id).y, -0.01) << what;
        EXPECT_LT(glm::length(test.velocity(id)), 0.05) << what;
    }
}

TEST(BadShapes, OnMeshesThatAreTornDoubledAndFlippedThingsComeToRest) {
    std::vector<std::pair<std::string, MeshShape>> meshes;
    MeshShape doubled = flat_mesh(4, 1);
    const auto once = doubled.triangles;
    doubled.triangles.insert(doubled.triangles.end(), once.begin(), once.end());
    meshes.emplace_back("every triangle twice", doubled);
    MeshShape flipped = flat_mesh(4, 1);
    for (std::size_t t = 0; t < flipped.triangles.size(); t += 3)
        std::swap(flipped.triangles[t][1], flipped.triangles[t][2]);
    meshes.emplace_back("every third flipped", flipped);
    MeshShape torn = flat_mesh(40, 0.1_r);  // holes are smaller than what falls
    for (std::size_t t = 7; t < torn.triangles.size(); t += 11)
        torn.triangles.erase(torn.triangles.begin() + static_cast<std::ptrdiff_t>(t));
    meshes.emplace_back("holes", torn);
    MeshShape needles = flat_mesh(4, 1);
    for (std::uint32_t i = 0; i + 2 < needles.vertices_m.size(); ++i) {
        needles.triangles.push_back({i, i, i + 1});
        needles.triangles.push_back({i, i + 1, i + 2});  // some have no area
    }
    meshes.emplace_back("triangles without area", needles);
    MeshShape fins = flat_mesh(4, 1);
    for (std::uint32_t i = 0; i + 5 < 20; ++i) {
        fins.vertices_m.push_back(fins.vertices_m[i] + Vec3{0.05_r, -0.4_r, 0.05_r});
        fins.triangles.push_back(
            {i, i + 1, static_cast<std::uint32_t>(fins.vertices_m.size() - 1)});
    }
    meshes.emplace_back("three triangles to an edge", fins);
    for (const auto& [what, mesh] : meshes) {
        for (std::size_t kind = 0; kind < one_of_each().size(); ++kind) {
            BadWorld test;
            test.add(mesh, {0, 0, 0}, {.kind = BodyKind::Static});
            const BodyId id = test.drop(one_of_each()[kind], {0.13_r, 0.8_r, 0.21_r});
            test.expect_bounded(4, 6, what + ", kind " + std::to_string(kind));
            EXPECT_GT(test.at(id).y, 0) << what << ", kind " << kind;
        }
    }
}

TEST(BadShapes, MeshesOfNoNumbersAreRefused) {
    MeshShape mesh = flat_mesh(2, 2);
    mesh.vertices_m[3].y = kNan;
    EXPECT_EQ(refusal(mesh), "shape: mesh: vertex 3 is not finite");
}

TEST(BadShapes, PartsInsideEachOtherWeighAndStandAsASolid) {
    CompoundShape nested;
    for (int i = 0; i < 6; ++i) {
        const Real size = 0.5_r - 0.07_r * static_cast<Real>(i);
        nested.children.push_back({.shape = BoxShape{{size, size, size}}});
    }
    nested.children.push_back({.shape = SphereShape{0.2_r}});
    BadWorld test;
    test.ground();
    const BodyId id = test.drop(nested, {0, 0.6_r, 0});
    test.expect_bounded(4, 6, "nested");
    EXPECT_NEAR(test.at(id).y, 0.25, 2e-3);
}

TEST(BadShapes, AThousandTimesLargerIsMetLikeAnyOther) {
    // Grains of 2 mm on blocks of 2 m, of each kind on each.
    const auto of_size = [](std::size_t kind, Real size_m) -> ShapeDef {
        switch (kind) {
            case 0:
                return BoxShape{{size_m, size_m, size_m}};
            case 1:
                return SphereShape{size_m / 2};
            case 2:
                return CylinderShape{size_m / 2, size_m};
            case 3:
                return HullShape{corners_of(Vec3{size_m / 2})};
            default:
                return CapsuleShape{size_m / 2, size_m};
        }
    };
    for (std::size_t large = 0; large < 4; ++large) {
        for (std::size_t grain = 0; grain < 5; ++grain) {
            BadWorld test;
            test.add(of_size(large, 2), {0, -1, 0}, {.kind = BodyKind::Static});
            test.drop(of_size(grain, 0.002_r),
                      {0, 0.004_r, 0},
                      {.kind = BodyKind::Dynamic, .mass_kg = 2e-5_r});
            const std::string what = std::to_string(grain) + " on " + std::to_string(large);
            test.expect_bounded(0.5, 0.5, what);
            EXPECT_GT(test.at(test.moving.front()).y, large == 1 ? -0.05 : 5e-4) << what;
        }
    }
}

TEST(BadShapes, TwoOfEachKindInOnePosePartGently) {
    for (std::size_t kind = 0; kind < one_of_each().size(); ++kind) {
        for (const bool in_air : {false, true}) {
            BadWorld test;
            test.ground();
            const Real height_m = in_air ? 2 : 0.3_r;
            test.drop(one_of_each()[kind], {0, height_m, 0});
            test.drop(one_of_each()[kind], {0, height_m, 0});
            test.expect_bounded(5, in_air ? 9 : 6, "kind " + std::to_string(kind));
        }
    }
}

TEST(BadShapes, FacesThatCoincideAtNoAngleNeitherPushNorStick) {
    for (std::size_t kind : {std::size_t{0}, std::size_t{5}}) {
        BadWorld test;
        const ShapeDef brick = kind == 0
                                   ? ShapeDef{BoxShape{{0.5_r, 0.5_r, 0.5_r}}}
                                   : ShapeDef{HullShape{corners_of({0.25_r, 0.25_r, 0.25_r})}};
        test.add(BoxShape{{4, 1, 4}}, {0, -0.5_r, 0}, {.kind = BodyKind::Static});
        for (int x = 0; x < 3; ++x)
            for (int y = 0; y < 3; ++y)
                test.drop(brick,
                          {0.5_r * static_cast<Real>(x), 0.25_r + 0.5_r * static_cast<Real>(y), 0});
        test.expect_bounded(2, 0.1, "wall");
        EXPECT_NEAR(test.at(test.moving.back()).y, 1.25, 2e-3);
        EXPECT_NEAR(test.at(test.moving.back()).x, 1, 1e-3);
    }
}

TEST(BadShapes, EverythingAtOneSpotComesApartWithoutABang) {
    BadWorld test;
    test.ground();
    for (int i = 0; i < 8; ++i)
        for (const ShapeDef& shape : one_of_each()) test.drop(shape, {0, 1, 0});
    test.expect_bounded(8, 12, "56 bodies");
    EXPECT_LT(max_penetration_m(test.world), 0.05);
}

TEST(BadShapes, FarAwayIsCoarseButBounded) {
    for (const Real far_m : {1e4_r, 1e5_r, 9e5_r}) {
        BadWorld test;
        test.home_m = {far_m, 0, 0};
        test.add(
            BoxShape{{40, 1, 40}}, test.home_m - Vec3{0, 0.5_r, 0}, {.kind = BodyKind::Static});
        Real beside_m = -3;
        for (const ShapeDef& shape : one_of_each()) {
            test.drop(shape, {beside_m, 0.6_r, 0});
            beside_m += 1;
        }
        test.expect_bounded(3, 12, std::to_string(far_m) + " m");
        for (const BodyId id : test.moving) EXPECT_GT(test.at(id).y, -0.3) << far_m;
    }
}

}  // namespace
}  // namespace plumbline::physics
