// Smooths the stairs along edges of the finished image, as FXAA does: finds which way an edge
// runs from the brightness of the four diagonal neighbours and blurs along it. An image that is
// going to be scaled up is sharpened a little, too. Passes: post. Reads codes, brightness in alpha.
#include "include/blocks.glsl"

in vec2 screen_uv;
in vec3 ray_world;
uniform sampler2D source_image;
#ifdef PL_KEEP_DEPTH
uniform sampler2D depth_image;
#endif

layout(location = 0) out vec4 out_color;

const float kLeastContrast = 0.04;  // below it, and below an eighth of the brightest: no edge
const float kReach_px = 8.0;        // how far along an edge is looked, both ways together
const float kSharpness = 0.35;

void main() {
    ivec2 size = textureSize(source_image, 0);
    ivec2 at = ivec2(gl_FragCoord.xy);
    ivec2 low = max(at - 1, ivec2(0));
    ivec2 high = min(at + 1, size - 1);
    vec4 here = texelFetch(source_image, at, 0);
    float sw = texelFetch(source_image, low, 0).a;
    float ne = texelFetch(source_image, high, 0).a;
    float se = texelFetch(source_image, ivec2(high.x, low.y), 0).a;
    float nw = texelFetch(source_image, ivec2(low.x, high.y), 0).a;
    vec3 color = here.rgb;

#ifdef PL_FXAA
    float darkest = min(here.a, min(min(sw, ne), min(se, nw)));
    float brightest = max(here.a, max(max(sw, ne), max(se, nw)));
    // Brightness grows across an edge; the edge runs at a right angle to that.
    vec2 along = vec2((sw + se) - (nw + ne), (se + ne) - (sw + nw));
    float smaller = min(abs(along.x), abs(along.y));
    float flatness = 0.03 * (sw + se + nw + ne) + 0.008;
    vec2 step_px = clamp(along / (smaller + flatness), -kReach_px, kReach_px) * 0.5;
    vec2 step_uv = step_px / vec2(size);
    vec4 blurred = 0.5 * (texture(source_image, screen_uv + step_uv) +
                          texture(source_image, screen_uv - step_uv));
    bool is_edge = brightest - darkest > max(kLeastContrast, 0.125 * brightest);
    // Brighter or darker than all around: the blur went over something else.
    bool holds = blurred.a >= darkest && blurred.a <= brightest;
    color = is_edge && holds ? blurred.rgb : color;
#endif
#ifdef PL_SHARPEN
    float detail = here.a - 0.25 * (sw + se + nw + ne);
    color += clamp(kSharpness * detail, -0.06, 0.06);
#endif
#ifdef PL_KEEP_DEPTH
    gl_FragDepth = texture(depth_image, screen_uv).r;
#endif
    out_color = vec4(color, 1.0);
}
