// Scenes as Bullet's own examples have them, in its world and in ours: what is meant to hold holds better.
#include "tests/engine/bullet_world/bullet_rig.h"

#include <algorithm>
#include <array>

namespace plumbline::bullet_world {
namespace {

constexpr btScalar kHalfPi = SIMD_HALF_PI;

btTransform at(const btVector3& place_m, btScalar about_z_rad = 0) {
    return btTransform(btQuaternion(btVector3(0, 0, 1), about_z_rad), place_m);
}

/// A person of eleven capsules, joined by hinges and cones.
template <class AnyRig>
class Ragdoll {
public:
    explicit Ragdoll(AnyRig& rig, btScalar up_m) : rig_(rig), up_m_(up_m) {
        btRigidBody& pelvis = part(0.15, 0.20, {0, 1, 0});
        btRigidBody& spine = part(0.15, 0.28, {0, 1.2, 0});
        btRigidBody& head = part(0.10, 0.05, {0, 1.6, 0});
        hinge(pelvis, spine, {0, 1.15, 0}, -SIMD_PI / 4, kHalfPi);
        cone(spine, head, {0, 1.5, 0}, kHalfPi, SIMD_PI / 4, kHalfPi);
        for (const double side : {-1.0, 1.0}) {
            btRigidBody& thigh = part(0.07, 0.45, {side * 0.18, 0.65, 0});
            btRigidBody& shin = part(0.05, 0.37, {side * 0.18, 0.2, 0});
            cone(pelvis, thigh, {side * 0.18, 0.9, 0}, -kHalfPi, SIMD_PI / 4, 0);
            hinge(thigh, shin, {side * 0.18, 0.425, 0}, 0, kHalfPi);
            btRigidBody& upper_arm = part(0.05, 0.33, {side * 0.35, 1.45, 0}, kHalfPi);
            btRigidBody& forearm = part(0.04, 0.25, {side * 0.7, 1.45, 0}, kHalfPi);
            cone(spine, upper_arm, {side * 0.2, 1.45, 0}, side > 0 ? 0 : SIMD_PI, kHalfPi, 0);
            hinge(upper_arm, forearm, {side * 0.525, 1.45, 0}, -kHalfPi, 0);
        }
    }

    /// How far the worst joint has come apart.
    double gap_m() const {
        double worst = 0;
        for (const Link& link : links_) {
            const btVector3 gap =
                link.a->getWorldTransform() * link.in_a - link.b->getWorldTransform() * link.in_b;
            worst = std::max(worst, static_cast<double>(gap.length()));
        }
        return worst;
    }
    double lowest_m() const {
        double lowest = 100;
        for (const btRigidBody* body : parts_) {
            const auto& capsule = static_cast<const btCapsuleShape&>(*body->getCollisionShape());
            const btScalar slope = std::abs(body->getWorldTransform().getBasis().getColumn(1).y());
            const btScalar end =
                place(*body).y() - slope * capsule.getHalfHeight() - capsule.getRadius();
            lowest = std::min(lowest, static_cast<double>(end));
        }
        return lowest;
    }
    bool asleep() const {
        return std::ranges::none_of(parts_, [](const auto* body) { return body->isActive(); });
    }
    double fastest_mps() const {
        double fastest = 0;
        for (const btRigidBody* body : parts_)
            fastest = std::max(fastest, static_cast<double>(body->getLinearVelocity().length()));
        return fastest;
    }

private:
    struct Link {
        btRigidBody* a;
        btRigidBody* b;
        btVector3 in_a;
        btVector3 in_b;
    };

    static btVector3 vector(const std::array<double, 3>& from) {
        return {static_cast<btScalar>(from[0]),
                static_cast<btScalar>(from[1]),
                static_cast<btScalar>(from[2])};
    }

    btRigidBody& part(double radius_m,
                      double length_m,
                      const std::array<double, 3>& place_m,
                      btScalar about_z_rad = 0) {
        auto& capsule = rig_.template shape<btCapsuleShape>(static_cast<btScalar>(radius_m),
                                                            static_cast<btScalar>(length_m));
        btRigidBody& body = rig_.loose(capsule, {0, 0, 0}, 1);
        body.setWorldTransform(at(vector(place_m) + btVector3(0, up_m_, 0), about_z_rad));
        body.setDamping(btScalar(0.05), btScalar(0.85));
        rig_.world.addRigidBody(&body);
        parts_.push_back(&body);
        return body;
    }

    std::pair<btTransform, btTransform> frames(btRigidBody& a,
                                               btRigidBody& b,
                                               const std::array<double, 3>& anchor_m,
                                               const btQuaternion& turn) {
        const btTransform joint(turn, vector(anchor_m) + btVector3(0, up_m_, 0));
        const btTransform in_a = a.getWorldTransform().inverse() * joint;
        const btTransform in_b = b.getWorldTransform().inverse() * joint;
        links_.push_back({&a, &b, in_a.getOrigin(), in_b.getOrigin()});
        return {in_a, in_b};
    }

    void hinge(btRigidBody& a,
               btRigidBody& b,
               const std::array<double, 3>& anchor_m,
               btScalar low_rad,
               btScalar high_rad) {
        const auto [in_a, in_b] = frames(a, b, anchor_m, btQuaternion(btVector3(0, 1, 0), kHalfPi));
        rig_.template join<btHingeConstraint>(false, a, b, in_a, in_b).setLimit(low_rad, high_rad);
    }

    void cone(btRigidBody& a,
              btRigidBody& b,
              const std::array<double, 3>& anchor_m,
              btScalar about_z_rad,
              btScalar swing_rad,
              btScalar twist_rad) {
        const auto [in_a, in_b] =
            frames(a, b, anchor_m, btQuaternion(btVector3(0, 0, 1), about_z_rad));
        rig_.template join<btConeTwistConstraint>(false, a, b, in_a, in_b)
            .setLimit(swing_rad, swing_rad, twist_rad);
    }

    AnyRig& rig_;
    btScalar up_m_;
    std::vector<btRigidBody*> parts_;
    std::vector<Link> links_;
};

struct Fallen {
    double worst_gap_m{0};
    double deepest_m{0};
    double fastest_mps{0};  ///< at the end
    bool asleep{false};
};

template <class AnyRig>
Fallen fall_of_a_ragdoll() {
    AnyRig rig;
    rig.floor();
    Ragdoll<AnyRig> ragdoll(rig, 1);
    Fallen fallen;
    for (int i = 0; i < 1200; ++i) {
        rig.world.stepSimulation(kStep_s, 1, kStep_s);
        fallen.worst_gap_m = std::max(fallen.worst_gap_m, ragdoll.gap_m());
        fallen.deepest_m = std::max(fallen.deepest_m, -ragdoll.lowest_m());
    }
    fallen.fastest_mps = ragdoll.fastest_mps();
    fallen.asleep = ragdoll.asleep();
    return fallen;
}

TEST(BulletExamples, ARagdollFallsAndKeepsItsJoints) {
    const Fallen ours = fall_of_a_ragdoll<OurRig>();
    const Fallen stock = fall_of_a_ragdoll<StockRig>();
    EXPECT_LT(ours.worst_gap_m, 1e-4);
    EXPECT_GT(stock.worst_gap_m, 0.01);
    EXPECT_LT(ours.deepest_m, 5e-3);
    EXPECT_GT(stock.deepest_m, 0.02);
    EXPECT_LT(ours.fastest_mps, 0.01);
    EXPECT_TRUE(ours.asleep);
}

/// Heights to which balls of restitution 0 to 1 rise again from a metre on a floor of restitution 1.
template <class AnyRig>
std::array<double, 5> rises_m() {
    AnyRig rig;
    rig.floor().setRestitution(1);
    auto& sphere = rig.template shape<btSphereShape>(btScalar(0.5));
    std::array<btRigidBody*, 5> balls{};
    std::array<double, 5> highest{};
    std::array<bool, 5> bounced{};
    for (std::size_t i = 0; i < balls.size(); ++i) {
        balls[i] = &rig.add(sphere, {btScalar(i) * 2, btScalar(1.5), 0}, 1);
        balls[i]->setRestitution(btScalar(i) / 4);
    }
    for (int step = 0; step < 90; ++step) {
        rig.world.stepSimulation(kStep_s, 1, kStep_s);
        for (std::size_t i = 0; i < balls.size(); ++i) {
            bounced[i] = bounced[i] || balls[i]->getLinearVelocity().y() > 0;
            if (bounced[i])
                highest[i] = std::max(highest[i], static_cast<double>(place(*balls[i]).y()) - 0.5);
        }
    }
    return highest;
}

TEST(BulletExamples, BallsRiseAsTheirRestitutionSays) {
    const auto ours = rises_m<OurRig>();
    const auto stock = rises_m<StockRig>();
    double stock_error_m = 0;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        const double e = static_cast<double>(i) / 4;
        EXPECT_NEAR(ours[i], e * e, 0.01) << e;
        stock_error_m = std::max(stock_error_m, std::abs(stock[i] - e * e));
    }
    EXPECT_GT(stock_error_m, 0.03);
}

/// A door on a hinge with a motor, which a heavy box stands in front of.
template <class AnyRig>
double door_gap_m() {
    AnyRig rig;
    rig.floor();
    btRigidBody& door =
        rig.add(rig.template shape<btBoxShape>(btVector3(btScalar(0.5), 1, btScalar(0.05))),
                {btScalar(0.5), btScalar(1.02), 0},
                20);
    rig.box({btScalar(0.7), btScalar(0.5), btScalar(0.9)}, 40);
    door.setActivationState(DISABLE_DEACTIVATION);
    auto& hinge = rig.template join<btHingeConstraint>(
        true, door, btVector3(btScalar(-0.5), 0, 0), btVector3(0, 1, 0), true);
    hinge.enableAngularMotor(true, btScalar(-1), 20);
    double worst = 0;
    for (int i = 0; i < 240; ++i) {
        rig.world.stepSimulation(kStep_s, 1, kStep_s);
        const btVector3 pivot = door.getWorldTransform() * btVector3(btScalar(-0.5), 0, 0);
        worst = std::max(worst, static_cast<double>(pivot.distance({0, btScalar(1.02), 0})));
    }
    return worst;
}

TEST(BulletExamples, ADoorThatPushesStaysOnItsHinge) {
    EXPECT_LT(door_gap_m<OurRig>(), 1e-3);
}

}  // namespace
}  // namespace plumbline::bullet_world
