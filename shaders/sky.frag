// The sky behind everything. Passes: sky. Reads the sky's cube map.
#include "include/blocks.glsl"
#include "include/color.glsl"

in vec2 screen_uv;
in vec3 ray_world;
flat in float sky_brightness;
uniform samplerCube sky_map;

layout(location = 0) out vec4 out_color;

void main() {
    vec3 color = texture(sky_map, ray_world).rgb;
#ifdef PL_SKY_CODES
    color = linear_from_srgb(color);
#endif
    color *= sky_brightness;
#ifdef PL_CODES
    color = srgb_from_linear(color);
#endif
    out_color = vec4(color, 1.0);
}
