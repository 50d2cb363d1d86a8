// Another scene read on a thread: what is told of it, and when.
#include "engine/app/frame/scene_opening.h"

#include "tests/engine/app/session_fixture.h"

#include <chrono>
#include <thread>

namespace plumbline::app {
namespace {

class SceneOpeningTest : public SessionTest {
protected:
    SceneOpeningTest() {
        def_.open_scene =
            [this](const std::filesystem::path& file) -> Result<std::unique_ptr<Session>> {
            opened_.push_back(file);
            if (file == "refused.toml") return Error{.message = "refused.toml: no scene"};
            return open();
        };
    }
    /// Until the thread has ended.
    Result<Done> wait() {
        for (;;) {
            Result<Done> updated = opening_.update();
            if (!opening_.running()) return updated;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }

    PlayDef def_;
    std::vector<std::filesystem::path> opened_;
    SceneOpening opening_;
};

TEST_F(SceneOpeningTest, GivesTheSessionOnceItIsOpen) {
    EXPECT_TRUE(opening_.update().ok());
    EXPECT_FALSE(opening_.running() || opening_.opened());
    opening_.begin(def_, "a.toml");
    opening_.begin(def_, "b.toml");  // one after the other
    EXPECT_TRUE(wait().ok());
    ASSERT_TRUE(opening_.opened());
    EXPECT_EQ(opened_, std::vector<std::filesystem::path>{"a.toml"});
    EXPECT_EQ(opening_.take()->description().title, "two cubes");
    EXPECT_FALSE(opening_.opened());
}

TEST_F(SceneOpeningTest, ARefusalIsToldOnceAndAnotherMayFollow) {
    opening_.begin(def_, "refused.toml");
    const Result<Done> refused = wait();
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().message, "refused.toml: no scene");
    EXPECT_FALSE(opening_.opened());
    EXPECT_TRUE(opening_.update().ok());
    opening_.begin(def_, "a.toml");
    EXPECT_TRUE(wait().ok());
    EXPECT_TRUE(opening_.opened());
}

}  // namespace
}  // namespace plumbline::app
