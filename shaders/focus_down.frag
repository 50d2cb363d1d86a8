// Half the scene's width and height for a lens to blur; alpha: how far a point is spread, as the
// radius of its disc in these pixels, negative before what is in focus. Passes: focus. Reads the
// scene's image and the depth image.
#include "include/blocks.glsl"
#include "include/view_depth.glsl"
#include "include/scene_light.glsl"

in vec2 screen_uv;
in vec3 ray_world;
uniform vec4 lens;  // radius in pixels = x - y / metres; at most z

layout(location = 0) out vec4 out_color;

void main() {
    ivec2 last = textureSize(source_image, 0) - 1;
    ivec2 low = ivec2(gl_FragCoord.xy) * 2;
    vec3 sum = vec3(0.0);
    float depth = 1.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 at = min(low + ivec2(i & 1, i >> 1), last);
        sum += min(scene_light(at), 64.0);
        depth = min(depth, texelFetch(depth_image, at, 0).r);
    }
    float radius_px = 0.5 * (lens.x - lens.y / view_depth(depth));
    out_color = vec4(sum * 0.25, clamp(radius_px, -0.5 * lens.z, 0.5 * lens.z));
}
