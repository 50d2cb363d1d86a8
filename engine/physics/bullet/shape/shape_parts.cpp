#include "engine/physics/bullet/shape/shape_parts.h"

#include "engine/core/limits.h"
#include "engine/physics/bullet/convert.h"
#include "engine/physics/bullet/shape/hull.h"

#include <BulletCollision/CollisionShapes/btConvexPolyhedron.h>
#include <LinearMath/btConvexHullComputer.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

/// The fault of a length, or nothing.
std::string length_fault(std::string_view what, Real value) {
    if (std::isfinite(value) && static_cast<double>(value) >= limits::kSizeMin_m &&
        static_cast<double>(value) <= limits::kSizeMax_m) {
        return {};
    }
    return fmt::format("{} is {} m; it must lie between {} and {} m",
                       what,
                       value,
                       limits::kSizeMin_m,
                       limits::kSizeMax_m);
}

std::string size_fault(std::initializer_list<std::pair<std::string_view, Real>> lengths) {
    for (const auto& [what, value] : lengths) {
        if (std::string fault = length_fault(what, value); !fault.empty()) return fault;
    }
    return {};
}

Quat real_quat(const Quatd& q) {
    return Quat{static_cast<Real>(q.w),
                static_cast<Real>(q.x),
                static_cast<Real>(q.y),
                static_cast<Real>(q.z)};
}

/// Largest skin of a shape: 4 cm as Bullet has it for things of 2 m and more, 2 % of smaller ones.
Real margin_for_size(Real smallest_extent_m) {
    return std::min(0.04_r, 0.02_r * smallest_extent_m);
}

/// A hull whose corners are drawn in by its margin, so that with the margin it is as large as asked.
/// Face against face it shows its outer corners: there Bullet adds no margin.
class InsetHull final : public btConvexHullShape {
public:
    InsetHull(const btAlignedObjectArray<btVector3>& inner, std::vector<btVector3> outer)
        : btConvexHullShape(&inner[0].x(), inner.size()), outer_(std::move(outer)) {}

    int getNumVertices() const override { return static_cast<int>(outer_.size()); }
    void getVertex(int i, btVector3& corner) const override {
        corner = outer_[static_cast<std::size_t>(i)];
    }

private:
    std::vector<btVector3> outer_;
};

/// Whether Bullet found a closed surface; it gives up on some small shapes and then crashes on them.
bool sound_faces(const btPolyhedralConvexShape& shape) {
    const btConvexPolyhedron* surface = shape.getConvexPolyhedron();
    if (surface == nullptr || surface->m_faces.size() < 4) return false;
    for (int f = 0; f < surface->m_faces.size(); ++f) {
        const btFace& face = surface->m_faces[f];
        const btVector3 normal(face.m_plane[0], face.m_plane[1], face.m_plane[2]);
        if (face.m_indices.size() < 3 || std::abs(normal.length2() - 1) > btScalar(1e-3)) {
            return false;
        }
    }
    return true;
}

/// Makes the shape, with faces where Bullet can: then whole faces meet, not one corner a step.
template <class Make>
std::unique_ptr<btConvexShape> with_faces(Make&& make) {
    auto shape = make();
    shape->initializePolyhedralFeatures();
    if (!sound_faces(*shape)) shape = make();
    return shape;
}

std::unique_ptr<btConvexShape> box_of(const Vec3& size) {
    return with_faces([&size] {
        auto box = std::make_unique<btBoxShape>(to_bullet(size * 0.5_r));
        box->setMargin(margin_for_size(std::min({size.x, size.y, size.z})));
        return box;
    });
}

using Kind = ConvexShape::Kind;

class PartBuilder {
public:
    PartBuilder(std::vector<ShapePart>& parts, std::vector<std::string>* notes)
        : parts_(parts), notes_(notes) {}

    bool uses_plane() const { return uses_plane_; }

    Result<Done> add(const ShapeDef& def, const Pose& body_from_shape) {
        return std::visit([&](const auto& shape) { return build(shape, body_from_shape); }, def);
    }

private:
    Result<Done> build(const BoxShape& box, const Pose& frame) {
        const Vec3 s = box.size_m;
        if (auto fault = size_fault({{"width", s.x}, {"height", s.y}, {"depth", s.z}});
            !fault.empty()) {
            return refused_shape("box: " + fault);
        }
        return keep(box_of(s),
                    {.kind = Kind::Box, .half_m = s * 0.5_r},
                    frame,
                    mass_of_box(Vec3d{s}),
                    0.5_r * std::min({s.x, s.y, s.z}));
    }

    Result<Done> build(const SphereShape& sphere, const Pose& frame) {
        const Real r = sphere.radius_m;
        if (auto fault = size_fault({{"radius", r}}); !fault.empty()) {
            return refused_shape("sphere: " + fault);
        }
        return keep(std::make_unique<btSphereShape>(r),
                    {.kind = Kind::Sphere, .radius_m = r},
                    frame,
                    mass_of_sphere(static_cast<double>(r)),
                    r);
    }

    Result<Done> build(const CylinderShape& cylinder, const Pose& frame) {
        const Real r = cylinder.radius_m;
        const Real h = cylinder.height_m;
        if (auto fault = size_fault({{"radius", r}, {"height", h}}); !fault.empty()) {
            return refused_shape("cylinder: " + fault);
        }
        auto shape = std::make_unique<btCylinderShape>(btVector3(r, h * 0.5_r, r));
        shape->setMargin(margin_for_size(std::min(2 * r, h)));
        return keep(std::move(shape),
                    {.kind = Kind::Cylinder, .radius_m = r, .half_height_m = h * 0.5_r},
                    frame,
                    mass_of_cylinder(static_cast<double>(r), static_cast<double>(h)),
                    std::min(r, 0.5_r * h));
    }

    Result<Done> build(const CapsuleShape& capsule, const Pose& frame) {
        const Real r = capsule.radius_m;
        const Real h = capsule.height_m;
        if (auto fault = size_fault({{"radius", r}, {"height", h}}); !fault.empty()) {
            return refused_shape("capsule: " + fault);
        }
        return keep(std::make_unique<btCapsuleShape>(r, h),
                    {.kind = Kind::Capsule, .radius_m = r, .half_height_m = h * 0.5_r},
                    frame,
                    mass_of_capsule(static_cast<double>(r), static_cast<double>(h)),
                    r);
    }

    Result<Done> build(const ConeShape& cone, const Pose& frame) {
        const Real r = cone.radius_m;
        const Real h = cone.height_m;
        if (auto fault = size_fault({{"radius", r}, {"height", h}}); !fault.empty()) {
            return refused_shape("cone: " + fault);
        }
        // Bullet wraps its margin round the cone, so the cone itself is drawn in by as much.
        const Real margin = margin_for_size(std::min(2 * r, h));
        const Real slant = std::sqrt(r * r + h * h);
        const Real top = 0.5_r * h - margin * slant / r;
        const Real bottom = -0.5_r * h + margin;
        const Real inner_h = top - bottom;
        auto shape = std::make_unique<btConeShape>(inner_h * r / h, inner_h);
        shape->setMargin(margin);
        const Vec3 shift{0, 0.5_r * (top + bottom), 0};
        const SolidMass mass = moved(mass_of_cone(static_cast<double>(r), static_cast<double>(h)),
                                     -Vec3d{shift},
                                     Quatd{1, 0, 0, 0});
        // The largest ball round the centre of mass, a quarter of the height above the base.
        const Real core = std::min(0.25_r * h, 0.75_r * h * r / slant);
        auto kept = keep(std::move(shape),
                         {.kind = Kind::Cone, .radius_m = r, .half_height_m = h * 0.5_r},
                         compose(frame, Pose{.position = shift}),
                         mass,
                         core);
        parts_.back().part_from_convex.position = -shift;
        return kept;
    }

    Result<Done> build(const PlaneShape& plane, const Pose& frame) {
        const Vec3 s{plane.size_m.x, plane.thickness_m, plane.size_m.y};
        if (auto fault = size_fault({{"width", s.x}, {"thickness", s.y}, {"depth", s.z}});
            !fault.empty()) {
            return refused_shape("plane: " + fault);
        }
        uses_plane_ = true;
        const Pose lowered{.position = {0, -0.5_r * s.y, 0}};
        return keep(box_of(s),
                    {.kind = Kind::Box, .half_m = s * 0.5_r},
                    compose(frame, lowered),
                    mass_of_box(Vec3d{s}),
                    0);
    }

    Result<Done> build(const HullShape& hull, const Pose& frame) {
        if (hull.points_m.size() < 4) {
            return refused_shape(
                fmt::format("hull: {} points; a hull needs at least 4", hull.points_m.size()));
        }
        Vec3 low = hull.points_m.front();
        Vec3 high = low;
        for (const Vec3& point : hull.points_m) {
            if (!is_finite(point)) return refused_shape("hull: a point is not finite");
            low = glm::min(low, point);
            high = glm::max(high, point);
        }
        const Vec3 size = high - low;
        const Real largest = std::max({size.x, size.y, size.z});
        if (auto fault = size_fault({{"largest extent", largest}}); !fault.empty()) {
            return refused_shape("hull: " + fault);
        }
        const HullSurface surface = hull_of(hull.points_m);
        if (too_flat(surface, static_cast<double>(largest))) return add_flat(hull, frame);
        if (surface.dropped > 0) {
            note(fmt::format("hull: {} corners, reduced to {}",
                             surface.corners_m.size() + surface.dropped,
                             surface.corners_m.size()));
        }
        return add_hull(surface, frame);
    }

    Result<Done> add_flat(const HullShape& hull, const Pose& frame) {
        const FlatBox flat = flat_box_around(hull.points_m);
        note(fmt::format(
            "hull: its points are flat; a box of {:.4g} x {:.4g} x {:.4g} m stands for them",
            flat.size_m.x,
            flat.size_m.y,
            flat.size_m.z));
        const Pose placed{.position = Vec3{flat.center_m},
                          .orientation = real_quat(flat.orientation)};
        const Vec3 s{flat.size_m};
        return keep(box_of(s),
                    {.kind = Kind::Box, .half_m = s * 0.5_r},
                    compose(frame, placed),
                    mass_of_box(flat.size_m),
                    0.5_r * std::min({s.x, s.y, s.z}));
    }

    Result<Done> add_hull(const HullSurface& surface, const Pose& frame) {
        SolidMass mass = mass_of_triangles(surface.corners_m, surface.triangles);
        const PrincipalFrame principal = principal_frame(mass.inertia);
        const Pose placed{.position = Vec3{mass.center_m},
                          .orientation = real_quat(principal.orientation)};
        const Quatd turn_back = glm::conjugate(principal.orientation);
        std::vector<Vec3d> corners;
        for (const Vec3d& corner : surface.corners_m)
            corners.push_back(turn_back * (corner - mass.center_m));

        const double margin =
            static_cast<double>(margin_for_size(static_cast<Real>(surface.width_m)));
        // Bullet adds the margin outside, so the corners are drawn in by as much.
        btConvexHullComputer inner;
        inner.compute(&corners[0].x,
                      sizeof(Vec3d),
                      static_cast<int>(corners.size()),
                      static_cast<btScalar>(margin),
                      0);
        std::vector<btVector3> outer;
        for (const Vec3d& corner : corners) outer.push_back(bullet_from_double(corner));
        auto shape = with_faces([&] {
            auto hull = std::make_unique<InsetHull>(inner.vertices, outer);
            hull->setMargin(static_cast<btScalar>(margin));
            return hull;
        });

        double core = static_cast<double>(limits::kSizeMax_m);
        for (const auto& t : surface.triangles) {
            const Vec3d n =
                glm::cross(corners[t[1]] - corners[t[0]], corners[t[2]] - corners[t[0]]);
            const double length = glm::length(n);
            if (length > 0) core = std::min(core, glm::dot(corners[t[0]], n) / length);
        }
        mass = moved(mass, turn_back * -mass.center_m, turn_back);
        auto geometry =
            std::make_shared<const HullGeometry>(hull_geometry(corners, surface.triangles));
        auto kept = keep(std::move(shape),
                         {.kind = Kind::Hull, .hull = geometry.get()},
                         compose(frame, placed),
                         mass,
                         static_cast<Real>(core));
        parts_.back().hull = std::move(geometry);
        return kept;
    }

    Result<Done> build(const MeshShape&, const Pose&) {
        return refused_shape("compound: a mesh may not be part of a compound; use hulls");
    }

    Result<Done> build(const CompoundShape& compound, const Pose& frame) {
        if (compound.children.empty()) return refused_shape("compound: it has no children");
        for (const CompoundChild& child : compound.children) {
            if (!is_finite(child.body_from_child))
                return refused_shape("compound: a child's place is not finite");
            auto added = add(child.shape, compose(frame, child.body_from_child));
            if (!added) return added;
        }
        return Done{};
    }

    Result<Done> keep(std::unique_ptr<btConvexShape> shape,
                      const ConvexShape& convex,
                      const Pose& frame,
                      const SolidMass& mass,
                      Real core) {
        parts_.push_back({.shape = std::move(shape),
                          .body_from_part = frame,
                          .convex = convex,
                          .mass = mass,
                          .inner_radius_m = core});
        return Done{};
    }

    void note(std::string text) {
        if (notes_ != nullptr) notes_->push_back(std::move(text));
    }

    std::vector<ShapePart>& parts_;
    std::vector<std::string>* notes_;
    bool uses_plane_{false};
};

}  // namespace

Error refused_shape(std::string why) {
    return {.message = "shape: " + std::move(why), .exit_code = ExitCode::Refused};
}

Result<ShapeParts> build_parts(const ShapeDef& def, std::vector<std::string>* notes) {
    ShapeParts result;
    PartBuilder builder(result.parts, notes);
    auto added = builder.add(def, Pose{});
    if (!added) return added.error();
    result.static_only = builder.uses_plane();
    return result;
}

}  // namespace plumbline::physics
