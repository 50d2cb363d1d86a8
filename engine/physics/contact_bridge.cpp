#include "engine/physics/bullet_convert_impl.h"
#include "engine/physics/contact_bridge_impl.h"
#include "engine/physics/island_impl.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

/// A side of cylinders is round only where it is touched across their axis.
constexpr btScalar kAcrossAxis = btScalar(0.02);

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

bool is_new(const btManifoldPoint& point) {
    return point.m_appliedImpulse == 0 && point.getLifeTime() <= 1;
}

}  // namespace

void ContactBridge::begin_step() {
    std::swap(last_loads_, loads_);
    loads_.clear();
    entries_.clear();
}

void ContactBridge::start_block(const btManifoldPoint& from,
                                const btCollisionObject& object_a,
                                const btCollisionObject& object_b,
                                ContactBlock& block) const {
    const btVector3& normal = from.m_normalWorldOnB;
    block.normal = from_bullet(normal);
    block.radius_a = rounding_of(object_a, from.m_index0, normal);
    block.radius_b = rounding_of(object_b, from.m_index1, normal);
    btVector3 tangent[2];
    btPlaneSpace1(normal, tangent[0], tangent[1]);
    block.tangent[0] = from_bullet(tangent[0]);
    block.tangent[1] = from_bullet(tangent[1]);
    block.friction = from.m_combinedFriction;
    block.restitution = from.m_combinedRestitution;
    block.rolling_m = from.m_combinedRollingFriction;
    block.spinning_m = from.m_combinedSpinningFriction;
}

void ContactBridge::add(btPersistentManifold& manifold,
                        std::uint32_t a,
                        std::uint32_t b,
                        Real h,
                        ContactSet& contacts) {
    const btCollisionObject& object_a = *manifold.getBody0();
    const btCollisionObject& object_b = *manifold.getBody1();
    const btVector3& center_a = object_a.getWorldTransform().getOrigin();
    const btVector3& center_b = object_b.getWorldTransform().getOrigin();
    const std::size_t first_block = contacts.blocks.size();
    const std::size_t first_entry = entries_.size();
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        btManifoldPoint& from = manifold.getContactPoint(i);
        const btVector3& normal = from.m_normalWorldOnB;
        if (i == 0 || contacts.blocks.back().normal != from_bullet(normal)) {
            ContactBlock& block = contacts.blocks.emplace_back();
            block.a = a;
            block.b = b;
            start_block(from, object_a, object_b, block);
        }
        ContactBlock& block = contacts.blocks.back();
        const auto at = static_cast<std::size_t>(block.count);
        set_lane(block.offset_a,
                 block.count,
                 from_bullet(from.getPositionWorldOnA() + normal * block.radius_a - center_a));
        set_lane(block.offset_b,
                 block.count,
                 from_bullet(from.getPositionWorldOnB() - normal * block.radius_b - center_b));
        block.start_separation_m[at] = from.getDistance();
        block.normal_Ns[at] = from.m_appliedImpulse * h;
        block.tangent_Ns[0] += from.m_appliedImpulseLateral1 * h;
        block.tangent_Ns[1] += from.m_appliedImpulseLateral2 * h;
        block.twist_Nms += from.m_prevRHS * h;
        ++block.count;
        entries_.push_back({.point = &from,
                            .block = static_cast<std::uint32_t>(contacts.blocks.size() - 1),
                            .lane = static_cast<std::uint32_t>(at),
                            .load = static_cast<std::uint32_t>(loads_.size())});
    }
    carry_over(manifold, h, contacts, first_block, first_entry);
    manifold.m_companionIdA = static_cast<int>(loads_.size());
    loads_.push_back({.manifold = &manifold});
}

void ContactBridge::carry_over(btPersistentManifold& manifold,
                               Real h,
                               ContactSet& contacts,
                               std::size_t first_block,
                               std::size_t first_entry) const {
    const auto slot = static_cast<std::size_t>(std::max(manifold.m_companionIdA, 0));
    if (slot >= last_loads_.size() || last_loads_[slot].manifold != &manifold) return;
    Real lost_N = last_loads_[slot].normal_N;
    Vec3 lost_friction_N = last_loads_[slot].friction_N;
    int fresh = 0;
    for (std::size_t i = first_entry; i < entries_.size(); ++i) {
        const btManifoldPoint& point = *entries_[i].point;
        lost_N -= point.m_appliedImpulse;
        if (is_new(point)) ++fresh;
    }
    if (fresh == 0 || lost_N <= 0) return;
    for (std::size_t i = first_block; i < contacts.blocks.size(); ++i) {
        const ContactBlock& block = contacts.blocks[i];
        lost_friction_N -=
            (block.tangent[0] * block.tangent_Ns[0] + block.tangent[1] * block.tangent_Ns[1]) / h;
    }
    const Real share = h / static_cast<Real>(fresh);
    for (std::size_t i = first_entry; i < entries_.size(); ++i) {
        if (!is_new(*entries_[i].point)) continue;
        ContactBlock& block = contacts.blocks[entries_[i].block];
        block.normal_Ns[entries_[i].lane] = lost_N * share;
        for (int t = 0; t < 2; ++t)
            block.tangent_Ns[t] += glm::dot(lost_friction_N, block.tangent[t]) * share;
    }
}

void ContactBridge::write_back(const ContactSet& contacts, Real h) {
    const Real per_s = 1 / h;
    for (const Entry& entry : entries_) {
        const ContactBlock& block = contacts.blocks[entry.block];
        btManifoldPoint& point = *entry.point;
        const Real share = per_s / static_cast<Real>(block.count);
        point.m_appliedImpulse = block.normal_Ns[entry.lane] * per_s;
        point.m_appliedImpulseLateral1 = block.tangent_Ns[0] * share;
        point.m_appliedImpulseLateral2 = block.tangent_Ns[1] * share;
        point.m_prevRHS = block.twist_Nms * share;
        set_frame_impulse(point, block.total_Ns[entry.lane]);
        PairLoad& load = loads_[entry.load];
        load.normal_N += point.m_appliedImpulse;
        load.friction_N += block.tangent[0] * point.m_appliedImpulseLateral1 +
                           block.tangent[1] * point.m_appliedImpulseLateral2;
    }
}

}  // namespace plumbline::physics
