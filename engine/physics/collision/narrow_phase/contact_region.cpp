#include "engine/physics/collision/narrow_phase/contact_region.h"

#include "engine/physics/transform.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace plumbline::physics {
namespace {

using FeatureKind = Feature::Kind;

/// Lines that differ by less than this, rad, touch all along and not where they cross.
constexpr double kParallelLines = 0.05;
/// A face steeper than this against the normal says nothing of what lies over it.
constexpr double kSteep = 1e-3;

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

bool is_line(const Feature& feature) {
    return feature.kind == FeatureKind::Segment || feature.kind == FeatureKind::Polygon;
}

Vec3d within_rim(const Feature& disc, const Vec3d& point) {
    const Vec3d out = point - disc.center_m;
    const double length = glm::length(out);
    return length > disc.radius_m ? disc.center_m + out * (disc.radius_m / length) : point;
}

std::size_t next_of(std::size_t corner, const Feature& feature) {
    return corner + 1 == feature.count ? 0 : corner + 1;
}

}  // namespace

ContactRegion::ContactRegion(
    const Feature& a, const Feature& b, const Vec3d& normal, double reach_m, double same_m)
    : normal_(normal), reach_m_(reach_m), same_m_(same_m) {
    const Vec3d size = magnitudes_of(normal);
    Vec3d least{1, 0, 0};
    if (size.y < size.x) least = {0, 1, 0};
    if (size.z < std::min(size.x, size.y)) least = {0, 0, 1};
    x_ = glm::normalize(glm::cross(normal, least));
    y_ = glm::cross(normal, x_);
    if (a.kind == FeatureKind::Segment && b.kind == FeatureKind::Segment) {
        add_overlap_of_segments(a, b);
        return;
    }
    Outline seen_a(a);
    Outline seen_b(b);
    outline(seen_a);
    outline(seen_b);
    compare(seen_a, seen_b);
    compare(seen_b, seen_a);
    add_corners(seen_a, seen_b, false);
    add_corners(seen_b, seen_a, true);
    if (is_line(a) && is_line(b)) add_crossings(seen_a, seen_b);
    if (b.kind == FeatureKind::Disc)
        add_disc_crossings(seen_b, seen_a, true);
    else if (a.kind == FeatureKind::Disc)
        add_disc_crossings(seen_a, seen_b, false);
}

/// The corners and, of polygons and segments, the lines of the edges.
void ContactRegion::outline(Outline& of) const {
    const Feature& feature = of.feature;
    for (std::size_t i = 0; i < feature.count; ++i) of.corners[i] = flat(feature.corners[i]);
    if (!is_line(feature)) return;
    of.edges = feature.kind == FeatureKind::Segment ? 1 : feature.count;
    const double turn = glm::dot(feature.normal, normal_) < 0 ? -1 : 1;
    for (std::size_t i = 0; i < of.edges; ++i) {
        const Flat edge = of.corners[next_of(i, feature)] - of.corners[i];
        const double length2 = glm::dot(edge, edge);
        const double scale = length2 > 0 ? turn / std::sqrt(length2) : 0.0;
        const Flat inward{-edge.y * scale, edge.x * scale};
        of.lines[i] = {inward, glm::dot(inward, of.corners[i])};
    }
}

/// Where each corner lies against the other feature.
void ContactRegion::compare(Outline& of, const Outline& with) const {
    const Feature& other = with.feature;
    // Beside a steep face its plane soon lies far below.
    const double beside_m = same_m_ * std::abs(glm::dot(other.normal, normal_));
    for (std::size_t i = 0; i < of.feature.count; ++i) {
        std::uint64_t inside = 0;
        double least_m = std::numeric_limits<double>::max();
        for (std::size_t k = 0; k < with.edges; ++k) {
            const double in_m =
                glm::dot(with.lines[k].inward, of.corners[i]) - with.lines[k].offset_m;
            inside |= static_cast<std::uint64_t>(in_m >= 0) << k;
            least_m = std::min(least_m, in_m);
        }
        of.inside_of[i] = inside;
        of.is_covered[i] = other.kind == FeatureKind::Polygon && least_m >= -beside_m;
        if (other.kind == FeatureKind::Disc) {
            Vec3d over;
            const double most_m = other.radius_m + beside_m;
            of.is_covered[i] = lift(other, of.feature.corners[i], over) &&
                               glm::distance(over, other.center_m) <= most_m;
        }
    }
}

/// Keeps the pair of points unless they are too far apart or known.
void ContactRegion::add(const Vec3d& on_a, const Vec3d& on_b) {
    const double distance_m = glm::dot(on_a - on_b, normal_);
    if (distance_m > reach_m_ || count_ == kRoom) return;
    const Flat at = flat(on_a);
    for (std::size_t i = 0; i < count_; ++i) {
        const Flat away = places_[i] - at;
        if (glm::dot(away, away) <= same_m_ * same_m_) return;
    }
    places_[count_] = at;
    points_[count_++] = {on_a, on_b, distance_m};
}

void ContactRegion::add_in_order(const Vec3d& first, const Vec3d& second, bool first_is_b) {
    if (first_is_b)
        add(second, first);
    else
        add(first, second);
}

/// The corners of `from` that lie over `onto`.
void ContactRegion::add_corners(const Outline& from, const Outline& onto, bool is_b) {
    for (std::size_t i = 0; i < from.feature.count; ++i) {
        const Vec3d& corner = from.feature.corners[i];
        Vec3d over;
        if (from.is_covered[i] && lift(onto.feature, corner, over))
            add_in_order(corner, over, is_b);
    }
}

/// Where the edges of both cross: the ends of each lie on two sides of the other. An edge that is covered from
/// end to end brings nothing that its ends do not.
void ContactRegion::add_crossings(const Outline& a, const Outline& b) {
    std::uint64_t open_b = 0;
    for (std::size_t k = 0; k < b.edges; ++k) {
        const bool is_covered = b.is_covered[k] && b.is_covered[next_of(k, b.feature)];
        open_b |= static_cast<std::uint64_t>(!is_covered) << k;
    }
    for (std::size_t i = 0; i < a.edges; ++i) {
        const std::size_t next = next_of(i, a.feature);
        if (a.is_covered[i] && a.is_covered[next]) continue;
        std::uint64_t crossed = (a.inside_of[i] ^ a.inside_of[next]) & open_b;
        for (; crossed != 0; crossed &= crossed - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(crossed));
            const std::uint64_t ends = b.inside_of[k] ^ b.inside_of[next_of(k, b.feature)];
            if ((ends >> i & 1U) != 0) add_crossing(a, i, b, k);
        }
    }
}

void ContactRegion::add_crossing(const Outline& a, std::size_t i, const Outline& b, std::size_t k) {
    const std::size_t next_i = next_of(i, a.feature);
    const std::size_t next_k = next_of(k, b.feature);
    const Flat r = a.corners[next_i] - a.corners[i];
    const Flat s = b.corners[next_k] - b.corners[k];
    const Flat apart = b.corners[k] - a.corners[i];
    const double turn = cross(r, s);
    if (turn == 0) return;
    const double t = std::clamp(cross(apart, s) / turn, 0.0, 1.0);
    const double u = std::clamp(cross(apart, r) / turn, 0.0, 1.0);
    const Vec3d& from_a = a.feature.corners[i];
    const Vec3d& from_b = b.feature.corners[k];
    add(from_a + (a.feature.corners[next_i] - from_a) * t,
        from_b + (b.feature.corners[next_k] - from_b) * u);
}

/// Where the rim of `disc` crosses the edges of the other, or its rim. `is_b`: the disc is b's.
void ContactRegion::add_disc_crossings(const Outline& disc, const Outline& other, bool is_b) {
    if (other.feature.kind == FeatureKind::Disc)
        return add_rim_crossings(disc.feature, other.feature, is_b);
    const double radius = disc.feature.radius_m;
    for (std::size_t i = 0; i < other.edges; ++i) {
        const std::size_t next = next_of(i, other.feature);
        if (other.is_covered[i] && other.is_covered[next]) continue;
        const Vec3d& from = other.feature.corners[i];
        const Vec3d& to = other.feature.corners[next];
        Vec3d over_from;
        Vec3d over_to;
        if (!lift(disc.feature, from, over_from) || !lift(disc.feature, to, over_to)) return;
        const Vec3d p = over_from - disc.feature.center_m;
        const Vec3d r = over_to - over_from;
        const double rr = glm::dot(r, r);
        const double pr = glm::dot(p, r);
        const double root2 = pr * pr - rr * (glm::dot(p, p) - radius * radius);
        if (!(rr > 0) || root2 < 0) continue;
        const double root = std::sqrt(root2);
        for (const double t : {(-pr - root) / rr, (-pr + root) / rr}) {
            if (t >= 0 && t <= 1) add_in_order(over_from + r * t, from + (to - from) * t, is_b);
        }
    }
}

/// As circles across the normal; what lies outside of a rim because the discs lean is brought back to it.
void ContactRegion::add_rim_crossings(const Feature& disc, const Feature& other, bool is_b) {
    const double radius = disc.radius_m;
    const double other_radius = other.radius_m;
    const Flat center = flat(disc.center_m);
    const Flat apart = flat(other.center_m) - center;
    const double apart_m = glm::length(apart);
    if (apart_m > radius + other_radius || apart_m < std::abs(radius - other_radius) ||
        apart_m <= same_m_)
        return;
    const double along =
        (apart_m * apart_m + radius * radius - other_radius * other_radius) / (2 * apart_m);
    const double across = std::sqrt(std::max(radius * radius - along * along, 0.0));
    const Flat out = apart / apart_m;
    for (const double side : {-across, across}) {
        const Flat place = center + out * along + Flat{-out.y, out.x} * side;
        const Vec3d there = x_ * place.x + y_ * place.y;
        Vec3d on_disc;
        Vec3d on_other;
        if (!lift(disc, there, on_disc) || !lift(other, there, on_other)) continue;
        add_in_order(within_rim(disc, on_disc), within_rim(other, on_other), is_b);
    }
}

/// Two lines touch where they cross or, nearly parallel, at both ends of what they have beside each other.
void ContactRegion::add_overlap_of_segments(const Feature& a, const Feature& b) {
    const Flat p = flat(a.corners[0]);
    const Flat r = flat(a.corners[1]) - p;
    const Flat q = flat(b.corners[0]);
    const Flat s = flat(b.corners[1]) - q;
    const double rr = glm::dot(r, r);
    const double ss = glm::dot(s, s);
    if (!(rr > 0) || !(ss > 0)) return;
    const Vec3d along_a = a.corners[1] - a.corners[0];
    const Vec3d along_b = b.corners[1] - b.corners[0];
    const double turn = cross(r, s);
    if (std::abs(turn) > kParallelLines * std::sqrt(rr * ss)) {
        const double t = cross(q - p, s) / turn;
        const double u = cross(q - p, r) / turn;
        if (t >= 0 && t <= 1 && u >= 0 && u <= 1)
            add(a.corners[0] + along_a * t, b.corners[0] + along_b * u);
        return;
    }
    double from = glm::dot(q - p, r) / rr;
    double to = glm::dot(q + s - p, r) / rr;
    if (from > to) std::swap(from, to);
    from = std::max(from, 0.0);
    to = std::min(to, 1.0);
    if (from > to) return;
    for (const double t : {from, to}) {
        const double u = std::clamp(glm::dot(p + r * t - q, s) / ss, 0.0, 1.0);
        add(a.corners[0] + along_a * t, b.corners[0] + along_b * u);
    }
}

/// The feature's point under or over `point`.
bool ContactRegion::lift(const Feature& feature, const Vec3d& point, Vec3d& lifted) const {
    if (feature.kind == FeatureKind::Polygon || feature.kind == FeatureKind::Disc) {
        const double steepness = glm::dot(feature.normal, normal_);
        if (std::abs(steepness) < kSteep) return false;
        const Vec3d& on_plane =
            feature.kind == FeatureKind::Disc ? feature.center_m : feature.corners[0];
        lifted = point + normal_ * (glm::dot(on_plane - point, feature.normal) / steepness);
        return true;
    }
    return false;
}

double ContactRegion::width_m() const {
    double least_m = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < count_; ++i) {
        for (std::size_t k = i + 1; k < count_; ++k) {
            const Flat along = places_[k] - places_[i];
            double low = 0;
            double high = 0;
            for (std::size_t l = 0; l < count_; ++l) {
                const double off = cross(along, places_[l] - places_[i]);
                low = std::min(low, off);
                high = std::max(high, off);
            }
            least_m = std::min(least_m, (high - low) / glm::length(along));
        }
    }
    return count_ < 3 ? 0 : least_m;
}

void ContactRegion::reduce(double level_m) {
    if (count_ <= PointChoice::kAllKept) return;
    std::array<FlatPoint, kRoom> flat;
    for (std::size_t i = 0; i < count_; ++i) flat[i] = {places_[i], points_[i].distance_m};
    const PointChoice choice = choose_points({flat.data(), count_}, level_m);
    std::array<RegionPoint, kMost> points;
    for (std::size_t i = 0; i < choice.count; ++i) points[i] = points_[choice.kept[i]];
    count_ = 0;
    for (std::size_t i = 0; i < choice.count; ++i) add(points[i].on_a, points[i].on_b);
}

}  // namespace plumbline::physics
