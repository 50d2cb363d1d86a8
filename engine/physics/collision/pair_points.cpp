#include "engine/physics/collision/pair_points.h"

#include "engine/physics/collision/mesh/convex_mesh.h"
#include "engine/physics/collision/narrow_phase/placed_convex.h"
#include "engine/physics/world/body_record.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace plumbline::physics {
namespace {

/// What a convex part is round about, if that goes through its body's centre of mass; world axes. Zero: nothing.
Vec3 symmetry_axis(const BodyRecord& body, const PlacedShape& part) {
    using Kind = ConvexShape::Kind;
    if (part.shape.kind != Kind::Cylinder && part.shape.kind != Kind::Cone) return {0, 0, 0};
    constexpr Real kBeside = 1e-4_r;  // of the radius
    const Vec3 axis = part.world_from_shape.rotation[1];
    const Vec3 beside =
        glm::cross(part.world_from_shape.position_m - body.motion->at.position_m, axis);
    const Real most_m = kBeside * part.shape.radius_m;
    return glm::dot(beside, beside) > most_m * most_m ? Vec3{0, 0, 0} : axis;
}

/// Whether a flat face looks along `outward`.
bool is_face(const PlacedShape& part, const Vec3& outward) {
    constexpr double kSame = 1 - 1e-6;
    const PlacedConvex convex = placed_convex(part, Vec3d(part.world_from_shape.position_m));
    const FacePlane face = face_along(convex, Vec3d(outward));
    return face.exists && glm::dot(face.normal, Vec3d(outward)) > kSame;
}

ContactSide side_of(const BodyRecord& body,
                    const PlacedShape* part,
                    const Vec3& on_surface,
                    const Vec3& outward) {
    const Transform& at = body.motion->at;
    RoundSide round{.center = on_surface};
    if (part != nullptr && part->shape.may_be_round())
        round = round_side(*part, on_surface, outward);
    ContactSide side{.radius_m = round.radius_m,
                     .offset_m = round.center - at.position_m,
                     .surface_m = on_surface,
                     .local_m = unrotated(on_surface - at.position_m, at.rotation)};
    if (part != nullptr && round.radius_m == 0) side.axis = symmetry_axis(body, *part);
    return side;
}

ManifoldPoint point_on(const Manifold& manifold,
                       const ManifoldParts& parts,
                       const ConvexPoint& found) {
    const Vec3 on_a = found.on_b + found.normal * found.distance_m;
    ManifoldPoint point{.normal_world = found.normal,
                        .distance_m = found.distance_m,
                        .a = side_of(*manifold.a, parts.a, on_a, -found.normal),
                        .b = side_of(*manifold.b, parts.b, found.on_b, found.normal)};
    if (point.a.radius_m > 0 && point.b.radius_m == 0 && parts.b != nullptr)
        point.b.is_moving_face = pushable(*manifold.b) && is_face(*parts.b, found.normal);
    if (point.b.radius_m > 0 && point.a.radius_m == 0 && parts.a != nullptr)
        point.a.is_moving_face = pushable(*manifold.a) && is_face(*parts.a, -found.normal);
    return point;
}

/// A point of a mesh is the same while it moves by less: a share of the shape, or anywhere on what rolls.
Real same_m(const ConvexShape& shape) {
    constexpr double kSameMeshShare = 0.1;
    const PlacedConvex convex = placed_convex({shape, Transform{}}, Vec3d{0, 0, 0});
    return convex.radius_m > 0 ? std::numeric_limits<Real>::infinity()
                               : static_cast<Real>(kSameMeshShare * size_of(convex));
}

const CollisionFilter& filter_of(const BodyRecord& body, const GeometryPart& part) {
    return part.own ? part.own->filter : body.filter;
}

/// Finds the points of one pair of bodies.
class PairPoints {
public:
    PairPoints(Pair& pair, const CollideStep& step) : pair_(pair), step_(step) {}

    void find() {
        const BodyGeometry& a = *pair_.a->traits.geometry;
        const BodyGeometry& b = *pair_.b->traits.geometry;
        for (Manifold& manifold : pair_.manifolds) manifold.found = false;
        if (a.mesh != nullptr || b.mesh != nullptr)
            collide_with_triangles();
        else if (a.parts.size() == 1 && b.parts.size() == 1)
            collide_parts(0, 0);
        else
            collide_all_parts();
        std::erase_if(pair_.manifolds, [](const Manifold& manifold) { return !manifold.found; });
    }

private:
    /// The parts of the body that has fewer, each against those of the other that its box meets.
    void collide_all_parts() {
        const bool a_is_few =
            pair_.a->traits.geometry->parts.size() <= pair_.b->traits.geometry->parts.size();
        const BodyRecord& few = a_is_few ? *pair_.a : *pair_.b;
        const BodyRecord& many = a_is_few ? *pair_.b : *pair_.a;
        const std::vector<GeometryPart>& of_few = few.traits.geometry->parts;
        const std::vector<GeometryPart>& of_many = many.traits.geometry->parts;
        const Transform many_from_few = inverse(many.motion->at) * few.motion->at;
        for (std::uint32_t i = 0; i < of_few.size(); ++i) {
            Bounds near = moved(of_few[i].bounds, many_from_few);
            near.low -= static_cast<double>(pair_.reach_m);
            near.high += static_cast<double>(pair_.reach_m);
            for (std::uint32_t k = 0; k < of_many.size(); ++k) {
                if (!overlap(near, of_many[k].bounds)) continue;
                if (a_is_few)
                    collide_parts(i, k);
                else
                    collide_parts(k, i);
            }
        }
    }

    void collide_parts(std::uint32_t part_a, std::uint32_t part_b) {
        const GeometryPart& a = pair_.a->traits.geometry->parts[part_a];
        const GeometryPart& b = pair_.b->traits.geometry->parts[part_b];
        if ((a.own || b.own) && !may_touch(filter_of(*pair_.a, a), filter_of(*pair_.b, b))) return;
        const Transform at_a = pair_.a->motion->at * a.mass_from_part;
        const Transform at_b = pair_.b->motion->at * b.mass_from_part;
        const PlacedShape placed_a{a.shape, at_a};
        const PlacedShape placed_b{b.shape, at_b};
        const ConvexContact found = collide(placed_a, placed_b, pair_.reach_m);
        if (found.count == 0) return;
        Manifold& manifold = manifold_of(part_a, part_b);
        renew_points(manifold, {&placed_a, &placed_b}, found.points(), found.same_m, step_);
        keep_reachable(manifold);
    }

    /// The convex parts of one body, each against the triangles of the other.
    void collide_with_triangles() {
        const bool mesh_is_a = pair_.a->traits.geometry->mesh != nullptr;
        const BodyRecord& body = mesh_is_a ? *pair_.b : *pair_.a;
        const BodyRecord& mesh = mesh_is_a ? *pair_.a : *pair_.b;
        std::vector<MeshPatch> patches;
        std::vector<ConvexPoint> found;
        const std::vector<GeometryPart>& parts = body.traits.geometry->parts;
        for (std::uint32_t i = 0; i < parts.size(); ++i) {
            if (parts[i].own && !may_touch(parts[i].own->filter, mesh.filter)) continue;
            const Transform at = body.motion->at * parts[i].mass_from_part;
            const PlacedShape part{parts[i].shape, at};
            collide_with_mesh(
                part, *mesh.traits.geometry->mesh, mesh.motion->at, pair_.reach_m, patches);
            found.clear();
            for (const MeshPatch& patch : patches) {
                for (std::size_t k = 0; k < patch.count; ++k) {
                    const auto& [on_mesh, distance_m] = patch.points[k];
                    found.push_back(mesh_is_a ? ConvexPoint{-patch.normal,
                                                            on_mesh + patch.normal * distance_m,
                                                            distance_m}
                                              : ConvexPoint{patch.normal, on_mesh, distance_m});
                }
            }
            if (found.empty()) continue;
            Manifold& manifold = mesh_is_a ? manifold_of(0, i) : manifold_of(i, 0);
            const ManifoldParts sides =
                mesh_is_a ? ManifoldParts{nullptr, &part} : ManifoldParts{&part, nullptr};
            renew_points(manifold, sides, found, same_m(parts[i].shape), step_);
            keep_reachable(manifold);
        }
    }

    void keep_reachable(Manifold& manifold) const {
        const Real always_m = near_m(pair_);
        if (pair_.reach_m <= always_m) return;
        for (std::size_t i = manifold.points.size(); i-- > 0;) {
            if (!is_reachable(manifold, manifold.points[i], always_m, step_))
                remove_point(manifold, i);
        }
    }

    /// Manifolds are in the order of their parts.
    Manifold& manifold_of(std::uint32_t part_a, std::uint32_t part_b) {
        const auto is_before = [=](const Manifold& manifold,
                                   std::pair<std::uint32_t, std::uint32_t> key) {
            return std::pair(manifold.part_a, manifold.part_b) < key;
        };
        const std::pair key{part_a, part_b};
        auto place =
            std::lower_bound(pair_.manifolds.begin(), pair_.manifolds.end(), key, is_before);
        if (place == pair_.manifolds.end() || std::pair(place->part_a, place->part_b) != key) {
            place = pair_.manifolds.insert(
                place, {.a = pair_.a, .b = pair_.b, .part_a = part_a, .part_b = part_b});
            place->material = step_.rules == nullptr
                                  ? material_of(*place)
                                  : step_.rules->combined(pair_.a->user, pair_.b->user);
        }
        place->found = true;
        return *place;
    }

    Pair& pair_;
    const CollideStep& step_;
};

}  // namespace

void find_points(Pair& pair, const CollideStep& step) {
    pair.reach_m = reach_of(pair, step);
    pair.predicted_mps = predicted_mps(pair);
    PairPoints(pair, step).find();
    pair.touches = std::ranges::any_of(
        pair.manifolds, [](const Manifold& manifold) { return !manifold.points.empty(); });
}

Material material_of(const Manifold& manifold) {
    const auto of_part = [](const BodyRecord& body, std::uint32_t part) {
        const std::vector<GeometryPart>& parts = body.traits.geometry->parts;
        return part < parts.size() && parts[part].own ? parts[part].own->material
                                                      : body.traits.material;
    };
    return combined(of_part(*manifold.a, manifold.part_a), of_part(*manifold.b, manifold.part_b));
}

void separate(Pair& pair) {
    pair.touches = false;
    pair.manifolds.clear();
}

void renew_points(Manifold& manifold,
                  const ManifoldParts& parts,
                  std::span<const ConvexPoint> found,
                  Real same_m,
                  const CollideStep& step) {
    std::vector<ManifoldPoint>& points = manifold.points;
    const std::size_t old_count = points.size();
    points.reserve(old_count + found.size());
    for (const ConvexPoint& point : found) points.push_back(point_on(manifold, parts, point));

    const auto old = std::span(points).first(old_count);
    for (ManifoldPoint& point : std::span(points).subspan(old_count)) {
        ManifoldPoint* const before = nearest_point(old, point, same_m);
        if (before != nullptr) {
            point.age_steps = before->age_steps + (step.refined ? 0 : 1);
            point.load = before->load;
            if (step.again) point.normal_Ns = before->normal_Ns;
            // One that is found twice is a new point the second time.
            point.feature = std::exchange(before->feature, 0);
        }
        if (point.feature == 0) point.feature = ++manifold.features_made;
    }
    points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(old_count));
}

}  // namespace plumbline::physics
