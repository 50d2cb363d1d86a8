// Generated meshes: centred on the origin (the plane: top at y = 0), normals outwards, texture
// coordinates in metres so that a tiling texture keeps its scale on any size.
#pragma once

#include "engine/assets/mesh_data.h"

namespace plumbline::assets {

MeshData box_mesh(const Vec3f& size_m);
MeshData sphere_mesh(float radius_m);
MeshData cylinder_mesh(float radius_m, float height_m);
/// height_m between the centres of the caps.
MeshData capsule_mesh(float radius_m, float height_m);
MeshData cone_mesh(float radius_m, float height_m);
MeshData plane_mesh(const Vec2f& size_m);

}  // namespace plumbline::assets
