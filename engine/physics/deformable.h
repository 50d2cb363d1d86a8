// A deforming body among rigid ones: what holds it, what it touches, and when it sleeps.
//
// Within each sub-step of the bodies it takes its own, shorter ones, and moves the bodies along with what it pushes them by: what a
// body gets in its sub-step is the sum. Points touch bodies; where a body is small against the cells, places between them do, too.
#pragma once

#include "engine/physics/force_field.h"
#include "engine/physics/point_body.h"
#include "engine/physics/self_contacts.h"
#include "engine/physics/surface_contacts.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace plumbline {
class Archive;
}

namespace plumbline::physics {

class PhysicsWorld;

struct DeformablePin {
    std::size_t point{0};
    BodyId to{};  ///< none: the world
};

struct DeformableDef {
    double thickness_m{0.004};
    double friction{0.5};
    bool self_collision{false};
    double substeps_per_s{6000};  ///< at most
    std::vector<DeformablePin> pins{};
};

class Deformable {
public:
    /// Bodies are where the pins hold them at the start.
    Deformable(const PhysicsWorld& world,
               std::unique_ptr<PointBody> body,
               const DeformableDef& def);

    const PointBody& body() const { return *body_; }
    /// To be set before begin_step(): PointBody::fluids().
    std::vector<FluidAtPoint>& fluids() { return body_->fluids(); }
    /// What it floats in moves: it does not sleep in the coming step.
    void stir() { is_stirred_ = true; }
    /// At once, and wakes it.
    void strike(std::size_t point, const Vec3d& impulse_Ns);
    /// Takes hold of points in the middle of play, as a hand does; those that pins hold are theirs. In place of what was held before.
    void grip(std::span<const std::uint32_t> points);
    bool is_gripped() const { return !grip_.points.empty() && !grip_.is_frost; }
    /// Where what is gripped goes to within the coming step, all of it alike.
    void lead_grip(const Vec3d& by_m);
    /// What it pulled the hand by in the latest step.
    const Vec3d& grip_Ns() const { return grip_.pulled_Ns; }
    void let_go();
    /// Holds all of it where it is, or lets go. A hand that takes hold of what is frozen thaws it.
    void set_frozen(bool frozen);
    bool is_frozen() const { return grip_.is_frost; }
    /// Looks for what is near, lets go of what is gone and wakes, or falls asleep.
    void begin_step(PhysicsWorld& world, double step_s);
    bool is_asleep() const { return asleep_; }
    /// The dynamic bodies that it pushes in this step; those that sleep do not move.
    std::span<const BodyId> movable() const { return movable_; }
    /// Of the points that it has pinned to a body: they move along with it.
    double pinned_kg(BodyId body) const;
    /// One sub-step of the bodies.
    void act(const PhysicsWorld& world, std::span<BodyInField* const> bodies, double seconds);
    /// What no sub-step of bodies has done of the step.
    void end_step(const PhysicsWorld& world);
    /// Own sub-steps in the step so far.
    std::uint64_t substeps() const { return substeps_; }

    void serialize(Archive& archive);

private:
    struct Holder {
        std::size_t point{0};
        BodyId to{};
        Vec3d in_mass_m{0, 0, 0};  ///< in the mass frame of what holds it; world
        std::size_t near{0};       ///< its number among the bodies near, in this step
    };
    /// What a hand holds, or frost.
    struct Grip {
        std::vector<std::uint32_t> points;
        std::vector<Vec3d> places_m;  ///< where it holds them
        Vec3d pulled_Ns{0, 0, 0};     ///< in the step
        bool is_frost{false};         ///< not a hand's: it is frozen

        void serialize(Archive& archive);
    };
    /// What pushes made of a body in the sub-step before, if nothing else held it: what stands on something does not move so.
    struct Expected {
        BodyId body{};
        Vec3d pushed_mps{0, 0, 0};
        Vec3d velocity_mps{0, 0, 0};

        void serialize(Archive& archive);
    };
    /// What the sheet does to a body that sleeps.
    struct Load {
        BodyId body{};
        Vec3d force_N{0, 0, 0};

        void serialize(Archive& archive);
    };

    bool is_blown() const;
    void list_near(const PhysicsWorld& world);
    void add_near(const PhysicsWorld& world, BodyId id);
    void wake_touched(PhysicsWorld& world);
    void rest(double step_s, bool disturbed);
    void place_near(std::span<BodyInField* const> bodies, double seconds);
    double yield_of(BodyId body, const Vec3d& start_mps) const;
    void note_expected(const Vec3d& gravity_mps2, double seconds);
    void substep(const Vec3d& gravity_mps2, double h, double left_s);
    void lead_pins(double h, double left_s);
    void load_holders();

    std::unique_ptr<PointBody> body_;
    DeformableDef def_;  ///< without pins: holders_ has them
    std::vector<Holder> holders_;
    Grip grip_;
    std::vector<NearBody> near_;
    std::vector<BodyId> movable_;
    std::vector<Expected> expected_;
    std::vector<Load> loads_;   ///< when they fell asleep
    std::vector<Load> felt_;    ///< in the latest step
    std::vector<BodyId> seen_;  ///< what was near in the step before
    SurfaceContacts contacts_;
    std::optional<SelfContacts> self_contacts_;  ///< of one that touches itself
    bool is_stirred_{false};
    double step_s_{0};
    double done_s_{0};           ///< of the step
    std::vector<Vec3d> kept_m_;  ///< its points at the start of the sub-step
    std::vector<Vec3d> calm_m_;  ///< where its points were when it last had moved
    double calm_s_{0};           ///< since then
    bool asleep_{false};
    std::uint64_t substeps_{0};
};

}  // namespace plumbline::physics
