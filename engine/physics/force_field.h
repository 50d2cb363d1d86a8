// Forces that depend on where bodies are and how they move: air, water, magnets. A step asks for them in every
// sub-step. Whoever makes a field owns it and hands it to PhysicsWorld::step().
#pragma once

#include "engine/core/math.h"
#include "engine/physics/body.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace plumbline::physics {

/// A body in the middle of a sub-step: where its velocity takes it in half of it, with half of what else changes its
/// velocity. What acts there makes the sub-step symmetric, hence of second order (leapfrog: Hairer, Lubich and Wanner,
/// Geometric Numerical Integration, I.1.4). Mass frame; world axes.
struct BodyInField {
    BodyId id{};
    Vec3d center_m{0, 0, 0};            ///< of mass
    Quatd world_from_mass{1, 0, 0, 0};  ///< the principal axes of inertia
    Vec3d velocity_mps{0, 0, 0};        ///< of the centre of mass
    Vec3d gain_mps{0, 0, 0};            ///< what all else changes it by in the sub-step
    Vec3d spin_radps{0, 0, 0};
    double mass_kg{0};            ///< with what moves along (ForceField::added_mass_kg)
    Vec3d inertia_kgm2{0, 0, 0};  ///< principal
    Vec3d impulse_Ns{0, 0, 0};    ///< what fields push it by in the sub-step: act() adds to it ...
    Vec3d angular_impulse_Nms{0, 0, 0};  ///< ... about the centre of mass, and to this

    void push(const Vec3d& impulse, const Vec3d& point_m) {
        impulse_Ns += impulse;
        angular_impulse_Nms += glm::cross(point_m - center_m, impulse);
    }
};

/// A sub-step: its middle, seconds since the step's start, and its length.
struct FieldTime {
    double at_s{0};
    double h_s{0};
};

class ForceField {
public:
    using Pair = std::pair<BodyId, BodyId>;

    virtual ~ForceField() = default;
    /// Whether the body is one of those that it acts on; they are dynamic. The same all through a step.
    virtual bool acts_on(BodyId body) const = 0;
    /// Adds to what the bodies are pushed by in a sub-step. It acts on all of them; bodies of different calls do not push
    /// each other in this step. What depends on velocity is to be solved over the whole of `time.h_s`.
    virtual void act(std::span<BodyInField* const> bodies, const FieldTime& time) = 0;
    /// Adds the awake bodies that push each other: they are solved together.
    virtual void list_pairs(std::vector<Pair>&) const {}
    /// Of the medium that moves along with the body, for the step to come.
    virtual double added_mass_kg(BodyId) const { return 0; }
    /// The least number of sub-steps that its bodies get. small_step only.
    virtual int substeps() const { return 1; }
    /// Potential energy of its bodies in it, as they are between steps.
    virtual double energy_J() const { return 0; }
    /// Whether bodies may come to rest on it, as on a floor.
    virtual bool carries() const { return false; }
};

/// What thresholds measure forces by, whatever the scene's gravity.
inline constexpr double kStandardGravity_mps2 = 9.80665;

/// More fields than this at once are not asked.
inline constexpr std::size_t kMostFields = 32;

}  // namespace plumbline::physics
