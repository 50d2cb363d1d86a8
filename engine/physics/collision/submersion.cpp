#include "engine/physics/collision/submersion.h"

#include "engine/physics/collision/shape/hull_geometry.h"
#include "engine/physics/collision/silhouette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace plumbline::physics {
namespace {

constexpr double kPi_rad = 3.14159265358979323846;
/// The sine of a lean that is none.
constexpr double kUpright = 1e-7;
/// Sides of a round shape where areas are asked for.
constexpr int kSides = 24;
/// Gauss and Legendre's places and weights for -1 to 1, the positive half.
constexpr std::array<std::array<double, 2>, 8> kGauss16{{{0.0950125098376374, 0.1894506104550685},
                                                         {0.2816035507792589, 0.1826034150449236},
                                                         {0.4580167776572274, 0.1691565193950025},
                                                         {0.6178762444026438, 0.1495959888165767},
                                                         {0.7554044083550030, 0.1246289712555339},
                                                         {0.8656312023878318, 0.0951585116824928},
                                                         {0.9445750230732326, 0.0622535239386479},
                                                         {0.9894009349916499, 0.0271524594117541}}};

/// A shape's frame as seen from the level: heights are above it.
struct Placed {
    Vec3d center_m;
    glm::dmat3 axes;  ///< columns, unit

    Vec3d at(const Vec3d& local) const { return center_m + axes * local; }
};

/// Sums over what lies below height 0.
struct Below {
    double volume_m3{0};
    Vec3d moment{0, 0, 0};   ///< m4: volume times centre
    Vec3d open_m2{0, 0, 0};  ///< vector area of the surface below
    double facing_m2{0};     ///< of the same surface, along the direction, either way round

    /// A triangle of the surface, counter-clockwise from outside. Its tetrahedron's tip is in the level, so the cut needs no lid.
    void add(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& direction) {
        const Vec3d area = glm::cross(b - a, c - a) * 0.5;
        const double volume = glm::dot(a, glm::cross(b, c)) / 6;
        volume_m3 += volume;
        moment += (a + b + c) * (volume / 4);
        open_m2 += area;
        facing_m2 += std::abs(glm::dot(area, direction));
    }
    void add_cut(std::array<Vec3d, 3> corners, const Vec3d& direction) {
        const auto below = [](const Vec3d& v) { return v.y <= 0; };
        const auto count = std::ranges::count_if(corners, below);
        if (count == 0) return;
        if (count == 3) return add(corners[0], corners[1], corners[2], direction);
        // The one that stands alone comes first.
        while (below(corners[0]) != (count == 1) || below(corners[1]) == (count == 1) ||
               below(corners[2]) == (count == 1))
            corners = {corners[1], corners[2], corners[0]};
        const auto crossing = [](const Vec3d& from, const Vec3d& to) {
            return from + (to - from) * (from.y / (from.y - to.y));
        };
        const Vec3d ab = crossing(corners[0], corners[1]);
        const Vec3d ac = crossing(corners[0], corners[2]);
        if (count == 1) return add(corners[0], ab, ac, direction);
        add(ab, corners[1], corners[2], direction);
        add(ab, corners[2], ac, direction);
    }
};

void add_polygon(Below& below, std::span<const Vec3d> corners, const Vec3d& direction) {
    for (std::size_t i = 2; i < corners.size(); ++i)
        below.add_cut({corners[0], corners[i - 1], corners[i]}, direction);
}

void add_box(Below& below, const Placed& placed, const Vec3d& half, const Vec3d& direction) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            std::array<Vec3d, 4> corners;
            for (int i = 0; i < 4; ++i) {
                Vec3d corner = half;
                const int u = (axis + 1) % 3;
                const int v = (axis + 2) % 3;
                corner[axis] *= side;
                corner[u] *= (i == 1 || i == 2 ? 1.0 : -1.0);
                corner[v] *= (i >= 2 ? 1.0 : -1.0) * side;
                corners[static_cast<std::size_t>(i)] = placed.at(corner);
            }
            add_polygon(below, corners, direction);
        }
    }
}

void add_hull(Below& below,
              const Placed& placed,
              const HullGeometry& hull,
              const Vec3d& direction) {
    std::vector<Vec3d> corners;
    for (const HullFace& face : hull.faces) {
        corners.clear();
        for (const std::uint32_t corner : hull.corners_of(face))
            corners.push_back(placed.at(hull.corners_m[corner]));
        add_polygon(below, corners, direction);
    }
}

// --- round shapes: discs of radius(s) along the axis

/// One piece of a profile: discs from `from` to `to` along the axis whose radius^2 is r0 + r1 s + r2 s^2.
struct Profile {
    double from{0};
    double to{0};
    std::array<double, 3> radius2{};

    double radius_at(double s) const {
        return std::sqrt(std::max(radius2[0] + s * (radius2[1] + s * radius2[2]), 0.0));
    }
};

std::vector<Profile> profiles_of(const ConvexShape& shape) {
    const auto r = static_cast<double>(shape.radius_m);
    const auto half = static_cast<double>(shape.half_height_m);
    const Profile side{-half, half, {r * r, 0, 0}};
    if (shape.kind == ConvexShape::Kind::Cylinder) return {side};
    if (shape.kind == ConvexShape::Kind::Cone) {
        const double slope = r / (2 * half);  // radius = slope (half - s)
        return {
            {-half, half, {slope * slope * half * half, -2 * slope * slope * half, slope * slope}}};
    }
    const double c = r * r - half * half;
    if (shape.kind == ConvexShape::Kind::Sphere) return {{-r, r, {r * r, 0, -1}}};
    return {{-half - r, -half, {c, -2 * half, -1}}, side, {half, half + r, {c, 2 * half, -1}}};
}

/// The segment of a disc below a chord: `height` is that of the disc's middle above the water along its steepest line.
/// Area, and how far its centroid lies down that line from the middle.
struct Segment {
    double area_m2{0};
    double moment_m3{0};
};

Segment segment_below(double radius, double height) {
    if (radius <= 0 || height >= radius) return {};
    if (height <= -radius) return {kPi_rad * radius * radius, 0};
    const double chord = std::sqrt(radius * radius - height * height);
    return {radius * radius * portable_acos(height / radius) - height * chord,
            2.0 / 3.0 * chord * chord * chord};
}

/// Places along the axis where the water begins or ceases to cut the discs: (height + slope s)^2 = radius^2, about the place
/// where the water cuts the axis, if it does so steeply: there the discs' height is all that decides.
void add_breaks(const Profile& profile, double slope, double height, std::vector<double>& breaks) {
    const double base = std::abs(slope) > 1 ? -height / slope : 0;
    const double there = height + slope * base;
    const auto& [r0, r1, r2] = profile.radius2;
    const double a = slope * slope - r2;
    const double b = 2 * slope * there - (r1 + 2 * r2 * base);
    const double c = there * there - (r0 + base * (r1 + base * r2));
    const double root = b * b - 4 * a * c;
    const auto keep = [&](double s) {
        if (s > profile.from && s < profile.to) breaks.push_back(s);
    };
    if (std::abs(a) < 1e-12) {
        if (std::abs(b) > 1e-12) keep(base - c / b);
    } else if (root >= 0) {
        keep(base + (-b - std::sqrt(root)) / (2 * a));
        keep(base + (-b + std::sqrt(root)) / (2 * a));
    }
}

/// The discs between two such places.
void add_discs(Below& below, const Placed& placed, const Profile& profile, double from, double to) {
    const Vec3d axis = placed.axes[1];
    const double lean = std::sqrt(std::max(1 - axis.y * axis.y, 0.0));
    // Down the discs' steepest line, in their plane.
    const Vec3d down = lean > kUpright ? (axis * axis.y - Vec3d{0, 1, 0}) / lean : Vec3d{0, 0, 0};
    const double half = (to - from) / 2;
    const auto add = [&](double s, double weight) {
        const Vec3d center = placed.center_m + axis * s;
        const Segment segment =
            segment_below(profile.radius_at(s), center.y / std::max(lean, kUpright));
        below.volume_m3 += weight * segment.area_m2;
        below.moment += (center * segment.area_m2 + down * segment.moment_m3) * weight;
    };
    for (const auto& [place, weight] : kGauss16) {
        add((from + to) / 2 - half * place, weight * half);
        add((from + to) / 2 + half * place, weight * half);
    }
}

void add_round(Below& below, const Placed& placed, const ConvexShape& shape) {
    const double up = placed.axes[1].y;
    const double steep = std::max(std::sqrt(std::max(1 - up * up, 0.0)), kUpright);
    for (const Profile& profile : profiles_of(shape)) {
        std::vector<double> breaks{profile.from, profile.to};
        add_breaks(profile, up / steep, placed.center_m.y / steep, breaks);
        std::ranges::sort(breaks);
        for (std::size_t i = 1; i < breaks.size(); ++i)
            add_discs(below, placed, profile, breaks[i - 1], breaks[i]);
    }
}

/// What is under looks from above like its widest disc and from the side like a segment; in between, like an ellipse of them.
void add_sphere(Below& below, const Placed& placed, double r, const Vec3d& direction) {
    const double height = placed.center_m.y;
    const double h = std::clamp(r - height, 0.0, 2 * r);  // of the cap below
    if (h == 0) return;
    const double volume = kPi_rad * h * h * (3 * r - h) / 3;
    below.volume_m3 += volume;
    below.moment +=
        volume * (placed.center_m - Vec3d{0, 3 * (2 * r - h) * (2 * r - h) / (4 * (3 * r - h)), 0});
    const double cut_m2 = kPi_rad * std::max(r * r - height * height, 0.0);
    const double above_m2 = height < 0 ? kPi_rad * r * r : cut_m2;
    const double aside_m2 = segment_below(r, height).area_m2;
    const glm::dvec2 seen{above_m2 * direction.y,
                          aside_m2 * std::sqrt(std::max(1 - direction.y * direction.y, 0.0))};
    below.open_m2 += Vec3d{0, -cut_m2, 0};
    below.facing_m2 += 2 * glm::length(seen) - cut_m2 * std::abs(direction.y);
}

/// The surface of a round shape as facets: for areas only.
Below round_surface(const Placed& placed, const ConvexShape& shape, const Vec3d& direction) {
    // As large as the circle that a ring stands for.
    const double step_rad = 2 * kPi_rad / kSides;
    const double wider = std::sqrt(step_rad / portable_sin(step_rad));
    std::vector<std::array<double, 2>> rings;  // height along the axis and radius
    for (const Profile& profile : profiles_of(shape)) {
        const int steps = profile.radius2[2] < 0 ? 12 : 1;
        for (int i = 0; i <= steps; ++i) {
            // Closer together towards the poles.
            const double share = 0.5 - 0.5 * portable_cos(kPi_rad * i / steps);
            const double s = profile.from + (profile.to - profile.from) * share;
            rings.push_back({s, profile.radius_at(s) * wider});
        }
    }
    const auto at = [&](const std::array<double, 2>& ring, int side) {
        const double angle = 2 * kPi_rad * side / kSides;
        return placed.at({ring[1] * portable_cos(angle), ring[0], ring[1] * portable_sin(angle)});
    };
    Below surface;
    for (int side = 0; side < kSides; ++side) {
        for (std::size_t i = 1; i < rings.size(); ++i) {
            const std::array<Vec3d, 4> corners{at(rings[i - 1], side),
                                               at(rings[i], side),
                                               at(rings[i], side + 1),
                                               at(rings[i - 1], side + 1)};
            add_polygon(surface, corners, direction);
        }
        const Vec3d bottom = placed.at({0, rings.front()[0], 0});
        const Vec3d top = placed.at({0, rings.back()[0], 0});
        surface.add_cut({bottom, at(rings.front(), side), at(rings.front(), side + 1)}, direction);
        surface.add_cut({top, at(rings.back(), side + 1), at(rings.back(), side)}, direction);
    }
    return surface;
}

double volume_m3(const ConvexShape& shape) {
    const auto r = static_cast<double>(shape.radius_m);
    const double height = 2 * static_cast<double>(shape.half_height_m);
    const double disc = kPi_rad * r * r;
    const double ball = 4.0 / 3.0 * disc * r;
    switch (shape.kind) {
        case ConvexShape::Kind::Sphere:
            return ball;
        case ConvexShape::Kind::Capsule:
            return ball + disc * height;
        case ConvexShape::Kind::Cylinder:
            return disc * height;
        case ConvexShape::Kind::Cone:
            return disc * height / 3;
        case ConvexShape::Kind::Box: {
            const Vec3d half(shape.half_m);
            return 8 * half.x * half.y * half.z;
        }
        case ConvexShape::Kind::Hull: {
            double reach_m = 0;
            for (const Vec3d& corner : shape.hull->corners_m)
                reach_m = std::max(reach_m, glm::length(corner));
            Below whole;
            add_hull(whole, {{0, -reach_m, 0}, glm::dmat3(1.0)}, *shape.hull, {0, 1, 0});
            return whole.volume_m3;
        }
        case ConvexShape::Kind::None:
            break;
    }
    return 0;
}

/// How high above the level the shape reaches. Hulls are not asked.
double top_m(const ConvexShape& shape, const Placed& placed) {
    const auto r = static_cast<double>(shape.radius_m);
    const double up = placed.axes[1].y;
    const double across = std::sqrt(std::max(1 - up * up, 0.0));
    const double half = static_cast<double>(shape.half_height_m) * std::abs(up);
    switch (shape.kind) {
        case ConvexShape::Kind::Sphere:
            return placed.center_m.y + r;
        case ConvexShape::Kind::Capsule:
            return placed.center_m.y + half + r;
        case ConvexShape::Kind::Cylinder:
            return placed.center_m.y + half + r * across;
        case ConvexShape::Kind::Cone:
            return placed.center_m.y +
                   std::max(half * (up > 0 ? 1 : -1), half * (up > 0 ? -1 : 1) + r * across);
        default:
            return HUGE_VAL;
    }
}

/// All of a round shape.
Below whole_below(const ConvexShape& shape, const Placed& placed, double whole_m3) {
    const double to_centroid_m =
        shape.kind == ConvexShape::Kind::Cone ? -static_cast<double>(shape.half_height_m) / 2 : 0;
    return {.volume_m3 = whole_m3,
            .moment = whole_m3 * (placed.center_m + placed.axes[1] * to_centroid_m)};
}

Below part_below(const ConvexShape& shape, const Placed& placed, const Vec3d& direction) {
    Below below;
    switch (shape.kind) {
        case ConvexShape::Kind::None:
            return below;
        case ConvexShape::Kind::Box:
            add_box(below, placed, Vec3d(shape.half_m), direction);
            break;
        case ConvexShape::Kind::Hull:
            add_hull(below, placed, *shape.hull, direction);
            break;
        case ConvexShape::Kind::Sphere:
            add_sphere(below, placed, static_cast<double>(shape.radius_m), direction);
            break;
        default: {
            const Below surface = round_surface(placed, shape, direction);
            below.open_m2 = surface.open_m2;
            below.facing_m2 = surface.facing_m2;
            add_round(below, placed, shape);
        }
    }
    return below;
}

}  // namespace

Submersion submersion(const BodyGeometry& geometry,
                      const Vec3d& center_m,
                      const Quatd& world_from_mass,
                      double level_m,
                      const Vec3d& direction) {
    const glm::dmat3 axes = glm::mat3_cast(world_from_mass);
    // Near the body: what is far from the origin keeps its digits.
    const Vec3d origin{center_m.x, level_m, center_m.z};
    Submersion sum;
    Vec3d moment{0, 0, 0};
    for (const GeometryPart& part : geometry.parts) {
        const Placed placed{center_m - origin + axes * Vec3d(part.mass_from_part.position_m),
                            axes * glm::dmat3(part.mass_from_part.rotation)};
        const double whole_m3 = volume_m3(part.shape);
        const Below below = top_m(part.shape, placed) <= 0
                                ? whole_below(part.shape, placed, whole_m3)
                                : part_below(part.shape, placed, direction);
        sum.whole_m3 += whole_m3;
        sum.volume_m3 += below.volume_m3;
        moment += below.moment;
        const bool is_under = below.volume_m3 > whole_m3 * (1 - 1e-6);
        if (is_under) {
            sum.silhouette_m2 +=
                physics::silhouette_m2(part.shape, glm::transpose(placed.axes) * direction);
            continue;
        }
        sum.waterline_m2 += glm::length(below.open_m2);
        sum.silhouette_m2 += (below.facing_m2 + std::abs(glm::dot(below.open_m2, direction))) / 2;
    }
    if (sum.volume_m3 > 0) sum.center_m = origin + moment / sum.volume_m3;
    return sum;
}

}  // namespace plumbline::physics
