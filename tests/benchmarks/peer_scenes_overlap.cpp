#include "tests/benchmarks/peer_scenes_overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace plumbline::bench {

namespace {

using Axes = std::array<Vec3d, 3>;

Axes axes_of(const BodyView& view) {
    const glm::dmat3 turn = glm::mat3_cast(view.orientation);
    return {turn[0], turn[1], turn[2]};
}

double reach(const Axes& axes, const Vec3d& half_m, const Vec3d& direction) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
        sum += half_m[i] * std::abs(glm::dot(axes[static_cast<std::size_t>(i)], direction));
    }
    return sum;
}

/// A body as far as it is needed here; kind None for hulls.
struct Solid {
    enum class Kind : std::uint8_t { None, Box, Ball };
    Kind kind{Kind::None};
    Vec3d half_m{0, 0, 0};  ///< x only: a ball's radius
    double outer_radius_m{0};
};

Solid solid_of(const PeerBody& body) {
    if (const auto* box = std::get_if<physics::BoxShape>(&body.shape)) {
        const Vec3d half_m = Vec3d(box->size_m) * 0.5;
        return {Solid::Kind::Box, half_m, glm::length(half_m)};
    }
    if (const auto* ball = std::get_if<physics::SphereShape>(&body.shape)) {
        const auto radius_m = static_cast<double>(ball->radius_m);
        return {Solid::Kind::Ball, {radius_m, 0, 0}, radius_m};
    }
    return {};
}

double depth_m(const Solid& a, const BodyView& at_a, const Solid& b, const BodyView& at_b) {
    using Kind = Solid::Kind;
    if (a.kind == Kind::None || b.kind == Kind::None) return 0;
    if (a.kind == Kind::Box && b.kind == Kind::Box)
        return box_box_depth_m(at_a, a.half_m, at_b, b.half_m);
    if (a.kind == Kind::Ball && b.kind == Kind::Ball)
        return a.half_m.x + b.half_m.x - glm::length(at_a.position - at_b.position);
    if (a.kind == Kind::Ball) return ball_box_depth_m(at_a.position, a.half_m.x, at_b, b.half_m);
    return ball_box_depth_m(at_b.position, b.half_m.x, at_a, a.half_m);
}

}  // namespace

double box_box_depth_m(const BodyView& a,
                       const Vec3d& half_a_m,
                       const BodyView& b,
                       const Vec3d& half_b_m) {
    const Axes of_a = axes_of(a);
    const Axes of_b = axes_of(b);
    const Vec3d apart = b.position - a.position;
    double least_m = std::numeric_limits<double>::infinity();
    const auto test = [&](const Vec3d& direction) {
        least_m = std::min(least_m,
                           reach(of_a, half_a_m, direction) + reach(of_b, half_b_m, direction) -
                               std::abs(glm::dot(apart, direction)));
    };
    for (const Vec3d& axis : of_a) test(axis);
    for (const Vec3d& axis : of_b) test(axis);
    for (const Vec3d& along_a : of_a) {
        for (const Vec3d& along_b : of_b) {
            const Vec3d cross = glm::cross(along_a, along_b);
            const double length = glm::length(cross);
            // Edges side by side: the faces' axes say it all.
            if (length > 1e-4) test(cross / length);
        }
    }
    return least_m;
}

double ball_box_depth_m(const Vec3d& center,
                        double radius_m,
                        const BodyView& box,
                        const Vec3d& half_m) {
    const Vec3d local = glm::conjugate(box.orientation) * (center - box.position);
    const Vec3d outside = glm::max(glm::abs(local) - half_m, Vec3d(0.0));
    const double gap_m = glm::length(outside);
    if (gap_m > 0) return radius_m - gap_m;
    const Vec3d inside = half_m - glm::abs(local);
    return radius_m + std::min({inside.x, inside.y, inside.z});
}

Overlaps overlaps_of(const PeerScene& scene, const std::vector<BodyView>& views) {
    std::vector<Solid> solids;
    for (const PeerBody& body : scene.bodies) solids.push_back(solid_of(body));
    Overlaps found;
    for (std::size_t i = 0; i < solids.size(); ++i) {
        for (std::size_t j = i + 1; j < solids.size(); ++j) {
            if (!scene.bodies[i].dynamic() && !scene.bodies[j].dynamic()) continue;
            const double reach_m = solids[i].outer_radius_m + solids[j].outer_radius_m;
            const Vec3d apart = views[i].position - views[j].position;
            if (glm::dot(apart, apart) > reach_m * reach_m) continue;
            const double depth = depth_m(solids[i], views[i], solids[j], views[j]);
            if (!(depth > 0)) continue;
            found.deepest_m = std::max(found.deepest_m, depth);
            found.sum_m += depth;
            found.sum_of_squares_m2 += depth * depth;
            ++found.pairs;
        }
    }
    return found;
}

}  // namespace plumbline::bench
