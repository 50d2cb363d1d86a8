#include "engine/physics/bullet/contact/contact_copy.h"

#include "engine/physics/bullet/convert.h"
#include "engine/physics/bullet/shape/primitive_shape.h"
#include "engine/physics/world/body_record.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace plumbline::physics {
namespace {

/// A side of cylinders is round only where it is touched across their axis.
constexpr btScalar kAcrossAxis = btScalar(0.02);

/// The part of a body that touches, if it is round.
struct RoundPart {
    Primitive shape;
    Transform world_from_shape;
};

/// Spheres, capsules and, like these, the sides of cylinders.
RoundPart round_part(const btCollisionObject& object, int child, const btVector3& outward) {
    const btCollisionShape* shape = object.getCollisionShape();
    btTransform at = object.getWorldTransform();
    if (shape->isCompound()) {
        const auto& compound = static_cast<const btCompoundShape&>(*shape);
        if (compound.getNumChildShapes() == 1) child = 0;
        if (child < 0 || child >= compound.getNumChildShapes()) return {};
        shape = compound.getChildShape(child);
        at *= compound.getChildTransform(child);
    }
    if (shape->getShapeType() != CYLINDER_SHAPE_PROXYTYPE)
        return {primitive_of(*shape), transform_from_bullet(at)};
    const auto& cylinder = static_cast<const btCylinderShape&>(*shape);
    if (std::abs(at.getBasis().getColumn(1).dot(outward)) >= kAcrossAxis) return {};
    return {{.kind = Primitive::Kind::Capsule, .radius_m = cylinder.getRadius()},
            transform_from_bullet(at)};
}

void place_side(ContactSide& side,
                const btCollisionObject& object,
                int child,
                const btVector3& outward) {
    const RoundPart part = round_part(object, child, outward);
    const Vec3 center =
        touching_center({part.shape, part.world_from_shape}, side.surface_m, from_bullet(outward));
    side.radius_m = part.shape.radius_m;
    side.offset_m = center - from_bullet(object.getWorldTransform().getOrigin());
}

/// The feature of a point that was found before; 0: new.
std::uint32_t feature_of(const btManifoldPoint& point) {
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(point.m_userPersistentData));
}

/// The points before `i` are matched. Brings the point that the feature names to place `i`; one that
/// is found again twice is a new point the second time, with the same load.
void match_point(Manifold& to, std::size_t i, const btManifoldPoint& point) {
    const std::uint32_t feature = feature_of(point);
    const auto has_feature = [feature](const ManifoldPoint& known) {
        return known.feature == feature;
    };
    const auto place = to.points.begin() + static_cast<std::ptrdiff_t>(i);
    const auto found =
        feature == 0 ? to.points.end() : std::find_if(place, to.points.end(), has_feature);
    if (found != to.points.end()) {
        if (found != place) std::iter_swap(found, place);
        return;
    }
    ManifoldPoint fresh{.feature = ++to.features_made};
    const auto twin = feature == 0 ? place : std::find_if(to.points.begin(), place, has_feature);
    if (twin != place) fresh.load = twin->load;
    set_feature(point, fresh.feature);
    to.points.push_back(fresh);
    std::swap(to.points[i], to.points.back());
}

void copy_point(const btManifoldPoint& from, ManifoldPoint& to) {
    to.age_steps = from.getLifeTime();
    to.normal_world = from_bullet(from.m_normalWorldOnB);
    to.a.surface_m = from_bullet(from.getPositionWorldOnA());
    to.a.local_m = from_bullet(from.m_localPointA);
    to.b.surface_m = from_bullet(from.getPositionWorldOnB());
    to.b.local_m = from_bullet(from.m_localPointB);
    to.distance_m = from.getDistance();
}

}  // namespace

void set_feature(const btManifoldPoint& point, std::uint32_t feature) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): a number where Bullet's users may keep a pointer
    point.m_userPersistentData = reinterpret_cast<void*>(static_cast<std::uintptr_t>(feature));
}

void find_again(btManifoldPoint& point, const ManifoldPoint& old) {
    set_feature(point, old.feature);
    point.m_lifeTime = old.age_steps + 1;
}

ManifoldPoint copied(const btManifoldPoint& point) {
    ManifoldPoint copy{.feature = feature_of(point)};
    copy_point(point, copy);
    return copy;
}

Manifold& sole_manifold(Pair& pair) {
    if (pair.manifolds.empty()) {
        pair.manifolds.push_back(
            {.a = pair.a, .b = pair.b, .material = material_of(*pair.a->rigid, *pair.b->rigid)});
    }
    return pair.manifolds.front();
}

void match_manifolds(const btManifoldArray& from, Pair& pair) {
    std::vector<Manifold>& to = pair.manifolds;
    const auto count = static_cast<std::size_t>(from.size());
    for (std::size_t i = 0; i < count; ++i) {
        const btPersistentManifold& manifold = *from[static_cast<int>(i)];
        const std::uint32_t number = number_of(manifold);
        const auto place = to.begin() + static_cast<std::ptrdiff_t>(i);
        const auto found = std::find_if(
            place, to.end(), [number](const Manifold& known) { return known.number == number; });
        if (found == to.end()) {
            to.push_back({.a = &record_of(*manifold.getBody0()),
                          .b = &record_of(*manifold.getBody1()),
                          .number = number});
            to.back().material = material_of(*manifold.getBody0(), *manifold.getBody1());
            std::swap(to[i], to.back());
        } else if (found != place) {
            std::iter_swap(found, place);
        }
    }
    to.resize(count);
}

void match_points(btPersistentManifold& from, Manifold& to) {
    const auto count = static_cast<std::size_t>(from.getNumContacts());
    for (std::size_t i = 0; i < count; ++i) {
        match_point(to, i, from.getContactPoint(static_cast<int>(i)));
    }
    to.points.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        copy_point(from.getContactPoint(static_cast<int>(i)), to.points[i]);
        to.points[i].normal_Ns = 0;
    }
}

void copy_manifold(const btPersistentManifold& from, Manifold& to) {
    to.a = &record_of(*from.getBody0());
    to.b = &record_of(*from.getBody1());
    to.points.resize(static_cast<std::size_t>(from.getNumContacts()));
    for (std::size_t i = 0; i < to.points.size(); ++i) {
        const btManifoldPoint& point = from.getContactPoint(static_cast<int>(i));
        copy_point(point, to.points[i]);
        to.points[i].normal_Ns = point.getAppliedImpulse();
    }
}

void remove_point(btPersistentManifold& from, Manifold& to, int index) {
    from.removeContactPoint(index);
    remove_point(to, static_cast<std::size_t>(index));
}

void copy_places(const btPersistentManifold& from, Manifold& to) {
    for (std::size_t i = 0; i < to.points.size(); ++i) {
        const btManifoldPoint& point = from.getContactPoint(static_cast<int>(i));
        const btVector3& normal = point.m_normalWorldOnB;
        place_side(to.points[i].a, *from.getBody0(), point.m_index0, -normal);
        place_side(to.points[i].b, *from.getBody1(), point.m_index1, normal);
    }
}

}  // namespace plumbline::physics
