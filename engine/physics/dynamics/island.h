// Bodies that push each other, as one step finds them, and what solves them.
#pragma once

#include "engine/core/threads/team.h"
#include "engine/physics/collision/manifold.h"
#include "engine/physics/force_field.h"
#include "engine/physics/physics_world.h"
#include "engine/physics/world/joint_record.h"

#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace plumbline::physics {

/// Dynamic bodies connected by touching pairs and joints. Static and kinematic bodies bound an
/// island and belong to none. Everything is in an order that only ids decide.
struct Island {
    std::vector<BodyRecord*> bodies;   ///< dynamic, awake
    std::vector<Manifold*> manifolds;  ///< with at least one point
    std::vector<JointRecord*> joints;  ///< not broken
    bool supported{false};             ///< something that bounds it touches or holds it
    bool carried{false};               ///< ... and moves: a kinematic body
    bool swept{false};                 ///< one of its bodies may pass something unseen in the step

    void clear() {
        bodies.clear();
        manifolds.clear();
        joints.clear();
        supported = false;
        carried = false;
        swept = false;
    }
};

/// What solving an island needs to know of the step.
struct IslandStep {
    double step_s{1.0 / 60.0};
    Vec3d gravity_mps2{0, 0, 0};
    int substeps_least{1};
    int substeps_most{1};
    int iterations{1};  ///< sweeps of bias and of relaxation per sub-step
    JointMethod joints{JointMethod::Direct};
    WorldFeatures features{};
    std::uint64_t number{1};  ///< of the step, from 1
    Team* team{nullptr};  ///< shares the work within the island; none: the caller alone solves it
    std::span<ForceField* const> fields{};
    double start_s{0};  ///< of the part of it at hand
    double part_s{0};   ///< of the part of it at hand; 0: it is solved at once
    bool first{true};   ///< of its parts
    bool last{true};
};

/// What solving an island left besides motions, loads and states of joints.
struct IslandResult {
    IslandReport report{};
    StepCost cost{};          ///< without times
    bool found_again{false};  ///< its points: lists of manifolds are out of date
};

/// Solves one island after the other: writes poses and velocities into the bodies' BodyMotion, mean
/// forces (N) onto the manifold points, and states into the joints. Bullet's copies are not touched. Solvers of different
/// islands may work at once.
class IslandSolver {
public:
    IslandSolver();
    ~IslandSolver();
    /// Adds to `result`; its report is of the latest part of the step, with the sub-steps of all.
    void solve(Island& island, const IslandStep& step, IslandResult& result);
    /// Solves the impacts of bodies that touch now, within no time: with restitution and friction, all points of a pair
    /// at once.
    void solve_impacts(Island& island, const IslandStep& step, IslandResult& result);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace plumbline::physics
