// Water and glass: ripples that run over it, and what it mirrors.

#ifdef PL_RIPPLES

// Short waves from several sides: how far each leans the surface along x and z, its number, 1/m, its speed,
// rad/s, and its phase.
struct Ripple {
    vec2 lean;
    vec2 number;
    float speed;
    float phase;
};
const int kRipples = 4;
const Ripple kRippleWaves[kRipples] =
    Ripple[](Ripple(vec2(0.9, 0.4), vec2(21.0, 9.6), 7.5, 0.0),
             Ripple(vec2(-0.5, 0.9), vec2(-17.2, 28.5), 8.8, 1.3),
             Ripple(vec2(0.3, -1.0), vec2(14.0, -43.0), 10.6, 4.0),
             Ripple(vec2(-1.0, -0.2), vec2(-61.0, -19.0), 13.0, 2.2));

// Bent out of line, so that no row of crests is seen.
vec2 off_line(vec2 at, float time_s) {
    return at + 0.035 * sin(at.yx * vec2(13.0, 11.0) + vec2(1.9, -2.3) * time_s);
}

// Of each wave of so steep water.
float ripple_height() { return 0.7 * material.surface.z; }

vec2 ripple_lean(vec2 bent, float time_s) {
    vec2 lean = vec2(0.0);
    for (int i = 0; i < kRipples; ++i) {
        Ripple wave = kRippleWaves[i];
        lean += wave.lean * sin(dot(bent, wave.number) - wave.speed * time_s + wave.phase);
    }
    return lean;
}

// How far the surface leans along x and z. Far off ripples are finer than pixels: only their mean, a
// level surface, stays.
vec2 ripple_slope(vec2 at, float time_s, float eye_distance_m) {
    return ripple_lean(off_line(at, time_s), time_s) *
           (ripple_height() / (1.0 + 0.02 * eye_distance_m * eye_distance_m));
}

// Of light from above that water mirrors, Schlick's weight with its index of 1.33.
float water_fresnel(float cosine) {
    float m = clamp(1.0 - cosine, 0.0, 1.0);
    float m2 = m * m;
    return 0.02 + 0.98 * m2 * m2 * m;
}

#endif

#ifdef PL_REFRACTION
#include "include/view_depth.glsl"

uniform sampler2D source_image;  // what was drawn before the water, at
uniform vec4 behind_px;          // ... its first and its last pixel

const float kIntoWater = 1.0 / 1.33;

vec3 place_behind(vec2 at_px) {
    vec2 clip = at_px / vec2(textureSize(depth_image, 0)) * 2.0 - 1.0;
    float z = view_depth(texelFetch(depth_image, ivec2(at_px), 0).r);
    return frame.camera_world.xyz + (frame.world_from_ray * vec4(clip, 1.0, 0.0)).xyz * z;
}

// What is seen through a place of the surface.
struct BelowWater {
    vec3 place;
    vec3 light;     // as it is without the water
    float depth_m;  // below the surface
    float way_m;    // from there to the surface
};

// The way of the light bends at the surface. It ends about as deep as what lies straight behind; what
// is seen of that place without the water is what is seen there. Where something before the water
// hides that, less far off.
BelowWater below_water(vec3 surface, vec3 normal, vec3 to_eye, float eye_distance_m) {
    vec3 way = refract(-to_eye, normal, kIntoWater);
    way.y = min(way.y, -0.2);
    vec2 size = vec2(textureSize(source_image, 0));
    BelowWater below;
    vec2 at_px = gl_FragCoord.xy;
    below.place = place_behind(at_px);
    below.depth_m = max(surface.y - below.place.y, 0.0);
    vec4 end = frame.clip_from_world * vec4(surface - way * (below.depth_m / way.y), 1.0);
    vec2 off_px = (end.xy / max(end.w, 1e-4) * 0.5 + 0.5) * size - at_px;
    for (int i = 0; i < 4; ++i) {
        vec2 there_px = clamp(gl_FragCoord.xy + off_px, behind_px.xy, behind_px.zw);
        vec3 there = place_behind(there_px);
        if (there.y < surface.y && distance(there, frame.camera_world.xyz) > eye_distance_m) {
            at_px = there_px;
            below.place = there;
            below.depth_m = surface.y - there.y;
            break;
        }
        off_px *= 0.6;
    }
    // The light of that very place: between two pixels what stands before the water would shine in.
    below.light = texelFetch(source_image, ivec2(at_px), 0).rgb;
    below.way_m = -below.depth_m / way.y;
    return below;
}

// What is left of light that came down through the water and went up to the surface.
vec3 through_water(BelowWater below) {
    float loss = (below.depth_m + below.way_m) * material.relief.z;
    return exp(log(max(material.base_color.rgb, 1e-3)) * loss);
}

// How much more of the sun's light falls below rippled water than below level water. A leaning surface
// moves what goes through it by its slope; where the area that a bundle of rays falls on is smaller than
// the one that it came through, there is more light.
float gathered_light(vec3 place, float depth_m) {
    vec3 down = refract(-frame.to_sun_world.xyz, vec3(0.0, 1.0, 0.0), kIntoWater);
    float time_s = frame.wind.z;
    float moved_m = (1.0 - kIntoWater) * depth_m * ripple_height() * material.relief.w;
    vec2 level = place.xz + down.xz * (depth_m / down.y);
    vec2 from = off_line(level, time_s);
    from -= moved_m * ripple_lean(from, time_s);
    mat2 change = mat2(1.0);
    for (int i = 0; i < kRipples; ++i) {
        Ripple wave = kRippleWaves[i];
        float steep = cos(dot(from, wave.number) - wave.speed * time_s + wave.phase);
        change += moved_m * steep * outerProduct(wave.lean, wave.number);
    }
    return 1.0 / max(abs(determinant(change)), 0.25);
}

#endif

#if defined(PL_RIPPLES) || defined(PL_GLASS)

// What stands round hides the sky low down: it is mirrored as something dark and green.
const vec3 kShores = vec3(0.22, 0.26, 0.15);
float over_shores(float upwards) { return smoothstep(0.04, 0.42, upwards); }

#endif

#ifdef PL_GLASS

// Of a pane, whose two sides mirror in turns: the sum of what goes back and forth between them.
float pane_fresnel(float head_on, float cosine) {
    float m = clamp(1.0 - abs(cosine), 0.0, 1.0);
    float m2 = m * m;
    float side = head_on + (1.0 - head_on) * m2 * m2 * m;
    return 2.0 * side / (1.0 + side);
}

#endif
