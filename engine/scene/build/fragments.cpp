#include "engine/scene/build/fragments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

namespace plumbline::scene {
namespace {

/// A face with its own normal; textures lie on it in metres.
void add_face(const physics::Polyhedron& solid,
              const physics::PolyhedronFace& face,
              const Vec3d& origin_m,
              assets::MeshData& mesh) {
    const auto corner_m = [&](std::size_t i) {
        return solid.corners_m[face.corners[i]] - origin_m;
    };
    Vec3d normal{0, 0, 0};
    for (std::size_t i = 2; i < face.corners.size(); ++i)
        normal += glm::cross(corner_m(i - 1) - corner_m(0), corner_m(i) - corner_m(0));
    normal = normalize_or(normal, Vec3d{0, 1, 0});
    const Vec3d across = std::abs(normal.y) < 0.9 ? Vec3d{0, 1, 0} : Vec3d{0, 0, 1};
    const Vec3d u = glm::normalize(glm::cross(across, normal));
    const Vec3d v = glm::cross(normal, u);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
        const Vec3d at_m = corner_m(i);
        const Vec3d on_whole_m = at_m + origin_m;
        assets::Vertex vertex;
        vertex.position_body = Vec3f(at_m);
        vertex.normal_body = Vec3f(normal);
        vertex.tangent_body = Vec4f(Vec3f(u), 1.0F);
        vertex.uv = Vec2f(glm::dvec2{glm::dot(on_whole_m, u), -glm::dot(on_whole_m, v)});
        mesh.vertices.push_back(vertex);
        if (i < 2) continue;
        const auto last = static_cast<std::uint32_t>(i);
        mesh.indices.insert(mesh.indices.end(), {first, first + last - 1, first + last});
    }
}

/// What is seen of the pieces together: not what lies between two of them.
assets::MeshData mesh_of_pieces(const physics::FracturePattern& pattern,
                                std::span<const std::uint32_t> pieces,
                                const Vec3d& origin_m) {
    assets::MeshData mesh;
    for (const std::uint32_t piece : pieces) {
        const physics::Polyhedron& solid = pattern.pieces[piece].solid;
        for (const physics::PolyhedronFace& face : solid.faces) {
            const bool is_within =
                face.beyond >= 0 &&
                std::ranges::binary_search(pieces, static_cast<std::uint32_t>(face.beyond));
            if (!is_within) add_face(solid, face, origin_m, mesh);
        }
    }
    mesh.sub_meshes = {{.first_index = 0,
                        .index_count = static_cast<std::uint32_t>(mesh.indices.size()),
                        .material = 0}};
    mesh.bounds = assets::bounds_of(mesh);
    return mesh;
}

physics::ShapeDef hull_of_piece(const physics::FracturePiece& piece, const Vec3d& origin_m) {
    physics::HullShape hull;
    for (const Vec3d& corner : piece.solid.corners_m) hull.points_m.emplace_back(corner - origin_m);
    return hull;
}

physics::ShapeDef shape_of_pieces(const physics::FracturePattern& pattern,
                                  std::span<const std::uint32_t> pieces,
                                  const Vec3d& origin_m) {
    if (pieces.size() == 1) return hull_of_piece(pattern.pieces[pieces[0]], origin_m);
    physics::CompoundShape compound;
    for (const std::uint32_t piece : pieces)
        compound.children.push_back({.shape = hull_of_piece(pattern.pieces[piece], origin_m)});
    return compound;
}

double volume_m3(const physics::FracturePattern& pattern, std::span<const std::uint32_t> pieces) {
    double sum_m3 = 0;
    for (const std::uint32_t piece : pieces) sum_m3 += pattern.pieces[piece].volume_m3;
    return sum_m3;
}

}  // namespace

Vec3d origin_of(const physics::FracturePattern& pattern, std::span<const std::uint32_t> pieces) {
    Vec3d sum{0, 0, 0};
    if (pieces.size() == pattern.pieces.size()) return sum;
    for (const std::uint32_t piece : pieces)
        sum += pattern.pieces[piece].volume_m3 * pattern.pieces[piece].center_m;
    return sum / volume_m3(pattern, pieces);
}

EntityDescription fragment_of(const FragileWhole& whole, std::span<const std::uint32_t> pieces) {
    const Vec3d center_m = origin_of(whole.pattern, pieces);
    EntityDescription part;
    part.label = whole.description.label;
    part.material = whole.description.material;
    part.contact_material = whole.description.contact_material;
    part.casts_shadow = whole.description.casts_shadow;
    part.location = whole.description.location;
    part.visual = MeshVisual{.key = fmt::format("{} of {}", fmt::join(pieces, "+"), whole.name),
                             .mesh = std::make_shared<assets::MeshData>(
                                 mesh_of_pieces(whole.pattern, pieces, center_m))};
    part.body = whole.description.body;
    BodyDescription& body = *part.body;
    body.shape = shape_of_pieces(whole.pattern, pieces, center_m);
    body.mass_kg = static_cast<Real>(whole.density_kgpm3 * volume_m3(whole.pattern, pieces));
    body.magnet.reset();
    body.fracture.reset();
    return part;
}

}  // namespace plumbline::scene
