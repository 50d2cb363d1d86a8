#include "engine/physics/character/character_state.h"

#include <algorithm>

namespace plumbline::physics {

namespace {

// Grazing hits would ask for an endless way back to restore the skin.
constexpr Real kLeastCosine = 0.05_r;
// How far behind an edge its face is looked for: Bullet rounds the edges of large boxes by up to
// 4 cm; the last one looks at the near side, for ridges.
constexpr std::array<Real, 3> kAsides_m{0.01_r, 0.05_r, -0.01_r};
constexpr Real kProbe_m = 0.06_r;    // and how far above and below
constexpr Real kFoot_m = 0.1_r;      // a flat face goes on so far around the point that carries
constexpr Real kSameFace = 0.998_r;  // cosine of 3.6 degrees: more than rays' normals are off

CapsuleShape query_capsule(const CharacterDef& def, Real height_m) {
    return {.radius_m = def.radius_m - kSkin_m, .height_m = height_m - 2 * def.radius_m};
}

}  // namespace

void PlaneSet::add(const LimitPlane& plane) {
    for (std::size_t i = 0; i < count_; ++i) {
        if (glm::dot(planes_[i].normal, plane.normal) > 0.9999_r) {
            planes_[i].room_m = std::min(planes_[i].room_m, plane.room_m);
            return;
        }
    }
    if (count_ < planes_.size()) planes_[count_++] = plane;
}

bool PlaneSet::allows(const Vec3& wish) const {
    const Real slack = 1e-5_r * (glm::length(wish) + 1e-3_r);
    for (std::size_t i = 0; i < count_; ++i) {
        if (glm::dot(wish, planes_[i].normal) < -planes_[i].room_m - slack) return false;
    }
    return true;
}

Vec3 PlaneSet::limited(const Vec3& wish) const {
    if (allows(wish)) return wish;
    for (std::size_t i = 0; i < count_; ++i) {
        const LimitPlane& plane = planes_[i];
        const Real excess = glm::dot(wish, plane.normal) + plane.room_m;
        if (excess >= 0) continue;
        const Vec3 candidate = wish - plane.normal * excess;
        if (allows(candidate) && glm::dot(candidate, wish) > 0) return candidate;
    }
    for (std::size_t i = 0; i < count_; ++i) {
        for (std::size_t j = i + 1; j < count_; ++j) {
            const Vec3& a = planes_[i].normal;
            const Vec3& b = planes_[j].normal;
            const Real cosine = glm::dot(a, b);
            const Real determinant = 1 - cosine * cosine;
            if (determinant < 1e-6_r) continue;
            // The point of both planes nearest to the start, and the way along their crease.
            const Real on_a = (planes_[j].room_m * cosine - planes_[i].room_m) / determinant;
            const Real on_b = (planes_[i].room_m * cosine - planes_[j].room_m) / determinant;
            const Vec3 crease = glm::normalize(glm::cross(a, b));
            const Vec3 candidate = a * on_a + b * on_b + crease * glm::dot(crease, wish);
            if (allows(candidate) && glm::dot(candidate, wish) > 0) return candidate;
        }
    }
    return {0, 0, 0};
}

void PlaneSet::consume(const Vec3& displacement) {
    for (std::size_t i = 0; i < count_; ++i) {
        const Real used = -glm::dot(displacement, planes_[i].normal);
        planes_[i].room_m = std::max(Real{0}, planes_[i].room_m - std::max(Real{0}, used));
    }
}

CapsuleProbe::CapsuleProbe(PhysicsWorld& world, const CharacterDef& def)
    : world_(world), def_(def) {
    PL_ASSERT(def.radius_m > 2 * kSkin_m, "a person wider than the skin");
    PL_ASSERT(def.crouched_height_m >= 2 * def.radius_m && def.height_m >= def.crouched_height_m,
              "a person at least as high as wide");
    const std::array<Real, 2> heights{def.height_m, def.crouched_height_m};
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
        const auto shape = world.create_shape(query_capsule(def, heights[i]));
        PL_ASSERT(shape.ok(), "a capsule within the limits");
        shapes_[i] = shape.value();
    }
}

Pose CapsuleProbe::pose_at(const Vec3d& feet) const {
    return {.position = Vec3(feet + Vec3d{0, 0.5 * static_cast<double>(height_m()), 0})};
}

QueryFilter CapsuleProbe::filter(BodyId also_ignored) const {
    return {.collides_with = def_.collides_with,
            .ignored = own_,
            .also_ignored = also_ignored ? also_ignored : unseen_};
}

std::optional<CapsuleContact> CapsuleProbe::sweep(const Vec3d& feet,
                                                  const Vec3& displacement,
                                                  BodyId also_ignored) const {
    const Real length = glm::length(displacement);
    if (length < 1e-7_r) return std::nullopt;
    const Vec3 direction = displacement / length;
    const Real reach = length + kSkin_m / kLeastCosine;
    const Pose from = pose_at(feet);
    const auto hit = physics::sweep(world_,
                                    shapes_[crouched_ ? 1 : 0],
                                    from,
                                    from.position + direction * reach,
                                    filter(also_ignored));
    if (!hit) return std::nullopt;
    const Real approach = -glm::dot(direction, hit->normal_world);
    if (approach < 1e-4_r) return std::nullopt;  // along the surface, or away from it
    CapsuleContact contact{.body = hit->body,
                           .user = hit->user,
                           .point = hit->point_world,
                           .normal = hit->normal_world};
    contact.raw_travel_m = hit->fraction * reach;
    contact.travel_m = contact.raw_travel_m - kSkin_m / std::max(approach, kLeastCosine);
    if (contact.travel_m >= length) return std::nullopt;
    contact.travel_m = std::max(contact.travel_m, Real{0});
    return contact;
}

std::vector<CapsuleContact> CapsuleProbe::touches(const Vec3d& feet,
                                                  Real reach_m,
                                                  BodyId also_ignored) const {
    std::vector<CapsuleContact> contacts;
    const auto hits = overlaps(
        world_, shapes_[crouched_ ? 1 : 0], pose_at(feet), kSkin_m + reach_m, filter(also_ignored));
    for (const OverlapHit& hit : hits) {
        contacts.push_back({.body = hit.body,
                            .user = hit.user,
                            .point = hit.point_world,
                            .normal = hit.normal_world,
                            .gap_m = -hit.depth_m - kSkin_m});
    }
    return contacts;
}

bool CapsuleProbe::is_free(const Vec3d& feet) const {
    return touches(feet, -kTouch_m).empty();
}

std::optional<RayHit> CapsuleProbe::ray(const Vec3& from, const Vec3& to) const {
    return cast_ray(world_, from, to, filter({}));
}

bool CapsuleProbe::is_flat(const Support& support) const {
    for (const Vec3& aside : {Vec3{kFoot_m, 0, 0}, Vec3{0, 0, kFoot_m}}) {
        for (const Vec3& there : {support.point + aside, support.point - aside}) {
            const auto face = ray(there + kUp * kProbe_m, there - kUp * kProbe_m);
            if (face && face->body == support.body &&
                glm::dot(face->normal_world, support.face_normal) < kSameFace)
                return false;
        }
    }
    return true;
}

Support CapsuleProbe::support_of(const CapsuleContact& contact, const Vec3d& feet) const {
    Support support{.face_normal = contact.normal,
                    .contact_normal = contact.normal,
                    .point = contact.point,
                    .body = contact.body};
    const Real cos_limit = portable_cos(def_.max_slope_rad);
    support.walkable = contact.normal.y >= cos_limit;
    const Vec3 outward = level(contact.point - Vec3(feet));
    const Real distance = glm::length(outward);
    if (contact.normal.y > 0.99995_r || distance < 1e-4_r) return support;
    // The round foot touches edges at any angle; what counts is the face behind the edge. Within a
    // face the contact's own normal is the better known one.
    for (const Real aside_m : kAsides_m) {
        const Vec3 above = contact.point + outward * (aside_m / distance);
        const auto hit = ray(above + kUp * kProbe_m, above - kUp * kProbe_m);
        if (!hit || hit->normal_world.y <= 0) continue;
        if (glm::dot(hit->normal_world, contact.normal) > kSameFace) return support;
        support.walkable = hit->normal_world.y >= cos_limit;
        if (!support.walkable) continue;
        support.face_normal = hit->normal_world;
        support.edge = true;
        return support;
    }
    return support;
}

}  // namespace plumbline::physics
