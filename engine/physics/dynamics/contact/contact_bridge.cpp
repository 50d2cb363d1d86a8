#include "engine/physics/dynamics/contact/contact_bridge.h"

#include "engine/physics/bullet/convert.h"
#include "engine/physics/dynamics/island.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace plumbline::physics {
namespace {

/// A side of cylinders is round only where it is touched across their axis.
constexpr btScalar kAcrossAxis = btScalar(0.02);
/// How fast the lasting load follows what a step carried, down and up: blows hardly count.
constexpr Real kFallShare = 0.25_r;
constexpr Real kRiseShare = 0.02_r;
constexpr std::uint32_t kKnown_steps = 10;  ///< fewer say more of the first blow

/// A rounded side: the ball that touches. Radius 0 for all sides that are not.
struct Rounding {
    Real radius_m{0};
    btVector3 center{0, 0, 0};  ///< world
};

/// Balls, capsules and the sides of cylinders. The centre is put on the shape's own centre or axis:
/// contact points are known to a few micrometres only, and a ball pressed beside its centre turns.
Rounding rounding_of(const btCollisionObject& object,
                     int child,
                     const btVector3& on_surface,
                     const btVector3& outward) {
    const btCollisionShape* shape = object.getCollisionShape();
    btTransform at = object.getWorldTransform();
    if (shape->isCompound()) {
        const auto& compound = static_cast<const btCompoundShape&>(*shape);
        if (compound.getNumChildShapes() == 1) child = 0;
        if (child < 0 || child >= compound.getNumChildShapes()) return {};
        shape = compound.getChildShape(child);
        at *= compound.getChildTransform(child);
    }
    const auto on_axis = [&](int up, Real radius_m) {
        const btVector3 axis = at.getBasis().getColumn(up);
        const btVector3 near = on_surface - outward * radius_m;
        return Rounding{radius_m, at.getOrigin() + axis * axis.dot(near - at.getOrigin())};
    };
    switch (shape->getShapeType()) {
        case SPHERE_SHAPE_PROXYTYPE:
            return {static_cast<const btSphereShape*>(shape)->getRadius(), at.getOrigin()};
        case CAPSULE_SHAPE_PROXYTYPE: {
            const auto& capsule = static_cast<const btCapsuleShape&>(*shape);
            return on_axis(capsule.getUpAxis(), capsule.getRadius());
        }
        case CYLINDER_SHAPE_PROXYTYPE: {
            const auto& cylinder = static_cast<const btCylinderShape&>(*shape);
            const btVector3 axis = at.getBasis().getColumn(cylinder.getUpAxis());
            if (std::abs(axis.dot(outward)) >= kAcrossAxis) return {};
            return on_axis(cylinder.getUpAxis(), cylinder.getRadius());
        }
        default:
            return {};
    }
}

/// A body's side of a contact point: the point, or the centre of the ball that touches there.
struct Side {
    Real radius_m{0};
    Vec3 offset_m{0, 0, 0};  ///< from the centre of mass, world axes
};

Side side_of(const btCollisionObject& object,
             int child,
             const btVector3& on_surface,
             const btVector3& outward) {
    const Rounding ball = rounding_of(object, child, on_surface, outward);
    const btVector3& place = ball.radius_m > 0 ? ball.center : on_surface;
    return {ball.radius_m, from_bullet(place - object.getWorldTransform().getOrigin())};
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

void ContactBridge::begin_island() {
    entries_.clear();
    island_loads_ = loads_.size();
}

const ContactBridge::PairLoad* ContactBridge::last_load(
    const btPersistentManifold& manifold) const {
    const auto slot = static_cast<std::size_t>(std::max(manifold.m_companionIdA, 0));
    if (slot >= last_loads_.size() || last_loads_[slot].manifold != &manifold) return nullptr;
    return &last_loads_[slot];
}

Real ContactBridge::lasting_load_N(const btPersistentManifold& manifold) const {
    const PairLoad* last = last_load(manifold);
    return last != nullptr && last->age >= kKnown_steps ? last->lasting_N : Real{0};
}

void ContactBridge::start_block(const btManifoldPoint& from,
                                bool swapped,
                                ContactBlock& block) const {
    btVector3 tangent[2];
    btPlaneSpace1(from.m_normalWorldOnB, tangent[0], tangent[1]);
    for (int t = 0; t < 2; ++t) block.tangent[t] = from_bullet(swapped ? -tangent[t] : tangent[t]);
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
    // What gives way to nothing is always a block's b.
    const bool swapped = static_cast<const btRigidBody&>(object_a).getInvMass() == 0;
    if (swapped) std::swap(a, b);
    const std::size_t first_block = contacts.blocks.size();
    const std::size_t first_entry = entries_.size();
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        btManifoldPoint& from = manifold.getContactPoint(i);
        const btVector3& normal = from.m_normalWorldOnB;
        Side side_a = side_of(object_a, from.m_index0, from.getPositionWorldOnA(), -normal);
        Side side_b = side_of(object_b, from.m_index1, from.getPositionWorldOnB(), normal);
        if (swapped) std::swap(side_a, side_b);
        const Vec3 facing = from_bullet(swapped ? -normal : normal);
        if (i == 0 || contacts.blocks.back().normal != facing) {
            ContactBlock& block = contacts.blocks.emplace_back();
            block.a = a;
            block.b = b;
            block.normal = facing;
            block.radius_a = side_a.radius_m;
            block.radius_b = side_b.radius_m;
            start_block(from, swapped, block);
        }
        ContactBlock& block = contacts.blocks.back();
        const auto at = static_cast<std::size_t>(block.count);
        set_lane(block.offset_a, block.count, side_a.offset_m);
        set_lane(block.offset_b, block.count, side_b.offset_m);
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
    PairLoad load{.manifold = &manifold};
    if (const PairLoad* last = last_load(manifold)) {
        load.lasting_N = last->lasting_N;
        load.age = last->age;
        ContactBlock& first = contacts.blocks[first_block];
        if (first.rolling_m > 0 || first.spinning_m > 0) first.rolling_Nms = last->rolling_Nm * h;
    }
    manifold.m_companionIdA = static_cast<int>(loads_.size());
    loads_.push_back(load);
}

void ContactBridge::carry_over(btPersistentManifold& manifold,
                               Real h,
                               ContactSet& contacts,
                               std::size_t first_block,
                               std::size_t first_entry) const {
    const PairLoad* last = last_load(manifold);
    if (last == nullptr) return;
    Real lost_N = last->normal_N;
    Vec3 lost_friction_N = last->friction_N;
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
        if (entry.lane == 0 && load.rolling_Nm == Vec3{0, 0, 0})
            load.rolling_Nm = block.rolling_Nms * per_s;
        load.friction_N += block.tangent[0] * point.m_appliedImpulseLateral1 +
                           block.tangent[1] * point.m_appliedImpulseLateral2;
    }
    for (std::size_t i = island_loads_; i < loads_.size(); ++i) {
        PairLoad& load = loads_[i];
        ++load.age;
        const bool first = load.age == 1;
        const Real share = first ? 1 : load.normal_N < load.lasting_N ? kFallShare : kRiseShare;
        load.lasting_N += share * (load.normal_N - load.lasting_N);
    }
}

void ContactBridge::serialize(Archive& archive, std::span<btPersistentManifold* const> manifolds) {
    constexpr std::uint32_t kGone = ~0U;  // its pair has parted since
    std::map<const btPersistentManifold*, std::uint32_t> number;
    for (std::uint32_t i = 0; i < manifolds.size(); ++i) number[manifolds[i]] = i;
    loads_.resize(archive.count(loads_.size()));
    for (PairLoad& load : loads_) {
        const auto found = number.find(load.manifold);
        std::uint32_t of = found != number.end() ? found->second : kGone;
        archive(of, load);
        if (!archive.reads()) continue;
        archive.expect(of == kGone || of < manifolds.size(), "a load has no contact");
        load.manifold = of < manifolds.size() ? manifolds[of] : nullptr;
    }
}

}  // namespace plumbline::physics
