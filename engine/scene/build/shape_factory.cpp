#include "engine/scene/build/shape_factory.h"

#include "engine/core/hash.h"

#include <algorithm>
#include <tuple>

namespace plumbline::scene {

namespace {

using physics::BoxShape;
using physics::CapsuleShape;
using physics::CompoundChild;
using physics::CompoundShape;
using physics::ConeShape;
using physics::CylinderShape;
using physics::HullShape;
using physics::MeshShape;
using physics::PlaneShape;
using physics::ShapeDef;
using physics::SphereShape;

template <class... Fns>
struct Overloaded : Fns... {
    using Fns::operator()...;
};
template <class... Fns>
Overloaded(Fns...) -> Overloaded<Fns...>;

constexpr int kRingPoints = 16;

void add_number(Hasher& hasher, Real value) {
    hasher.add(&value, sizeof value);
}

void add_vector(Hasher& hasher, const Vec3& v) {
    for (int axis = 0; axis < 3; ++axis) add_number(hasher, v[axis]);
}

void add_content(Hasher& hasher, const ShapeDef& shape) {
    const auto kind = static_cast<std::uint32_t>(shape.index());
    hasher.add(&kind, sizeof kind);
    std::visit(Overloaded{[&](const BoxShape& s) { add_vector(hasher, s.size_m); },
                          [&](const SphereShape& s) { add_number(hasher, s.radius_m); },
                          [&](const PlaneShape& s) {
                              add_vector(hasher, {s.size_m.x, s.thickness_m, s.size_m.y});
                          },
                          [&](const HullShape& s) {
                              for (const Vec3& p : s.points_m) add_vector(hasher, p);
                          },
                          [&](const MeshShape& s) {
                              for (const Vec3& p : s.vertices_m) add_vector(hasher, p);
                              for (const auto& t : s.triangles) hasher.add(t.data(), sizeof t);
                          },
                          [&](const CompoundShape& s) {
                              for (const CompoundChild& child : s.children) {
                                  add_content(hasher, child.shape);
                                  add_vector(hasher, child.body_from_child.position);
                                  const Quat& q = child.body_from_child.orientation;
                                  add_vector(hasher, {q.x, q.y, q.z});
                                  add_number(hasher, q.w);
                              }
                          },
                          [&](const auto& s) {
                              add_vector(hasher, {s.radius_m, s.height_m, Real{0}});
                          }},
               shape);
}

void add_ring(std::vector<Vec3>& points, Real radius_m, Real y_m) {
    for (int i = 0; i < kRingPoints; ++i) {
        const Real angle = Real{2} * kPi * static_cast<Real>(i) / kRingPoints;
        points.push_back({radius_m * portable_cos(angle), y_m, radius_m * portable_sin(angle)});
    }
}

/// Half a ball: rings from the equator to the pole on the side of `sign`.
void add_cap(std::vector<Vec3>& points, Real radius_m, Real equator_y_m, Real sign) {
    for (const Real latitude_deg : {0.0_r, 30.0_r, 60.0_r}) {
        const Real latitude = radians_from_degrees(latitude_deg);
        add_ring(points,
                 radius_m * portable_cos(latitude),
                 equator_y_m + sign * radius_m * portable_sin(latitude));
    }
    points.push_back({0, equator_y_m + sign * radius_m, 0});
}

void add_corners(std::vector<Vec3>& points, const Vec3& min, const Vec3& max) {
    for (unsigned corner = 0; corner < 8; ++corner) {
        points.push_back({(corner & 1U) != 0 ? max.x : min.x,
                          (corner & 2U) != 0 ? max.y : min.y,
                          (corner & 4U) != 0 ? max.z : min.z});
    }
}

std::vector<Vec3> stretched(std::vector<Vec3> points, const Vec3& scale) {
    for (Vec3& p : points) p *= scale;
    return points;
}

bool is_even(Real a, Real b) {
    return std::abs(a - b) <= 1e-6_r * std::max(std::abs(a), std::abs(b));
}

CompoundShape scaled_compound(const CompoundShape& compound, const Vec3& scale) {
    CompoundShape result;
    const bool uniform = is_even(scale.x, scale.y) && is_even(scale.x, scale.z);
    for (const CompoundChild& child : compound.children) {
        const Quat& q = child.body_from_child.orientation;
        const bool turned = std::abs(q.w) < Real{1} - 1e-6_r;
        CompoundChild copy = child;
        if (uniform || !turned) {
            copy.shape = scaled(child.shape, scale);
            copy.body_from_child.position *= scale;
        } else {
            // A turned child that stretches unevenly shears: only its points can follow.
            HullShape hull{.points_m = points_of(child.shape)};
            for (Vec3& p : hull.points_m) p = transform_point(child.body_from_child, p) * scale;
            copy = {.shape = hull, .body_from_child = {}};
        }
        result.children.push_back(std::move(copy));
    }
    return result;
}

}  // namespace

ShapeDef scaled(const ShapeDef& shape, const Vec3& scale) {
    if (scale == Vec3{1, 1, 1}) return shape;
    const bool level_even = is_even(scale.x, scale.z);
    const bool even = level_even && is_even(scale.x, scale.y);
    const auto as_hull = [&] {
        return ShapeDef{HullShape{.points_m = stretched(points_of(shape), scale)}};
    };
    return std::visit(
        Overloaded{
            [&](const BoxShape& s) { return ShapeDef{BoxShape{.size_m = s.size_m * scale}}; },
            [&](const SphereShape& s) {
                return even ? ShapeDef{SphereShape{.radius_m = s.radius_m * scale.x}} : as_hull();
            },
            [&](const CylinderShape& s) {
                return level_even ? ShapeDef{CylinderShape{.radius_m = s.radius_m * scale.x,
                                                           .height_m = s.height_m * scale.y}}
                                  : as_hull();
            },
            [&](const ConeShape& s) {
                return level_even ? ShapeDef{ConeShape{.radius_m = s.radius_m * scale.x,
                                                       .height_m = s.height_m * scale.y}}
                                  : as_hull();
            },
            [&](const CapsuleShape& s) {
                return even ? ShapeDef{CapsuleShape{.radius_m = s.radius_m * scale.x,
                                                    .height_m = s.height_m * scale.x}}
                            : as_hull();
            },
            [&](const PlaneShape& s) {
                return ShapeDef{PlaneShape{.size_m = {s.size_m.x * scale.x, s.size_m.y * scale.z},
                                           .thickness_m = s.thickness_m * scale.y}};
            },
            [&](const HullShape&) { return as_hull(); },
            [&](const MeshShape& s) {
                return ShapeDef{MeshShape{.vertices_m = stretched(s.vertices_m, scale),
                                          .triangles = s.triangles}};
            },
            [&](const CompoundShape& s) { return ShapeDef{scaled_compound(s, scale)}; }},
        shape);
}

std::vector<Vec3> points_of(const ShapeDef& shape) {
    std::vector<Vec3> points;
    std::visit(
        Overloaded{
            [&](const BoxShape& s) { add_corners(points, s.size_m * -0.5_r, s.size_m * 0.5_r); },
            [&](const SphereShape& s) {
                add_cap(points, s.radius_m, 0, Real{1});
                add_cap(points, s.radius_m, 0, Real{-1});
            },
            [&](const CylinderShape& s) {
                add_ring(points, s.radius_m, s.height_m * -0.5_r);
                add_ring(points, s.radius_m, s.height_m * 0.5_r);
            },
            [&](const CapsuleShape& s) {
                add_cap(points, s.radius_m, s.height_m * 0.5_r, Real{1});
                add_cap(points, s.radius_m, s.height_m * -0.5_r, Real{-1});
            },
            [&](const ConeShape& s) {
                add_ring(points, s.radius_m, s.height_m * -0.5_r);
                points.push_back({0, s.height_m * 0.5_r, 0});
            },
            [&](const PlaneShape& s) {
                add_corners(points,
                            {s.size_m.x * -0.5_r, -s.thickness_m, s.size_m.y * -0.5_r},
                            {s.size_m.x * 0.5_r, 0, s.size_m.y * 0.5_r});
            },
            [&](const HullShape& s) { points = s.points_m; },
            [&](const MeshShape& s) { points = s.vertices_m; },
            [&](const CompoundShape& s) {
                for (const CompoundChild& child : s.children) {
                    for (const Vec3& p : points_of(child.shape)) {
                        points.push_back(transform_point(child.body_from_child, p));
                    }
                }
            }},
        shape);
    return points;
}

void bounds_of(const ShapeDef& shape, Vec3& min_body, Vec3& max_body) {
    min_body = max_body = {0, 0, 0};
    bool first = true;
    for (const Vec3& p : points_of(shape)) {
        min_body = first ? p : glm::min(min_body, p);
        max_body = first ? p : glm::max(max_body, p);
        first = false;
    }
}

Real volume_of(const ShapeDef& shape) {
    return std::visit(
        Overloaded{
            [](const BoxShape& s) { return s.size_m.x * s.size_m.y * s.size_m.z; },
            [](const SphereShape& s) {
                return Real{4} / Real{3} * kPi * s.radius_m * s.radius_m * s.radius_m;
            },
            [](const CylinderShape& s) { return kPi * s.radius_m * s.radius_m * s.height_m; },
            [](const CapsuleShape& s) {
                return kPi * s.radius_m * s.radius_m *
                       (s.height_m + Real{4} / Real{3} * s.radius_m);
            },
            [](const ConeShape& s) { return kPi * s.radius_m * s.radius_m * s.height_m / Real{3}; },
            [](const PlaneShape& s) { return s.size_m.x * s.size_m.y * s.thickness_m; },
            [](const HullShape& s) { return hull_volume_m3(s.points_m); },
            [](const MeshShape&) { return Real{0}; },
            [](const CompoundShape& s) {
                Real sum{0};
                for (const CompoundChild& child : s.children) sum += volume_of(child.shape);
                return sum;
            }},
        shape);
}

Real inner_radius_of(const ShapeDef& shape) {
    return std::visit(
        Overloaded{[](const SphereShape& s) { return s.radius_m; },
                   [](const CapsuleShape& s) { return s.radius_m; },
                   [](const BoxShape& s) {
                       return 0.5_r * std::min({s.size_m.x, s.size_m.y, s.size_m.z});
                   },
                   [](const CylinderShape& s) { return std::min(s.radius_m, s.height_m * 0.5_r); },
                   [](const ConeShape& s) {
                       const Real slant = glm::length(Vec2{s.radius_m, s.height_m});
                       return s.radius_m * s.height_m / (s.radius_m + slant);
                   },
                   [](const CompoundShape& s) {
                       // A compound is as easily passed by as its thinnest part.
                       Real least{0};
                       for (const CompoundChild& child : s.children) {
                           const Real radius = inner_radius_of(child.shape);
                           least = least > Real{0} ? std::min(least, radius) : radius;
                       }
                       return least;
                   },
                   [&](const auto&) {
                       // Half of what the box would give: a tetrahedron's share, the least of all hulls
                       // that fill their boxes evenly.
                       Vec3 min;
                       Vec3 max;
                       bounds_of(shape, min, max);
                       const Vec3 size = max - min;
                       return 0.25_r * std::min({size.x, size.y, size.z});
                   }},
        shape);
}

ShapeDef hull_of(const assets::MeshData& mesh) {
    const auto less = [](const Vec3& a, const Vec3& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    };
    HullShape hull;
    hull.points_m.reserve(mesh.vertices.size());
    for (const assets::Vertex& vertex : mesh.vertices) {
        hull.points_m.push_back(Vec3(vertex.position_body));
    }
    std::sort(hull.points_m.begin(), hull.points_m.end(), less);
    hull.points_m.erase(std::unique(hull.points_m.begin(), hull.points_m.end()),
                        hull.points_m.end());
    return hull;
}

ShapeDef mesh_of(const assets::MeshData& mesh) {
    MeshShape shape;
    shape.vertices_m.reserve(mesh.vertices.size());
    for (const assets::Vertex& vertex : mesh.vertices) {
        shape.vertices_m.push_back(Vec3(vertex.position_body));
    }
    shape.triangles.reserve(mesh.indices.size() / 3);
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        shape.triangles.push_back({mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
    }
    return shape;
}

Result<BuiltShape> ShapeFactory::make(const ShapeDef& shape, std::vector<std::string>& notes) {
    Hasher hasher;
    add_content(hasher, shape);
    const std::uint64_t key = hasher.digest();
    if (const auto known = shapes_.find(key); known != shapes_.end()) return known->second;

    const Result<physics::ShapeId> id = physics_.create_shape(shape, &notes);
    if (!id) return id.error();
    const BuiltShape built{.id = *id,
                           .volume_m3 = volume_of(shape),
                           .inner_radius_m = inner_radius_of(shape),
                           .convex = !std::holds_alternative<MeshShape>(shape) &&
                                     !std::holds_alternative<CompoundShape>(shape) &&
                                     !std::holds_alternative<PlaneShape>(shape)};
    shapes_.emplace(key, built);
    return built;
}

Result<BuiltShape> ShapeFactory::make_from_model(const assets::MeshData& mesh,
                                                 std::uint32_t mesh_id,
                                                 bool as_hull,
                                                 const Vec3& scale,
                                                 std::vector<std::string>& notes) {
    Hasher hasher;
    const std::uint32_t words[] = {0xFFFF'FFFFU, mesh_id, as_hull ? 1U : 0U};
    hasher.add(words, sizeof words);
    add_vector(hasher, scale);
    const std::uint64_t key = hasher.digest();
    if (const auto known = shapes_.find(key); known != shapes_.end()) return known->second;

    Result<BuiltShape> built = make(scaled(as_hull ? hull_of(mesh) : mesh_of(mesh), scale), notes);
    if (built) shapes_.emplace(key, *built);
    return built;
}

}  // namespace plumbline::scene
