// Places of a deforming body's surface that touch rigid bodies.
#pragma once

#include "engine/physics/force_field.h"
#include "engine/physics/point_body.h"

#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace plumbline::physics {

class PhysicsWorld;

/// How thick a surface is, and how rough.
struct SurfaceTraits {
    double thickness_m{0.004};
    double friction{0.5};
};

/// A rigid body as it moves through a sub-step.
struct NearMotion {
    BodyInField* state{nullptr};  ///< null: it does not feel what touches it
    Vec3d center_m{0, 0, 0};
    Quatd world_from_mass{1, 0, 0, 0};
    Vec3d velocity_mps{0, 0, 0};  ///< of the centre of mass
    Vec3d spin_radps{0, 0, 0};
    bool falls{false};  ///< by gravity
    double inverse_mass{0};
    Vec3d inverse_inertia{0, 0, 0};  ///< principal
    Vec3d start_mps{0, 0, 0};
    Vec3d pushed_Ns{0, 0, 0};  ///< within the sub-step

    /// `body`: in the middle of a sub-step of so long; null: it goes on as it was.
    void start(BodyInField* body, double seconds);
    /// Of the speed that a push would give it if it were free. It has a state.
    void give_way(double share);
    void push(const Vec3d& impulse_Ns, const Vec3d& arm_m);
    void move(double h);
};

/// A rigid body near a deforming one.
struct NearBody {
    BodyId id{};
    NearMotion own{};
    NearMotion* shared{
        nullptr};  ///< of another deforming body that takes its sub-steps along; null: its own
    SurfaceMotion belt{};
    double friction{0};
    std::uint32_t places{1};  ///< along a cell's side that may touch it
    bool touches{true};       ///< else it only holds pins
    bool can_wake{false};     ///< asleep, and dynamic
    bool is_kinematic{false};
    Vec3d felt_Ns{0, 0, 0};  ///< in the step

    NearMotion& motion() { return shared != nullptr ? *shared : own; }
    const NearMotion& motion() const { return shared != nullptr ? *shared : own; }
    /// `arm_m`: from its centre of mass.
    void push(const Vec3d& impulse_Ns, const Vec3d& arm_m) {
        felt_Ns += impulse_Ns;
        motion().push(impulse_Ns, arm_m);
    }
    /// Whether what lies on it is carried along.
    bool carries() const {
        return own.velocity_mps != Vec3d{0, 0, 0} || own.spin_radps != Vec3d{0, 0, 0} ||
               belt.velocity_mps != Vec3{0, 0, 0} || belt.spin_radps != Vec3{0, 0, 0};
    }
};

/// How fast what is so far apart must part at least, so that nothing sinks in within `h`; below 0: it may approach. What has sunk
/// in comes out little by little.
double wanted_opening_mps(double gap_m, double h);

class SurfaceContacts {
public:
    /// Forgets what there was and looks for what may touch within `seconds`, as bodies are at their start.
    void find(const PhysicsWorld& world,
              const PointBody& body,
              std::span<const NearBody> near,
              double thickness_m,
              double seconds);
    /// Changes velocities so that nothing goes deeper within `h`, with friction; the same points and bodies as found.
    void solve(PointBody& body, std::span<NearBody> near, double h);
    /// After points and bodies have moved for `h`.
    void follow(const PointBody& body, std::span<const NearBody> near, double h);

private:
    struct Contact {
        std::uint32_t near{0};
        SurfacePlace place{};
        Vec3d normal{0, 1, 0};  ///< out of the body
        Vec3d arm_m{0, 0, 0};   ///< from the body's centre
        double gap_m{0};
        double pressed_Ns{0};  ///< in the sub-step at hand
        Vec3d rubbed_Ns{0, 0, 0};
    };

    static void solve_one(Contact& contact, PointBody& body, NearBody& near, double h);

    std::vector<Contact> contacts_;
    std::map<std::uint32_t, std::vector<SurfacePlace>> places_;  ///< by how many along a side
};

}  // namespace plumbline::physics
