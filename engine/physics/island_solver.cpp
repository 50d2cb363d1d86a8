// From Bullet's manifolds and our records to the small-step loop, and back.
#include "engine/physics/bullet_convert_impl.h"
#include "engine/physics/island_impl.h"
#include "engine/physics/physics_world_impl.h"
#include "engine/physics/small_step/island_loop.h"

#include <cmath>

namespace plumbline::physics {
namespace {

constexpr Real kPush_mps = 3;

/// A side of cylinders is round only where it is touched across their axis.
constexpr btScalar kAcrossAxis = btScalar(0.02);

Quatd double_orientation(const btMatrix3x3& basis) {
    btQuaternion q;
    basis.getRotation(q);
    return glm::normalize(Quatd{static_cast<double>(q.w()),
                                static_cast<double>(q.x()),
                                static_cast<double>(q.y()),
                                static_cast<double>(q.z())});
}

SymmetricMat3 symmetric(const btMatrix3x3& m) {
    return {
        .xx = m[0][0], .xy = m[0][1], .xz = m[0][2], .yy = m[1][1], .yz = m[1][2], .zz = m[2][2]};
}

SolverBody kinematic_body(const BodyRecord& record) {
    SolverBody body;
    body.velocity_mps = from_bullet(record.rigid->getLinearVelocity());
    body.spin_radps = from_bullet(record.rigid->getAngularVelocity());
    body.start_position_m = double_from_bullet(record.rigid->getWorldTransform().getOrigin());
    body.start_orientation = double_orientation(record.rigid->getWorldTransform().getBasis());
    return body;
}

SolverBody dynamic_body(const BodyRecord& record, const IslandStep& step, double h) {
    const btRigidBody& rigid = *record.rigid;
    SolverBody body = kinematic_body(record);
    body.inverse_mass = rigid.getInvMass();
    body.inverse_inertia = symmetric(rigid.getInvInertiaTensorWorld());
    body.inertia_kgm2 = record.inertia_kgm2;
    body.round_inertia = record.round_inertia;
    body.acceleration_mps2 = Vec3(step.gravity_mps2);
    if (record.forced) {
        body.acceleration_mps2 +=
            from_bullet((rigid.getTotalForce() - record.weight_N) * rigid.getInvMass());
        body.angular_acceleration_radps2 =
            from_bullet(rigid.getInvInertiaTensorWorld() * rigid.getTotalTorque());
    }
    if (record.linear_damping_per_s > 0)
        body.linear_keep = static_cast<Real>(std::exp(-record.linear_damping_per_s * h));
    if (record.angular_damping_per_s > 0)
        body.angular_keep = static_cast<Real>(std::exp(-record.angular_damping_per_s * h));
    if (record.flight.going) {
        body.start_position_m = record.flight.position_m;
        body.start_orientation = record.flight.orientation;
    }
    return body;
}

/// The radius with which a shape touches along `normal_world`: of balls, capsules and the sides of
/// cylinders; 0 for all else.
Real rounding_of(const btCollisionObject& object, int child, const btVector3& normal_world) {
    const btCollisionShape* shape = object.getCollisionShape();
    btMatrix3x3 basis = object.getWorldTransform().getBasis();
    if (shape->isCompound()) {
        const auto& compound = static_cast<const btCompoundShape&>(*shape);
        if (compound.getNumChildShapes() == 1) child = 0;
        if (child < 0 || child >= compound.getNumChildShapes()) return 0;
        shape = compound.getChildShape(child);
        basis *= compound.getChildTransform(child).getBasis();
    }
    switch (shape->getShapeType()) {
        case SPHERE_SHAPE_PROXYTYPE:
            return static_cast<const btSphereShape*>(shape)->getRadius();
        case CAPSULE_SHAPE_PROXYTYPE:
            return static_cast<const btCapsuleShape*>(shape)->getRadius();
        case CYLINDER_SHAPE_PROXYTYPE: {
            const auto& cylinder = static_cast<const btCylinderShape&>(*shape);
            const btVector3 axis = basis.getColumn(cylinder.getUpAxis());
            return std::abs(axis.dot(normal_world)) < kAcrossAxis ? cylinder.getRadius() : Real{0};
        }
        default:
            return 0;
    }
}

ContactPoint point_of(const btManifoldPoint& from,
                      const btCollisionObject& object_a,
                      const btCollisionObject& object_b,
                      Real h) {
    ContactPoint point;
    const btVector3& normal = from.m_normalWorldOnB;
    point.radius_a = rounding_of(object_a, from.m_index0, normal);
    point.radius_b = rounding_of(object_b, from.m_index1, normal);
    point.offset_a = from_bullet(from.getPositionWorldOnA() + normal * point.radius_a -
                                 object_a.getWorldTransform().getOrigin());
    point.offset_b = from_bullet(from.getPositionWorldOnB() - normal * point.radius_b -
                                 object_b.getWorldTransform().getOrigin());
    point.start_separation_m = from.getDistance();
    point.normal_Ns = from.m_appliedImpulse * h;
    point.tangent_Ns[0] = from.m_appliedImpulseLateral1 * h;
    point.tangent_Ns[1] = from.m_appliedImpulseLateral2 * h;
    return point;
}

}  // namespace

struct IslandSolver::Impl {
    IslandLoop loop;
    std::vector<BodyRecord*> records;      ///< of loop.bodies; null: the world
    std::vector<btManifoldPoint*> points;  ///< of loop.contacts.points

    std::uint32_t index_of(const btCollisionObject& object, const IslandStep& step, double h);
    void add_body(BodyRecord& record, const SolverBody& body);
    void add_manifold(btPersistentManifold& manifold, const IslandStep& step, double h);
    void add_joint(JointRecord& joint, const IslandStep& step, double h);
    void write_bodies();
    void write_points(double h);
    void write_joints(Island& island, double step_s);
};

IslandSolver::IslandSolver() : impl_(std::make_unique<Impl>()) {}
IslandSolver::~IslandSolver() = default;

void IslandSolver::Impl::add_body(BodyRecord& record, const SolverBody& body) {
    record.rigid->setCompanionId(static_cast<int>(loop.bodies.size()));
    records.push_back(&record);
    loop.bodies.push_back(body);
}

/// Kinematic bodies that move join the island when something of it touches them.
std::uint32_t IslandSolver::Impl::index_of(const btCollisionObject& object,
                                           const IslandStep&,
                                           double) {
    if (object.getCompanionId() >= 0) return static_cast<std::uint32_t>(object.getCompanionId());
    BodyRecord& record = record_of(object);
    if (record.kind != BodyKind::Kinematic) return kWorldBody;
    const btRigidBody& rigid = *record.rigid;
    if (rigid.getLinearVelocity().isZero() && rigid.getAngularVelocity().isZero())
        return kWorldBody;
    add_body(record, kinematic_body(record));
    return static_cast<std::uint32_t>(object.getCompanionId());
}

void IslandSolver::Impl::add_manifold(btPersistentManifold& manifold,
                                      const IslandStep& step,
                                      double h) {
    const btCollisionObject& object_a = *manifold.getBody0();
    const btCollisionObject& object_b = *manifold.getBody1();
    const std::uint32_t a = index_of(object_a, step, h);
    const std::uint32_t b = index_of(object_b, step, h);
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        btManifoldPoint& from = manifold.getContactPoint(i);
        const Vec3 normal = from_bullet(from.m_normalWorldOnB);
        std::vector<ContactGroup>& groups = loop.contacts.groups;
        if (i == 0 || groups.back().normal != normal) {
            ContactGroup group;
            group.a = a;
            group.b = b;
            group.first = static_cast<std::uint32_t>(loop.contacts.points.size());
            group.normal = normal;
            btVector3 tangent[2];
            btPlaneSpace1(from.m_normalWorldOnB, tangent[0], tangent[1]);
            group.tangent[0] = from_bullet(tangent[0]);
            group.tangent[1] = from_bullet(tangent[1]);
            group.friction = from.m_combinedFriction;
            group.restitution = from.m_combinedRestitution;
            group.rolling_m = from.m_combinedRollingFriction;
            group.spinning_m = from.m_combinedSpinningFriction;
            group.bounded = !loop.bodies[a].movable() || !loop.bodies[b].movable();
            groups.push_back(group);
        }
        ++groups.back().count;
        loop.contacts.points.push_back(point_of(from, object_a, object_b, static_cast<Real>(h)));
        points.push_back(&from);
    }
}

void IslandSolver::Impl::add_joint(JointRecord& joint, const IslandStep& step, double h) {
    SolverJoint entry = joint.solver;
    entry.a = index_of(*joint.a->rigid, step, h);
    entry.b = joint.b != nullptr ? index_of(*joint.b->rigid, step, h) : kWorldBody;
    loop.joints.push_back(entry);
}

void IslandSolver::Impl::write_bodies() {
    for (std::size_t i = 1; i < loop.bodies.size(); ++i) {
        BodyRecord& record = *records[i];
        const SolverBody& body = loop.bodies[i];
        btRigidBody& rigid = *record.rigid;
        rigid.setCompanionId(-1);
        if (!body.movable()) continue;
        Flight& flight = record.flight;
        flight.position_m = body.start_position_m + Vec3d(body.moved_m);
        flight.orientation = glm::normalize(Quatd(body.turned) * body.start_orientation);
        flight.velocity_mps = Vec3d(body.velocity_mps);
        flight.spin_radps = Vec3d(body.spin_radps);
        flight.going = true;
        rigid.setLinearVelocity(to_bullet(body.velocity_mps));
        rigid.setAngularVelocity(to_bullet(body.spin_radps));
        rigid.setCenterOfMassTransform(
            to_bullet(Pose{Vec3(flight.position_m), Quat(flight.orientation)}));
    }
}

void IslandSolver::Impl::write_points(double h) {
    const Real per_s = static_cast<Real>(1 / h);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const ContactPoint& point = loop.contacts.points[i];
        points[i]->m_appliedImpulse = point.normal_Ns * per_s;
        points[i]->m_appliedImpulseLateral1 = point.tangent_Ns[0] * per_s;
        points[i]->m_appliedImpulseLateral2 = point.tangent_Ns[1] * per_s;
        set_frame_impulse(*points[i], point.total_Ns);
    }
}

void IslandSolver::Impl::write_joints(Island& island, double step_s) {
    for (std::size_t i = 0; i < island.joints.size(); ++i) {
        JointRecord& joint = *island.joints[i];
        joint.solver = loop.joints[i];
        joint.state.error_m = joint.solver.error_m;
        joint.state.force_N =
            static_cast<Real>(glm::length(joint.solver.total_impulse_Ns) / step_s);
        joint.state.torque_Nm =
            static_cast<Real>(glm::length(joint.solver.total_angular_impulse_Nms) / step_s);
        joint.state.position = static_cast<Real>(joint.solver.position);
    }
}

void IslandSolver::solve(Island& island, const IslandStep& step) {
    Impl& impl = *impl_;
    impl.loop.clear();
    impl.records.assign(1, nullptr);
    impl.points.clear();
    const int substeps = std::max(step.substeps_least, step.substeps_most);
    const double h = step.step_s / substeps;
    for (BodyRecord* record : island.bodies) impl.add_body(*record, dynamic_body(*record, step, h));
    for (btPersistentManifold* manifold : island.manifolds) impl.add_manifold(*manifold, step, h);
    for (JointRecord* joint : island.joints) impl.add_joint(*joint, step, h);

    const LoopReport report =
        impl.loop.run({.step_s = step.step_s,
                       .substeps = substeps,
                       .iterations = step.iterations,
                       .gravity_mps2 = static_cast<Real>(glm::length(step.gravity_mps2)),
                       .push_mps = kPush_mps,
                       .gyroscopic_torque = step.features.gyroscopic_torque});
    impl.write_bodies();
    impl.write_points(h);
    impl.write_joints(island, step.step_s);
    step.cost->row_solves += report.row_solves;
    step.cost->contacts += static_cast<std::uint32_t>(impl.points.size());
}

}  // namespace plumbline::physics
