// Coarser versions of a mesh for when it is far off. Pure arithmetic on mesh data; no GL.
//
// Loose cards of foliage (leaves, petals, blades of grass) become fewer and larger: the crown stays
// as dense. Of everything else, edges are collapsed (assets/model/mesh_simplify.h).
#pragma once

#include "engine/assets/asset_library.h"

#include <map>
#include <vector>

namespace plumbline::render {

struct MeshLod {
    float error_m{0.0F};  ///< how far a point may have moved, in body space
    std::vector<assets::SubMesh> sub_meshes;
    /// The same parts, foliage near to far, by the side that they are seen from (foliage_order.h);
    /// empty: none of them is dense.
    std::vector<std::vector<assets::SubMesh>> by_side;
};

/// By mesh, the finest first; a mesh without an entry has none.
using LodTable = std::map<assets::MeshId, std::vector<MeshLod>>;

/// Appends the vertices and indices of coarser versions; the mesh's own stay as they are. Nothing
/// for meshes that are cheap already. `is_foliage` by sub-mesh; parts beyond its end are none.
std::vector<MeshLod> add_lods(assets::MeshData& mesh, const std::vector<bool>& is_foliage);

}  // namespace plumbline::render
