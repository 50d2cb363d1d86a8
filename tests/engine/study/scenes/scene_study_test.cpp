#include "engine/study/scenes/scene_study.h"

#include <gtest/gtest.h>

namespace plumbline::study {
namespace {

// It needs both programs beside it, and says so before it samples at the scene.
TEST(SceneStudy, NamesTheProgramThatIsMissing) {
    const Result<SceneStudy> study = study_scene({.scene = "/nowhere.toml"});
    ASSERT_FALSE(study.ok());
    EXPECT_EQ(study.error().exit_code, ExitCode::RunFailed);
    EXPECT_NE(study.error().message.find("need the program"), std::string::npos);
    EXPECT_EQ(study.error().message.find("nowhere"), std::string::npos);
}

}  // namespace
}  // namespace plumbline::study
