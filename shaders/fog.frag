// Fog over opaque surfaces and the sky, blended by the share of their light that it replaces. Passes: fog.
// Reads the depth image.
#include "include/blocks.glsl"
#include "include/fog.glsl"
#include "include/view_depth.glsl"

in vec2 screen_uv;
in vec3 ray_world;
uniform float has_sky;  // 1: the farthest depth is the sky's; 0: a background's at that distance

layout(location = 0) out vec4 out_color;

void main() {
    float depth = texelFetch(depth_image, ivec2(gl_FragCoord.xy), 0).r;
    float ray_m = length(ray_world);
    float transmittance = depth * has_sky >= 1.0
                              ? sky_transmittance(ray_world / ray_m)
                              : fog_transmittance(ray_m * view_depth(depth));
    out_color = vec4(frame.fog.rgb, 1.0 - transmittance);
}
