// Where deforming surfaces touch, one itself or two each other: points against triangles, edges against edges.
#pragma once

#include "engine/physics/deformable/part_pairs.h"
#include "engine/physics/point_body.h"
#include "engine/physics/surface_contacts.h"

#include <cstdint>
#include <span>
#include <vector>

namespace plumbline {
class Archive;
}

namespace plumbline::physics {

/// What has passed through is sent back: on which side of each other two parts were when they came near is remembered for as long
/// as they are. What encloses something is touched from outside. The bodies outlive it.
class PartContacts {
public:
    /// Of a body with itself, as it is at rest: what lies closer together there than the thickness may stay so.
    PartContacts(PointBody& body, const SurfaceTraits& traits);
    /// Of two bodies with each other.
    PartContacts(PointBody& first, PointBody& second, const SurfaceTraits& traits);

    /// Lists what may touch within `seconds`, unless what was listed still holds it; solve() does so anew where points have moved on.
    void begin_step(double seconds);
    /// Changes velocities so that nothing comes closer than the thickness within `h`, with friction; momentum is kept.
    void solve(double h);
    /// After points have moved for `h`.
    void follow(double h);

    void serialize(Archive& archive);

private:
    /// A place on one part of the surface against one on another.
    struct Contact : PartPlace {
        Vec3d normal{0, 1, 0};  ///< from the second to the first
        double inverse_mass{0};
        double gap_m{0};
        double pressed_Ns{0};  ///< in the sub-step at hand
        Vec3d rubbed_Ns{0, 0, 0};
    };
    double inverse_mass(std::uint32_t point) const;
    void change_velocity(std::uint32_t point, const Vec3d& by_mps);
    void look_anew();
    void look(double h);
    void find_normals();
    Vec3d facing_of(const Contact& contact, bool are_edges) const;
    bool turn(const PartPair& pair, Contact& contact, double& distance_m) const;
    void add(PartPair& pair, double seconds);
    void solve_one(Contact& contact, double h);

    PointBody* first_;
    PointBody* second_{nullptr};  ///< none: of one with itself
    SurfaceTraits traits_;
    std::vector<Vec3d> rest_m_;  ///< of one with itself
    PartPairs near_;
    std::vector<Vec3d> normals_;  ///< of all points, as of the latest look_anew()
    double seconds_{0};           ///< of the step
    double fastest_mps_{0};       ///< of points at its start, and what it may become
    double looked_for_s_{0};      ///< so long contacts_ are what may touch ...
    double look_in_s_{0};         ///< ... of which so much is left
    std::vector<Contact> contacts_;
};

}  // namespace plumbline::physics
