#include "engine/physics/collision/narrow_phase/convex_convex.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::physics {
namespace {

/// Shares of the smaller shape's size: a face as good as the best direction, points that are one, points
/// that are equally deep.
constexpr double kAsGoodShare = 1e-6;
constexpr double kOnePoint = 1e-4;
constexpr double kAsDeep = 2e-4;

double smaller_size(const PlacedConvex& a, const PlacedConvex& b) {
    return std::min(size_of(a), size_of(b));
}

/// How much less a face's normal may part cores that are `core_m` apart and still count as good. Round ones touch
/// elsewhere where the normal turns: there it may turn by 1e-4 only.
double as_good(const PlacedConvex& a, const PlacedConvex& b, double core_m) {
    constexpr double kTurned = 5e-9;
    const double good_m = kAsGoodShare * smaller_size(a, b);
    const bool is_round = a.radius_m + b.radius_m > 0 && core_m > 0;
    return is_round ? std::min(good_m, kTurned * core_m) : good_m;
}

/// What of both shapes faces the other along a normal.
struct Facing {
    Facing(const PlacedConvex& of_a, const PlacedConvex& of_b, const Vec3d& along)
        : a(of_a), b(of_b), normal(along) {
        find_feature(a, -normal, feature_a);
        find_feature(b, normal, feature_b);
    }

    bool is_region() const {
        return feature_a.kind != Feature::Kind::Point && feature_b.kind != Feature::Kind::Point;
    }
    ContactRegion region(double reach_m) const {
        return {feature_a, feature_b, normal, reach_m + round_m, kOnePoint * size_m};
    }
    /// Adds a point of the cores, as one of the surfaces.
    void put(const RegionPoint& core, SurfaceContact& contact) const {
        contact.points[contact.count++] = {core.on_a - normal * a.radius_m,
                                           core.on_b + normal * b.radius_m,
                                           core.distance_m - round_m};
    }
    void put(const ContactRegion& reduced, SurfaceContact& contact) const {
        for (const RegionPoint& point : reduced.points()) put(point, contact);
    }
    /// Adds the nearest points, in place of the last, where none of the contact's is as near.
    void put_nearest(const RegionPoint& core,
                     double core_m,
                     double reach_m,
                     SurfaceContact& contact) const {
        const double distance_m = core_m - round_m;
        if (distance_m > reach_m) return;
        const double as_deep_m = kAsDeep * size_m + feature_a.between_m + feature_b.between_m;
        for (std::size_t i = 0; i < contact.count; ++i) {
            if (contact.points[i].distance_m <= distance_m + as_deep_m) return;
        }
        if (contact.count == contact.points.size()) --contact.count;
        put({core.on_a, core.on_b, core_m}, contact);
    }
    /// Cores that overlap by `depth_m` along the normal part nowhere more easily (by more than
    /// kAsGoodShare) where the points of a - b reach wide enough round the origin. Those at the height -depth_m, or up to `uneven_m` higher, over
    /// the plane through the origin form a polygon whose rim is `wide_m` from the origin's foot; the difference
    /// of the centres lies above. Their hull must have the origin deeper inside on all other sides.
    bool is_shallowest(double depth_m, double wide_m, double uneven_m) const {
        const Vec3d centers = a.center_m - b.center_m;
        const double top_m = glm::dot(centers, normal);
        if (!(top_m > depth_m)) return false;
        // The region's corners may lie beside the face by as much.
        const double sure_m = wide_m - 2 * kOnePoint * size_m;
        // Directions that lean less than this against the normal are as good.
        const double lean = std::min(std::sqrt(2 * kAsGoodShare * size_m / depth_m), 1.0);
        if (sure_m * lean * 0.8 < uneven_m) return false;
        // The hull's cut at the height depth_m must cover the ball of that radius.
        const double share = 2 * depth_m / (top_m + depth_m);
        const double aside_m = glm::length(centers - normal * top_m);
        return sure_m * (1 - share) - aside_m * share >= depth_m;
    }

    const PlacedConvex& a;
    const PlacedConvex& b;
    Vec3d normal;
    double round_m{a.radius_m + b.radius_m};
    double size_m{smaller_size(a, b)};
    Feature feature_a;
    Feature feature_b;
};

/// Takes a normal in place of the one found where it is as good.
void prefer(const PlacedConvex& a,
            const PlacedConvex& b,
            const Vec3d& normal,
            double as_good_m,
            Separation& best) {
    const double distance_m = distance_along(a, b, normal);
    if (distance_m < best.distance_m - as_good_m) return;
    best.normal = normal;
    best.distance_m = distance_m;
}

/// A cylinder that is touched on its side is the segment of its axis with a radius.
PlacedConvex swollen_axis(const PlacedConvex& convex, const Vec3d& normal, ConvexShape& axis) {
    constexpr double kOnSide = 0.1;
    if (convex.shape == nullptr || convex.shape->kind != ConvexShape::Kind::Cylinder ||
        std::abs(glm::dot(convex.axes[1], normal)) > kOnSide)
        return convex;
    axis = *convex.shape;
    axis.kind = ConvexShape::Kind::Capsule;
    PlacedConvex swollen = convex;
    swollen.shape = &axis;
    swollen.radius_m = static_cast<double>(axis.radius_m);
    return swollen;
}

/// The normal that sides of cylinders have is known to many more digits from their axes.
void prefer_sides(const PlacedConvex& a,
                  const PlacedConvex& b,
                  double as_good_m,
                  Separation& best) {
    ConvexShape axis_a;
    ConvexShape axis_b;
    const PlacedConvex core_a = swollen_axis(a, best.normal, axis_a);
    const PlacedConvex core_b = swollen_axis(b, best.normal, axis_b);
    if (core_a.shape != &axis_a && core_b.shape != &axis_b) return;
    const double reach_m = std::numeric_limits<double>::max();
    const Closest closest = closest_points(core_a, core_b, reach_m);
    if (!(closest.distance_m > 0)) return;
    prefer(a, b, glm::normalize(closest.on_a - closest.on_b), as_good_m, best);
}

/// How far inside the face a point lies, seen along the face's normal.
double margin_in(const Feature& face, const Vec3d& point) {
    if (face.kind == Feature::Kind::Disc) {
        const Vec3d out = point - face.center_m;
        const double up = glm::dot(out, face.normal);
        return face.radius_m - std::sqrt(std::max(glm::dot(out, out) - up * up, 0.0));
    }
    if (face.kind != Feature::Kind::Polygon) return 0;
    double least_m = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < face.count; ++i) {
        const Vec3d& from = face.corners[i];
        const Vec3d edge = face.corners[i + 1 == face.count ? 0 : i + 1] - from;
        const double length = glm::length(edge);
        if (!(length > 0)) continue;
        const double in_m = glm::dot(glm::cross(face.normal, edge), point - from) / length;
        least_m = std::min(least_m, in_m);
    }
    return least_m;
}

/// A face of one core as the direction that parts both.
struct FaceTry {
    Vec3d normal{0, 1, 0};  ///< from b to a
    bool is_of_b{false};
    Vec3d nearest{0, 0, 0};  ///< of the other core's points, to the plane
    double core_m{std::numeric_limits<double>::lowest()};  ///< how far that is

    RegionPoint points() const {
        const Vec3d across = normal * core_m;
        return is_of_b ? RegionPoint{nearest, nearest - across, core_m}
                       : RegionPoint{nearest + across, nearest, core_m};
    }
};

/// The better of the faces that the centres lie over; its distance is the lowest number where there is none.
FaceTry best_face(const PlacedConvex& a, const PlacedConvex& b) {
    FaceTry best;
    const auto consider = [&](const FacePlane& face, const PlacedConvex& other, bool is_of_b) {
        if (!face.exists) return;
        const Vec3d nearest = support(other, -face.normal);
        const double core_m = glm::dot(nearest, face.normal) - face.offset_m;
        if (core_m > best.core_m)
            best = {is_of_b ? face.normal : -face.normal, is_of_b, nearest, core_m};
    };
    consider(face_under(a, b.center_m), b, false);
    consider(face_under(b, a.center_m), a, true);
    return best;
}

/// Whether the feature lies almost across the normal.
bool is_level(const Feature& feature, const Vec3d& normal) {
    constexpr double kLean = 1e-3;
    if (feature.kind == Feature::Kind::Point) return false;
    if (feature.kind != Feature::Kind::Segment)
        return std::abs(glm::dot(feature.normal, normal)) > 1 - kLean * kLean / 2;
    const Vec3d along = feature.corners[1] - feature.corners[0];
    return std::abs(glm::dot(along, normal)) < kLean * glm::length(along);
}

const RegionPoint& nearest_of(std::span<const RegionPoint> points) {
    return *std::min_element(
        points.begin(), points.end(), [](const RegionPoint& x, const RegionPoint& y) {
            return x.distance_m < y.distance_m;
        });
}

/// Whether the point nearest to the face's plane proves that no direction is better than the face's normal: of cores
/// that are apart, because it lies over the face; of those that overlap, see is_shallowest().
bool proves_best(const Facing& facing, const FaceTry& face) {
    const double margin_m =
        margin_in(face.is_of_b ? facing.feature_b : facing.feature_a, face.nearest);
    if (face.core_m >= 0) return margin_m >= 0;
    return facing.is_shallowest(-face.core_m, margin_m, 0);
}

/// Whether the whole region proves it.
bool proves_best(const Facing& facing,
                 const FaceTry& face,
                 const ContactRegion& reduced,
                 const RegionPoint& nearest) {
    if (nearest.distance_m > face.core_m + as_good(facing.a, facing.b, face.core_m)) return false;
    if (face.core_m >= 0) return true;
    double highest_m = face.core_m;
    for (const RegionPoint& point : reduced.points())
        highest_m = std::max(highest_m, point.distance_m);
    return facing.is_shallowest(-face.core_m, reduced.width_m(), highest_m - face.core_m);
}

enum class Verdict : std::uint8_t { Apart, Found, Unknown };

Verdict by_faces(const PlacedConvex& a, const PlacedConvex& b, double reach_m, ConvexPair& found) {
    const FaceTry face = best_face(a, b);
    if (face.core_m - a.radius_m - b.radius_m > reach_m) return Verdict::Apart;
    if (face.core_m == FaceTry{}.core_m) return Verdict::Unknown;
    const Facing facing(a, b, face.normal);
    const bool is_proven = proves_best(facing, face);
    const Feature& other = face.is_of_b ? facing.feature_a : facing.feature_b;
    if (!is_proven && !is_level(other, face.normal)) return Verdict::Unknown;
    RegionPoint nearest = face.points();
    if (facing.is_region()) {
        ContactRegion region = facing.region(reach_m);
        if (!is_proven && region.points().empty()) return Verdict::Unknown;
        if (!is_proven) nearest = nearest_of(region.points());
        region.reduce(kAsDeep * facing.size_m);
        if (!is_proven && !proves_best(facing, face, region, nearest)) return Verdict::Unknown;
        facing.put(region, found.contact);
    }
    facing.put_nearest(nearest, face.core_m, reach_m, found.contact);
    found.separation = {face.normal, face.core_m - facing.round_m, nearest.on_a, nearest.on_b};
    return Verdict::Found;
}

}  // namespace

double distance_along(const PlacedConvex& a, const PlacedConvex& b, const Vec3d& normal) {
    return glm::dot(support(a, -normal) - support(b, normal), normal) - a.radius_m - b.radius_m;
}

std::optional<Separation> separation_of(const PlacedConvex& a,
                                        const PlacedConvex& b,
                                        double reach_m) {
    const double round_m = a.radius_m + b.radius_m;
    const Closest closest = closest_points(a, b, reach_m + round_m);
    if (closest.distance_m > reach_m + round_m) return std::nullopt;
    Separation found{.on_a = closest.on_a, .on_b = closest.on_b};
    if (closest.distance_m > 0) {
        found.normal = glm::normalize(closest.on_a - closest.on_b);
        found.distance_m = closest.distance_m - round_m;
    } else {
        const Penetration deep = penetration_of(a, b, closest.simplex);
        found = {deep.normal, -deep.depth_m - round_m, deep.on_a, deep.on_b};
    }
    const double as_good_m = as_good(a, b, found.distance_m + round_m);
    const FacePlane of_a = face_along(a, -found.normal);
    const FacePlane of_b = face_along(b, found.normal);
    Separation by_a = found;
    Separation by_b = found;
    if (of_a.exists) prefer(a, b, -of_a.normal, as_good_m, by_a);
    if (of_b.exists) prefer(a, b, of_b.normal, as_good_m, by_b);
    const bool has_a = by_a.normal != found.normal;
    const bool has_b = by_b.normal != found.normal;
    if (has_a && (!has_b || by_a.distance_m >= by_b.distance_m)) return by_a;
    if (has_b) return by_b;
    prefer_sides(a, b, as_good_m, found);
    return found;
}

SurfaceContact contact_along(const PlacedConvex& a,
                             const PlacedConvex& b,
                             const Separation& separation,
                             double reach_m) {
    const Facing facing(a, b, separation.normal);
    SurfaceContact contact;
    if (facing.is_region()) {
        ContactRegion region = facing.region(reach_m);
        region.reduce(kAsDeep * facing.size_m);
        facing.put(region, contact);
    }
    const double core_m = separation.distance_m + facing.round_m;
    facing.put_nearest({separation.on_a, separation.on_b, core_m}, core_m, reach_m, contact);
    return contact;
}

std::optional<ConvexPair> contact_of(const PlacedConvex& a, const PlacedConvex& b, double reach_m) {
    ConvexPair found;
    switch (by_faces(a, b, reach_m, found)) {
        case Verdict::Apart:
            return std::nullopt;
        case Verdict::Found:
            return found;
        case Verdict::Unknown:
            break;
    }
    const std::optional<Separation> separation = separation_of(a, b, reach_m);
    if (!separation) return std::nullopt;
    return ConvexPair{*separation, contact_along(a, b, *separation, reach_m)};
}

}  // namespace plumbline::physics
