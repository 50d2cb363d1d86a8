// Radiance to the screen: bloom added, exposure, tone curve, sRGB. Passes: post. Reads the HDR
// image, the bloom image and, where lines follow, the depth image.
#include "include/blocks.glsl"
#include "include/color.glsl"

in vec2 screen_uv;
in vec3 ray_world;
uniform sampler2D source_image;
#ifdef PL_BLOOM
uniform sampler2D bloom_image;
#endif
#ifdef PL_KEEP_DEPTH
uniform sampler2D depth_image;
#endif

layout(location = 0) out vec4 out_color;

void main() {
    vec3 color = texelFetch(source_image, ivec2(gl_FragCoord.xy), 0).rgb;
#ifdef PL_BLOOM
    color = mix(color, texture(bloom_image, screen_uv).rgb, frame.tone.y);
#endif
#ifdef PL_KEEP_DEPTH
    gl_FragDepth = texelFetch(depth_image, ivec2(gl_FragCoord.xy), 0).r;
#endif
    out_color = vec4(srgb_from_linear(tone_mapped(color, frame.tone.x)), 1.0);
}
