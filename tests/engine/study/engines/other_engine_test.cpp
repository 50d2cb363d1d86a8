// A simulation whose steps another program makes: here a script that puts its only body somewhere.
#include "engine/study/engines/other_engine.h"

#include "tests/engine/study/scenes/scene_run_fixture.h"

namespace plumbline::study {
namespace {

class OtherEngineTest : public PlayedSceneTest {
protected:
    /// Answers every line behind the scene's with these states.
    Result<std::unique_ptr<OtherEngine>> start(const std::string& scene,
                                               const std::string& states) {
        play(scene);
        const std::string answer = R"({"cpu_ms":1,"step_ms":[1],"states":[)" + states + "]}";
        Result<EngineProcess> process = EngineProcess::start(
            {.program = "sh",
             .arguments = {"-c",
                           "echo '{\"version\":\"1\"}'; read a; echo '{}'; while read b; do echo "
                           "\"$b\" >> " +
                               asked_.string() + "; echo '" + answer + "'; done"},
             .silent = true});
        EXPECT_TRUE(process);
        process_.emplace(std::move(*process));
        return OtherEngine::create({"bullet", 60, {}}, *process_, *scene_);
    }
    void TearDown() override {
        std::filesystem::remove(asked_);
        PlayedSceneTest::TearDown();
    }

    std::optional<EngineProcess> process_;
    std::filesystem::path asked_{file_.string() + ".asked"};
};

TEST_F(OtherEngineTest, PutsBodiesWhereTheEngineHasThem) {
    auto engine = start(std::string(kFalling), "7,8,9,0,0,0,1,1,2,3,0,0,0");
    ASSERT_TRUE(engine);
    for (int i = 0; i < 3; ++i) scene_->step();
    const physics::BodyId body = scene_->simulation().moving_bodies().front().body;
    // Our own physics has not moved it.
    EXPECT_EQ(scene_->simulation().physics.state(body).world_from_body.position, (Vec3{1, 100, 0}));
    const Result<EngineMoved> moved = (*engine)->catch_up(10);
    ASSERT_TRUE(moved);
    EXPECT_EQ(scene_->simulation().physics.state(body).world_from_body.position, (Vec3{7, 8, 9}));
    EXPECT_EQ(scene_->simulation().physics.state(body).velocity_mps, (Vec3{1, 2, 3}));
    EXPECT_NEAR(scene_->simulation().time_s(), 0.05, 1e-9);
    scene_->step();
    ASSERT_TRUE((*engine)->catch_up(10));
    std::ifstream asked(asked_);
    std::string first;
    std::string second;
    std::getline(asked, first);
    std::getline(asked, second);
    EXPECT_NE(first.find(R"("steps":3)"), std::string::npos);
    EXPECT_NE(first.find(R"("set":[[0,1.0,100.0)"), std::string::npos) << "how it starts";
    EXPECT_EQ(second.find("set"), std::string::npos) << "nothing was changed";
}

TEST_F(OtherEngineTest, SaysWhatWasChangedMeanwhile) {
    auto engine = start(std::string(kFalling), "7,8,9,0,0,0,1,1,2,3,0,0,0");
    ASSERT_TRUE(engine);
    physics::PhysicsWorld& physics = scene_->simulation().physics;
    physics.set_velocity(scene_->simulation().moving_bodies().front().body, {0, 42, 0}, {});
    scene_->step();
    ASSERT_TRUE((*engine)->catch_up(10));
    std::string line;
    std::getline(std::ifstream(asked_), line);
    EXPECT_NE(line.find("42"), std::string::npos);
}

TEST_F(OtherEngineTest, OtherBodiesAndStatesThatAreNoNumbersAreTold) {
    auto engine = start(std::string(kFalling), "1,2");
    ASSERT_TRUE(engine);
    scene_->step();
    EXPECT_FALSE((*engine)->catch_up(10));
    auto other = start(std::string(kFalling), "null,8,9,0,0,0,1,1,2,3,0,0,0");
    ASSERT_TRUE(other);
    scene_->step();
    const Result<EngineMoved> moved = (*other)->catch_up(10);
    ASSERT_TRUE(moved);
    EXPECT_FALSE(moved->is_finite);
}

TEST_F(OtherEngineTest, AfterItTheSceneIsItsOwnAgain) {
    auto engine = start(std::string(kFalling), "");
    ASSERT_TRUE(engine);
    engine->reset();
    scene_->step();
    const physics::BodyId body = scene_->simulation().moving_bodies().front().body;
    EXPECT_LT(scene_->simulation().physics.state(body).velocity_mps.y, -0.1);
}

TEST_F(OtherEngineTest, AWindySceneIsRefused) {
    const auto engine = start(std::string(kFalling) + "drag = {}\n", "");
    ASSERT_FALSE(engine);
    EXPECT_NE(engine.error().message.find("no other engine is handed: drag"), std::string::npos);
}

}  // namespace
}  // namespace plumbline::study
