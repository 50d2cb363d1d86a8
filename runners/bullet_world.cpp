// Bullet as Debian packages it, with its own contacts, solver and defaults; but no sleep.
#include "runners/engine_world.h"
#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

namespace plumbline::engines {
namespace {

btVector3 vector_of(const Json& json) {
    return {json.at(0).get<btScalar>(), json.at(1).get<btScalar>(), json.at(2).get<btScalar>()};
}
btQuaternion rotation_of(const Json& json) {
    return {json.at(0).get<btScalar>(),
            json.at(1).get<btScalar>(),
            json.at(2).get<btScalar>(),
            json.at(3).get<btScalar>()};
}
btTransform place_of(const Json& json) {
    return btTransform(rotation_of(json.at("turn")), vector_of(json.at("at_m")));
}

/// Bodies as the scene combines them: sqrt(a b) and the larger.
btScalar combined_friction(const btCollisionObject* a, const btCollisionObject* b) {
    return std::sqrt(a->getFriction() * b->getFriction());
}
btScalar combined_restitution(const btCollisionObject* a, const btCollisionObject* b) {
    return std::max(a->getRestitution(), b->getRestitution());
}

struct Filter {
    std::uint32_t group{0};
    std::uint32_t mask{0};
};

class MaskFilter : public btOverlapFilterCallback {
public:
    std::vector<Filter> filters;

    bool needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const override {
        const Filter& first = filter_of(*a);
        const Filter& second = filter_of(*b);
        return (first.group & second.mask) != 0 && (second.group & first.mask) != 0;
    }

private:
    const Filter& filter_of(const btBroadphaseProxy& proxy) const {
        const auto* object = static_cast<const btCollisionObject*>(proxy.m_clientObject);
        return filters[static_cast<std::size_t>(object->getUserIndex())];
    }
};

/// The frame of a joint in a body: `axis` of the world along the frame's own x (`along` 0) or z (2).
btTransform frame_in(const btTransform& body,
                     const btVector3& at,
                     const btVector3& axis,
                     int along) {
    btVector3 p;
    btVector3 q;
    btPlaneSpace1(axis, p, q);
    const btMatrix3x3 turn =
        along == 0
            ? btMatrix3x3(axis.x(),
                          p.x(),
                          q.x(),  //
                          axis.y(),
                          p.y(),
                          q.y(),
                          axis.z(),
                          p.z(),
                          q.z())
            : btMatrix3x3(p.x(), q.x(), axis.x(), p.y(), q.y(), axis.y(), p.z(), q.z(), axis.z());
    return body.inverse() * btTransform(turn, at);
}

class BulletWorld : public EngineWorld {
public:
    explicit BulletWorld(const Json& scene)
        : step_s_(btScalar(1) / scene.at("step_hz").get<btScalar>()),
          dispatcher_(&configuration_),
          world_(&dispatcher_, &broad_phase_, &solver_, &configuration_) {
        refuse_specials(scene);
        gCalculateCombinedFrictionCallback = combined_friction;
        gCalculateCombinedRestitutionCallback = combined_restitution;
        world_.setGravity(vector_of(scene.at("gravity_mps2")));
        world_.getSolverInfo().m_numIterations =
            knob(scene, "iterations", world_.getSolverInfo().m_numIterations);
        world_.getPairCache()->setOverlapFilterCallback(&filter_);
        for (const Json& body : scene.at("bodies")) add(body);
        for (const Json& joint : scene.at("joints")) join(joint);
    }
    ~BulletWorld() override {
        for (const auto& joint : joints_) world_.removeConstraint(joint.get());
        for (const auto& body : bodies_) world_.removeRigidBody(body.get());
    }

    void set_state(std::size_t index, std::span<const double, kNumbers> state) override {
        btRigidBody& body = *bodies_[index];
        const auto number = [&state](std::size_t i) { return static_cast<btScalar>(state[i]); };
        const btTransform at(btQuaternion(number(3), number(4), number(5), number(6)),
                             btVector3(number(0), number(1), number(2)));
        body.setCenterOfMassTransform(at);
        body.setLinearVelocity({number(7), number(8), number(9)});
        body.setAngularVelocity({number(10), number(11), number(12)});
    }
    void get_state(std::size_t index, std::span<double, kNumbers> state) const override {
        const btRigidBody& body = *bodies_[index];
        const btQuaternion turn = body.getCenterOfMassTransform().getRotation();
        const btVector3& at = body.getCenterOfMassPosition();
        const btVector3& v = body.getLinearVelocity();
        const btVector3& w = body.getAngularVelocity();
        const btScalar numbers[kNumbers] = {at.x(),
                                            at.y(),
                                            at.z(),
                                            turn.x(),
                                            turn.y(),
                                            turn.z(),
                                            turn.w(),
                                            v.x(),
                                            v.y(),
                                            v.z(),
                                            w.x(),
                                            w.y(),
                                            w.z()};
        std::ranges::copy(numbers, state.begin());
    }
    void set_gravity(const Json& gravity_mps2) override {
        world_.setGravity(vector_of(gravity_mps2));
        for (const auto& body : bodies_) body->setGravity(vector_of(gravity_mps2));
    }
    void step() override { world_.stepSimulation(step_s_, 0); }

private:
    btCollisionShape* keep(std::unique_ptr<btCollisionShape> shape) {
        shapes_.push_back(std::move(shape));
        return shapes_.back().get();
    }

    btCollisionShape* shape_of(const Json& part) {
        const std::string kind = part.at("shape");
        const auto size = [&part](const char* key) { return part.at(key).get<btScalar>(); };
        if (kind == "box") return keep(std::make_unique<btBoxShape>(vector_of(part.at("half_m"))));
        if (kind == "sphere") return keep(std::make_unique<btSphereShape>(size("radius_m")));
        if (kind == "hull") {
            auto hull = std::make_unique<btConvexHullShape>();
            for (const Json& point : part.at("points_m")) hull->addPoint(vector_of(point), false);
            hull->recalcLocalAabb();
            return keep(std::move(hull));
        }
        if (kind == "mesh") {
            meshes_.push_back(std::make_unique<btTriangleMesh>());
            const Json& points = part.at("points_m");
            for (const Json& corners : part.at("triangles"))
                meshes_.back()->addTriangle(vector_of(points.at(corners.at(0).get<std::size_t>())),
                                            vector_of(points.at(corners.at(1).get<std::size_t>())),
                                            vector_of(points.at(corners.at(2).get<std::size_t>())));
            return keep(std::make_unique<btBvhTriangleMeshShape>(meshes_.back().get(), true));
        }
        const btScalar radius = size("radius_m");
        const btScalar half = size("half_height_m");
        if (kind == "capsule") return keep(std::make_unique<btCapsuleShape>(radius, 2 * half));
        if (kind == "cylinder")
            return keep(std::make_unique<btCylinderShape>(btVector3(radius, half, radius)));
        if (kind == "cone") return keep(std::make_unique<btConeShape>(radius, 2 * half));
        throw Lacks("a " + kind);
    }

    btCollisionShape* whole_shape(const Json& parts) {
        if (parts.size() == 1 && place_of(parts.at(0)) == btTransform::getIdentity())
            return shape_of(parts.at(0));
        auto whole = std::make_unique<btCompoundShape>();
        for (const Json& part : parts) whole->addChildShape(place_of(part), shape_of(part));
        return keep(std::move(whole));
    }

    void add(const Json& body) {
        const bool moves = body.at("kind") == "dynamic";
        const btVector3 inertia = moves ? vector_of(body.at("inertia_kgm2")) : btVector3(0, 0, 0);
        btRigidBody::btRigidBodyConstructionInfo info(
            moves ? body.at("mass_kg").get<btScalar>() : btScalar(0),
            nullptr,
            whole_shape(body.at("parts")),
            inertia);
        info.m_startWorldTransform = place_of(body);
        info.m_friction = body.at("friction");
        info.m_restitution = body.at("restitution");
        info.m_linearDamping = body.at("linear_damping_per_s");
        info.m_angularDamping = body.at("angular_damping_per_s");
        bodies_.push_back(std::make_unique<btRigidBody>(info));
        btRigidBody& made = *bodies_.back();
        made.setUserIndex(static_cast<int>(filter_.filters.size()));
        filter_.filters.push_back({body.at("group"), body.at("collides_with")});
        if (body.at("kind") == "kinematic")
            made.setCollisionFlags(made.getCollisionFlags() |
                                   btCollisionObject::CF_KINEMATIC_OBJECT);
        if (moves) made.setActivationState(DISABLE_DEACTIVATION);
        if (body.at("continuous")) {
            btVector3 low;
            btVector3 high;
            made.getCollisionShape()->getAabb(btTransform::getIdentity(), low, high);
            const btVector3 half = (high - low) / 2;
            const btScalar least = half[half.minAxis()];
            made.setCcdMotionThreshold(least / 2);
            made.setCcdSweptSphereRadius(least / 2);
        }
        world_.addRigidBody(&made);
    }

    void join(const Json& joint) {
        const std::string kind = joint.at("kind");
        btRigidBody& a = *bodies_[joint.at("a").get<std::size_t>()];
        const int number_of_b = joint.at("b");
        btRigidBody& b = number_of_b < 0 ? btTypedConstraint::getFixedBody()
                                         : *bodies_[static_cast<std::size_t>(number_of_b)];
        const btVector3 at = vector_of(joint.at("anchor_a_m"));
        const btVector3 axis = vector_of(joint.at("axis"));
        const auto frame = [&](const btRigidBody& body, int along) {
            return frame_in(body.getCenterOfMassTransform(), at, axis, along);
        };
        std::unique_ptr<btTypedConstraint> made;
        if (kind == "ball") {
            made = std::make_unique<btPoint2PointConstraint>(
                a, b, frame(a, 0).getOrigin(), frame(b, 0).getOrigin());
        } else if (kind == "fixed") {
            made = std::make_unique<btFixedConstraint>(a, b, frame(a, 0), frame(b, 0));
        } else if (kind == "hinge") {
            made =
                hinge(joint, std::make_unique<btHingeConstraint>(a, b, frame(a, 2), frame(b, 2)));
        } else if (kind == "slider") {
            made = slider(
                joint, std::make_unique<btSliderConstraint>(b, a, frame(b, 0), frame(a, 0), true));
        } else if (kind == "cone") {
            made = cone(joint,
                        std::make_unique<btConeTwistConstraint>(a, b, frame(a, 0), frame(b, 0)));
        } else {
            throw Lacks("joints of kind " + kind);
        }
        world_.addConstraint(made.get(), !joint.at("collide").get<bool>());
        joints_.push_back(std::move(made));
    }

    std::unique_ptr<btTypedConstraint> hinge(const Json& joint,
                                             std::unique_ptr<btHingeConstraint> made) const {
        if (joint.contains("limits")) {
            const btScalar least = joint.at("limits").at(0);
            const btScalar most = joint.at("limits").at(1);
            if (std::max(-least, most) > SIMD_PI) throw Lacks("a hinge that counts turns");
            made->setLimit(least, most);
        }
        if (joint.contains("motor"))
            made->enableAngularMotor(true,
                                     joint.at("motor").at("target"),
                                     joint.at("motor").at("max").get<btScalar>() * step_s_);
        return made;
    }

    static std::unique_ptr<btTypedConstraint> slider(const Json& joint,
                                                     std::unique_ptr<btSliderConstraint> made) {
        const bool is_limited = joint.contains("limits");
        made->setLowerLinLimit(is_limited ? joint.at("limits").at(0).get<btScalar>() : btScalar(1));
        made->setUpperLinLimit(is_limited ? joint.at("limits").at(1).get<btScalar>()
                                          : btScalar(-1));
        made->setLowerAngLimit(0);
        made->setUpperAngLimit(0);
        if (joint.contains("motor")) {
            made->setPoweredLinMotor(true);
            made->setTargetLinMotorVelocity(joint.at("motor").at("target"));
            made->setMaxLinMotorForce(joint.at("motor").at("max"));
        }
        return made;
    }

    static std::unique_ptr<btTypedConstraint> cone(const Json& joint,
                                                   std::unique_ptr<btConeTwistConstraint> made) {
        const auto larger = [&joint](const char* key) -> btScalar {
            if (!joint.contains(key)) return BT_LARGE_FLOAT;
            const btScalar least = joint.at(key).at(0);
            const btScalar most = joint.at(key).at(1);
            return std::max(std::abs(least), std::abs(most));
        };
        if (joint.contains("twist_limits") && joint.at("twist_limits").at(0).get<double>() !=
                                                  -joint.at("twist_limits").at(1).get<double>())
            throw Lacks("limits of twist that differ");
        made->setLimit(larger("limits"), larger("limits"), larger("twist_limits"));
        return made;
    }

    btScalar step_s_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase broad_phase_;
    btSequentialImpulseConstraintSolver solver_;
    MaskFilter filter_;
    btDiscreteDynamicsWorld world_;
    std::vector<std::unique_ptr<btTriangleMesh>> meshes_;
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
    std::vector<std::unique_ptr<btTypedConstraint>> joints_;
};

}  // namespace

Engine bullet_engine() {
    static const std::string version =
        std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100);
    return {"bullet", version.c_str(), [](const Json& scene) -> std::unique_ptr<EngineWorld> {
                return std::make_unique<BulletWorld>(scene);
            }};
}

}  // namespace plumbline::engines
