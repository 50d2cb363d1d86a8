#include "engine/physics/collision/mesh/triangle_contact.h"

#include "engine/physics/collision/mesh/face_clip.h"
#include "engine/physics/collision/mesh/triangle_distance.h"
#include "engine/physics/collision/narrow_phase/convex_convex.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::physics {
namespace {

/// Of the shape's inner radius: a centre that is no deeper behind a triangle has sunk in from its front.
constexpr double kSunk = 0.5;
/// Cosine of the angle between faces that look another way.
constexpr double kOtherWay = 0.5;
/// Normals this near, squared, see the same of the shape.
constexpr double kSameAspect2 = 1e-20;
/// Of the shape's size: as near the lowest point the points over a face must come.
constexpr double kNearest = 1e-4;
/// An edge or a side of a triangle this much across a normal, rad, lies in the normal's plane.
constexpr double kLies_rad = 1e-3;
/// Triangles may rise this much over a normal's plane, rad, and it still is the outermost there.
constexpr double kRises_rad = 2e-3;
/// A face whose normal is more than this along another's does not face it.
constexpr double kFacing = -0.5;
/// Of an edge: its ends, where other edges begin.
constexpr double kEnd = 1e-3;
/// Of both sizes: features this near cover each other.
constexpr double kTouchingShare = 1e-4;
/// Over an edge that counts as flat and still sticks out a centre is above neither face by up to this, rad.
constexpr double kWedge_rad = 1.5 * kFlatEdge_rad;
/// Cosine of the angle between normals of one face.
constexpr double kSameFaceNormal = 0.9998;
/// Points that most bodies have less of.
constexpr std::size_t kUsual = 32;

constexpr double kFarAway_m = std::numeric_limits<double>::max();

std::size_t after(std::size_t corner) {
    return corner == 2 ? 0 : corner + 1;
}

Feature triangle_feature(const std::array<Vec3d, 3>& corners, const Vec3d& normal) {
    Feature feature;
    feature.kind = Feature::Kind::Polygon;
    feature.normal = normal;
    for (const Vec3d& corner : corners) feature.add(corner);
    return feature;
}

}  // namespace

TriangleContacts::TriangleContacts(const PlacedConvex& convex,
                                   const PlacedMesh& mesh,
                                   double reach_m)
    : convex_(convex), mesh_(mesh), reach_m_(reach_m), size_m_(size_of(convex)) {
    points_.reserve(kUsual);
}

void TriangleContacts::add(std::uint32_t triangle) {
    const Side side = side_of(triangle);
    if (convex_.shape->kind == ConvexShape::Kind::Sphere) return add_sphere(side);
    look_along(side.normal);
    if (aspect_.lowest_m - side.offset_m > reach_m_) return;
    const Cover cover = cover_of(side);
    if (cover == Cover::Whole && side.is_seam[0] && side.is_seam[1] && side.is_seam[2])
        return add_inner(side);
    const std::size_t first = points_.size();
    const double face_m = cover == Cover::None ? kFarAway_m : add_face(side);
    if (face_m <= aspect_.lowest_m - side.offset_m + kNearest * size_m_) return;
    if (side.sticks_out[0] || side.sticks_out[1] || side.sticks_out[2]) add_edge(side, first);
}

TriangleContacts::Side TriangleContacts::side_of(std::uint32_t triangle) const {
    const MeshTriangle& kinds = mesh_.mesh.triangles[triangle];
    Side side{.index = triangle, .corners = mesh_.corners_m(triangle)};
    const auto& [a, b, c] = side.corners;
    side.normal = glm::normalize(glm::cross(b - a, c - a));
    side.offset_m = glm::dot(a, side.normal);
    // The centre is the origin.
    const double sunk_m = kinds.has_two_fronts ? 0.0 : kSunk * size_m_ / 2;
    const bool behind = side.offset_m > sunk_m;
    const EdgeKind outward = behind ? EdgeKind::Concave : EdgeKind::Convex;
    for (std::size_t i = 0; i < 3; ++i) {
        // Seen from behind the corners go round the other way.
        const EdgeKind kind = kinds.edges[behind ? 2 - i : i];
        side.sticks_out[i] = kind == EdgeKind::Rim || kind == outward;
        side.is_seam[i] = kind == EdgeKind::Flat;
    }
    if (!behind) return side;
    side.is_behind = true;
    std::swap(side.corners[1], side.corners[2]);
    side.normal = -side.normal;
    side.offset_m = -side.offset_m;
    return side;
}

void TriangleContacts::look_along(const Vec3d& normal) {
    const Vec3d away = normal - aspect_.normal;
    if (glm::dot(away, away) < kSameAspect2) return;
    aspect_.normal = normal;
    aspect_.lowest = support(convex_, -normal);
    aspect_.lowest_m = glm::dot(aspect_.lowest, normal) - convex_.radius_m;
    Feature& feature = aspect_.feature;
    find_feature(convex_, -normal, feature);
    if (feature.kind != Feature::Kind::Polygon) return;
    for (std::size_t i = 0; i < feature.count; ++i) {
        const Vec3d along = feature.corners[(i + 1) % feature.count] - feature.corners[i];
        // Its corners go round its own normal, which is against ours.
        aspect_.outward[i] = glm::cross(normal, along);
        aspect_.touching[i] = kTouchingShare * size_m_ * glm::length(along);
    }
}

/// How the shape's lowest face and the triangle lie over each other.
TriangleContacts::Cover TriangleContacts::cover_of(const Side& side) const {
    const Feature& feature = aspect_.feature;
    const double steepness = glm::dot(feature.normal, side.normal);
    Cover cover = Cover::Whole;
    if (feature.kind == Feature::Kind::Polygon) {
        if (!(steepness < kFacing)) return Cover::Part;
        for (std::size_t i = 0; i < feature.count; ++i) {
            std::array<double, 3> out{};
            for (std::size_t k = 0; k < 3; ++k)
                out[k] = glm::dot(side.corners[k] - feature.corners[i], aspect_.outward[i]);
            const auto [least, most] = std::minmax({out[0], out[1], out[2]});
            if (least > aspect_.touching[i]) return Cover::None;
            if (most >= 0) cover = Cover::Part;
        }
        return cover;
    }
    if (feature.kind != Feature::Kind::Disc || !(steepness < kFacing)) return Cover::Part;
    const bool whole = std::ranges::all_of(side.corners, [&](const Vec3d& corner) {
        const double up_m = glm::dot(feature.center_m - corner, feature.normal) / steepness;
        const Vec3d away = corner + side.normal * up_m - feature.center_m;
        return glm::dot(away, away) < feature.radius_m * feature.radius_m;
    });
    return whole ? Cover::Whole : Cover::Part;
}

/// Of the triangle's corners the deepest, if it is the deepest of the face too.
void TriangleContacts::add_inner(const Side& side) {
    const Feature& feature = aspect_.feature;
    const Vec3d& on_face =
        feature.kind == Feature::Kind::Disc ? feature.center_m : feature.corners[0];
    const double steepness = glm::dot(feature.normal, side.normal);
    MeshPoint deepest{.normal = side.normal,
                      .distance_m = kFarAway_m,
                      .triangle = side.index,
                      .kind = MeshPoint::Kind::Seam,
                      .is_behind = side.is_behind};
    for (const Vec3d& corner : side.corners) {
        const double distance_m = glm::dot(on_face - corner, feature.normal) / steepness;
        if (distance_m >= deepest.distance_m) continue;
        deepest.distance_m = distance_m;
        deepest.on_mesh = corner;
    }
    if (!(deepest.distance_m <= reach_m_)) return;
    keep_deepest(deepest);
}

/// One point inside each face says enough: its corners say the rest.
void TriangleContacts::keep_deepest(const MeshPoint& inside) {
    for (MeshPoint& known : inner_) {
        if (glm::dot(known.normal, inside.normal) < kSameFaceNormal) continue;
        if (inside.distance_m < known.distance_m) known = inside;
        return;
    }
    inner_.push_back(inside);
}

std::vector<MeshPoint>& TriangleContacts::points() {
    points_.insert(points_.end(), inner_.begin(), inner_.end());
    // What touches a front is not behind a face that looks the other way: beside a ridge the shape's centre is behind the
    // plane of the other slope all the same.
    std::vector<Vec3d> fronts;
    for (const MeshPoint& point : points_) {
        if (!point.is_behind && point.distance_m < kSunk * size_m_) fronts.push_back(point.normal);
    }
    std::erase_if(points_, [&fronts](const MeshPoint& point) {
        return point.is_behind && std::ranges::any_of(fronts, [&point](const Vec3d& front) {
                   return glm::dot(front, point.normal) < kOtherWay;
               });
    });
    return points_;
}

/// `core`: of the shape's core and the mesh.
void TriangleContacts::put(const Side& side,
                           const Vec3d& normal,
                           const RegionPoint& core,
                           MeshPoint::Kind kind) {
    const MeshPoint point{.normal = normal,
                          .on_mesh = core.on_b,
                          .distance_m = core.distance_m - convex_.radius_m,
                          .triangle = side.index,
                          .kind = kind,
                          .is_behind = side.is_behind};
    if (kind == MeshPoint::Kind::Seam) return keep_deepest(point);
    points_.push_back(point);
}

/// What of the shape's lowest feature lies over the triangle. Returns the least distance there.
double TriangleContacts::add_face(const Side& side) {
    double touching_m = size_m_;
    for (std::size_t i = 0; i < 3; ++i)
        touching_m = std::min(touching_m, glm::distance(side.corners[i], side.corners[after(i)]));
    touching_m = kTouchingShare * touching_m + kWedge_rad * convex_.radius_m;
    const Feature& feature = aspect_.feature;
    const double nearest_m = feature.kind == Feature::Kind::Disc ? add_disc(side, touching_m)
                                                                 : add_polygon(side, touching_m);
    const double lowest_m = aspect_.lowest_m - side.offset_m;
    if (nearest_m <= lowest_m + kNearest * size_m_) return nearest_m;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3d outward = glm::cross(side.corners[after(i)] - side.corners[i], side.normal);
        if (glm::dot(aspect_.lowest - side.corners[i], outward) > 0) return nearest_m;
    }
    put_over(side, aspect_.lowest, MeshPoint::Kind::Face);
    return lowest_m;
}

double TriangleContacts::add_polygon(const Side& side, double touching_m) {
    const Feature& feature = aspect_.feature;
    ClippedPolygon region;
    clip_to_triangle(
        {feature.corners.data(), feature.count}, side.corners, side.normal, touching_m, region);
    double nearest_m = kFarAway_m;
    for (std::size_t i = 0; i < region.count; ++i) {
        const double distance_m =
            glm::dot(region.corners[i], side.normal) - side.offset_m - convex_.radius_m;
        if (distance_m > reach_m_) continue;
        nearest_m = std::min(nearest_m, distance_m);
        bool on_seam = region.cuts[i] != 0;
        for (std::size_t edge = 0; edge < 3; ++edge)
            on_seam =
                on_seam && (side.is_seam[edge] || (unsigned{region.cuts[i]} >> edge & 1U) == 0);
        put_over(side, region.corners[i], on_seam ? MeshPoint::Kind::Seam : MeshPoint::Kind::Face);
    }
    return nearest_m;
}

double TriangleContacts::add_disc(const Side& side, double touching_m) {
    const ContactRegion region(aspect_.feature,
                               triangle_feature(side.corners, side.normal),
                               side.normal,
                               reach_m_ + convex_.radius_m,
                               touching_m);
    double nearest_m = kFarAway_m;
    for (const RegionPoint& point : region.points()) {
        const bool on_seam = is_on_seam(side, point);
        put_over(side, point.on_a, on_seam ? MeshPoint::Kind::Seam : MeshPoint::Kind::Face);
        nearest_m = std::min(nearest_m, point.distance_m - convex_.radius_m);
    }
    return nearest_m;
}

/// A point of the core and the one on the triangle's plane below it.
void TriangleContacts::put_over(const Side& side, const Vec3d& core, MeshPoint::Kind kind) {
    const double up_m = glm::dot(core, side.normal) - side.offset_m;
    put(side, side.normal, {core, core - side.normal * up_m, up_m}, kind);
}

/// Whether the point is there only because two triangles of one face meet there.
bool TriangleContacts::is_on_seam(const Side& side, const RegionPoint& point) const {
    const double near_m = kTouchingShare * size_m_;
    bool on_seam = false;
    for (std::size_t i = 0; i < 3; ++i) {
        const bool near =
            away_from_line2(point.on_b, side.corners[i], side.corners[after(i)]) < near_m * near_m;
        if (near && !side.is_seam[i]) return false;
        on_seam = on_seam || near;
    }
    if (!on_seam) return false;
    const Feature& feature = aspect_.feature;
    const auto end = feature.corners.begin() + static_cast<std::ptrdiff_t>(feature.count);
    return std::none_of(feature.corners.begin(), end, [&](const Vec3d& corner) {
        const Vec3d away = corner - point.on_a;
        return glm::dot(away, away) < near_m * near_m;
    });
}

/// Whether no other triangle at the place rises over the normal's plane: also of such as meet there without
/// sharing corners.
bool TriangleContacts::is_outermost(const Side& side,
                                    const Vec3d& place,
                                    const Vec3d& normal) const {
    const double near_m = kTouchingShare * size_m_;
    bool outermost = true;
    mesh_.visit_round(place, near_m, [&](std::uint32_t other) {
        if (!outermost || other == side.index) return;
        const std::array<Vec3d, 3> corners = mesh_.corners_m(other);
        const bool rises = std::ranges::any_of(corners, [&](const Vec3d& corner) {
            const Vec3d there = corner - place;
            return glm::dot(there, normal) > kRises_rad * glm::length(there) + near_m;
        });
        if (rises) outermost = away_from_triangle2(place, corners) > near_m * near_m;
    });
    return outermost;
}

/// What of the triangle lies farthest along the normal: the edge or the corner nearest to `place`.
TriangleContacts::Edge TriangleContacts::edge_along(const Side& side,
                                                    const Vec3d& normal,
                                                    const Vec3d& place) {
    std::array<double, 3> along{};
    for (std::size_t i = 0; i < 3; ++i) along[i] = glm::dot(side.corners[i], normal);
    const auto top =
        static_cast<std::size_t>(std::max_element(along.begin(), along.end()) - along.begin());
    Edge found{top, top};
    double least2 = kFarAway_m;
    for (std::size_t from = 0; from < 3; ++from) {
        const std::size_t to = after(from);
        const double level_m = kLies_rad * glm::distance(side.corners[from], side.corners[to]);
        if (along[top] - std::min(along[from], along[to]) > level_m) continue;
        const double away2 = away_from_line2(place, side.corners[from], side.corners[to]);
        if (away2 >= least2) continue;
        least2 = away2;
        found = {from, to};
    }
    return found;
}

bool TriangleContacts::sticks_out(const Side& side, const Edge& edge) {
    if (edge.from != edge.to) return side.sticks_out[edge.from];
    return side.sticks_out[edge.from] || side.sticks_out[(edge.from + 2) % 3];
}

/// The face did not have the shape's lowest point: an edge or a corner may be nearer. `first`: the face's points
/// begin there.
void TriangleContacts::add_edge(const Side& side, std::size_t first) {
    const std::optional<Separation> found =
        separation_of(convex_, placed_triangle(side.corners), reach_m_);
    if (!found) return;
    const Vec3d& normal = found->normal;
    const Edge edge = edge_along(side, normal, found->on_b);
    if (!sticks_out(side, edge)) return;
    const Vec3d& from = side.corners[edge.from];
    const Vec3d along = side.corners[edge.to] - from;
    const double length2 = glm::dot(along, along);
    // Between its ends, where other edges begin.
    const double t = length2 > 0 ? glm::dot(found->on_b - from, along) / length2 : 0.0;
    if (!is_outermost(side, from + along * std::clamp(t, kEnd, 1 - kEnd), normal)) return;
    // The face's own points on that edge would press a second time.
    const double near_m = kSameMeshPoint * size_m_;
    const auto begin = points_.begin() + static_cast<std::ptrdiff_t>(first);
    const auto is_on_edge = [&](const MeshPoint& point) {
        return away_from_line2(point.on_mesh, from, from + along) < near_m * near_m;
    };
    points_.erase(std::remove_if(begin, points_.end(), is_on_edge), points_.end());
    press_with_edge(
        side, edge, normal, {found->on_a, found->on_b, found->distance_m + convex_.radius_m});
}

void TriangleContacts::press_with_edge(const Side& side,
                                       const Edge& edge,
                                       const Vec3d& normal,
                                       const RegionPoint& nearest) {
    double region_m = kFarAway_m;
    Feature feature;
    find_feature(convex_, -normal, feature);
    if (edge.from != edge.to && feature.kind != Feature::Kind::Point) {
        Feature line;
        line.kind = Feature::Kind::Segment;
        line.add(side.corners[edge.from]);
        line.add(side.corners[edge.to]);
        const ContactRegion region(
            feature, line, normal, reach_m_ + convex_.radius_m, kTouchingShare * size_m_);
        for (const RegionPoint& point : region.points()) {
            put(side, normal, point, MeshPoint::Kind::Edge);
            region_m = std::min(region_m, point.distance_m);
        }
    }
    if (region_m > nearest.distance_m + kNearest * size_m_)
        put(side, normal, nearest, MeshPoint::Kind::Edge);
}

void TriangleContacts::add_sphere(const Side& side) {
    const double height_m = -side.offset_m;
    if (height_m - convex_.radius_m > reach_m_) return;
    const NearestPoint nearest = nearest_to({0, 0, 0}, side.corners, side.normal);
    if (nearest.is_face)
        return put(side, side.normal, {{0, 0, 0}, nearest.at, height_m}, MeshPoint::Kind::Face);
    const double away_m = glm::length(nearest.at);
    if (away_m - convex_.radius_m > reach_m_) return;
    if (!sticks_out(side, {nearest.from, nearest.to})) {
        if (glm::distance(nearest.at, side.normal * side.offset_m) <= kWedge_rad * away_m)
            put_over(side, {0, 0, 0}, MeshPoint::Kind::Face);
        return;
    }
    // A centre on the edge itself has no direction of its own.
    const Vec3d normal = away_m > 1e-9 * size_m_ ? -nearest.at / away_m : side.normal;
    if (!is_outermost(side, nearest.at, normal)) return;
    put(side, normal, {{0, 0, 0}, nearest.at, away_m}, MeshPoint::Kind::Edge);
}

}  // namespace plumbline::physics
