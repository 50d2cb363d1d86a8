// A scene that is judged as it is stepped.
#pragma once

#include "engine/study/gallery/case_events.h"
#include "engine/study/gallery/hard_case_judge.h"
#include "tests/support/scene_in_code.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace plumbline::study {

using scene::HardCaseRule;
using test::cube;
using test::Running;
using test::scene_of;

inline constexpr double kG = 9.81;

/// A cube at (0, 5, 0) and the case's rules.
inline scene::SceneDescription falling(std::vector<HardCaseRule> rules, double seconds = 0.9) {
    scene::SceneDescription scene = scene_of({cube("cube", {0, 5, 0}), cube("other", {20, 5, 0})});
    scene.hard_case =
        scene::HardCase{.id = "H1", .seconds = seconds, .settled_s = 0, .rules = std::move(rules)};
    return scene;
}

struct Judged {
    Running run;
    HardCaseJudge judge;

    explicit Judged(const scene::SceneDescription& scene)
        : run(scene), judge(made(*run.simulation)) {
        play_case_events(*run.simulation);
    }
    static HardCaseJudge made(const scene::Simulation& simulation) {
        Result<HardCaseJudge> judge = HardCaseJudge::create(simulation);
        EXPECT_TRUE(judge.ok()) << (judge.ok() ? "" : judge.error().message);
        return std::move(*judge);
    }
    void step(int count) {
        for (int i = 0; i < count; ++i) {
            run.step(1);
            judge.after_step(*run.simulation);
        }
    }
    const RuleState& rule(std::size_t i) const { return judge.rules()[i]; }
};

}  // namespace plumbline::study
