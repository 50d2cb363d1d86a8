#include "engine/physics/collision/shape/mesh_geometry.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

namespace plumbline::physics {
namespace {

constexpr std::uint32_t kNone = 0xffffffffU;

std::uint64_t mixed(std::uint64_t bits) {
    bits ^= bits >> 32U;
    bits *= 0x9e3779b97f4a7c15U;
    bits ^= bits >> 29U;
    bits *= 0xbf58476d1ce4e5b9U;
    return bits ^ bits >> 32U;
}

std::uint64_t hash_of(const Vec3d& place) {
    std::uint64_t hash = 0;
    for (int axis = 0; axis < 3; ++axis)
        hash = mixed(hash ^ std::bit_cast<std::uint64_t>(place[axis]));
    return hash;
}

/// Gives equal places one number.
class Welder {
public:
    Welder(std::size_t most, std::vector<Vec3>& corners)
        : slots_(std::bit_ceil(2 * most + 1), kNone), corners_(corners) {}

    std::uint32_t number_of(const Vec3& place) {
        const Vec3 key = place + Vec3{0, 0, 0};  // -0 becomes 0
        const std::size_t mask = slots_.size() - 1;
        for (std::size_t slot = hash_of(Vec3d(key)) & mask;; slot = (slot + 1) & mask) {
            if (slots_[slot] == kNone) {
                slots_[slot] = static_cast<std::uint32_t>(corners_.size());
                corners_.push_back(key);
                return slots_[slot];
            }
            if (corners_[slots_[slot]] == key) return slots_[slot];
        }
    }

private:
    std::vector<std::uint32_t> slots_;
    std::vector<Vec3>& corners_;
};

/// Things that each belong to a corner, listed corner by corner.
struct Buckets {
    std::vector<std::uint32_t> first;
    std::vector<std::uint32_t> things;

    std::span<std::uint32_t> at(std::size_t corner) {
        return std::span(things).subspan(first[corner], first[corner + 1] - first[corner]);
    }
};

/// `corner_of(thing)`: for things from 0 up.
template <class CornerOf>
Buckets sorted_by_corner(std::size_t corners, std::size_t count, const CornerOf& corner_of) {
    Buckets buckets{.first = std::vector<std::uint32_t>(corners + 1, 0),
                    .things = std::vector<std::uint32_t>(count)};
    for (std::size_t i = 0; i < count; ++i) ++buckets.first[corner_of(i) + 1];
    std::partial_sum(buckets.first.begin(), buckets.first.end(), buckets.first.begin());
    std::vector<std::uint32_t> next = buckets.first;
    for (std::size_t i = 0; i < count; ++i)
        buckets.things[next[corner_of(i)]++] = static_cast<std::uint32_t>(i);
    return buckets;
}

class MeshBuilder {
public:
    MeshGeometry build(std::span<const Vec3> corners,
                       std::span<const std::array<std::uint32_t, 3>> triangles) {
        weld(corners, triangles);
        drop_repeated();
        classify_edges();
        grow_tree();
        return std::move(mesh_);
    }

private:
    void weld(std::span<const Vec3> corners,
              std::span<const std::array<std::uint32_t, 3>> triangles) {
        mesh_.corners_m.reserve(corners.size());
        Welder welder(corners.size(), mesh_.corners_m);
        std::vector<std::uint32_t> number(corners.size());
        for (std::size_t i = 0; i < corners.size(); ++i) number[i] = welder.number_of(corners[i]);
        mesh_.triangles.reserve(triangles.size());
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            const auto& [a, b, c] = triangles[t];
            const MeshTriangle triangle{.corners = {number[a], number[b], number[c]},
                                        .source = static_cast<std::uint32_t>(t)};
            if (has_area(triangle)) mesh_.triangles.push_back(triangle);
        }
    }

    Vec3d area_normal(const MeshTriangle& triangle) const {
        const Vec3d a = mesh_.corner_m(triangle, 0);
        return glm::cross(mesh_.corner_m(triangle, 1) - a, mesh_.corner_m(triangle, 2) - a);
    }

    bool has_area(const MeshTriangle& triangle) const {
        double longest2 = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3d edge = mesh_.corner_m(triangle, (i + 1) % 3) - mesh_.corner_m(triangle, i);
            longest2 = std::max(longest2, glm::dot(edge, edge));
        }
        return glm::length(area_normal(triangle)) > kNoHeight * longest2;
    }

    static std::array<std::uint32_t, 3> in_order(const MeshTriangle& triangle) {
        std::array<std::uint32_t, 3> corners = triangle.corners;
        std::sort(corners.begin(), corners.end());
        return corners;
    }

    static bool same_winding(const MeshTriangle& a, const MeshTriangle& b) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (a.corners[0] == b.corners[i]) return a.corners[1] == b.corners[(i + 1) % 3];
        }
        return false;
    }

    void drop_repeated() {
        std::vector<MeshTriangle>& all = mesh_.triangles;
        Buckets buckets = sorted_by_corner(
            mesh_.corners_m.size(), all.size(), [&](std::size_t t) { return in_order(all[t])[0]; });
        std::vector<bool> repeats(all.size(), false);
        for (std::size_t corner = 0; corner < mesh_.corners_m.size(); ++corner) {
            const std::span<std::uint32_t> here = buckets.at(corner);
            const auto key = [&all](std::uint32_t t) { return std::pair(in_order(all[t]), t); };
            std::sort(here.begin(), here.end(), [&key](std::uint32_t a, std::uint32_t b) {
                return key(a) < key(b);
            });
            for (std::size_t i = 1, kept = 0; i < here.size(); ++i) {
                MeshTriangle& first = all[here[kept]];
                repeats[here[i]] = in_order(first) == in_order(all[here[i]]);
                if (!repeats[here[i]])
                    kept = i;
                else if (!same_winding(first, all[here[i]]))
                    first.has_two_fronts = true;
            }
        }
        std::size_t count = 0;
        for (std::size_t t = 0; t < all.size(); ++t) {
            if (!repeats[t]) all[count++] = all[t];
        }
        all.resize(count);
    }

    void classify_edges();
    EdgeKind kind_of(std::uint32_t edge, std::uint32_t other) const;
    void grow_tree();

    MeshGeometry mesh_;
};

/// Edge 3 t + i is the i-th of triangle t.
void MeshBuilder::classify_edges() {
    std::vector<MeshTriangle>& all = mesh_.triangles;
    const auto ends = [&all](std::size_t edge) {
        const MeshTriangle& triangle = all[edge / 3];
        return std::minmax({triangle.corners[edge % 3], triangle.corners[(edge % 3 + 1) % 3]});
    };
    Buckets buckets = sorted_by_corner(
        mesh_.corners_m.size(), 3 * all.size(), [&](std::size_t edge) { return ends(edge).first; });
    for (std::size_t corner = 0; corner < mesh_.corners_m.size(); ++corner) {
        const std::span<std::uint32_t> here = buckets.at(corner);
        const auto far_end = [&ends](std::uint32_t edge) { return ends(edge).second; };
        std::sort(here.begin(), here.end(), [&far_end](std::uint32_t a, std::uint32_t b) {
            return std::pair(far_end(a), a) < std::pair(far_end(b), b);
        });
        for (std::size_t from = 0, to = 0; from < here.size(); from = to) {
            while (to < here.size() && far_end(here[to]) == far_end(here[from])) ++to;
            const bool is_pair = to - from == 2;
            for (std::size_t i = from; i < to; ++i) {
                all[here[i] / 3].edges[here[i] % 3] =
                    is_pair ? kind_of(here[i], here[from + to - 1 - i]) : EdgeKind::Rim;
            }
        }
    }
}

/// Seen from the front of the triangle of `edge`.
EdgeKind MeshBuilder::kind_of(std::uint32_t edge, std::uint32_t other) const {
    const MeshTriangle& mine = mesh_.triangles[edge / 3];
    const MeshTriangle& its = mesh_.triangles[other / 3];
    const Vec3d from = mesh_.corner_m(mine, edge % 3);
    const Vec3d along = glm::normalize(mesh_.corner_m(mine, (edge % 3 + 1) % 3) - from);
    const Vec3d normal = glm::normalize(area_normal(mine));
    Vec3d away = mesh_.corner_m(its, (other % 3 + 2) % 3) - from;
    away -= along * glm::dot(away, along);
    const double rise = glm::dot(away, normal);
    // Out over the edge: the triangle itself lies on the other side.
    const double out = glm::dot(away, glm::cross(along, normal));
    if (std::abs(rise) <= kFlatEdge_rad * std::abs(out))
        return out > 0 ? EdgeKind::Flat : EdgeKind::Rim;
    return rise < 0 ? EdgeKind::Convex : EdgeKind::Concave;
}

void MeshBuilder::grow_tree() {
    std::vector<Bounds> boxes;
    boxes.reserve(mesh_.triangles.size());
    for (const MeshTriangle& triangle : mesh_.triangles) {
        const Vec3d a = mesh_.corner_m(triangle, 0);
        const Vec3d b = mesh_.corner_m(triangle, 1);
        const Vec3d c = mesh_.corner_m(triangle, 2);
        boxes.push_back({glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))});
    }
    mesh_.tree = BoxTree(boxes);
}

}  // namespace

MeshGeometry mesh_geometry(std::span<const Vec3> corners_m,
                           std::span<const std::array<std::uint32_t, 3>> triangles) {
    return MeshBuilder().build(corners_m, triangles);
}

}  // namespace plumbline::physics
