#include "engine/physics/collision/ghost_contacts.h"

#include "engine/physics/collision/narrow_phase/placed_convex.h"
#include "engine/physics/world/body_record.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

namespace plumbline::physics {
namespace {

/// Normals that lie nearer to each other (cosine, 26 degrees) are no side's: a body lies on both, if on faces.
constexpr Real kSameNormal = 0.9_r;
/// A normal that lies nearer to a face's (cosine) is that face's; of what is round, which has a normal for every place, still nearer.
constexpr Real kAlongFace = 1 - 1e-5_r;
constexpr Real kRoundAlongFace = 1 - 1e-6_r;
/// Of the body's inner radius: a step as high as this is felt.
constexpr Real kLevelShare = 0.002_r;
/// How deep what is level may be, as a multiple of the other contact's depth.
constexpr Real kDepths = 1.5_r;
constexpr Real kMostDepthShare = 0.02_r;  ///< of the inner radius: deeper contacts say nothing
constexpr double kAcross = 0.05;  ///< of the normal: a motion along it has no side to pass on

/// Points of a manifold with one normal, as one of its bodies has them.
struct Touch {
    Pair* pair;
    Manifold* manifold;
    const BodyRecord* other;
    Vec3 normal_world;  ///< as the points have it
    Vec3 normal;        ///< from the other to the body
    Vec3 place;         ///< on the other, world
    Real nearest_m;     ///< least distance of a point, negative: penetration
    bool is_a;          ///< the body is the manifold's a
    bool is_round;      ///< the body's side there
    Real along_face() const { return is_round ? kRoundAlongFace : kAlongFace; }
};

void add_touches(Pair& pair, Manifold& manifold, const BodyRecord& body, std::vector<Touch>& all) {
    const bool is_a = manifold.a == &body;
    const std::size_t before = all.size();
    for (const ManifoldPoint& point : manifold.points) {
        const auto begin = all.begin() + static_cast<std::ptrdiff_t>(before);
        const auto known = std::find_if(begin, all.end(), [&](const Touch& touch) {
            return touch.normal_world == point.normal_world;
        });
        if (known != all.end()) {
            known->nearest_m = std::min(known->nearest_m, point.distance_m);
            continue;
        }
        all.push_back({.pair = &pair,
                       .manifold = &manifold,
                       .other = is_a ? manifold.b : manifold.a,
                       .normal_world = point.normal_world,
                       .normal = is_a ? point.normal_world : -point.normal_world,
                       .place = is_a ? point.b.surface_m : point.a.surface_m,
                       .nearest_m = point.distance_m,
                       .is_a = is_a,
                       .is_round = (is_a ? point.a : point.b).radius_m > 0});
    }
}

bool is_mesh(const BodyRecord& body) {
    return body.traits.geometry->mesh != nullptr;
}

bool is_round(const BodyRecord& body) {
    const ConvexShape::Kind kind = body.traits.primitive.kind;
    return kind == ConvexShape::Kind::Sphere || kind == ConvexShape::Kind::Capsule;
}

bool touches_more(const BodyRecord& body) {
    return std::ranges::count_if(body.small.pairs,
                                 [](const PairLink& link) { return link.pair->touches; }) > 1;
}

/// Looks at what one body after another touches in the step.
class GhostSearch {
public:
    explicit GhostSearch(const CollideStep& step) : step_(step) {}

    void look_at(const BodyRecord& body) {
        body_ = &body;
        touches_.clear();
        for (const PairLink& link : body.small.pairs) {
            if (!link.pair->touches) continue;
            for (Manifold& manifold : link.pair->manifolds)
                add_touches(*link.pair, manifold, body, touches_);
        }
        met_.clear();
        for (const Touch& touch : touches_) {
            if (acts(touch)) (is_behind_another(touch) ? ghosts_ : met_).push_back(touch);
        }
        const auto passed = std::partition(
            met_.begin(), met_.end(), [&](const Touch& touch) { return !passes_by(touch); });
        // A body that meets something moves otherwise from then on. Only a round surface still is where it was then, turned or not.
        const bool alone =
            passed == met_.begin() && std::none_of(passed, met_.end(), [](const Touch& touch) {
                return pushable(*touch.other) && touches_more(*touch.other);
            });
        std::copy_if(passed, met_.end(), std::back_inserter(ghosts_), [&](const Touch& touch) {
            return alone || (is_round(body) && !is_round(*touch.other));
        });
    }

    std::span<const Touch> ghosts() const { return ghosts_; }

private:
    /// The parts that touch, from the body's centre of mass.
    struct Parts {
        PlacedConvex own;
        PlacedConvex other;
    };

    PlacedConvex placed(const BodyRecord& record, std::uint32_t part) const {
        const GeometryPart& geometry = record.traits.geometry->parts[part];
        const Transform at = record.motion->at * geometry.mass_from_part;
        return placed_convex({geometry.shape, at}, Vec3d(body_->motion->at.position_m));
    }

    Parts parts_of(const Touch& touch) const {
        const Manifold& manifold = *touch.manifold;
        return {placed(*body_, touch.is_a ? manifold.part_a : manifold.part_b),
                placed(*touch.other, touch.is_a ? manifold.part_b : manifold.part_a)};
    }

    /// By how much the parts overlap along `direction`, from the other to the body, m; negative: they are apart.
    double overlap_m(const Touch& touch, const Vec3& direction) const {
        if (is_mesh(*touch.other)) return std::numeric_limits<double>::infinity();
        const Parts parts = parts_of(touch);
        return -separation_along(parts.own, parts.other, Vec3d(direction));
    }

    /// Whether a point closes within the step, or nearly.
    bool acts(const Touch& touch) const {
        const auto velocity_of = [&](const BodyMotion& motion) {
            return motion.velocity_at(touch.place - motion.at.position_m);
        };
        const Real closing_mps =
            glm::dot(velocity_of(*touch.other->motion) - velocity_of(*body_->motion), touch.normal);
        return touch.nearest_m <= std::max(closing_mps * step_.step_s, Real{0}) + step_.drop_m +
                                      kLevelShare * body_->sweep.inner_radius_m;
    }

    bool is_behind_another(const Touch& touch) const {
        return !is_mesh(*touch.other) && std::ranges::any_of(touches_, [&](const Touch& other) {
            return other.manifold != touch.manifold &&
                   (is_covered(touch, other) || is_level(touch, other));
        });
    }

    /// Whether the place where `touch` meets its shape lies within the one that `before` meets, which does not give way.
    bool is_covered(const Touch& touch, const Touch& before) const {
        if (pushable(*before.other) || is_mesh(*before.other) ||
            glm::dot(before.normal, touch.normal) < kSameNormal)
            return false;
        const PlacedConvex cover = parts_of(before).other;
        const Vec3d place = Vec3d(touch.place) - Vec3d(body_->motion->at.position_m);
        const FacePlane above = face_under(cover, place);
        const auto within_m = static_cast<double>(kLevelShare * body_->sweep.inner_radius_m);
        return above.exists && glm::dot(above.normal, place) < above.offset_m - within_m;
    }

    /// How far apart along its normal is still level with `under`.
    Real level_m(const Touch& under) const {
        const Real size_m = body_->sweep.inner_radius_m;
        const Real depth_m = std::max(-under.nearest_m, Real{0});
        return std::min(kDepths * depth_m, kMostDepthShare * size_m) + kLevelShare * size_m;
    }

    /// Whether the body lies on `under` so that what `touch` meets is level with it.
    bool is_level(const Touch& touch, const Touch& under) const {
        const Real alike = glm::dot(under.normal, touch.normal);
        if (alike > touch.along_face()) return false;
        if (std::abs(glm::dot(touch.place - under.place, under.normal)) > level_m(under))
            return false;
        if (alike > kSameNormal && !is_on_edge(touch)) return false;
        const double overlaps_m = overlap_m(touch, under.normal);
        if (overlaps_m > static_cast<double>(level_m(under))) return false;
        // Of two that would cover each other's sides, the one that reaches less far into the other's.
        return overlap_m(under, touch.normal) > overlaps_m;
    }

    /// Whether the body, with no face of its own, touches an edge or a corner of the other.
    bool is_on_edge(const Touch& touch) const {
        const Parts parts = parts_of(touch);
        const Vec3d normal{touch.normal};
        const auto along = static_cast<double>(touch.along_face());
        const FacePlane own = face_along(parts.own, -normal);
        const FacePlane others = face_along(parts.other, normal);
        return others.exists && glm::dot(others.normal, normal) < along &&
               !(own.exists && glm::dot(own.normal, -normal) > along);
    }

    /// Whether some direction keeps the two apart, as they move now. Near ones count anyway.
    bool passes_by(const Touch& touch) const {
        const BodyRecord& other = *touch.other;
        if (is_mesh(other) || touch.nearest_m <= near_m(*touch.pair) || !body_->joints.empty() ||
            !other.joints.empty())
            return false;
        const Vec3d apart_mps{body_->motion->velocity_mps - other.motion->velocity_mps};
        const Vec3d normal{touch.normal};
        const Vec3d across =
            normal - apart_mps * (glm::dot(apart_mps, normal) / glm::dot(apart_mps, apart_mps));
        if (!(glm::length(across) > kAcross)) return false;
        const Parts parts = parts_of(touch);
        const auto keeps_apart = [&](const Vec3d& direction) {
            const double closing_mps = std::max(-glm::dot(apart_mps, direction), 0.0);
            const Vec3d between(body_->motion->at.position_m - other.motion->at.position_m);
            return glm::dot(between, direction) - reach_m(*body_, parts.own, -direction) -
                       reach_m(other, parts.other, direction) >
                   closing_mps * static_cast<double>(step_.step_s) +
                       static_cast<double>(step_.drop_m);
        };
        const Vec3d side = glm::normalize(across);
        const FacePlane own = face_along(parts.own, -side);
        const FacePlane others = face_along(parts.other, side);
        return keeps_apart(side) || (own.exists && keeps_apart(-own.normal)) ||
               (others.exists && keeps_apart(others.normal));
    }

    /// How far from its centre of mass the body's part may reach along `direction` within the step, as it turns, m.
    double reach_m(const BodyRecord& record,
                   const PlacedConvex& part,
                   const Vec3d& direction) const {
        const Vec3d center(record.motion->at.position_m - body_->motion->at.position_m);
        const double now_m = glm::dot(support(part, direction) - center, direction) + part.radius_m;
        return std::min(now_m + static_cast<double>(spin_mps(record) * step_.step_s),
                        std::max(static_cast<double>(record.traits.radius_m), now_m));
    }

    const CollideStep& step_;
    const BodyRecord* body_{nullptr};
    std::vector<Touch> touches_;  ///< the body's
    std::vector<Touch> met_;      ///< those of it that act
    std::vector<Touch> ghosts_;   ///< of all bodies
};

}  // namespace

void drop_ghost_contacts(std::span<BodyRecord* const> bodies, const CollideStep& step) {
    GhostSearch search(step);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (i + 1 < bodies.size()) {
            for (const PairLink& link : bodies[i + 1]->small.pairs) __builtin_prefetch(link.pair);
        }
        search.look_at(*bodies[i]);
    }
    for (const Touch& ghost : search.ghosts()) {
        std::erase_if(ghost.manifold->points, [&](const ManifoldPoint& point) {
            return point.normal_world == ghost.normal_world;
        });
        ghost.pair->touches = std::ranges::any_of(
            ghost.pair->manifolds, [](const Manifold& left) { return !left.points.empty(); });
    }
}

}  // namespace plumbline::physics
