// Light that air in the sun sends to the eye, as a share of the sun's, and the distance of what is
// behind it: the shadow map is asked in steps along each line of sight, with a quarter of the scene's
// width and height. Neighbours ask at other distances: the passes after this one take the mean of
// sixteen. Passes: shafts. Reads the depth image and the sun's shadow map.
#include "include/blocks.glsl"
#include "include/view_depth.glsl"

in vec2 screen_uv;
in vec3 ray_world;
#ifdef PL_SUN_SHADOW
uniform sampler2DShadow sun_shadow_map;
#endif
uniform vec3 air;  // density, 1/m; as far as it is looked at, m; steps

layout(location = 0) out vec2 out_light;

#ifdef PL_SUN_SHADOW
// `at`: coordinates of the first cascade.
float lit(vec3 at, float eye_distance_m) {
#ifdef PL_CASCADES
    int i = int(eye_distance_m > frame.cascade_ends.x) + int(eye_distance_m > frame.cascade_ends.y) +
            int(eye_distance_m > frame.cascade_ends.z);
    vec4 cascade = frame.cascades[i];
    at = at * cascade.w + cascade.xyz;
    at.x = (at.x + float(i)) * frame.clusters.z;
#endif
    return texture(sun_shadow_map, vec3(at.xy, min(at.z, 1.0)));
}
#endif

// Haze sends most light on nearly straight ahead (Henyey and Greenstein 1941, g = 0.7); times pi,
// since the sun's radiance stands for its irradiance over pi.
float phase(float cosine) {
    float d = 1.49 - 1.4 * cosine;
    return 0.1275 * inversesqrt(d) / d;
}

void main() {
    vec2 size = vec2(textureSize(depth_image, 0));
    ivec2 at = ivec2(gl_FragCoord.xy) * 4;
    float z = min(view_depth(texelFetch(depth_image, at, 0).r), kFarthest_m);
    // The ray through that pixel, which is not the middle of this one.
    vec2 off = ((vec2(at) + 0.5) / size - screen_uv) * 2.0;
    vec3 ray = ray_world + (frame.world_from_ray * vec4(off, 0.0, 0.0)).xyz;
    float metres = length(ray);
    float end_m = min(z * metres, air.y);
    ivec2 cell = ivec2(gl_FragCoord.xy) & 3;
    float shift = (float((((cell.x + cell.y) & 3) << 2) + cell.x) + 0.5) / 16.0;
    float sum = 0.0;
#ifdef PL_SUN_SHADOW
    vec3 start = (frame.sun_shadow_from_world * vec4(frame.camera_world.xyz, 1.0)).xyz;
    vec3 way = (frame.sun_shadow_from_world * vec4(ray / metres, 0.0)).xyz;
    float step_m = end_m / air.z;
    float before = 1.0;
    float through = exp(-air.x * step_m);
    for (float i = 0.0; i < air.z; i += 1.0) {
        float there_m = (i + shift) * step_m;
        sum += before * lit(start + way * there_m, there_m);
        before *= through;
    }
    sum *= 1.0 - through;
#else
    sum = 1.0 - exp(-air.x * end_m);
#endif
    out_light = vec2(sum * phase(dot(ray, frame.to_sun_world.xyz) / metres), z);
}
