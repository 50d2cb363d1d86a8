// The mean over four neighbours along one axis that lie on the same surface. Passes: occlusion,
// shafts. Reads what they found, and the distance.
#include "include/blocks.glsl"

in vec2 screen_uv;
in vec3 ray_world;
uniform sampler2D source_image;
uniform ivec2 axis;

layout(location = 0) out vec2 out_mean;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(source_image, 0) - 1;
    vec2 here = texelFetch(source_image, at, 0).rg;
    vec2 before = texelFetch(source_image, max(at - axis, 0), 0).rg;
    vec2 after = texelFetch(source_image, min(at + axis, last), 0).rg;
    vec2 first = texelFetch(source_image, max(at - 2 * axis, 0), 0).rg;
    vec2 end = texelFetch(source_image, min(at + 2 * axis, last), 0).rg;
    // A surface runs on as it does on the side without an edge.
    vec2 steps = vec2(here.g - before.g, after.g - here.g);
    float run = abs(steps.x) < abs(steps.y) ? steps.x : steps.y;
    vec4 off = abs(vec4(before.g, after.g, first.g, end.g) - here.g - run * vec4(-1.0, 1.0, -2.0, 2.0));
    vec4 weights = clamp(2.0 - off * (50.0 / here.g), 0.0, 1.0) * vec4(1.0, 1.0, 0.5, 0.5);
    float sum = here.r + dot(weights, vec4(before.r, after.r, first.r, end.r));
    out_mean = vec2(sum / (1.0 + dot(weights, vec4(1.0))), here.g);
}
