// How much of the light from everywhere reaches what is seen, and its distance along the line of
// sight: from the depth image alone, with half its width and height. In planes through the line of
// sight the two horizons bound what is open, weighed by the cosine to the surface (Jimenez et al.
// 2016). Neighbours look in other planes: the passes after this one take the mean of sixteen.
// Passes: occlusion. Reads the depth image.
#include "include/blocks.glsl"
#include "include/view_depth.glsl"

in vec2 screen_uv;
in vec3 ray_world;
uniform vec2 tan_half;   // of half the angles of view
uniform vec4 reach;      // radius, m; the same in pixels at 1 m, and at most; strength
uniform ivec2 counts;    // slices; steps to each horizon

layout(location = 0) out vec2 out_visibility;

vec3 view_position(ivec2 at, vec2 texel) {
    vec2 ray = ((vec2(at) + 0.5) * texel * 2.0 - 1.0) * tan_half;
    return vec3(ray, 1.0) * view_depth(texelFetch(depth_image, at, 0).r);
}

// How the surface runs along an axis, as the side without an edge tells.
vec3 run_along(ivec2 at, ivec2 axis, ivec2 size, vec2 texel, vec3 here) {
    vec3 before = here - view_position(max(at - axis, 0), texel);
    vec3 after = view_position(min(at + axis, size - 1), texel) - here;
    bool is_first = any(lessThan(at - axis, ivec2(0)));
    bool is_last = any(greaterThanEqual(at + axis, size));
    return is_first || (!is_last && abs(after.z) < abs(before.z)) ? after : before;
}

float arc_cosine(float x) {
    float y = abs(x);
    float angle = sqrt(1.0 - y) * (1.5707288 + y * (-0.2121144 + y * (0.0742610 - y * 0.0187293)));
    return x < 0.0 ? 3.1415927 - angle : angle;
}

// Of the open angle between the line of sight and a horizon at that cosine; `b`, `a`: the normal along
// the line of sight, and across it towards the horizon.
float open_arc(float cosine, float a, float b) {
    float c = clamp(cosine, -1.0, 1.0);
    float s2 = 1.0 - c * c;
    return b * s2 + a * (arc_cosine(c) - c * sqrt(s2));
}

void main() {
    ivec2 size = textureSize(depth_image, 0);
    vec2 texel = 1.0 / vec2(size);
    ivec2 at = ivec2(gl_FragCoord.xy) * 2;
    vec3 here = view_position(at, texel);
    float reach_px = min(reach.y / here.z, reach.z);
    out_visibility = vec2(1.0, min(here.z, kFarthest_m));
    if (reach_px < kLeastReach_px) return;

    vec3 dx = run_along(at, ivec2(1, 0), size, texel, here);
    vec3 dy = run_along(at, ivec2(0, 1), size, texel, here);
    vec3 normal = normalize(cross(dy, dx));
    vec3 to_eye = normalize(-here);
    normal = dot(normal, to_eye) < 0.0 ? -normal : normal;

    ivec2 cell = ivec2(gl_FragCoord.xy) & 3;
    float turn = float((((cell.x + cell.y) & 3) << 2) + cell.x) / 16.0;
    float shift = float((cell.y - cell.x) & 3) * 0.25 + 0.125;
    float open = 0.0;
    float all = 0.0;
    for (int slice = 0; slice < counts.x; ++slice) {
        float phi = (float(slice) + turn) * 3.1415927 / float(counts.x);
        vec2 way = vec2(cos(phi), sin(phi));
        vec3 across = normalize(vec3(way, 0.0) - dot(vec3(way, 0.0), to_eye) * to_eye);
        float a = dot(normal, across);
        float b = dot(normal, to_eye);
        float sine = a * inversesqrt(a * a + b * b + 1e-8);
        // No lower than the surface itself.
        vec2 lowest = vec2(-sine, sine);
        vec2 horizon = lowest;
        for (int i = 0; i < counts.y; ++i) {
            float share = (float(i) + shift) / float(counts.y);
            vec2 offset = way * max(share * share * reach_px, float(i) + 1.5);
            for (int side = 0; side < 2; ++side) {
                ivec2 there = at + ivec2(side == 0 ? offset + 0.5 : 0.5 - offset);
                if (any(lessThan(there, ivec2(0))) || any(greaterThanEqual(there, size))) continue;
                vec3 way_there = view_position(there, texel) - here;
                float distance2 = dot(way_there, way_there) + 1e-8;
                float inverse = inversesqrt(distance2);
                // All within half the radius counts, nothing beyond it.
                float weight = clamp(2.0 - 2.0 * distance2 * inverse / reach.x, 0.0, 1.0);
                float cosine = dot(way_there, to_eye) * inverse;
                horizon[side] = max(horizon[side], mix(lowest[side], cosine, weight));
            }
        }
        open += open_arc(horizon.x, a, b) + open_arc(horizon.y, -a, b);
        all += open_arc(lowest.x, a, b) + open_arc(lowest.y, -a, b);
    }
    float visibility = clamp(open / max(all, 1e-4), 0.0, 1.0);
    float fade = clamp((reach_px - kLeastReach_px) / kLeastReach_px, 0.0, 1.0);
    out_visibility.x = 1.0 - (1.0 - visibility) * reach.w * fade;
}
