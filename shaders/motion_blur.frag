// What the camera's way while the shutter was open makes of the scene: each place is the mean of all
// that passed it. Passes: motion_blur. Reads the scene's image and the depth image.
#include "include/blocks.glsl"
#include "include/view_depth.glsl"
#include "include/scene_light.glsl"

in vec2 screen_uv;
in vec3 ray_world;
uniform mat4 clip_before_from_world;
uniform vec2 streak;  // its longest in pixels; samples at most

layout(location = 0) out vec4 out_color;

void main() {
    vec2 size = vec2(textureSize(source_image, 0));
    ivec2 at = ivec2(gl_FragCoord.xy);
    float z = view_depth(texelFetch(depth_image, at, 0).r);
    vec4 before = clip_before_from_world * vec4(frame.camera_world.xyz + ray_world * z, 1.0);
    vec2 way_px = (screen_uv - (before.xy / max(before.w, 1e-4) * 0.5 + 0.5)) * size;
    float length_px = length(way_px);
    way_px *= min(1.0, streak.x / max(length_px, 1e-4));
    float count = clamp(ceil(min(length_px, streak.x)), 1.0, streak.y);
    vec3 sum = vec3(0.0);
    for (float i = 0.5; i < count; i += 1.0) {
        vec2 there = clamp(gl_FragCoord.xy + way_px * (i / count), vec2(0.0), size - 1.0);
        sum += scene_light(ivec2(there));
    }
    out_color = vec4(sum / count, 1.0);
}
