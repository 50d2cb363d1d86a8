#include "engine/app/accuracy/study_control.h"

#include "tests/engine/app/session_fixture.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace plumbline::app {
namespace {

class StudyControlTest : public SessionTest {
protected:
    void keep(const Session& session, const char* title) const {
        study::CachedStudy kept{.made_on = "2026-11-28"};
        kept.study.seconds = 1;
        kept.study.subject.title = title;
        kept.study.subject.points = {{.errors = {0.01}, .cost = {.ms_per_s_min = 6}}};
        ASSERT_TRUE(
            study::keep_study(folder_.path() / "kept", study::study_key(session.opened()), kept));
    }
};

TEST_F(StudyControlTest, ShowsTheOneThatWasKeptUntilTheSceneIsAnother) {
    const auto session = open();
    keep(*session, "of the scene");
    StudyControl control(*session, folder_.path() / "kept");
    EXPECT_EQ(control.study(), nullptr);
    control.look_up();
    ASSERT_NE(control.study(), nullptr);
    EXPECT_EQ(control.study()->subject.title, "of the scene");
    ASSERT_TRUE(session->apply(StartAgain{}));
    control.take_answers();
    EXPECT_NE(control.study(), nullptr) << "the same scene";
    folder_.write("scene.toml", "[scene]\ntitle = \"another\"\n" + cube_text("cube", "0, 9, 0"));
    ASSERT_TRUE(session->reload());
    control.take_answers();
    EXPECT_EQ(control.study(), nullptr);
    control.look_up();
    EXPECT_EQ(control.study(), nullptr) << "none was made of this one";
}

// The programs are not beside the tests, so it comes to nothing; what was known stays.
TEST_F(StudyControlTest, AFailureIsSaidAndLosesNothing) {
    const auto session = open();
    keep(*session, "before");
    StudyControl control(*session, folder_.path() / "kept");
    control.start();
    EXPECT_TRUE(control.runs());
    for (int i = 0; i < 1000 && control.runs(); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        control.take_answers();
    }
    EXPECT_FALSE(control.runs());
    EXPECT_NE(control.failure().find("need the program"), std::string::npos) << control.failure();
    ASSERT_NE(control.study(), nullptr);
    EXPECT_EQ(control.study()->subject.title, "before");
}

}  // namespace
}  // namespace plumbline::app
