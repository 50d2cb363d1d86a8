// A deforming body among rigid ones: what holds it, what it touches, and when it sleeps. Deformables takes its steps.
//
// Within each sub-step of the bodies it takes its own, shorter ones, and moves the bodies along with what it pushes them by: what a
// body gets in its sub-step is the sum. Points touch bodies; where a body is small against the cells, places between them do, too.
#pragma once

#include "engine/physics/force_field.h"
#include "engine/physics/point_body.h"
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

class PartContacts;
class PhysicsWorld;

struct DeformablePin {
    std::size_t point{0};
    BodyId to{};  ///< none: the world
};

struct DeformableDef {
    SurfaceTraits surface{};
    bool self_collision{false};
    double substeps_per_s{6000};  ///< at most
    bool asleep{false};           ///< at the start: as it is it hangs or lies still
    std::vector<DeformablePin> pins{};
};

class Deformable {
public:
    /// Bodies are where the pins hold them at the start.
    Deformable(const PhysicsWorld& world,
               std::unique_ptr<PointBody> body,
               const DeformableDef& def);
    ~Deformable();
    Deformable(const Deformable&) = delete;
    Deformable& operator=(const Deformable&) = delete;

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
    bool is_asleep() const { return rest_.asleep; }
    /// The dynamic bodies that it pushes in this step; those that sleep do not move.
    std::span<const BodyId> movable() const { return movable_; }
    /// Of the points that it has pinned to a body: they move along with it.
    double pinned_kg(BodyId body) const;
    /// By which it pushed what does not yield to it, as a person's body, all through the latest step that it was awake in; 0: it did not.
    Vec3d force_on(BodyId body) const;
    /// Own sub-steps in the step so far.
    std::uint64_t substeps() const { return done_.substeps; }

    void serialize(Archive& archive);

private:
    friend class Deformables;
    static constexpr double kCalm_s = 2;  ///< of none of its points moving: then it sleeps

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

    /// What has not moved for a while.
    struct Rest {
        std::vector<Vec3d> places_m;  ///< of its points when it last had moved
        double calm_s{0};             ///< since then
        bool asleep{false};
    };
    struct Done {
        std::uint64_t substeps{0};  ///< in the step
        std::uint32_t taken{0};     ///< in the bodies' sub-step, of ...
        std::uint32_t most{1};
    };

    // --- a step, in this order
    /// Looks for what is near, lets go of what is gone and wakes what its load has changed of.
    void begin_step(PhysicsWorld& world, double step_s);
    bool is_calm() const { return rest_.calm_s > kCalm_s; }
    void fall_asleep(bool sleeps);
    // ... a sub-step of the bodies
    void begin_act(const PhysicsWorld& world, std::span<BodyInField* const> bodies, double seconds);
    /// Own sub-steps that it wants for the rest of it.
    std::uint32_t plan(double left_s);
    // ... one of its own, or of those that it takes them with
    void lead(const Vec3d& gravity_mps2, double h, double left_s);
    void feel(const Vec3d& gravity_mps2);  ///< forces, over as long as it planned
    void touch(double h);
    void move(double h);
    // ...
    void end_act(const Vec3d& gravity_mps2, double seconds);
    void end_step(double step_s);

    /// Of those bodies that are near `first`, too, there is one motion.
    void share_motions(Deformable& first);
    void disturb() { rest_.calm_s = 0; }
    void wake() {
        rest_.asleep = false;
        disturb();
    }
    bool is_blown() const;
    void list_near(const PhysicsWorld& world, double step_s);
    void find_reach(double step_s);
    std::uint32_t places_against(const PhysicsWorld& world, BodyId id, BodyKind kind) const;
    void add_near(const PhysicsWorld& world, BodyId id);
    void wake_touched(PhysicsWorld& world);
    void note_rest(double step_s, bool disturbed);
    void place_near(std::span<BodyInField* const> bodies, double seconds);
    double yield_of(BodyId body, const Vec3d& start_mps) const;
    void note_expected(const Vec3d& gravity_mps2, double seconds);
    void lead_pins(double h, double left_s);
    void load_holders();

    std::unique_ptr<PointBody> body_;
    DeformableDef def_;  ///< without pins: holders_ has them
    std::vector<Holder> holders_;
    Grip grip_;
    std::vector<NearBody> near_;
    std::vector<BodyId> movable_;
    std::vector<Expected> expected_;
    std::vector<Load> loads_;  ///< when they fell asleep
    std::vector<Load> felt_;   ///< in the latest step
    std::vector<Load> borne_;  ///< by what is kinematic, when it last was awake
    std::optional<std::vector<BodyId>>
        seen_;  ///< what was near in the step before, if it knows one
    SurfaceContacts contacts_;
    std::unique_ptr<PartContacts> self_contacts_;  ///< of one that touches itself; else null
    bool is_stirred_{false};
    PointBounds reach_;          ///< where it may be within the step
    std::vector<Vec3d> kept_m_;  ///< its points at the start of the sub-step
    Rest rest_;
    Done done_;
};

}  // namespace plumbline::physics
