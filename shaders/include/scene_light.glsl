// The scene's image with what is added to its light after all is drawn: for the pass that reads it
// first.

uniform sampler2D source_image;
#if defined(PL_OCCLUSION) || defined(PL_SHAFTS)
#include "include/view_depth.glsl"
#endif
#ifdef PL_OCCLUSION
uniform sampler2D occlusion_image;
#endif
#ifdef PL_SHAFTS
uniform sampler2D shafts_image;
#endif

#if defined(PL_OCCLUSION) || defined(PL_SHAFTS)
// The first number of a smaller image whose second is the distance, at `place` in its texels: from
// the four round it that lie on the same surface.
float of_same_surface(sampler2D image, vec2 place, float z) {
    vec2 size = vec2(textureSize(image, 0));
    vec2 mean = texture(image, (place + 0.5) / size).rg;
    if (abs(mean.g - z) < 0.02 * z) return mean.r;
    ivec2 low = ivec2(place);
    ivec2 high = min(low + 1, ivec2(size) - 1);
    vec2 a = texelFetch(image, low, 0).rg;
    vec2 b = texelFetch(image, ivec2(high.x, low.y), 0).rg;
    vec2 c = texelFetch(image, ivec2(low.x, high.y), 0).rg;
    vec2 d = texelFetch(image, high, 0).rg;
    vec2 share = fract(place) * 0.9 + 0.05;
    vec4 weights = vec4(1.0 - share.x, share.x, 1.0 - share.x, share.x) *
                   vec4(1.0 - share.y, 1.0 - share.y, share.y, share.y);
    weights /= 0.001 * z + abs(vec4(a.g, b.g, c.g, d.g) - z);
    return dot(weights, vec4(a.r, b.r, c.r, d.r)) / dot(weights, vec4(1.0));
}
#endif

vec3 scene_light(ivec2 at) {
    vec4 texel = texelFetch(source_image, at, 0);
    vec3 color = texel.rgb;
#if defined(PL_OCCLUSION) || defined(PL_SHAFTS)
    float z = min(view_depth(texelFetch(depth_image, at, 0).r), kFarthest_m);
#endif
#ifdef PL_OCCLUSION
    // Alpha: the share that came from everywhere.
    color *= 1.0 - texel.a * (1.0 - of_same_surface(occlusion_image, vec2(at) * 0.5, z));
#endif
#ifdef PL_SHAFTS
    color += frame.sun_radiance.rgb * of_same_surface(shafts_image, vec2(at) * 0.25, z);
#endif
    return color;
}
