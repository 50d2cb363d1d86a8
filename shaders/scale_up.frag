// The finished image in the size of the target. Passes: post. Reads codes.
#include "include/blocks.glsl"

in vec2 screen_uv;
in vec3 ray_world;
uniform sampler2D source_image;
#ifdef PL_KEEP_DEPTH
uniform sampler2D depth_image;
#endif

layout(location = 0) out vec4 out_color;

void main() {
#ifdef PL_KEEP_DEPTH
    gl_FragDepth = texture(depth_image, screen_uv).r;
#endif
    out_color = vec4(texture(source_image, screen_uv).rgb, 1.0);
}
