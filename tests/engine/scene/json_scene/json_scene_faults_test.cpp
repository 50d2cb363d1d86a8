// JSON scenes that are wrong: file, object and element named, exit code 4.
#include "tests/engine/scene/json_scene/json_scene_fixture.h"

#include <utility>

namespace plumbline::scene {
namespace {

namespace fs = std::filesystem;

TEST_F(JsonFault, OfTheWholeFile) {
    EXPECT_EQ(said_of("[]"), "a.json: error: expected an object, found array");
    EXPECT_EQ(said_of(R"({"objects": []})"),
              "a.json: error: camera: missing; expected an object with resolution and transform");
    EXPECT_EQ(said_of(R"({"camera": 3, "objects": []})"),
              "a.json: error: camera: expected an object, found number");
    EXPECT_EQ(said_of(R"({"camera": {"resolution": [4, 3]}})"),
              "a.json: error: objects: missing; expected an array of objects");
    EXPECT_EQ(said_of(R"({"camera": {"resolution": [4, 3]}, "objects": [7]})"),
              "a.json: error: objects[0]: expected an object, found number");
    EXPECT_EQ(said_of(R"({"camera": {"resolution": [4, 3]}, "objects": [], "background": [1, 2]})"),
              "a.json: error: background: expected 3 numbers, found 2");
    EXPECT_TRUE(
        said_of("{\"camera\":\n  nonsense}").starts_with("a.json:2:4: error: this is no JSON"));
    EXPECT_NE(said_of(std::string(5000, '[')).find("it nests deeper than 32 levels"),
              std::string::npos);
    EXPECT_NE(said_of_object(R"("vertices": [1e999])").find("number overflow"), std::string::npos);
}

TEST_F(JsonFault, OfTheCamera) {
    EXPECT_EQ(said_of(R"({"camera": {}, "objects": []})"),
              "a.json: error: camera.resolution: missing; expected [width, height] in pixels");
    for (const char* side : {"0", "-4", "2.5", "20000"}) {
        EXPECT_EQ(
            said_of(fmt::format(R"({{"camera": {{"resolution": [4, {}]}}, "objects": []}})", side)),
            fmt::format("a.json: error: camera.resolution: expected whole numbers from 1 to "
                        "16384, found {}",
                        side));
    }
    EXPECT_EQ(said_of_camera(R"(, "s": 0)"),
              "a.json: error: camera.s: expected a number above 0, up to 1e+09, found 0");
    EXPECT_EQ(said_of_camera(R"(, "z_near": "x")"),
              "a.json: error: camera.z_near: expected a number above 0, up to 1e+09, found string");
    EXPECT_EQ(said_of_camera(R"(, "z_near": 5, "z_far": 5)"),
              "a.json: error: camera.z_far: 5 is not beyond z_near, 5");
    EXPECT_EQ(said_of_camera(R"(, "transform": [{"scale": [1, 0, 1]}])"),
              "a.json: error: camera.transform: it flattens space: no image can be taken so");
}

constexpr std::string_view kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
    "element face 1\nproperty list uchar uint vertex_indices\nend_header\n"
    "0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 0 1 2 3\n3 0 1 2\n";

TEST_F(JsonFault, OfMeshFiles) {
    const auto said = [&](std::string_view from, std::string_view to) {
        std::string text(kPly);
        write("m.ply", text.replace(text.find(from), from.size(), to));
        return said_of_object(R"("filename": "m.ply")");
    };
    const std::string at = "a.json: error: objects[1].filename: ";
    const std::string refused = at + "model m.ply is refused: ";
    EXPECT_EQ(said("3 0 1 2\n", "3 0 1 3\n"),
              refused + "face 0 names a vertex that is not there: it has 3");
    EXPECT_EQ(said("3 0 1 2\n", "2 0 1\n"), refused + "face 0 has 2 corners");
    EXPECT_EQ(said("1 0 0 1", "nan 0 0 1"), refused + "vertex 1 is not finite");
    EXPECT_EQ(said("vertex 3", "vertex 2147483648"), refused + "2147483648 vertex are too many");
    EXPECT_EQ(said("vertex 3", "vertex 9000000"),
              refused + "its header promises 108000002 bytes or more; 44 follow");
    EXPECT_EQ(said("0 1 0 1 2 3", "0 1 0 1 x 3"),
              refused +
                  "it breaks off, or holds what is no number, in its element vertex number 2 "
                  "of 3");
    EXPECT_EQ(said_of_object(R"("filename": "none.ply")").find(at), 0U);
    EXPECT_EQ(said_of_object(R"("filename": 4)"), at + "expected text, found number");
}

TEST_F(JsonFault, MeshFilesCutAtEveryLength) {
    for (std::size_t length = 0; length + 2 < kPly.size(); ++length) {
        write("m.ply", kPly.substr(0, length));
        EXPECT_EQ(said_of_object(R"("filename": "m.ply")")
                      .find("a.json: error: objects[1].filename: model m.ply is refused: "),
                  0U)
            << length;
    }
}

TEST_F(JsonFault, SceneFilesCutAtEveryLength) {
    write("m.ply", kPly);
    const std::string whole =
        R"({"camera": {"resolution": [4, 3]}, "objects": [{"filename": "m.ply"}]})";
    for (std::size_t length = 0; length < whole.size(); ++length)
        EXPECT_EQ(said_of(whole.substr(0, length)).find("a.json"), 0U) << length;
}

TEST_F(JsonFault, PathsThatLeadOut) {
    write("outside.ply", kPly);
    write("in/a.ply", kPly);
    fs::create_symlink(folder() / "outside.ply", folder() / "in/link.ply");
    for (const char* name : {"../outside.ply", "link.ply", "/etc/passwd", "..\\\\outside.ply"}) {
        write("in/a.json",
              fmt::format(
                  R"({{"camera": {{"resolution": [4, 3]}}, "objects": [{{"filename": "{}"}}]}})",
                  name));
        const Outcome outcome = load_file("in/a.json");
        ASSERT_FALSE(outcome.scene.ok()) << name;
        EXPECT_EQ(outcome.faults.at(0).find("in/a.json: error: objects[0].filename: "), 0U)
            << outcome.faults.at(0);
        EXPECT_EQ(outcome.scene.error().exit_code, ExitCode::Refused);
    }
}

}  // namespace
}  // namespace plumbline::scene
