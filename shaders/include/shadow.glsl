// Lookups in shadow maps: 1 is fully lit. Every tap is a hardware comparison of four texels.

#ifdef PL_SOFT_SHADOWS

// Four taps half a texel off centre weigh 3 x 3 texels like a tent.
float filtered_shadow(sampler2DShadow map, vec3 at, vec2 texel) {
    vec2 h = 0.5 * texel;
    float lit = texture(map, at + vec3(-h, 0.0)) + texture(map, at + vec3(h.x, -h.y, 0.0)) +
                texture(map, at + vec3(-h.x, h.y, 0.0)) + texture(map, at + vec3(h, 0.0));
    return 0.25 * lit;
}

float flashlight_shadow(sampler2DShadow map, vec3 at, float texel) {
    return filtered_shadow(map, at, vec2(texel));
}

#else

// The flashlight's map is fine where its light is strong.
float flashlight_shadow(sampler2DShadow map, vec3 at, float texel) {
    return texture(map, at);
}

#ifdef PL_HARD_SHADOWS

float filtered_shadow(sampler2DShadow map, vec3 at, vec2 texel) {
    return texture(map, at);
}

#else

// Two taps across one diagonal: most of the smoothness at half the cost.
float filtered_shadow(sampler2DShadow map, vec3 at, vec2 texel) {
    vec2 h = 0.5 * texel;
    return 0.5 * (texture(map, at + vec3(-h.x, h.y, 0.0)) + texture(map, at + vec3(h.x, -h.y, 0.0)));
}

#endif
#endif

#ifdef PL_CONTACT_HARDENING

const int kBlockerTaps = 10;
const int kDiscTaps = 16;

// Points of a disc, evenly spread: each turns on by the golden angle.
const mat2 kGoldenTurn = mat2(-0.737369, 0.675490, -0.675490, -0.737369);

// The share of the sun's disc that is seen: as wide an edge as the disc at the mean distance of what
// hides it (R. Fernando, "Percentage-Closer Soft Shadows", 2005). `cosine`: of the light with the surface.
float disc_shadow(sampler2DShadow map, sampler2D depths, vec3 at, float cosine) {
    float texel = frame.sun_radiance.w;
    float tangent = frame.cascade_ends.w;  // place in the map over depth in it
    float steep = min(sqrt(max(1.0 - cosine * cosine, 0.0)) / max(cosine, 0.05), 4.0) / PL_SUN_MAP_DEPTH;
    float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    vec2 first = vec2(cos(6.2831853 * noise), sin(6.2831853 * noise));
#ifdef PL_CASCADES
    vec2 unit = vec2(frame.clusters.z, 1.0);
#else
    vec2 unit = vec2(1.0);
#endif
    float widest = max(tangent * at.z, 1.5 * texel);
    vec2 turn = first;
    vec2 hiding = vec2(0.0);  // sum of depths, number
    for (int i = 0; i < kBlockerTaps; ++i) {
        float off = widest * sqrt((float(i) + 0.5) / float(kBlockerTaps));
        float depth = texture(depths, at.xy + turn * unit * off).r;
        hiding += vec2(depth, 1.0) * float(depth < at.z - off * steep);
        turn = kGoldenTurn * turn;
    }
    if (hiding.y < 0.5) return 1.0;
    float radius = clamp((at.z - hiding.x / hiding.y) * tangent, 0.7 * texel, widest);
    turn = first;
    float lit = 0.0;
    for (int i = 0; i < kDiscTaps; ++i) {
        float off = radius * sqrt((float(i) + 0.5) / float(kDiscTaps));
        lit += texture(map, vec3(at.xy + turn * unit * off, at.z - off * steep));
        turn = kGoldenTurn * turn;
    }
    return lit / float(kDiscTaps);
}

#endif
