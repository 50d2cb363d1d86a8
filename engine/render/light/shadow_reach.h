// Where the sun's shadows can fall on a large plain thing, as a floor is: the rest of it is drawn
// without a look at the shadow map. Pure arithmetic.
#pragma once

#include "engine/assets/asset_library.h"
#include "engine/render/culling/convex_volume.h"
#include "engine/render/render_frame.h"

#include <optional>

namespace plumbline::render {

/// Nothing that the mesh casts falls on itself where it faces the light. Told of meshes of up to 64
/// triangles; others are not said to be convex.
bool is_convex(const assets::MeshData& mesh);

/// Holds every place that something but the item shadows; nothing: there is no such place. `margin_m`:
/// how far beside its caster a shadow may be drawn.
std::optional<ConvexVolume> shadows_of_others(const RenderFrame& frame,
                                              const assets::AssetLibrary& library,
                                              const DrawItem& receiver,
                                              const Vec3f& light_direction_world,
                                              float margin_m);

/// Whether the item, if convex, casts on no other: each lies before one of its faces that the light falls
/// on, up to `sunk_m` in it.
bool shades_nothing(const RenderFrame& frame,
                    const assets::AssetLibrary& library,
                    const DrawItem& caster,
                    const Vec3f& light_direction_world,
                    float sunk_m);

}  // namespace plumbline::render
