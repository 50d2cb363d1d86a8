#include "engine/physics/collision/sweep/time_of_impact.h"

#include "engine/physics/collision/mesh/placed_mesh.h"
#include "engine/physics/collision/narrow_phase/convex_convex.h"
#include "engine/physics/dynamics/rotation.h"
#include "engine/physics/transform.h"

#include <algorithm>
#include <array>
#include <utility>

namespace plumbline::physics {
namespace {

constexpr int kMostAdvances = 64;
/// Of the overlap with which bodies cross each other: as near counts as touching, and as deep an overlap is where bodies
/// that touched before are stopped.
constexpr double kTouchingShare = 0.02;
constexpr double kLimitShare = 0.15;
/// Less is overlapped on the way by what grazes the other: its impact would turn by much within a step.
constexpr double kGrazingShare = 0.03;
constexpr double kLeastAdvance = 1e-6;
/// Bodies that overlap already by more may do so by this more.
constexpr double kNoiseShare = 5e-4;

/// The body's frame after a share of its path; its origin is relative to `origin`.
struct Place {
    glm::dmat3 axes{1.0};
    Vec3d position_m{0, 0, 0};
};

Place place_on(const BodyPath& path, double share, const Vec3d& origin) {
    const double gone = std::max(std::min(share, path.until) - path.since, 0.0);
    const glm::dmat3 turned(glm::mat3_cast(turn_by(path.turn_rad, gone)));
    return {turned * glm::dmat3(path.from.rotation),
            Vec3d(path.from.position_m) - origin + path.displacement_m * gone};
}

PlacedConvex placed_on(const GeometryPart& part, const Place& place) {
    PlacedConvex convex = placed_convex({part.shape, part.mass_from_part}, Vec3d{0, 0, 0});
    convex.center_m = place.axes * convex.center_m + place.position_m;
    convex.axes = place.axes * convex.axes;
    return convex;
}

bool is_round_about_axis(const ConvexShape& shape) {
    using enum ConvexShape::Kind;
    return shape.kind == Capsule || shape.kind == Cylinder || shape.kind == Cone;
}

/// The part of a turn that moves a part's surface: a round one turns about its own axis in place.
Vec3d felt_turn(const GeometryPart& part, const BodyPath& path) {
    if (part.mass_from_part.position_m != Vec3{0, 0, 0}) return path.turn_rad;
    if (part.shape.kind == ConvexShape::Kind::Sphere) return {0, 0, 0};
    if (!is_round_about_axis(part.shape)) return path.turn_rad;
    const Vec3d axis{path.from.rotation * part.mass_from_part.rotation[1]};
    return path.turn_rad - axis * glm::dot(path.turn_rad, axis);
}

double farthest(const Bounds& bounds) {
    return glm::length(glm::max(magnitudes_of(bounds.low), magnitudes_of(bounds.high)));
}

/// A point's arc leaves the boxes of both ends by no more than its height over the chord.
Bounds swept_bounds(const GeometryPart& part, const BodyPath& path) {
    const double angle = glm::length(path.turn_rad);
    const double bulge_m = std::min(angle * angle / 8, 1.0) * farthest(part.bounds);
    const Bounds first = bounds_of(placed_on(part, place_on(path, 0, Vec3d{0, 0, 0})));
    const Bounds last = bounds_of(placed_on(part, place_on(path, 1, Vec3d{0, 0, 0})));
    return {glm::min(first.low, last.low) - bulge_m, glm::max(first.high, last.high) + bulge_m};
}

/// A convex thing that moves and turns about a centre, over the whole step.
struct Motion {
    Vec3d displacement_m{0, 0, 0};
    Vec3d turn_rad{0, 0, 0};
    double radius_m{0};    ///< of all its points about the centre
    bool may_stop{false};  ///< before the step ends
};
struct Motions {
    Motion a;
    Motion b;

    double most() const {
        double sum = 0;
        for (const Motion& motion : {a, b})
            sum +=
                glm::length(motion.displacement_m) + glm::length(motion.turn_rad) * motion.radius_m;
        return sum;
    }
};

Motion motion_of(const GeometryPart& part, const BodyPath& path) {
    return {.displacement_m = path.displacement_m,
            .turn_rad = felt_turn(part, path),
            .radius_m = farthest(part.bounds),
            .may_stop = path.until < 1};
}

/// The two at some share of the step, and the centres that they turn about.
struct Moment {
    PlacedConvex a;
    PlacedConvex b;
    Vec3d center_a{0, 0, 0};
    Vec3d center_b{0, 0, 0};
};

/// The least that one of the two reaches to along a normal within a further share of the step. Every point's motion is
/// known to first order from a support point, and differs by no more than its centripetal acceleration brings.
double least_along(const PlacedConvex& convex,
                   const Vec3d& center,
                   const Motion& motion,
                   const Vec3d& normal,
                   double share) {
    const auto lowest = [&](const Vec3d& along) {
        return glm::dot(support(convex, -along) - center, along);
    };
    double least = lowest(normal + glm::cross(normal, motion.turn_rad) * share) +
                   glm::dot(motion.displacement_m, normal) * share;
    if (motion.may_stop) least = std::min(least, lowest(normal));
    return least + glm::dot(center, normal) - convex.radius_m -
           glm::dot(motion.turn_rad, motion.turn_rad) * motion.radius_m * share * share / 2;
}

/// How near the two can come along a normal.
double least_distance(const Moment& now,
                      const Motions& motions,
                      const Vec3d& normal,
                      double share) {
    return least_along(now.a, now.center_a, motions.a, normal, share) +
           least_along(now.b, now.center_b, motions.b, -normal, share);
}

/// A share of the step within which the two do not come nearer along the normal than the goal; 1 where they never do.
double safe_share(const Moment& now, const Motions& motions, const Vec3d& normal, double goal_m) {
    constexpr int kMostHalvings = 24;
    double share = 1;
    for (int i = 0; i < kMostHalvings; ++i, share /= 2) {
        if (least_distance(now, motions, normal, share) >= goal_m) break;
    }
    if (share == 1) return share;
    // The bound falls ever faster: a secant to the goal stays on the safe side of it.
    double safe = share;
    double beyond = 2 * share;
    for (int i = 0; i < 4; ++i) {
        const double middle = (safe + beyond) / 2;
        (least_distance(now, motions, normal, middle) >= goal_m ? safe : beyond) = middle;
    }
    return safe;
}

/// Of the step, within which an impact is looked for.
struct Shares {
    double earliest{0};
    double latest{1};
    double end{
        1};  ///< of both paths: what touches before the latest may come to cross the other after it
};

/// Whether what came to touch on the way is inside the other at its end.
bool ends_overlapped(const Moment& end, double reach_m, double crossing_m) {
    const std::optional<Separation> apart = separation_of(end.a, end.b, reach_m);
    return apart && apart->distance_m < -kTouchingShare * crossing_m;
}

/// How near two bodies come, m: distances below 0 are overlaps.
struct Depths {
    double touching_m{0};
    double impact_m{0};  ///< what came to touch on the way has an impact if it comes so deep
    double limit_m{0};   ///< what touches at the start goes on until then
    double noise_m{0};

    Depths(double crossing_m, Known known)
        : touching_m(kTouchingShare * crossing_m),
          impact_m(-(known == Known::Apart ? kGrazingShare : 1) * crossing_m),
          limit_m(-(known == Known::Apart ? kGrazingShare : kLimitShare) * crossing_m),
          noise_m(kNoiseShare * crossing_m) {}

    double deepest_m() const { return std::min(impact_m, limit_m); }
    /// Which distance is the next to be looked at.
    double goal_m(bool touches, bool has_impact) const {
        if (!touches) return touching_m / 2;
        return (has_impact ? deepest_m() : limit_m) - noise_m;
    }
};

/// Advances two convex things; `at(share)` places both.
template <class At>
std::optional<Impact> advance(
    const At& at, const Motions& motions, double crossing_m, Known known, Shares within) {
    const double reach_m = motions.most();
    const bool held = known == Known::Held;
    Depths depths(crossing_m, known);
    std::optional<Impact> touch;
    bool touched_from_start = true;  // or held by contacts
    double share = within.earliest;
    for (int i = 0; i < kMostAdvances; ++i) {
        const Moment now = at(share);
        const std::optional<Separation> apart = separation_of(now.a, now.b, reach_m);
        if (!apart) return std::nullopt;
        const double distance_m = apart->distance_m;
        if (i == 0 && distance_m <= -crossing_m) return std::nullopt;
        if (i == 0) depths.limit_m = std::min(depths.limit_m, distance_m - depths.noise_m);
        const bool touches = distance_m <= depths.touching_m;
        touched_from_start = held || (touched_from_start && touches);
        if (!touches) touch.reset();
        if (touches && !touch && (!touched_from_start || distance_m <= depths.limit_m))
            touch = Impact{share, apart->normal};
        if (touch && distance_m <= depths.deepest_m()) return touch;
        const double goal_m = depths.goal_m(touches, touch.has_value());
        share += std::max(safe_share(now, motions, apart->normal, goal_m), kLeastAdvance);
        if (!touch && share >= within.latest) return std::nullopt;
        if (share < within.end) continue;
        const bool stays = !held && touch && ends_overlapped(at(within.end), reach_m, crossing_m);
        return stays ? touch : std::nullopt;
    }
    return touch;
}

/// Whether what meets the triangle meets its face: what slides over a mesh comes by edges that lie in its surface.
bool is_on_face(const MeshGeometry& mesh, std::uint32_t triangle, const Vec3d& normal) {
    constexpr double kLeastAlong = 0.7;
    const auto corner = [&](std::size_t i) { return mesh.corner_m(mesh.triangles[triangle], i); };
    const Vec3d across = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
    return std::abs(glm::dot(across, normal)) >= kLeastAlong * glm::length(across);
}

/// Impacts of two bodies, part by part.
class Impacts {
public:
    Impacts(const MovingBody& a, const MovingBody& b, Known known, double latest, double end)
        : a_(a),
          b_(b),
          known_(known),
          within_{std::max(a.path.since, b.path.since), latest, end},
          crossing_m_(std::min(a.crossing_m, b.crossing_m)) {}

    std::optional<Impact> find() {
        if (a_.geometry.mesh != nullptr) {
            for (const GeometryPart& part : b_.geometry.parts) {
                if (!part.own || may_touch(part.own->filter, a_.filter))
                    meet_mesh(b_, part, a_, -1);
            }
        } else if (b_.geometry.mesh != nullptr) {
            for (const GeometryPart& part : a_.geometry.parts) {
                if (!part.own || may_touch(part.own->filter, b_.filter)) meet_mesh(a_, part, b_, 1);
            }
        } else {
            for (const GeometryPart& part : a_.geometry.parts) meet_parts(part);
        }
        return first_;
    }

private:
    void keep(const std::optional<Impact>& impact, double side) {
        if (!impact || impact->share >= within_.latest) return;
        within_.latest = impact->share;
        first_ = Impact{impact->share, impact->normal * side};
    }

    static Bounds swept(const MovingBody& body, const GeometryPart& part) {
        const bool is_all = body.swept != nullptr && body.geometry.parts.size() == 1;
        return is_all ? *body.swept : swept_bounds(part, body.path);
    }

    void meet_parts(const GeometryPart& a) {
        const Bounds near = swept(a_, a);
        for (const GeometryPart& b : b_.geometry.parts) {
            const bool differ = a.own || b.own;
            if (differ &&
                !may_touch(a.own ? a.own->filter : a_.filter, b.own ? b.own->filter : b_.filter))
                continue;
            if (!overlap(near, swept(b_, b))) continue;
            const Vec3d origin{a_.path.from.position_m};
            const Motions motions{motion_of(a, a_.path), motion_of(b, b_.path)};
            const auto at = [&](double share) {
                const Place place_a = place_on(a_.path, share, origin);
                const Place place_b = place_on(b_.path, share, origin);
                return Moment{placed_on(a, place_a),
                              placed_on(b, place_b),
                              place_a.position_m,
                              place_b.position_m};
            };
            keep(advance(at, motions, crossing_m_, known_, within_), 1);
        }
    }

    /// `side`: -1 where the mesh is the first of the two.
    void meet_mesh(const MovingBody& body,
                   const GeometryPart& part,
                   const MovingBody& mesh_body,
                   double side) {
        const MeshGeometry& mesh = *mesh_body.geometry.mesh;
        const Vec3d origin{body.path.from.position_m};
        // All that the part sweeps as the mesh sees it.
        const Transform mesh_from_world = inverse(mesh_body.path.from);
        Bounds near = moved(swept_bounds(part, body.path), mesh_from_world);
        const double mesh_moves_m = glm::length(mesh_body.path.displacement_m) +
                                    glm::length(mesh_body.path.turn_rad) * farthest(near);
        near.low -= mesh_moves_m;
        near.high += mesh_moves_m;
        const Motions motions{motion_of(part, body.path),
                              {.displacement_m = mesh_body.path.displacement_m,
                               .turn_rad = mesh_body.path.turn_rad,
                               .radius_m = farthest(near),
                               .may_stop = mesh_body.path.until < 1}};
        mesh.tree.visit(near, [&](std::uint32_t triangle) {
            const auto at = [&](double share) {
                const Place own = place_on(body.path, share, origin);
                const Place place = place_on(mesh_body.path, share, origin);
                std::array<Vec3d, 3> corners;
                for (std::size_t i = 0; i < 3; ++i)
                    corners[i] =
                        place.axes * mesh.corner_m(mesh.triangles[triangle], i) + place.position_m;
                return Moment{placed_on(part, own),
                              placed_triangle(corners),
                              own.position_m,
                              place.position_m};
            };
            const auto impact = advance(at, motions, crossing_m_, known_, within_);
            if (impact && known_ == Known::Touching) {
                const glm::dmat3 axes = place_on(mesh_body.path, impact->share, origin).axes;
                if (!is_on_face(mesh, triangle, glm::transpose(axes) * impact->normal)) return;
            }
            keep(impact, side);
        });
    }

    const MovingBody& a_;
    const MovingBody& b_;
    Known known_;
    Shares within_;
    double crossing_m_;
    std::optional<Impact> first_;
};

}  // namespace

std::optional<Impact> time_of_impact(
    const MovingBody& a, const MovingBody& b, Known known, double latest, double end) {
    return Impacts(a, b, known, latest, end).find();
}

Bounds swept_bounds(const BodyGeometry& geometry, const BodyPath& path) {
    Bounds all = swept_bounds(geometry.parts.front(), path);
    for (const GeometryPart& part : geometry.parts) {
        const Bounds bounds = swept_bounds(part, path);
        all.low = glm::min(all.low, bounds.low);
        all.high = glm::max(all.high, bounds.high);
    }
    return all;
}

}  // namespace plumbline::physics
