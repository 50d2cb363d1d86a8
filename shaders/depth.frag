// Leaves only depth behind; with an alpha mask, only where the mask is. Passes: shadows.
#include "include/blocks.glsl"

#ifdef PL_ALPHA_MASK
in vec2 surface_uv;
uniform sampler2D base_color_map;
#endif

void main() {
#ifdef PL_ALPHA_MASK
    if (texture(base_color_map, surface_uv).a * material.base_color.a < material.emissive.w) discard;
#endif
}
