// The sky behind everything. Passes: sky. Reads the sky's cube map.
#include "include/blocks.glsl"
#include "include/color.glsl"
#include "include/fog.glsl"

in vec2 screen_uv;
in vec3 ray_world;
uniform samplerCube sky_map;
uniform int sky_is_srgb;

layout(location = 0) out vec4 out_color;

void main() {
    vec3 color = texture(sky_map, ray_world).rgb;
    if (sky_is_srgb != 0) color = linear_from_srgb(color);
    color *= frame.tone.w;
#ifdef PL_FOG
    color = mix(frame.fog.rgb, color, sky_transmittance(normalize(ray_world)));
#endif
#ifdef PL_TONE_MAP
    color = tone_mapped(color, frame.tone.x);
#endif
#ifdef PL_ENCODE
    color = srgb_from_linear(color);
#endif
    out_color = vec4(color, 1.0);
}
