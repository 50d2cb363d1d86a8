#include "engine/scene/build/rope_layout.h"

#include "engine/core/portable_math.h"

#include <algorithm>
#include <cmath>

namespace plumbline::scene {
namespace {

constexpr double kSlack = 1e-6;    // of the length: less is straight
constexpr double kNoWidth = 1e-3;  // of the length: anchors above each other
constexpr double kFits = 1e-9;     // of a piece: so far may its points be off
constexpr int kMostRounds = 100;

/// In the plane of the anchors: x across, y up.
using Vec2d = glm::dvec2;

/// A hanging chain by the force that its second half pulls its first joint with.
class HangingChain {
public:
    HangingChain(int pieces, double piece_m, double weight_N, double compliance_mpN)
        : pieces_(pieces), piece_m_(piece_m), weight_N_(weight_N), compliance_(compliance_mpN) {}

    /// Where it ends, from where it begins, and how that changes with the force.
    struct End {
        Vec2d at{0, 0};
        glm::dmat2 by_force{0};
    };
    /// Calls visit(point) for each point.
    template <class Visit>
    End end(const Vec2d& force_N, Visit visit) const {
        End sum;
        for (int i = 0; i <= pieces_; ++i) {
            const Vec2d at_joint = force_N + Vec2d{0, weight_N_ * i};
            const double share = i == 0 || i == pieces_ ? 0.5 : 1;
            sum.at += at_joint * (compliance_ * share / 2);
            visit(sum.at);
            sum.at += at_joint * (compliance_ * share / 2);
            sum.by_force += glm::dmat2(compliance_ * share);
            if (i == pieces_) break;
            const Vec2d middle = force_N + Vec2d{0, weight_N_ * (i + 0.5)};
            const double size = std::max(glm::length(middle), 1e-12);
            const Vec2d along = middle / size;
            sum.at += along * piece_m_;
            sum.by_force += (glm::dmat2(1) - glm::outerProduct(along, along)) * (piece_m_ / size);
        }
        return sum;
    }

private:
    int pieces_;
    double piece_m_;
    double weight_N_;
    double compliance_;
};

/// x of sinh(x) / x = ratio, by Newton's method.
double catenary_parameter(double ratio) {
    double x = std::sqrt(6 * (ratio - 1));
    for (int i = 0; i < kMostRounds; ++i) {
        const double up = portable_exp(x);
        const double down = 1 / up;
        const double step = ((up - down) / 2 - ratio * x) / ((up + down) / 2 - ratio);
        x -= step;
        if (std::abs(step) < 1e-14 * x) break;
    }
    return x;
}

/// The force at the first anchor of the catenary that ends at `end_m`.
Vec2d catenary_force(const Vec2d& end_m, double length_m, double weight_N) {
    const double across = std::max(end_m.x, kNoWidth * length_m);
    const double rise = std::clamp(end_m.y, -0.999 * length_m, 0.999 * length_m);
    const double ratio = std::sqrt(length_m * length_m - rise * rise) / across;
    const double x = catenary_parameter(std::max(ratio, 1 + kSlack));
    const double scale_m = across / (2 * x);
    const double horizontal = weight_N * scale_m / length_m;
    const double down = portable_exp(-2 * x);
    const double coth = (1 + down) / (1 - down);
    return {horizontal, weight_N / 2 * (rise / length_m * coth - 1)};
}

std::vector<Vec2d> chain_points(const HangingChain& chain, const Vec2d& force_N) {
    std::vector<Vec2d> points;
    chain.end(force_N, [&](const Vec2d& point) { points.push_back(point); });
    return points;
}

/// Moves the inner points until neighbours are one length apart.
void space_out(std::vector<Vec2d>& points, double piece_m) {
    for (int round = 0; round < kMostRounds * kMostRounds; ++round) {
        double worst_m = 0;
        for (std::size_t i = 1; i < points.size(); ++i) {
            const Vec2d between = points[i] - points[i - 1];
            const double length_m = std::max(glm::length(between), 1e-12);
            const bool first_moves = i > 1;
            const bool second_moves = i + 1 < points.size();
            const double share = first_moves && second_moves ? 0.5 : 1;
            const Vec2d change = between * (share * (1 - piece_m / length_m));
            if (first_moves) points[i - 1] += change;
            if (second_moves) points[i] -= change;
            worst_m = std::max(worst_m, std::abs(length_m - piece_m));
        }
        if (worst_m < kFits * piece_m) return;
    }
}

/// Points of the chain in equilibrium; where no force is found, as for ends above each other, near it.
std::vector<Vec2d> hang(const HangingChain& chain,
                        const Vec2d& end_m,
                        double piece_m,
                        Vec2d force_N) {
    const auto nothing = [](const Vec2d&) {};
    const Vec2d first_N = force_N;
    for (int i = 0; i < kMostRounds; ++i) {
        const HangingChain::End now = chain.end(force_N, nothing);
        const Vec2d error = end_m - now.at;
        if (glm::length(error) < kFits * piece_m) return chain_points(chain, force_N);
        Vec2d step = glm::inverse(now.by_force) * error;
        // As much of it as comes nearer.
        while (glm::length(end_m - chain.end(force_N + step, nothing).at) > glm::length(error) &&
               glm::length(step) > kFits * glm::length(force_N))
            step *= 0.5;
        force_N += step;
    }
    std::vector<Vec2d> points = chain_points(chain, first_N);
    const Vec2d error = end_m - points.back();
    const double count = static_cast<double>(points.size() - 1);
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i] += error * (static_cast<double>(i) / count);
    space_out(points, piece_m);
    return points;
}

/// The shortest turn from one unit vector to another.
Quatd turn_onto(const Vec3d& from, const Vec3d& to) {
    const Quatd half{1 + glm::dot(from, to), glm::cross(from, to)};
    if (half.w > 1e-9) return glm::normalize(half);
    const Vec3d other = std::abs(from.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 0, 1};
    return Quatd{0, glm::normalize(glm::cross(from, other))};
}

/// The point of the path that is this far along it.
Vec3d along_path(const std::vector<Vec3d>& path, double way_m) {
    for (std::size_t i = 1; i < path.size(); ++i) {
        const double length = glm::distance(path[i - 1], path[i]);
        if (way_m <= length || i + 1 == path.size())
            return path[i - 1] + (path[i] - path[i - 1]) * (length > 0 ? way_m / length : 0.0);
        way_m -= length;
    }
    return path.front();
}

/// How far along the path the point after `way_m` is that is `chord_m` away.
double next_on_path(const std::vector<Vec3d>& path, double way_m, double chord_m, double whole_m) {
    const Vec3d from = along_path(path, way_m);
    double low = way_m;
    double high = std::min(way_m + chord_m, whole_m);
    // A chord is no longer than the path: forward until it is long enough.
    while (high < whole_m && glm::distance(from, along_path(path, high)) < chord_m)
        high = std::min(high + chord_m / 4, whole_m);
    if (glm::distance(from, along_path(path, high)) < chord_m) return whole_m + chord_m;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (glm::distance(from, along_path(path, middle)) < chord_m ? low : high) = middle;
    }
    return high;
}

/// Points on the path, one chord from one to the next.
std::vector<Vec3d> walk(const std::vector<Vec3d>& path, int pieces) {
    const double whole_m = length_of(path);
    double low = 0;
    double high = whole_m / pieces;
    const auto reaches_past = [&](double chord_m) {
        double way_m = 0;
        for (int i = 0; i < pieces && way_m <= whole_m; ++i)
            way_m = next_on_path(path, way_m, chord_m, whole_m);
        return way_m > whole_m;
    };
    for (int i = 0; i < 50 && path.size() > 2; ++i) {
        const double middle = (low + high) / 2;
        (reaches_past(middle) ? high : low) = middle;
    }
    const double chord_m = path.size() > 2 ? low : high;
    std::vector<Vec3d> points{path.front()};
    double way_m = 0;
    for (int i = 1; i < pieces; ++i) {
        way_m = path.size() > 2 ? next_on_path(path, way_m, chord_m, whole_m) : chord_m * i;
        points.push_back(along_path(path, way_m));
    }
    points.push_back(path.back());
    return points;
}

}  // namespace

std::vector<Pose> RopeLayout::pieces() const {
    std::vector<Pose> poses;
    Vec3d before{0, 1, 0};
    Quatd turn{1, 0, 0, 0};
    for (std::size_t i = 0; i + 1 < points_m.size(); ++i) {
        const Vec3d along = normalize_or(points_m[i + 1] - points_m[i], before);
        turn = glm::normalize(turn_onto(before, along) * turn);
        before = along;
        poses.push_back({Vec3((points_m[i] + points_m[i + 1]) * 0.5), Quat(turn)});
    }
    return poses;
}

RopeLayout lay_rope(const RopeDescription& rope, int pieces, const Vec3d& gravity_mps2) {
    RopeLayout layout;
    layout.piece_m = rope.length_m / pieces;
    std::vector<Vec3d> path;
    for (const Vec3& point : rope.path_m) path.emplace_back(point);
    const Vec3d a(rope.anchor_a_m);
    const Vec3d b(rope.anchor_b_m);
    if (path.empty()) path = {a, b};
    if (!rope.path_m.empty() || rope.length_m < glm::distance(a, b) * (1 + kSlack)) {
        layout.points_m = walk(path, pieces);
        return layout;
    }
    const double gravity = glm::length(gravity_mps2);
    const Vec3d up = gravity > 0 ? gravity_mps2 / -gravity : Vec3d{0, 1, 0};
    const double rise_m = glm::dot(b - a, up);
    const Vec3d across = (b - a) - rise_m * up;
    const Vec3d sideways = std::abs(up.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 0, 1};
    const Vec3d x_axis =
        normalize_or(across, glm::normalize(sideways - glm::dot(sideways, up) * up));
    const Vec2d end_m{glm::length(across), rise_m};
    const double piece_N = rope.mass_kg * (gravity > 0 ? gravity : 1) / pieces;
    const double compliance = rope.stiffness_N > 0 ? layout.piece_m / rope.stiffness_N : 0;
    const Vec2d force_N = catenary_force(end_m, rope.length_m, piece_N * pieces);
    const HangingChain chain(pieces, layout.piece_m, piece_N, compliance);
    for (const Vec2d& point : hang(chain, end_m, layout.piece_m, force_N))
        layout.points_m.push_back(a + x_axis * point.x + up * point.y);
    return layout;
}

}  // namespace plumbline::scene
