#include "engine/app/scene_watch.h"

#include "tests/engine/app/session_fixture.h"

#include <fmt/format.h>

#include <chrono>
#include <thread>

namespace plumbline::app {
namespace {

class SceneWatchTest : public SessionTest {
protected:
    /// On a clock of its own; the events of the system come when they come.
    bool saved(SceneWatch& watch) {
        for (int i = 0; i < 100; ++i) {
            now_s_ += 0.2;
            if (watch.saved(now_s_)) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        return false;
    }
    double now_s_{0};
};

TEST_F(SceneWatchTest, EveryFileOfTheSceneCounts) {
    folder_.write("parts.toml", "[[material]]\nname = \"oak\"\n");
    folder_.write("chair.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder_.write("scene.toml",
                  "[scene]\ninclude = [\"parts.toml\"]\n[[entity]]\nname = \"chair\"\n"
                  "model = \"chair.obj\"\nmaterial = \"oak\"\n");
    const auto session = open();
    ASSERT_TRUE(session);
    SceneWatch watch(session->files());
    EXPECT_FALSE(watch.saved(0.0));
    for (const char* name : {"scene.toml", "parts.toml", "chair.obj", "config/surfaces.toml"}) {
        folder_.write(name, fmt::format("{}\n# saved\n", folder_.read(name)));
        EXPECT_TRUE(saved(watch)) << name;
        EXPECT_FALSE(watch.saved(now_s_ + 0.01)) << "once a save";
    }
}

TEST_F(SceneWatchTest, ASaveBetweenReadingAndWatchingIsNotMissed) {
    const auto session = open();
    ASSERT_TRUE(session);
    folder_.write("scene.toml", kTwoCubes + "# saved at once\n");
    SceneWatch watch(session->files());
    EXPECT_TRUE(watch.saved(0.0));
    EXPECT_FALSE(watch.saved(0.0));
}

}  // namespace
}  // namespace plumbline::app
