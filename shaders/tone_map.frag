// Radiance to what a screen shows: bloom added, exposure and tone curve where the frame asks for
// them, sRGB. The only place where light is encoded. Passes: post. Reads the scene's image, the
// bloom image and, where lines follow, the depth image.
#include "include/blocks.glsl"
#include "include/color.glsl"
#include "include/scene_light.glsl"

in vec2 screen_uv;
in vec3 ray_world;
#ifdef PL_BLOOM
uniform sampler2D bloom_image;
#endif
#if defined(PL_KEEP_DEPTH) && !defined(PL_OCCLUSION) && !defined(PL_SHAFTS)
uniform sampler2D depth_image;
#endif

layout(location = 0) out vec4 out_color;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
#ifdef PL_FOUR_SAMPLES
    vec3 color = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        // What the screen cannot show must not outshine its neighbours.
        color += min(scene_light(at * 2 + ivec2(i & 1, i >> 1)), 1.0) * 0.25;
    }
#else
    vec3 color = scene_light(at);
#endif
#ifdef PL_BLOOM
    color = mix(color, texture(bloom_image, screen_uv).rgb, frame.tone.y);
#endif
#ifdef PL_TONE_MAP
    color = tone_mapped(color, frame.tone.x);
#endif
    color = srgb_from_linear(color);
#ifdef PL_KEEP_DEPTH
    gl_FragDepth = texture(depth_image, screen_uv).r;
#endif
#ifdef PL_FXAA
    // The pass that smooths and sharpens wants to know how bright a pixel looks.
    out_color = vec4(color, dot(color, vec3(0.299, 0.587, 0.114)));
#else
    out_color = vec4(color, 1.0);
#endif
}
