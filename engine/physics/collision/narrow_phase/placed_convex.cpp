#include "engine/physics/collision/narrow_phase/placed_convex.h"

#include "engine/physics/collision/shape/hull_geometry.h"
#include "engine/physics/transform.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::physics {
namespace {

using Kind = ConvexShape::Kind;

/// Hulls with more corners are climbed from neighbour to neighbour.
constexpr std::size_t kFewCorners = 24;
/// A disc has four places on its rim that are fixed on the body, so that they stay where they are while what it carries
/// presses it this way and that; where it leans by more than this, rad, its lowest point is a fifth.
constexpr double kLevelDisc = 0.005;
constexpr double kBetweenPlaces = 0.293;  ///< 1 - cos(pi / 4)

Vec3d in_shape(const PlacedConvex& convex, const Vec3d& v) {
    return {glm::dot(convex.axes[0], v), glm::dot(convex.axes[1], v), glm::dot(convex.axes[2], v)};
}

/// The unit vector from the axis towards `direction` (in the shape's frame); 0 along the axis itself.
Vec3d radial(const Vec3d& direction) {
    const double length = std::sqrt(direction.x * direction.x + direction.z * direction.z);
    if (!(length > 1e-12 * std::abs(direction.y))) return {0, 0, 0};
    return {direction.x / length, 0, direction.z / length};
}

std::uint32_t support_corner(const HullGeometry& hull, const Vec3d& direction) {
    const std::vector<Vec3d>& corners = hull.corners_m;
    std::uint32_t best = 0;
    double most = glm::dot(corners[0], direction);
    if (corners.size() <= kFewCorners) {
        for (std::uint32_t i = 1; i < corners.size(); ++i) {
            const double along = glm::dot(corners[i], direction);
            if (along > most) {
                most = along;
                best = i;
            }
        }
        return best;
    }
    for (bool climbs = true; climbs;) {
        climbs = false;
        const std::uint32_t here = best;
        for (std::uint32_t i = hull.first_neighbour[here]; i < hull.first_neighbour[here + 1];
             ++i) {
            const double along = glm::dot(corners[hull.neighbours[i]], direction);
            if (along <= most) continue;
            most = along;
            best = hull.neighbours[i];
            climbs = true;
        }
    }
    return best;
}

/// In the shape's own frame.
Vec3d local_support(const ConvexShape& shape, const Vec3d& direction) {
    const auto radius = static_cast<double>(shape.radius_m);
    const auto half = static_cast<double>(shape.half_height_m);
    switch (shape.kind) {
        case Kind::Box: {
            const Vec3d size{shape.half_m};
            return {std::copysign(size.x, direction.x),
                    std::copysign(size.y, direction.y),
                    std::copysign(size.z, direction.z)};
        }
        case Kind::Capsule:
            return {0, std::copysign(half, direction.y), 0};
        case Kind::Cylinder:
            return radial(direction) * radius + Vec3d{0, std::copysign(half, direction.y), 0};
        case Kind::Cone: {
            const Vec3d rim = radial(direction) * radius + Vec3d{0, -half, 0};
            const Vec3d apex{0, half, 0};
            return glm::dot(apex, direction) > glm::dot(rim, direction) ? apex : rim;
        }
        case Kind::Hull:
            return shape.hull->corners_m[support_corner(*shape.hull, direction)];
        case Kind::Sphere:
        case Kind::None:
            break;
    }
    return {0, 0, 0};
}

const HullFace& face_of_hull(const HullGeometry& hull, const Vec3d& direction) {
    const HullFace* best = &hull.faces.front();
    double most = glm::dot(best->normal, direction);
    for (const HullFace& face : hull.faces) {
        const double along = glm::dot(face.normal, direction);
        if (along <= most) continue;
        most = along;
        best = &face;
    }
    return *best;
}

/// Over whose plane the point lies highest.
const HullFace& face_of_hull_under(const HullGeometry& hull, const Vec3d& point) {
    const HullFace* best = &hull.faces.front();
    double most = std::numeric_limits<double>::lowest();
    for (const HullFace& face : hull.faces) {
        const double height = glm::dot(face.normal, point) - face.offset_m;
        if (height <= most) continue;
        most = height;
        best = &face;
    }
    return *best;
}

int longest_axis(const Vec3d& v) {
    const Vec3d size = magnitudes_of(v);
    int axis = 0;
    if (size.y > size[axis]) axis = 1;
    if (size.z > size[axis]) axis = 2;
    return axis;
}

/// Places features of one shape into the frame of the call.
class Placer {
public:
    Placer(const PlacedConvex& convex, Feature& feature) : convex_(convex), feature_(feature) {
        feature.count = 0;
    }

    void point(const Vec3d& local) {
        feature_.kind = Feature::Kind::Point;
        add(local);
    }
    void segment(const Vec3d& from, const Vec3d& to) {
        feature_.kind = Feature::Kind::Segment;
        add(from);
        add(to);
    }
    void box_face(const Vec3d& half, const Vec3d& direction) {
        const int k = longest_axis(direction);
        const int u = (k + 1) % 3;
        const int v = (k + 2) % 3;
        const double side = direction[k] < 0 ? -1 : 1;
        Vec3d corner{0, 0, 0};
        corner[k] = side * half[k];
        start_polygon(unit(k) * side);
        constexpr std::array<std::array<double, 2>, 4> kRound{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
        for (const auto& [along_u, along_v] : kRound) {
            corner[u] = along_u * half[u];
            corner[v] = along_v * half[v] * side;
            add(corner);
        }
    }
    void hull_face(const HullGeometry& hull, const HullFace& face) {
        start_polygon(face.normal);
        for (const std::uint32_t corner : hull.corners_of(face)) add(hull.corners_m[corner]);
    }
    /// `direction`: the one that asks, whose leaning over the disc says which place on the rim is lowest.
    void disc(double height, double side, double radius, const Vec3d& direction) {
        feature_.kind = Feature::Kind::Disc;
        feature_.normal = convex_.axes[1] * side;
        feature_.center_m = convex_.center_m + convex_.axes[1] * height;
        feature_.radius_m = radius;
        for (const Vec3d& out : {Vec3d{1, 0, 0}, Vec3d{0, 0, 1}, Vec3d{-1, 0, 0}, Vec3d{0, 0, -1}})
            add(out * radius + Vec3d{0, height, 0});
        const double lean = std::sqrt(direction.x * direction.x + direction.z * direction.z);
        if (lean > kLevelDisc)
            add(radial(direction) * radius + Vec3d{0, height, 0});
        else
            feature_.between_m = kBetweenPlaces * lean * radius;
    }

private:
    static Vec3d unit(int axis) {
        Vec3d v{0, 0, 0};
        v[axis] = 1;
        return v;
    }
    void start_polygon(const Vec3d& normal) {
        feature_.kind = Feature::Kind::Polygon;
        feature_.normal = convex_.axes * normal;
    }
    void add(const Vec3d& local) { feature_.add(convex_.center_m + convex_.axes * local); }

    const PlacedConvex& convex_;
    Feature& feature_;
};

/// Where a cone's side faces most along the direction: unit, in the shape's frame.
Vec3d side_normal_of_cone(const ConvexShape& cone, const Vec3d& direction) {
    const auto radius = static_cast<double>(cone.radius_m);
    const double height = 2 * static_cast<double>(cone.half_height_m);
    return glm::normalize(radial(direction) * height + Vec3d{0, radius, 0});
}

bool looks_along_axis(const Vec3d& direction) {
    constexpr double kHalfRoot = 0.7071;
    return std::abs(direction.y) > kHalfRoot;
}

void find_triangle_feature(const PlacedConvex& convex, const Vec3d& direction, Feature& feature) {
    const auto& [a, b, c] = convex.triangle;
    const Vec3d across = glm::cross(b - a, c - a);
    const double length = glm::length(across);
    feature.count = 0;
    if (!(length > 0)) {
        feature.kind = Feature::Kind::Point;
        feature.add(support(convex, direction));
        return;
    }
    const bool front = glm::dot(across, direction) >= 0;
    feature.kind = Feature::Kind::Polygon;
    feature.normal = across * ((front ? 1 : -1) / length);
    feature.add(a);
    feature.add(front ? b : c);
    feature.add(front ? c : b);
}

/// The plane across one of the shape's axes, on the side of the axis that has `side`'s sign.
FacePlane plane_across(const PlacedConvex& convex, int axis, double side, double half_m) {
    const Vec3d normal = glm::normalize(convex.axes[axis]) * (side < 0 ? -1.0 : 1.0);
    return {
        .normal = normal, .offset_m = glm::dot(normal, convex.center_m) + half_m, .exists = true};
}

FacePlane hull_plane(const PlacedConvex& convex, const HullFace& face) {
    const Vec3d normal = glm::normalize(convex.axes * face.normal);
    return {.normal = normal,
            .offset_m = glm::dot(normal, convex.center_m) + face.offset_m,
            .exists = true};
}

FacePlane triangle_plane(const PlacedConvex& convex, const Vec3d& direction) {
    const auto& [a, b, c] = convex.triangle;
    Vec3d normal = glm::cross(b - a, c - a);
    const double length = glm::length(normal);
    if (!(length > 0)) return {};
    normal *= (glm::dot(normal, direction) < 0 ? -1 : 1) / length;
    return {.normal = normal, .offset_m = glm::dot(normal, a), .exists = true};
}

}  // namespace

PlacedConvex placed_convex(const PlacedShape& placed, const Vec3d& origin_world) {
    const ConvexShape& shape = placed.shape;
    const bool swollen = shape.kind == Kind::Sphere || shape.kind == Kind::Capsule;
    return {.shape = &shape,
            .axes = glm::dmat3(placed.world_from_shape.rotation),
            .center_m = Vec3d(placed.world_from_shape.position_m) - origin_world,
            .radius_m = swollen ? static_cast<double>(shape.radius_m) : 0.0};
}

PlacedConvex placed_triangle(const std::array<Vec3d, 3>& corners_m) {
    return {.center_m = (corners_m[0] + corners_m[1] + corners_m[2]) / 3.0, .triangle = corners_m};
}

Vec3d support(const PlacedConvex& convex, const Vec3d& direction) {
    if (convex.shape == nullptr) {
        const auto& [a, b, c] = convex.triangle;
        const Vec3d along{glm::dot(a, direction), glm::dot(b, direction), glm::dot(c, direction)};
        if (along.x >= along.y && along.x >= along.z) return a;
        return along.y >= along.z ? b : c;
    }
    return convex.center_m +
           convex.axes * local_support(*convex.shape, in_shape(convex, direction));
}

void find_feature(const PlacedConvex& convex, const Vec3d& direction, Feature& feature) {
    if (convex.shape == nullptr) return find_triangle_feature(convex, direction, feature);
    const ConvexShape& shape = *convex.shape;
    const Vec3d local = in_shape(convex, direction);
    const auto radius = static_cast<double>(shape.radius_m);
    const auto half = static_cast<double>(shape.half_height_m);
    Placer placer(convex, feature);
    switch (shape.kind) {
        case Kind::Box:
            return placer.box_face(Vec3d{shape.half_m}, local);
        case Kind::Hull:
            return placer.hull_face(*shape.hull, face_of_hull(*shape.hull, local));
        case Kind::Capsule:
            return placer.segment({0, -half, 0}, {0, half, 0});
        case Kind::Cylinder: {
            if (looks_along_axis(local)) {
                const double side = local.y < 0 ? -1 : 1;
                return placer.disc(side * half, side, radius, local);
            }
            const Vec3d out = radial(local) * radius;
            return placer.segment(out - Vec3d{0, half, 0}, out + Vec3d{0, half, 0});
        }
        case Kind::Cone: {
            if (-local.y > glm::dot(side_normal_of_cone(shape, local), local))
                return placer.disc(-half, -1, radius, local);
            const Vec3d out = radial(local);
            if (out == Vec3d{0, 0, 0}) return placer.point({0, half, 0});
            return placer.segment(out * radius - Vec3d{0, half, 0}, {0, half, 0});
        }
        case Kind::Sphere:
        case Kind::None:
            break;
    }
    placer.point({0, 0, 0});
}

double separation_along(const PlacedConvex& a, const PlacedConvex& b, const Vec3d& direction) {
    return glm::dot(support(a, -direction) - support(b, direction), direction) - a.radius_m -
           b.radius_m;
}

FacePlane face_along(const PlacedConvex& convex, const Vec3d& direction) {
    if (convex.shape == nullptr) return triangle_plane(convex, direction);
    const ConvexShape& shape = *convex.shape;
    const Vec3d local = in_shape(convex, direction);
    switch (shape.kind) {
        case Kind::Box: {
            const int k = longest_axis(local);
            return plane_across(convex, k, local[k], static_cast<double>(shape.half_m[k]));
        }
        case Kind::Hull:
            return hull_plane(convex, face_of_hull(*shape.hull, local));
        case Kind::Cylinder:
            if (!looks_along_axis(local)) return {};
            return plane_across(convex, 1, local.y, static_cast<double>(shape.half_height_m));
        case Kind::Cone:
            if (local.y >= 0) return {};
            return plane_across(convex, 1, -1, static_cast<double>(shape.half_height_m));
        case Kind::Sphere:
        case Kind::Capsule:
        case Kind::None:
            break;
    }
    return {};
}

FacePlane face_under(const PlacedConvex& convex, const Vec3d& point) {
    if (convex.shape == nullptr) return triangle_plane(convex, point - convex.center_m);
    const ConvexShape& shape = *convex.shape;
    const Vec3d local = in_shape(convex, point - convex.center_m);
    const auto radius = static_cast<double>(shape.radius_m);
    const auto half = static_cast<double>(shape.half_height_m);
    const double ring = std::sqrt(local.x * local.x + local.z * local.z);
    switch (shape.kind) {
        case Kind::Box: {
            const Vec3d size{shape.half_m};
            const Vec3d height = magnitudes_of(local) - size;
            int k = height.y > height.x ? 1 : 0;
            if (height.z > height[k]) k = 2;
            return plane_across(convex, k, local[k], size[k]);
        }
        case Kind::Hull:
            return hull_plane(convex, face_of_hull_under(*shape.hull, local));
        case Kind::Cylinder:
            if (std::abs(local.y) - half < ring - radius) return {};
            return plane_across(convex, 1, local.y, half);
        case Kind::Cone:
            if (-local.y - half < ring - radius) return {};
            return plane_across(convex, 1, -1, half);
        case Kind::Sphere:
        case Kind::Capsule:
        case Kind::None:
            break;
    }
    return {};
}

double size_of(const PlacedConvex& convex) {
    if (convex.shape == nullptr) {
        const auto& [a, b, c] = convex.triangle;
        return std::min({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
    }
    const ConvexShape& shape = *convex.shape;
    const auto radius = static_cast<double>(shape.radius_m);
    const auto half = static_cast<double>(shape.half_height_m);
    switch (shape.kind) {
        case Kind::Box: {
            const Vec3d size{shape.half_m};
            return 2 * std::min({size.x, size.y, size.z});
        }
        case Kind::Hull:
            return shape.hull->width_m;
        case Kind::Cylinder:
        case Kind::Cone:
            return 2 * std::min(radius, half);
        case Kind::Sphere:
        case Kind::Capsule:
        case Kind::None:
            break;
    }
    return 2 * radius;
}

}  // namespace plumbline::physics
