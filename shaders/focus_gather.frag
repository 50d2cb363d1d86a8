// The mean of all points whose discs reach a pixel: what is behind what is seen there spreads no
// further than that itself does. Passes: focus. Reads the halved scene.
#include "include/blocks.glsl"

in vec2 screen_uv;
in vec3 ray_world;
uniform sampler2D source_image;
uniform vec2 disc;  // its largest radius in pixels; samples

layout(location = 0) out vec4 out_color;

void main() {
    vec2 texel = 1.0 / vec2(textureSize(source_image, 0));
    vec4 here = texelFetch(source_image, ivec2(gl_FragCoord.xy), 0);
    float own = abs(here.a);
    vec3 sum = here.rgb;
    float spread = own;
    float count = 1.0;
    // Sunflower: every sample stands for the same area.
    mat2 turn = mat2(-0.7373689, 0.6754903, -0.6754903, -0.7373689);
    vec2 way = vec2(1.0, 0.0);
    for (float i = 0.5; i < disc.y; i += 1.0) {
        way = turn * way;
        float radius_px = disc.x * sqrt(i / disc.y);
        vec4 there = texture(source_image, screen_uv + way * radius_px * texel);
        float reach = abs(there.a);
        reach = there.a > here.a ? min(reach, 2.0 * own) : reach;
        float share = smoothstep(radius_px - 0.5, radius_px + 0.5, reach);
        sum += mix(sum / count, there.rgb, share);
        spread += mix(spread / count, reach, share);
        count += 1.0;
    }
    out_color = vec4(sum / count, spread / count);
}
