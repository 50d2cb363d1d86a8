// Primitives and collision shapes: { box = … } and its kin, hulls, meshes, compounds.
#include "engine/core/limits.h"
#include "engine/scene/sections/scene_parts.h"

#include <fmt/format.h>

#include <array>

namespace plumbline::scene {
namespace {

constexpr std::array<std::string_view, 6> kPrimitives{
    "box", "sphere", "cylinder", "capsule", "cone", "plane"};
constexpr std::string_view kExpectedPrimitive =
    "one of box = [x, y, z], sphere = r, cylinder = [r, h], capsule = [r, h], cone = [r, h], "
    "plane = [w, d]";
constexpr std::size_t kHullPoints = 10'000;
constexpr std::size_t kCompoundParts = 1'000;

/// [a, b], both lengths.
std::optional<Vec2> read_two_lengths(TableReader& table, std::string_view key) {
    const auto lengths = table.pair(key, kSize_m, "two lengths in m");
    if (!lengths) return {};
    return Vec2{(*lengths)[0], (*lengths)[1]};
}

template <class Round>
std::optional<Primitive> read_round(TableReader& table, std::string_view key) {
    const auto lengths = read_two_lengths(table, key);
    if (!lengths) return {};
    return Round{.radius_m = lengths->x, .height_m = lengths->y};
}

std::optional<std::vector<Vec3>> read_points(TableReader& table,
                                             std::string_view key,
                                             std::size_t min,
                                             std::size_t max) {
    const TomlNode* node = table.find(key);
    const TomlArray* array = node->array();
    if (array == nullptr || array->size() < min || array->size() > max) {
        table.error(key, "{}; expected {} to {} points [x, y, z]", found(*node), min, max);
        return {};
    }
    std::vector<Vec3> points;
    points.reserve(array->size());
    for (std::size_t i = 0; i < array->size(); ++i) {
        const auto point = vector_of((*array)[i],
                                     fmt::format("{}[{}]", table.path_of(key), i),
                                     kCoordinate_m,
                                     table.faults());
        if (!point) return {};
        points.push_back(Vec3(*point));
    }
    return points;
}

std::optional<physics::MeshShape> read_mesh(TableReader& table) {
    physics::MeshShape mesh;
    const TomlNode* node = table.find("triangles");
    auto vertices = read_points(table, "mesh_m", 3, limits::kVertices);
    if (node == nullptr || node->array() == nullptr || node->array()->empty()) {
        table.error("triangles", "missing; expected [[i, j, k], …] beside mesh_m");
        return {};
    }
    if (!vertices) return {};
    mesh.vertices_m = std::move(*vertices);
    const std::size_t count = mesh.vertices_m.size();
    const TomlArray& triangles = *node->array();
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const TomlArray* corners = triangles[t].array();
        bool good = corners != nullptr && corners->size() == 3;
        std::array<std::uint32_t, 3> triangle{};
        for (std::size_t i = 0; good && i < 3; ++i) {
            const auto* index = std::get_if<std::int64_t>(&(*corners)[i].value);
            good = index != nullptr && *index >= 0 && *index < static_cast<std::int64_t>(count);
            if (good) triangle[i] = static_cast<std::uint32_t>(*index);
        }
        if (!good) {
            table.faults().error(triangles[t].location,
                                 fmt::format("{}[{}]", table.path_of("triangles"), t),
                                 "expected [i, j, k] with indices of points from 0 to {}",
                                 count - 1);
            return {};
        }
        mesh.triangles.push_back(triangle);
    }
    return mesh;
}

physics::ShapeDef shape_of(const Primitive& primitive) {
    return std::visit([](const auto& shape) { return physics::ShapeDef{shape}; }, primitive);
}

std::optional<physics::CompoundChild> read_compound_part(const TomlNode& node,
                                                         const std::string& path,
                                                         FaultList& faults) {
    if (node.table() == nullptr) {
        faults.error(node.location, path, found(node) + "; expected a table with a shape");
        return {};
    }
    TableReader part(node, path, faults);
    physics::CompoundChild child;
    child.body_from_child = read_pose(part);
    const auto primitive = read_primitive(part);
    bool good = true;
    if (part.has("plane")) {
        part.error("plane", "a plane cannot be part of a compound");
        good = false;
    } else if (primitive) {
        child.shape = shape_of(*primitive);
    } else if (part.has("hull_m")) {
        auto points = read_points(part, "hull_m", 4, kHullPoints);
        good = points.has_value();
        if (good) child.shape = physics::HullShape{std::move(*points)};
    } else {
        good = false;
        bool tried = false;
        for (const std::string_view key : kPrimitives) tried = tried || part.has(key);
        if (!tried) part.error("", "no shape; expected {}, or hull_m", kExpectedPrimitive);
    }
    part.finish();
    if (!good) return {};
    return child;
}

BodyShapeDescription read_compound(TableReader& table) {
    physics::CompoundShape compound;
    const TomlNode* node = table.find("compound");
    const TomlArray* parts = node->array();
    if (parts == nullptr || parts->empty() || parts->size() > kCompoundParts) {
        table.error("compound",
                    "{}; expected 1 to {} tables with a shape each",
                    found(*node),
                    kCompoundParts);
        return FitShape{};
    }
    for (std::size_t i = 0; i < parts->size(); ++i) {
        auto child = read_compound_part(
            (*parts)[i], fmt::format("{}[{}]", table.path_of("compound"), i), table.faults());
        if (child) compound.children.push_back(std::move(*child));
    }
    return physics::ShapeDef{std::move(compound)};
}

/// `hull = "model"` and `mesh = "model"` name the entity's own model.
void check_names_model(TableReader& table, std::string_view key) {
    std::string named = "model";
    table.read(key, named);
    if (named == "model") return;
    table.error(key,
                "{}; expected \"model\", the entity's own (or {}_m with points)",
                found(*table.find(key)),
                key);
}

}  // namespace

std::optional<Primitive> read_primitive(TableReader& table) {
    std::string_view kind;
    for (const std::string_view key : kPrimitives) {
        if (!table.has(key)) continue;
        if (!kind.empty()) {
            table.error(key, "given beside {}; a shape is one of them", kind);
            continue;
        }
        kind = key;
    }
    if (kind == "box") {
        std::optional<Vec3> size;
        table.read(kind, size, kSize_m);
        if (!size) return {};
        return physics::BoxShape{*size};
    }
    if (kind == "sphere") {
        const auto radius = table.number(kind, kSize_m);
        if (!radius) return {};
        return physics::SphereShape{*radius};
    }
    if (kind == "cylinder") return read_round<physics::CylinderShape>(table, kind);
    if (kind == "capsule") return read_round<physics::CapsuleShape>(table, kind);
    if (kind == "cone") return read_round<physics::ConeShape>(table, kind);
    if (kind == "plane") {
        const auto size = read_two_lengths(table, kind);
        if (!size) return {};
        return physics::PlaneShape{.size_m = *size};
    }
    return {};
}

std::optional<Primitive> read_entity_primitive(TableReader& entity) {
    // A prefab's primitive is replaced as a whole: parts of two shapes make none.
    const TomlNode* node = entity.find("primitive");
    if (node == nullptr) return {};
    if (node->table() == nullptr) {
        entity.error("primitive", "{}; expected {{ {} }}", found(*node), kExpectedPrimitive);
        return {};
    }
    TableReader table(*node, entity.path_of("primitive"), entity.faults());
    const auto primitive = read_primitive(table);
    if (node->table()->empty()) table.error("", "is empty; expected {}", kExpectedPrimitive);
    table.finish();
    return primitive;
}

BodyShapeDescription read_body_shape(TableReader& body, const VisualDescription& visual) {
    const TomlNode* node = body.find("shape");
    if (node == nullptr) return FitShape{};
    if (const std::string* text = node->text(); text != nullptr && *text == "fit")
        return FitShape{};
    if (node->table() == nullptr) {
        body.error(
            "shape",
            "{}; expected \"fit\" or a table with {}, hull, hull_m, mesh, mesh_m or compound",
            found(*node),
            kExpectedPrimitive);
        return FitShape{};
    }
    TableReader table(*node, body.path_of("shape"), body.faults());
    BodyShapeDescription shape{FitShape{}};
    const auto primitive = read_primitive(table);
    int primitives = 0;
    for (const std::string_view key : kPrimitives) primitives += table.has(key) ? 1 : 0;
    int kinds = primitives;
    for (const std::string_view key : {"hull", "hull_m", "mesh", "mesh_m", "compound"})
        kinds += table.has(key) ? 1 : 0;
    table.find("triangles");

    if (kinds == 0) {
        table.error("",
                    "names no shape; expected {}, hull, hull_m, mesh, mesh_m or compound",
                    kExpectedPrimitive);
    } else if (primitives > 1) {
        return shape;  // said while reading them
    } else if (kinds > 1) {
        table.error("", "names several shapes; expected one (a compound holds several)");
    } else if (primitive) {
        shape = shape_of(*primitive);
    } else if (table.has("hull")) {
        check_names_model(table, "hull");
        shape = ModelHullShape{};
    } else if (table.has("mesh")) {
        check_names_model(table, "mesh");
        shape = ModelMeshShape{};
    } else if (table.has("hull_m")) {
        if (auto points = read_points(table, "hull_m", 4, kHullPoints))
            shape = physics::ShapeDef{physics::HullShape{std::move(*points)}};
    } else if (table.has("mesh_m")) {
        if (auto mesh = read_mesh(table)) shape = physics::ShapeDef{std::move(*mesh)};
    } else if (table.has("compound")) {
        shape = read_compound(table);
    }
    if (table.has("triangles") && !table.has("mesh_m"))
        table.error("triangles", "given without mesh_m");
    const bool names_model = std::holds_alternative<ModelHullShape>(shape) ||
                             std::holds_alternative<ModelMeshShape>(shape);
    if (names_model && std::holds_alternative<Primitive>(visual))
        table.error("", "the entity has a primitive, not a model; expected \"fit\" or a shape");
    table.finish();
    return shape;
}

}  // namespace plumbline::scene
