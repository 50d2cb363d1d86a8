// Triangles on the CPU, as files and generators give them and as the renderer uploads them.
#pragma once

#include "engine/core/bounds.h"
#include "engine/core/math.h"

#include <cstdint>
#include <vector>

namespace plumbline::assets {

/// How a vertex moves in the wind, in 255ths.
struct WindWeights {
    std::uint8_t sway{0};     ///< how far it is carried along: 0 at the root, 255 at the freest tip
    std::uint8_t phase{0};    ///< of its swinging, in turns: equal on one branch
    std::uint8_t flutter{0};  ///< how much it trembles across its surface
    std::uint8_t unused{0};

    friend bool operator==(const WindWeights&, const WindWeights&) = default;
};

/// Body frame, metres. 64 bytes. cross(normal, tangent.xyz) * tangent.w runs *up* the image
/// (towards smaller v), as glTF has it, so that normal maps with +Y up work unchanged.
struct Vertex {
    Vec3f position_body{0.0F};
    Vec3f normal_body{0.0F, 1.0F, 0.0F};         ///< unit
    Vec4f tangent_body{1.0F, 0.0F, 0.0F, 1.0F};  ///< xyz unit along +u; w +-1, see below
    Vec2f uv{0.0F};                              ///< v runs down the image, as in glTF
    Vec3f color{1.0F};                           ///< linear; multiplies the base colour
    WindWeights wind{};                          ///< zero: stands still in any wind
};

/// A run of indices with one material.
struct SubMesh {
    std::uint32_t first_index{0};
    std::uint32_t index_count{0};
    std::uint32_t material{0};  ///< index into ModelData::materials
};

/// Counter-clockwise triangles seen from outside.
struct MeshData {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<SubMesh> sub_meshes;  ///< cover all indices
    Aabb bounds;                      ///< body frame
    std::uint32_t version{0};         ///< another number: other triangles, to be uploaded again
};

Aabb bounds_of(const MeshData& mesh);
/// Whether any of it moves in the wind.
bool sways(const MeshData& mesh);
/// Replaces Vertex::normal_body by the area-weighted mean of the triangles that share the vertex.
void compute_normals(MeshData& mesh);
/// Fills Vertex::tangent_body from positions, unit normals and texture coordinates: directions of
/// Lengyel 2001, weighted by corner angles, orthogonal to the normal. Vertices without usable
/// texture coordinates get some tangent orthogonal to their normal.
void compute_tangents(MeshData& mesh);
/// Of triangles and normals: all of one material, with bounds and tangents.
MeshData finished(MeshData mesh);

}  // namespace plumbline::assets
