// Primitives, hulls, meshes and compounds of scene files.
#include "tests/engine/scene/sections/scene_file_fixture.h"

namespace plumbline::scene {
namespace {

TEST_F(SceneFileTest, EveryPrimitive) {
    const Outcome outcome = load(R"([[entity]]
primitive = { sphere = 0.5 }
[[entity]]
primitive = { cylinder = [0.4, 2] }
[[entity]]
primitive = { capsule = [0.3, 1.5] }
[[entity]]
primitive = { cone = [0.2, 1] }
[[entity]]
primitive = { plane = [10, 20] }
body = { kind = "static" }
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    const auto visual = [&](std::size_t i) {
        return std::get<Primitive>(outcome.scene->entities.at(i).visual);
    };
    EXPECT_EQ(std::get<physics::SphereShape>(visual(0)).radius_m, 0.5_r);
    EXPECT_EQ(std::get<physics::CylinderShape>(visual(1)).radius_m, 0.4_r);
    EXPECT_EQ(std::get<physics::CylinderShape>(visual(1)).height_m, Real{2});
    EXPECT_EQ(std::get<physics::CapsuleShape>(visual(2)).height_m, 1.5_r);
    EXPECT_EQ(std::get<physics::ConeShape>(visual(3)).radius_m, 0.2_r);
    EXPECT_EQ(std::get<physics::PlaneShape>(visual(4)).size_m, (Vec2{10, 20}));
    EXPECT_TRUE(std::holds_alternative<FitShape>(outcome.scene->entities[4].body->shape));
}

TEST_F(SceneFileTest, HullsMeshesAndCompounds) {
    write("assets/m.glb", "x");
    const Outcome outcome = load(R"([[entity]]
body = { shape = { hull_m = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]] } }
[[entity]]
[entity.body]
kind = "static"
shape = { mesh_m = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], triangles = [[0, 1, 2], [2, 1, 0]] }
[[entity]]
[entity.body]
shape = { compound = [
    { sphere = 0.5, position_m = [0, 1, 0] },
    { box = [1, 1, 1], rotation_deg = [0, 0, 90] },
    { hull_m = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]] },
] }
[[entity]]
model = "m.glb"
body = { shape = { hull = "model" } }
[[entity]]
model = "m.glb"
body = { kind = "static", shape = { mesh = "model" } }
[[entity]]
model = "m.glb"
body = { shape = "fit" }
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty());
    const auto& entities = outcome.scene->entities;
    const auto def = [&](std::size_t i) {
        return std::get<physics::ShapeDef>(entities.at(i).body->shape);
    };
    EXPECT_EQ(std::get<physics::HullShape>(def(0)).points_m.size(), 4U);
    const auto mesh = std::get<physics::MeshShape>(def(1));
    EXPECT_EQ(mesh.vertices_m.size(), 3U);
    EXPECT_EQ(mesh.triangles.at(1), (std::array<std::uint32_t, 3>{2, 1, 0}));
    const auto compound = std::get<physics::CompoundShape>(def(2));
    ASSERT_EQ(compound.children.size(), 3U);
    expect_near(compound.children[0].body_from_child.position, {0, 1, 0});
    expect_near(compound.children[1].body_from_child.orientation * Vec3{1, 0, 0}, {0, 1, 0});
    EXPECT_TRUE(std::holds_alternative<ModelHullShape>(entities[3].body->shape));
    EXPECT_EQ(std::get<ModelVisual>(entities[3].visual).file, assets() / "m.glb");
    EXPECT_TRUE(std::holds_alternative<ModelMeshShape>(entities[4].body->shape));
    EXPECT_TRUE(std::holds_alternative<FitShape>(entities[5].body->shape));
}

/// All that is said about a body of that shape, by its value's column.
const std::string kShapedBody = "[[entity]]\nbody = { kind = \"static\", shape = ";

TEST_F(SceneFileTest, AShapeIsOneShape) {
    const std::string at = "2:35: error: entity[0].body.shape";
    expect_only(kShapedBody + "3 }\n",
                at + ": 3; expected \"fit\" or a table with one of box = [x, y, z], sphere = r, "
                     "cylinder = [r, h], capsule = [r, h], cone = [r, h], plane = [w, d], hull, "
                     "hull_m, mesh, mesh_m or compound");
    expect_only(kShapedBody + "{} }\n",
                at + ": names no shape; expected one of box = [x, y, z], sphere = r, cylinder = "
                     "[r, h], capsule = [r, h], cone = [r, h], plane = [w, d], hull, hull_m, mesh, "
                     "mesh_m or compound");
    expect_only(kShapedBody + "{ sphere = 1, hull = \"model\" } }\n",
                at + ": names several shapes; expected one (a compound holds several)");
    expect_only(kShapedBody + "{ sphere = 1, box = [1, 1, 1] } }\n",
                "2:46: error: entity[0].body.shape.sphere: given beside box; a shape is one of "
                "them");
    expect_only(kShapedBody + "{ sphere = 1, triangles = [] } }\n",
                "2:61: error: entity[0].body.shape.triangles: given without mesh_m");
    expect_only(kShapedBody + "{ cone = [1] } }\n",
                "2:44: error: entity[0].body.shape.cone: an array of 1; expected two lengths in m");
}

TEST_F(SceneFileTest, OnlyModelsHaveModelsToFit) {
    expect_only("[[entity]]\nprimitive = { sphere = 1 }\nbody = { shape = { hull = \"model\" } }\n",
                "3:18: error: entity[0].body.shape: the entity has a primitive, not a model; "
                "expected \"fit\" or a shape");
    expect_first("[[entity]]\nmodel = \"m.glb\"\nbody = { shape = { hull = \"other\" } }\n",
                 "scene.toml:2:9: warning: entity[0].model: \"m.glb\" does not exist");
    expect_only("[[prefab]]\nname = \"p\"\nbody = { shape = { hull = \"other\" } }\n",
                "3:27: error: prefab[0].body.shape.hull: \"other\"; expected \"model\", the "
                "entity's own (or hull_m with points)");
}

TEST_F(SceneFileTest, TrianglesNameTheirPoints) {
    const std::string mesh = "{ mesh_m = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]";
    const std::string at = "error: entity[0].body.shape.triangles";
    expect_only(kShapedBody + mesh + " } }\n",
                "2:35: " + at + ": missing; expected [[i, j, k], …] beside mesh_m");
    for (const char* wrong : {"[0, 1, 3]", "[0, 1, -1]", "[0, 1]", "[0, 1, 1.0]", "7"}) {
        expect_only(kShapedBody + mesh + ", triangles = [[0, 1, 2], " + wrong + "] } }\n",
                    "2:105: " + at + "[1]: expected [i, j, k] with indices of points from 0 to 2");
    }
}

TEST_F(SceneFileTest, CompoundsHoldShapes) {
    const std::string at = "error: entity[0].body.shape.compound";
    expect_only(kShapedBody + "{ compound = [] } }\n",
                "2:48: " + at + ": an array of 0; expected 1 to 1000 tables with a shape each");
    expect_only(kShapedBody + "{ compound = [3] } }\n",
                "2:49: " + at + "[0]: 3; expected a table with a shape");
    expect_only(kShapedBody + "{ compound = [{ plane = [1, 1] }] } }\n",
                "2:59: " + at + "[0].plane: a plane cannot be part of a compound");
    expect_first(kShapedBody + "{ compound = [{ position_m = [0, 1, 0] }] } }\n",
                 "scene.toml:2:49: " + at + "[0]: no shape; expected one of box");
}

}  // namespace
}  // namespace plumbline::scene
