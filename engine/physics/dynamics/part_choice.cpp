#include "engine/physics/dynamics/part_choice.h"

#include "engine/physics/dynamics/island.h"
#include "engine/physics/world/body_record.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

/// Finding points more often would cost too much, of many bodies sooner.
constexpr std::size_t kMostParts = 128;
constexpr std::size_t kMostBodiesTimesParts = 2048;

/// How fast the body's surface turns away under a contact point, rad/s: what is round about an axis does not by turning
/// about that.
Real felt_spin_radps(const BodyRecord& record) {
    using enum ConvexShape::Kind;
    const Vec3& spin = record.motion->spin_radps;
    const ConvexShape::Kind kind = record.traits.primitive.kind;
    if (kind == Sphere || record.motion->inverse_mass <= 0) return 0;
    if (kind != Capsule && kind != Cylinder && kind != Cone) return glm::length(spin);
    const Vec3& axis = record.motion->at.rotation[1];
    return glm::length(spin - axis * glm::dot(spin, axis));
}

/// ... after what closes at this speed has struck it off its centre.
Real struck_spin_radps(const BodyRecord& record, const BodyRecord& other, Real closing_mps) {
    const Real own = record.motion->inverse_mass;
    if (record.traits.primitive.kind == ConvexShape::Kind::Sphere || own <= 0) return 0;
    return closing_mps * own / ((own + other.motion->inverse_mass) * record.traits.radius_m);
}

/// How fast the manifold's points close, at most.
Real closing_mps(const Manifold& manifold) {
    Real most = 0;
    for (const ManifoldPoint& point : manifold.points) {
        const Vec3 apart = manifold.a->motion->velocity_at(point.a.offset_m) -
                           manifold.b->motion->velocity_at(point.b.offset_m);
        most = std::max(most, -glm::dot(apart, point.normal_world));
    }
    return most;
}

/// Whether a force moves the body through things within one step: only contacts found before it does hold it.
bool drives_through(const BodyRecord& record, Real step_s) {
    return record.applied.by_caller &&
           glm::length(record.applied.force_N) * record.motion->inverse_mass * step_s * step_s >
               record.sweep.inner_radius_m;
}

/// What a body may turn by before its points are found anew: they leave its surface by half the square of a turn, and
/// what is thin by a larger share of its thickness.
Real most_turn_rad(const BodyRecord& record, bool finely) {
    constexpr Real kMostTurn_rad = 0.1_r;
    constexpr Real kMostFineTurn_rad = 0.05_r;
    constexpr Real kMostLeft = 0.25_r;  // of the inner radius
    const Real inner_radius_m = record.sweep.inner_radius_m;
    if (!finely || inner_radius_m <= 0) return kMostTurn_rad;
    return std::min(kMostFineTurn_rad,
                    std::sqrt(2 * kMostLeft * inner_radius_m / record.traits.radius_m));
}

/// How far the manifold's points run over the bodies within a step, as a share of what points may lag behind.
Real rolling_share(const Manifold& manifold, Real step_s, bool finely) {
    constexpr Real kMostSlide = 0.25_r;  // of the inner radius, over the faces of a mesh
    const BodyRecord& a = *manifold.a;
    const BodyRecord& b = *manifold.b;
    const Real closing = closing_mps(manifold);
    const Real spin_a = std::max(felt_spin_radps(a), struck_spin_radps(a, b, closing));
    const Real spin_b = std::max(felt_spin_radps(b), struck_spin_radps(b, a, closing));
    const Real share =
        std::max(spin_a / most_turn_rad(a, finely), spin_b / most_turn_rad(b, finely)) * step_s;
    if (a.traits.geometry->mesh == nullptr && b.traits.geometry->mesh == nullptr) return share;
    const Vec3 apart = a.motion->velocity_mps - b.motion->velocity_mps;
    const Vec3& normal = manifold.points.front().normal_world;
    const Vec3 slide = apart - normal * glm::dot(apart, normal);
    const Real size_m = std::max(a.sweep.inner_radius_m, b.sweep.inner_radius_m);
    if (size_m <= 0) return share;
    return std::max(share, glm::length(slide) * step_s / (kMostSlide * size_m));
}

}  // namespace

bool may_be_parted(const Island& island, double step_s) {
    const auto is_driven_through = [step_s](const BodyRecord* record) {
        return drives_through(*record, static_cast<Real>(step_s));
    };
    return island.joints.empty() && island.bodies.size() <= kMostBodiesInParts &&
           std::ranges::none_of(island.bodies, is_driven_through);
}

int most_parts(const Island& island) {
    const std::size_t parts = kMostBodiesTimesParts / island.bodies.size();
    return static_cast<int>(std::clamp(parts, std::size_t{1}, kMostParts));
}

int parts_of_step(const Island& island, double rest_s) {
    if (!may_be_parted(island, rest_s)) return 1;
    Real share = 0;
    for (const Manifold* manifold : island.manifolds)
        share = std::max(share, rolling_share(*manifold, static_cast<Real>(rest_s), island.swept));
    return std::clamp(static_cast<int>(std::ceil(share)), 1, most_parts(island));
}

}  // namespace plumbline::physics
