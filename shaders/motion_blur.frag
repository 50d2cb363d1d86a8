// What the way of camera and things while the shutter was open makes of the scene: each place is the mean
// of all that passed it. Passes: motion_blur. Reads the scene's image, the depth image and, where things
// moved, their ways.
#include "include/blocks.glsl"
#include "include/view_depth.glsl"
#include "include/scene_light.glsl"

in vec2 screen_uv;
in vec3 ray_world;
uniform mat4 clip_before_from_world;
uniform vec2 streak;  // its longest in pixels; samples at most
#ifdef PL_MOVED
uniform sampler2D blurred_image;  // ways
#endif

layout(location = 0) out vec4 out_color;

vec2 no_longer(vec2 way_px) {
    return way_px * min(1.0, streak.x / max(length(way_px), 1e-4));
}

float count_of(vec2 way_px) { return clamp(ceil(length(way_px)), 1.0, streak.y); }

void main() {
    vec2 size = vec2(textureSize(source_image, 0));
    ivec2 at = ivec2(gl_FragCoord.xy);
    float z = view_depth(texelFetch(depth_image, at, 0).r);
    vec4 before = clip_before_from_world * vec4(frame.camera_world.xyz + ray_world * z, 1.0);
    vec2 way_px = no_longer((screen_uv - (before.xy / max(before.w, 1e-4) * 0.5 + 0.5)) * size);
    float count = count_of(way_px);
    vec3 sum = vec3(0.0);
#ifdef PL_MOVED
    vec4 moved = texelFetch(blurred_image, at, 0);
    vec2 moved_px = no_longer(moved.xy);
    count = max(count, moved.z > 0.0 ? count_of(moved_px) : 1.0);
    for (float i = 0.5; i < count; i += 1.0) {
        // What moved stood here at that moment, or it did not, and what is behind it was seen.
        ivec2 there = ivec2(clamp(gl_FragCoord.xy + moved_px * (i / count), vec2(0.0), size - 1.0));
        if (moved.z <= 0.0 || texelFetch(blurred_image, there, 0).z < 0.75) {
            ivec2 behind = ivec2(clamp(gl_FragCoord.xy + way_px * (i / count), vec2(0.0), size - 1.0));
            if (texelFetch(blurred_image, behind, 0).z < 0.75) {
                there = behind;
            } else if (moved.z < 0.75) {
                there = at;
            }
        }
        sum += scene_light(there);
    }
#else
    for (float i = 0.5; i < count; i += 1.0) {
        vec2 there = clamp(gl_FragCoord.xy + way_px * (i / count), vec2(0.0), size - 1.0);
        sum += scene_light(ivec2(there));
    }
#endif
    out_color = vec4(sum / count, 1.0);
}
