// One triangle that covers the target. Passes: sky, post.
#include "include/blocks.glsl"

out vec2 screen_uv;
out vec3 ray_world;
flat out float sky_brightness;  // uniforms are dear in the pixels of software GL

void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    screen_uv = corner * 0.5 + 0.5;
    ray_world = (frame.world_from_ray * vec4(corner, 1.0, 0.0)).xyz;
    gl_Position = vec4(corner, 1.0, 1.0);
    sky_brightness = frame.tone.w;
}
