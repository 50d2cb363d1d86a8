// Joint tests run over solvers: what each is held to, and how a joint's state is read.
#pragma once

#include "engine/physics/totals.h"
#include "tests/engine/physics/test_world.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <ostream>
#include <vector>

namespace plumbline::physics {

/// What a solver is held to at 60 Hz. The bounds of Bullet's are what it reaches, rounded up.
struct JointBar {
    const char* name;
    Solver solver;
    int substeps;
    double period;         ///< relative, of a pendulum
    double spring_period;  ///< relative, at 0.12 rad a step
    double energy;         ///< share of a small swing's lost or gained in 10 s
    double swing_gap_m;    ///< of a pendulum's pivot
    double rod_m;          ///< of a distance joint that swings through 180 degrees
    double rest_m;         ///< of a beam fixed at one end
    double limit_rad;      ///< past a hinge's limit, hit at 3 rad/s
    double cone_rad;       ///< past a cone's or twist's, hit at 2 rad/s
    double crash_m;        ///< of a train that stops from 40 m/s
    double load;           ///< relative, of forces and torques at rest
    double drive;          ///< relative, of speeds under a motor

    WorldDef world(const Vec3& gravity_mps2 = {0, -9.81_r, 0}) const {
        const bool small = solver == Solver::SmallStep;
        return {.gravity_mps2 = gravity_mps2,
                .substeps = substeps,
                .substeps_max = substeps,
                .iterations = small ? 1 : 10,
                .solver = solver};
    }
    friend std::ostream& operator<<(std::ostream& out, const JointBar& bar) {
        return out << bar.name;
    }
};

/// Bullet's own joints in one step of 1/60 s.
constexpr JointBar bullet_bar(const char* name, Solver solver) {
    return {.name = name,
            .solver = solver,
            .substeps = 1,
            .period = 5e-4,
            .spring_period = 1e-3,
            .energy = 0.05,
            .swing_gap_m = 1e-4,
            .rod_m = 0.02,
            .rest_m = 2e-3,
            .limit_rad = 1e-4,
            .cone_rad = 0.04,
            .crash_m = 1,
            .load = 1e-5,
            .drive = 1e-5};
}

/// The matrix solver meets equations to the last digit, and limits later.
constexpr JointBar bullet_dantzig_bar() {
    JointBar bar = bullet_bar("bullet_dantzig", Solver::BulletDantzig);
    bar.rest_m = 1e-5;
    bar.limit_rad = 5e-4;
    return bar;
}

// Bullet's conjugate-gradient solver is not here: it throws joints apart whose rows act on each
// other, a slider between two free bodies or a ball joint on a long arm, within a few steps.
inline const JointBar kJointBars[] = {
    {.name = "small_step",
     .solver = Solver::SmallStep,
     .substeps = 4,
     .period = 5e-5,
     .spring_period = 1e-4,
     .energy = 1e-3,
     .swing_gap_m = 1e-6,
     .rod_m = 1e-5,
     .rest_m = 1e-5,
     .limit_rad = 1e-3,
     .cone_rad = 2e-3,
     .crash_m = 1e-3,
     .load = 1e-4,
     .drive = 1e-4},
    bullet_bar("bullet_si", Solver::BulletSi),
    {.name = "bullet_si_8",
     .solver = Solver::BulletSi,
     .substeps = 8,
     .period = 1e-5,
     .spring_period = 2e-5,
     .energy = 0.005,
     .swing_gap_m = 2e-6,
     .rod_m = 5e-4,
     .rest_m = 5e-5,
     .limit_rad = 1e-4,
     .cone_rad = 0.005,
     .crash_m = 1,
     .load = 1e-5,
     .drive = 1e-5},
    bullet_dantzig_bar(),
    bullet_bar("bullet_pgs", Solver::BulletPgs),
};

/// Tests of a fixture made from this run once with each solver.
class JointTest : public testing::TestWithParam<JointBar> {
protected:
    const JointBar& bar() const { return GetParam(); }
};

inline JointId join(TestWorld& test, const JointDef& def) {
    const Result<JointId> made = test.world.create_joint(def);
    EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.error().message);
    return made ? *made : JointId{};
}
inline double position(const TestWorld& test, JointId joint) {
    return static_cast<double>(test.world.joint(joint).state.position);
}
inline double force_N(const TestWorld& test, JointId joint) {
    return static_cast<double>(test.world.joint(joint).state.force_N);
}
inline double torque_Nm(const TestWorld& test, JointId joint) {
    return static_cast<double>(test.world.joint(joint).state.torque_Nm);
}
inline double total_energy_J(const TestWorld& test) {
    return energy(test.world).total_J();
}

/// Times at which `value` crosses zero upwards, by the straight line between steps.
inline std::vector<double> upward_crossings_s(TestWorld& test,
                                              double seconds,
                                              const std::function<double()>& value) {
    std::vector<double> times_s;
    const double step_s = test.world.def().step_s;
    const auto steps = static_cast<int>(seconds / step_s + 0.5);
    double before = value();
    for (int i = 0; i < steps; ++i) {
        test.world.step();
        const double now = value();
        if (before < 0 && now >= 0) times_s.push_back((i + before / (before - now)) * step_s);
        before = now;
    }
    return times_s;
}
/// Mean time between crossings.
inline double period_of(const std::vector<double>& times_s) {
    EXPECT_GE(times_s.size(), 3U);
    if (times_s.size() < 2) return 0;
    return (times_s.back() - times_s.front()) / static_cast<double>(times_s.size() - 1);
}

inline std::string name_of(const testing::TestParamInfo<JointBar>& info) {
    return info.param.name;
}

}  // namespace plumbline::physics
