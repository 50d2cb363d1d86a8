// A program of Bullet's own: every setting as Bullet has it, shapes with their default margins.
#include "engine/bullet_world/small_step_dynamics_world.h"
#include "tests/benchmarks/peer_scenes_world.h"

#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <map>
#include <utility>

namespace plumbline::bench {

namespace {

btVector3 bullet(const Vec3& v) {
    return {v.x, v.y, v.z};
}

std::unique_ptr<btCollisionShape> bullet_shape(const physics::ShapeDef& def) {
    if (const auto* box = std::get_if<physics::BoxShape>(&def))
        return std::make_unique<btBoxShape>(bullet(box->size_m * 0.5_r));
    if (const auto* sphere = std::get_if<physics::SphereShape>(&def))
        return std::make_unique<btSphereShape>(sphere->radius_m);
    auto hull = std::make_unique<btConvexHullShape>();
    for (const Vec3& point : std::get<physics::HullShape>(def).points_m) {
        hull->addPoint(bullet(point), false);
    }
    hull->recalcLocalAabb();
    return hull;
}

/// How two materials combine, which Bullet keeps in global pointers.
struct Combiners {
    CalculateCombinedCallback friction{gCalculateCombinedFrictionCallback};
    CalculateCombinedCallback restitution{gCalculateCombinedRestitutionCallback};
    CalculateCombinedCallback rolling{gCalculateCombinedRollingFrictionCallback};
    CalculateCombinedCallback spinning{gCalculateCombinedSpinningFrictionCallback};

    void install() const {
        gCalculateCombinedFrictionCallback = friction;
        gCalculateCombinedRestitutionCallback = restitution;
        gCalculateCombinedRollingFrictionCallback = rolling;
        gCalculateCombinedSpinningFrictionCallback = spinning;
    }
};

/// Bullet's own: read before the first PhysicsWorld puts in ours.
const Combiners kStock;

template <class World>
class BareWorld final : public SteppedWorld {
public:
    BareWorld(const PeerScene& scene, double step_s)
        : scene_(scene), step_s_(static_cast<btScalar>(step_s)) {
        world_.setGravity(bullet(scene.description.gravity_mps2));
        for (const PeerBody& body : scene.bodies) add(body);
        for (const PeerJoint& joint : scene.joints) add(joint);
    }
    ~BareWorld() override {
        for (const auto& joint : joints_) world_.removeConstraint(joint.get());
        for (const auto& body : bodies_) world_.removeRigidBody(body.get());
    }
    BareWorld(const BareWorld&) = delete;
    BareWorld& operator=(const BareWorld&) = delete;

    void step() override {
        const Combiners others;
        kStock.install();
        world_.stepSimulation(step_s_, 0);
        others.install();
    }

    void read(std::vector<BodyView>& views) const override {
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            if (!scene_.bodies[i].dynamic()) continue;
            const btRigidBody& body = *bodies_[i];
            const btVector3& p = body.getWorldTransform().getOrigin();
            const btQuaternion q = body.getWorldTransform().getRotation();
            const btVector3& v = body.getLinearVelocity();
            const btVector3& w = body.getAngularVelocity();
            views[i].position = Vec3d(Vec3{p.x(), p.y(), p.z()});
            views[i].orientation = Quatd(Quat{q.w(), q.x(), q.y(), q.z()});
            views[i].velocity_mps = Vec3d(Vec3{v.x(), v.y(), v.z()});
            views[i].angular_velocity_radps = Vec3d(Vec3{w.x(), w.y(), w.z()});
        }
    }
    bool all_asleep() const override {
        for (const auto& body : bodies_) {
            if (!body->isStaticObject() && body->isActive()) return false;
        }
        return true;
    }

private:
    int group_bit(const std::string& name) {
        return groups_.try_emplace(name, 1 << groups_.size()).first->second;
    }

    /// One shape for all bodies that look alike and follow each other.
    btCollisionShape& shape_of(const PeerBody& body) {
        const auto* box = std::get_if<physics::BoxShape>(&body.shape);
        const auto* sphere = std::get_if<physics::SphereShape>(&body.shape);
        const Vec3 key = box != nullptr      ? box->size_m
                         : sphere != nullptr ? Vec3{sphere->radius_m, 0, 0}
                                             : Vec3{0, 0, 0};
        if (shapes_.empty() || key != last_key_) shapes_.push_back(bullet_shape(body.shape));
        last_key_ = key;
        return *shapes_.back();
    }

    void add(const PeerBody& body) {
        const bool dynamic = body.dynamic();
        btVector3 inertia(0, 0, 0);
        if (dynamic) inertia = bullet(*body.body.inertia_kgm2);
        btRigidBody::btRigidBodyConstructionInfo info(
            dynamic ? *body.body.mass_kg : 0.0F, nullptr, &shape_of(body), inertia);
        const Quat& q = body.start.orientation;
        info.m_startWorldTransform =
            btTransform(btQuaternion(q.x, q.y, q.z, q.w), bullet(body.start.position));
        // Bullet multiplies the two; the scenes mean sqrt(a*b), and one value a scene.
        info.m_friction = std::sqrt(*body.body.friction);
        info.m_restitution = std::sqrt(*body.body.restitution);
        auto rigid = std::make_unique<btRigidBody>(info);
        rigid->setLinearVelocity(bullet(body.body.velocity_mps));
        rigid->setAngularVelocity(bullet(body.body.angular_velocity_radps));
        if (dynamic && !body.body.can_sleep) rigid->setActivationState(DISABLE_DEACTIVATION);
        if (body.body.collides_with.empty()) {
            world_.addRigidBody(rigid.get());
        } else {
            int mask = 0;
            for (const std::string& name : body.body.collides_with) mask |= group_bit(name);
            world_.addRigidBody(rigid.get(), group_bit(body.body.group), mask);
        }
        bodies_.push_back(std::move(rigid));
    }

    void add(const PeerJoint& joint) {
        btRigidBody& a = *bodies_[joint.a];
        btRigidBody& b = *bodies_[joint.b];
        const btVector3 anchor = bullet(joint.anchor_m);
        joints_.push_back(
            std::make_unique<btPoint2PointConstraint>(a,
                                                      b,
                                                      a.getWorldTransform().inverse() * anchor,
                                                      b.getWorldTransform().inverse() * anchor));
        world_.addConstraint(joints_.back().get(), !joint.collide);
    }

    const PeerScene& scene_;
    btScalar step_s_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    World world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    std::map<std::string, int> groups_{{"default", 1}};
    Vec3 last_key_{0, 0, 0};
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
    std::vector<std::unique_ptr<btPoint2PointConstraint>> joints_;
};

}  // namespace

std::unique_ptr<SteppedWorld> make_bare_world(const PeerScene& scene, double step_s) {
    return std::make_unique<BareWorld<btDiscreteDynamicsWorld>>(scene, step_s);
}

std::unique_ptr<SteppedWorld> make_drop_in_world(const PeerScene& scene, double step_s) {
    return std::make_unique<BareWorld<SmallStepDynamicsWorld>>(scene, step_s);
}

}  // namespace plumbline::bench
