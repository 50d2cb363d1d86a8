// Animations play with the steps; the aids of the viewer are there for a model by itself alone.
#include "engine/effects/effect_runtime.h"
#include "engine/scene/extract.h"
#include "engine/scene/scene_file.h"
#include "tests/engine/assets/fixture.h"
#include "tests/engine/effects/drawn.h"
#include "tests/support/scene_in_code.h"

#include <algorithm>

namespace plumbline::effects {
namespace {

using assets::test::append_bytes;
using assets::test::TempFolder;
using assets::test::TriangleFile;

/// A triangle that slides from x = 0 to 2 m in one second, beside one that stands at x = 5.
std::string sliding_model() {
    TriangleFile file;
    std::string times;
    std::string places;
    append_bytes<float>(times, {0, 1});
    append_bytes<float>(places, {0, 0, 0, 2, 0, 0});
    file.json["nodes"] = {{{"mesh", 0}, {"name", "sled"}},
                          {{"mesh", 0}, {"translation", {5, 0, 0}}}};
    file.json["scenes"][0]["nodes"] = {0, 1};
    const std::size_t input = file.add_accessor(times, 5126, 2, "SCALAR");
    const std::size_t output = file.add_accessor(places, 5126, 2, "VEC3");
    file.json["animations"] = {
        {{"name", "slide"},
         {"samplers", {{{"input", input}, {"output", output}}}},
         {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
    return file.glb();
}

scene::SceneDescription model_scene(const TempFolder& folder, const std::string& bytes) {
    Diagnostics faults;
    auto scene = scene::load_scene(folder.write("m.glb", bytes), {}, faults);
    EXPECT_TRUE(scene.ok());
    scene->sun.reset();
    return *scene;
}

std::vector<float> places_x(const render::RenderFrame& frame) {
    std::vector<float> places;
    for (const render::DrawItem& item : frame.items) places.push_back(item.world_from_body[3].x);
    std::sort(places.begin(), places.end());
    return places;
}

TEST(ModelAnimation, MovesItsPartsWithTheStepsAndRepeats) {
    const TempFolder folder;
    test::Running run(model_scene(folder, sliding_model()));
    EffectRuntime effects(*run, {.picture = true});
    const float ground_x =
        run->registry.get<scene::Placement>(run->find("ground")).world_from_body.position.x;
    run.step(15, effects);  // a quarter of the second
    render::RenderFrame frame = draw(run, effects);
    ASSERT_EQ(frame.items.size(), 3U) << "ground, what stands, what slides; not the model at rest";
    std::vector<float> expected{0.0F, 0.5F, ground_x};
    std::sort(expected.begin(), expected.end());
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(places_x(frame)[i], expected[i], 1e-4);

    run.step(60, effects);  // once round
    frame = draw(run, effects);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(places_x(frame)[i], expected[i], 1e-4);

    for (auto [entity, playing] : run->registry.view<scene::PlayingModel>()) playing.paused = true;
    run.step(7, effects);
    frame = draw(run, effects);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(places_x(frame)[i], expected[i], 1e-4);
}

TEST(ViewerAids, AreOnlyWhereAModelIsByItselfAndDoWhatTheirSwitchesSay) {
    const TempFolder folder;
    test::Running run(model_scene(folder, TriangleFile{}.glb()));
    EffectRuntime effects(*run, {.picture = true});
    const render::RenderFrame plain = draw(run, effects);
    EXPECT_TRUE(plain.lines.vertices.empty());
    EXPECT_EQ(plain.items.size(), 2U);

    run->switches.grid = true;
    run->switches.normals = true;
    run->switches.ground = false;
    run->switches.background = 1;
    const render::RenderFrame frame = draw(run, effects);
    // 21 lines each way, and one for each of the triangle's three normals.
    EXPECT_EQ(frame.lines.vertices.size(), 2U * (42 + 3));
    EXPECT_EQ(frame.items.size(), 1U);
    EXPECT_EQ(frame.clear_color, Vec3f(1.0F));

    test::Running other(test::scene_of({test::ground()}));
    other->switches.grid = true;
    EffectRuntime none(*other, {.picture = true});
    EXPECT_TRUE(draw(other, none).lines.vertices.empty());
}

}  // namespace
}  // namespace plumbline::effects
