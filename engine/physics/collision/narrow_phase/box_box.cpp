#include "engine/physics/collision/narrow_phase/box_box.h"

#include "engine/physics/transform.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

/// Edges whose directions differ by less (sine) say nothing that faces do not.
constexpr Real kParallel = 0.01_r;
/// Another direction must part the boxes by so much more than the last best one, as a share of the
/// smaller box: rounding must not change the kind of contact from step to step.
constexpr Real kFaceGain = 1e-3_r;
constexpr Real kEdgeGain = 5e-3_r;
/// Two edges whose normal lies this near (cosine, 8 degrees) to a face's meet by that face: their one point would let
/// thin plates that lie on each other rock, and turn into each other.
constexpr Real kAlongFace = 0.99_r;
/// Points deeper than the deepest but this share of the face are as good as the deepest.
constexpr Real kLevel = 5e-3_r;

/// The direction in which the boxes are farthest apart, or overlap least.
struct Axis {
    Real separation_m{-1e30_r};
    Vec3 direction{0, 1, 0};  ///< unit, from a to b
    int of_a{-1};             ///< a's face, or edge when `of_b` is set too
    int of_b{-1};
};

/// What the tests share: b as a sees it.
struct Frame {
    const OrientedBox& a;
    const OrientedBox& b;
    Vec3 between{0, 0, 0};  ///< from a's centre to b's, world
    Mat3 cosine{1};         ///< [j][i] = a's axis i along b's axis j
    Mat3 abs_cosine{1};
    Real size_m{0};  ///< least half edge
};

Frame frame_of(const OrientedBox& a, const OrientedBox& b) {
    Frame f{.a = a, .b = b, .between = b.center - a.center};
    f.cosine = glm::transpose(a.axes) * b.axes;
    for (int j = 0; j < 3; ++j) f.abs_cosine[j] = magnitudes_of(f.cosine[j]);
    const Vec3 least = glm::min(a.half_m, b.half_m);
    f.size_m = std::min({least.x, least.y, least.z});
    return f;
}

/// Whether the boxes are within reach along it; keeps the direction if it parts them by more.
bool consider(Axis& best, const Axis& axis, Real gain_m, Real reach_m) {
    if (axis.separation_m > reach_m) return false;
    if (axis.separation_m > best.separation_m + gain_m) best = axis;
    return true;
}

bool consider_faces(const Frame& f, Real reach_m, Axis& best) {
    for (int i = 0; i < 3; ++i) {
        const Vec3& along = f.a.axes[i];
        const Real offset_m = glm::dot(f.between, along);
        const Vec3 row{f.abs_cosine[0][i], f.abs_cosine[1][i], f.abs_cosine[2][i]};
        const Real separation_m = std::abs(offset_m) - f.a.half_m[i] - glm::dot(row, f.b.half_m);
        const Axis axis{separation_m, offset_m < 0 ? -along : along, i, -1};
        if (!consider(best, axis, kFaceGain * f.size_m, reach_m)) return false;
    }
    for (int j = 0; j < 3; ++j) {
        const Vec3& along = f.b.axes[j];
        const Real offset_m = glm::dot(f.between, along);
        const Real separation_m =
            std::abs(offset_m) - f.b.half_m[j] - glm::dot(f.abs_cosine[j], f.a.half_m);
        const Axis axis{separation_m, offset_m < 0 ? -along : along, -1, j};
        if (!consider(best, axis, kFaceGain * f.size_m, reach_m)) return false;
    }
    return true;
}

/// Gottschalk, Lin and Manocha (OBBTree, 1996, section 5): in a's frame an edge of a has one component, so most of each
/// cross product vanishes; what is left is longer than the unit direction's by the sine between the edges.
bool consider_edges(const Frame& f, Real reach_m, Axis& best) {
    const Vec3 between = f.between * f.a.axes;
    for (int i = 0; i < 3; ++i) {
        const int i1 = (i + 1) % 3;
        const int i2 = (i + 2) % 3;
        for (int j = 0; j < 3; ++j) {
            const int j1 = (j + 1) % 3;
            const int j2 = (j + 2) % 3;
            const Real sine2 = 1 - f.cosine[j][i] * f.cosine[j][i];
            if (sine2 < kParallel * kParallel) continue;
            const Real offset = between[i2] * f.cosine[j][i1] - between[i1] * f.cosine[j][i2];
            const Real reach_of_both =
                f.a.half_m[i1] * f.abs_cosine[j][i2] + f.a.half_m[i2] * f.abs_cosine[j][i1] +
                f.b.half_m[j1] * f.abs_cosine[j2][i] + f.b.half_m[j2] * f.abs_cosine[j1][i];
            const Real separation = std::abs(offset) - reach_of_both;
            const Real sine = std::sqrt(sine2);
            if (separation > reach_m * sine) return false;
            if (separation <= (best.separation_m + kEdgeGain * f.size_m) * sine) continue;
            const Vec3 along = glm::cross(f.a.axes[i], f.b.axes[j]) / sine;
            best = {separation / sine, offset < 0 ? -along : along, i, j};
        }
    }
    return true;
}

/// The corner or the middle of the edge or face of `box` that lies farthest in a direction.
Vec3 support(const OrientedBox& box, const Vec3& direction, int skipped_axis) {
    Vec3 point = box.center;
    for (int k = 0; k < 3; ++k) {
        if (k == skipped_axis) continue;
        const Real side = glm::dot(direction, box.axes[k]) < 0 ? -1 : 1;
        point += box.axes[k] * (side * box.half_m[k]);
    }
    return point;
}

BoxContact meet_edges(const Frame& f, const Axis& axis, Real reach_m) {
    const Vec3 on_a = support(f.a, axis.direction, axis.of_a);
    const Vec3 on_b = support(f.b, -axis.direction, axis.of_b);
    const Vec3& u = f.a.axes[axis.of_a];
    const Vec3& v = f.b.axes[axis.of_b];
    const Vec3 apart = on_a - on_b;
    const Real cosine = glm::dot(u, v);
    const Real along_b = (glm::dot(apart, v) - cosine * glm::dot(apart, u)) / (1 - cosine * cosine);
    const Real limit_m = f.b.half_m[axis.of_b];
    BoxContact contact{.normal = -axis.direction};
    if (axis.separation_m > reach_m) return contact;
    contact.count = 1;
    contact.on_b[0] = on_b + v * std::clamp(along_b, -limit_m, limit_m);
    contact.distance_m[0] = axis.separation_m;
    return contact;
}

/// A face of a box cut by four planes has at most eight corners.
struct Polygon {
    std::array<Vec3, 8> corners{};
    int count{0};

    void add(const Vec3& corner) {
        if (count < 8) corners[static_cast<std::size_t>(count++)] = corner;
    }
    const Vec3& at(int i) const { return corners[static_cast<std::size_t>(i)]; }
};

/// Keeps what lies below `limit_m` along `direction` (Sutherland and Hodgman 1974).
void cut(Polygon& polygon, const Vec3& direction, Real limit_m) {
    std::array<Real, 8> above;
    bool any_above = false;
    for (int i = 0; i < polygon.count; ++i) {
        const Real above_m = glm::dot(polygon.at(i), direction) - limit_m;
        above[static_cast<std::size_t>(i)] = above_m;
        any_above = any_above || !(above_m <= 0);
    }
    if (!any_above) return;
    Polygon kept;
    for (int i = 0; i < polygon.count; ++i) {
        const int next = i + 1 == polygon.count ? 0 : i + 1;
        const Real here_m = above[static_cast<std::size_t>(i)];
        const Real next_m = above[static_cast<std::size_t>(next)];
        const Vec3& here = polygon.at(i);
        if (here_m <= 0) kept.add(here);
        if ((here_m < 0 && next_m > 0) || (here_m > 0 && next_m < 0))
            kept.add(here + (polygon.at(next) - here) * (here_m / (here_m - next_m)));
    }
    polygon = kept;
}

/// The face of `box` that looks most against `direction`; corners from `origin`.
Polygon face_against(const OrientedBox& box, const Vec3& direction, const Vec3& origin) {
    const Vec3 cosines = glm::transpose(box.axes) * direction;
    const Vec3 size = magnitudes_of(cosines);
    int k = 0;
    if (size.y > size[k]) k = 1;
    if (size.z > size[k]) k = 2;
    const Vec3 middle =
        box.center - origin + box.axes[k] * (cosines[k] > 0 ? -box.half_m[k] : box.half_m[k]);
    const Vec3 u = box.axes[(k + 1) % 3] * box.half_m[(k + 1) % 3];
    const Vec3 v = box.axes[(k + 2) % 3] * box.half_m[(k + 2) % 3];
    Polygon face;
    face.add(middle - u - v);
    face.add(middle + u - v);
    face.add(middle + u + v);
    face.add(middle - u + v);
    return face;
}

/// Indices of up to four corners: one of the deepest, the one farthest from it, and those that make
/// the largest triangles on either side of the line between.
int choose_four(const Polygon& polygon,
                const std::array<Real, 8>& distance_m,
                const Vec3& normal,
                Real size_m,
                std::array<int, 4>& chosen) {
    if (polygon.count <= 4) {
        for (int i = 0; i < polygon.count; ++i) chosen[static_cast<std::size_t>(i)] = i;
        return polygon.count;
    }
    const auto best = [&](const auto& score) {
        int found = 0;
        for (int i = 1; i < polygon.count; ++i)
            if (score(i) > score(found)) found = i;
        return found;
    };
    Vec3 middle{0, 0, 0};
    for (int i = 0; i < polygon.count; ++i) middle += polygon.at(i);
    middle /= static_cast<Real>(polygon.count);
    const Real deepest = *std::min_element(distance_m.begin(), distance_m.begin() + polygon.count);
    const auto away2 = [](const Vec3& p, const Vec3& q) { return glm::dot(p - q, p - q); };
    chosen[0] = best([&](int i) {
        const bool level = distance_m[static_cast<std::size_t>(i)] <= deepest + kLevel * size_m;
        return level ? away2(polygon.at(i), middle) : Real{-1};
    });
    const Vec3& first = polygon.at(chosen[0]);
    chosen[1] = best([&](int i) { return away2(polygon.at(i), first); });
    const Vec3 line = glm::cross(normal, polygon.at(chosen[1]) - first);
    chosen[2] = best([&](int i) { return glm::dot(polygon.at(i) - first, line); });
    chosen[3] = best([&](int i) { return -glm::dot(polygon.at(i) - first, line); });
    return 4;
}

/// `outward`: from the box whose face it is towards the other.
BoxContact meet_face(const OrientedBox& box,
                     const OrientedBox& other,
                     int face,
                     const Vec3& outward,
                     bool face_is_a,
                     Real reach_m) {
    Polygon polygon = face_against(other, outward, box.center);
    for (int side = 1; side < 3; ++side) {
        const int k = (face + side) % 3;
        cut(polygon, box.axes[k], box.half_m[k]);
        cut(polygon, -box.axes[k], box.half_m[k]);
    }
    Polygon near;
    std::array<Real, 8> distance_m{};
    for (int i = 0; i < polygon.count; ++i) {
        const Real away_m = glm::dot(polygon.at(i), outward) - box.half_m[face];
        if (away_m > reach_m) continue;
        distance_m[static_cast<std::size_t>(near.count)] = away_m;
        near.add(polygon.at(i));
    }
    std::array<int, 4> chosen{};
    const Real size_m = std::min(box.half_m[(face + 1) % 3], box.half_m[(face + 2) % 3]);
    BoxContact contact{.normal = face_is_a ? -outward : outward};
    const int count = choose_four(near, distance_m, outward, size_m, chosen);
    for (int i = 0; i < count; ++i) {
        const auto from = static_cast<std::size_t>(chosen[static_cast<std::size_t>(i)]);
        const auto to = static_cast<std::size_t>(contact.count++);
        // The corner lies on the other box, the face on this one.
        const Vec3 corner = near.corners[from] + box.center;
        contact.on_b[to] = face_is_a ? corner : corner - outward * distance_m[from];
        contact.distance_m[to] = distance_m[from];
    }
    return contact;
}

}  // namespace

BoxContact collide_boxes(const OrientedBox& a, const OrientedBox& b, Real reach_m) {
    const Frame f = frame_of(a, b);
    Axis best;
    if (!consider_faces(f, reach_m, best)) return {};
    const Axis face = best;
    if (!consider_edges(f, reach_m, best)) return {};
    if (glm::dot(face.direction, best.direction) > kAlongFace) best = face;
    if (best.of_a >= 0 && best.of_b >= 0) return meet_edges(f, best, reach_m);
    if (best.of_a >= 0) return meet_face(a, b, best.of_a, best.direction, true, reach_m);
    return meet_face(b, a, best.of_b, -best.direction, false, reach_m);
}

}  // namespace plumbline::physics
