// A body made of points that deforms: its state, and the order of one of its sub-steps. Knows nothing of other bodies.
#pragma once

#include "engine/core/math.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace plumbline {
class Archive;
}

namespace plumbline::physics {

/// A place on the surface, between up to four points; weights sum to 1.
struct SurfacePlace {
    std::array<std::uint32_t, 4> points{};
    std::array<double, 4> weights{};
};

/// What a surface is made of, by numbers of points; without what is torn.
struct SurfaceParts {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::array<std::uint32_t, 2>> edges;
    bool encloses{false};  ///< the triangles enclose it, counter-clockwise from outside
    std::size_t torn{0};   ///< what was, when they were listed
};

/// What flows round a point, for a step: air, and water below its level.
struct FluidAtPoint {
    Vec3d air_mps{0, 0, 0};
    double level_m{-1e30};  ///< of its surface there; far below where there is none
    Vec3d flow_mps{0, 0, 0};
    double density_kgpm3{0};
    double weight_Npm3{0};  ///< of the water
    double drag{1};         ///< times all that resists motion in it
    bool has_waves{false};  ///< which take with them what bobs
};

/// Sums over all points.
struct PointTotals {
    Vec3d moment_kgm{0, 0, 0};  ///< of mass times place
    Vec3d momentum_kgmps{0, 0, 0};
    Vec3d angular_momentum_kgm2ps{0, 0, 0};  ///< about the world's origin
    double kinetic_J{0};
    double elastic_J{0};
    double water_J{0};       ///< what the water that it displaces has risen by
    double displaced_m3{0};  ///< what of it is under water, by fluids()
};

/// World axes. Forces are explicit (symplectic Euler), in sub-steps that resolve the waves in it: at rest they balance exactly,
/// whatever the sub-steps, and momentum is kept. Where the sub-steps that are allowed do not resolve them, it is softer than it was
/// asked to be.
class PointBody {
public:
    virtual ~PointBody() = default;
    PointBody(const PointBody&) = delete;
    PointBody& operator=(const PointBody&) = delete;

    std::span<const Vec3d> positions_m() const { return positions_m_; }
    std::span<const Vec3d> velocities_mps() const { return velocities_mps_; }
    double mass_kg(std::size_t point) const { return masses_kg_[point]; }
    double mass_kg() const;
    /// 0: it is pinned.
    double inverse_mass(std::size_t point) const { return inverse_masses_[point]; }

    /// From now on the point goes where lead() says.
    void pin(std::size_t point) { inverse_masses_[point] = 0; }
    void unpin(std::size_t point) { inverse_masses_[point] = 1 / masses_kg_[point]; }
    /// What a pinned point pushed what holds it by in the latest sub-step, N s.
    const Vec3d& support_Ns(std::size_t point) const { return impulses_Ns_[point]; }

    /// Sub-steps that the coming `seconds` take, at most `most`. The sub-steps follow, one by one.
    virtual std::uint32_t plan(double seconds, std::uint32_t most) = 0;
    double substep_s() const { return substep_s_; }  ///< of the latest plan
    /// Sub-steps shorter than planned; what the plan made softer stays so.
    void shorten_substeps(double to_s) { substep_s_ = to_s; }
    /// Of the latest plan: the share of its stiffness that the sub-steps bear.
    double stiffness_share() const { return stiffness_share_; }
    /// Changes velocities by all forces of a sub-step.
    void accelerate(const Vec3d& gravity_mps2);
    /// At once: contacts, and what leads pinned points.
    void change_velocity(std::size_t point, const Vec3d& by_mps) {
        velocities_mps_[point] += by_mps;
    }
    /// What presses on a point, along a unit normal: of a body much heavier than what damping moves with the point. In the next
    /// sub-step's damping it does not yield along the normal, and the body takes what damping does there.
    void press(std::size_t point, const Vec3d& normal, double inverse_mass_pkg) {
        if (inverse_mass_pkg * kMuchHeavier * masses_kg_[point] * damping_ >= 1) return;
        braces_[point] = normal;
        is_braced_ = true;
    }
    /// Moves points along their velocities.
    void move(double seconds);
    /// Whether all numbers are finite and no point is faster than rigid bodies may be.
    bool is_sound() const;
    /// To places where it was, at rest.
    void put_back(std::span<const Vec3d> positions_m);

    virtual bool feels_air() const { return false; }
    /// By point, for whoever sets them; empty: still air and no water.
    std::vector<FluidAtPoint>& fluids() { return fluids_; }
    /// Places that may touch others, `along` of them on the side of each cell, both corners counted as one.
    virtual std::vector<SurfacePlace> places(std::uint32_t along) const = 0;
    /// Nothing is done where they are listed already as they are.
    virtual void list_parts(SurfaceParts& parts) const { parts = {}; }
    virtual double longest_side_m() const = 0;  ///< of a cell at rest
    PointTotals totals() const;

    void serialize(Archive& archive);

protected:
    static constexpr double kMuchHeavier = 4;  ///< times

    PointBody() = default;
    void add_point(const Vec3d& position_m, double mass_kg);

    /// For plan(): as many as wanted, as far as there may be; as many as there may be, too, where the number wanted is none. Sets
    /// substep_s_, and the share of the stiffness to 1.
    std::uint32_t take_substeps(double seconds, double wanted, std::uint32_t most);
    /// Adds to impulses_Ns_ what acts in the sub-step.
    virtual void add_forces() = 0;
    /// Before forces act: what they do comes whole to what touches the body.
    virtual void damp() {}
    virtual void after_move() {}
    virtual void serialize_own(Archive&) {}
    virtual double elastic_J() const = 0;
    virtual double water_J() const { return 0; }
    virtual double displaced_m3() const { return 0; }
    /// Of the forces on a point.
    virtual double weight_of(std::size_t) const { return 1; }

    std::vector<Vec3d> positions_m_;
    std::vector<Vec3d> velocities_mps_;
    std::vector<double> masses_kg_;
    std::vector<double> inverse_masses_;
    std::vector<Vec3d> impulses_Ns_;
    std::vector<Vec3d> braces_;  ///< by point: a normal, or zero
    bool is_braced_{false};      ///< any of them
    std::vector<FluidAtPoint> fluids_;
    double substep_s_{0};
    double damping_{
        0};  ///< of the latest plan: the share of its speed that the fastest mode loses in a sub-step, above 1 too
    double stiffness_share_{1};
};

/// A box round points; there is one at least.
struct PointBounds {
    Vec3d low_m{0, 0, 0};
    Vec3d high_m{0, 0, 0};
};
PointBounds bounds_of(std::span<const Vec3d> points_m);
double fastest_mps(std::span<const Vec3d> velocities_mps);

/// A pinned point, so fast.
void lead(PointBody& body, std::size_t point, const Vec3d& velocity_mps);
/// Leaves this share of all motion.
void slow_down(PointBody& body, double share);

}  // namespace plumbline::physics
