// Water and glass: ripples that run over it, and what it mirrors.

#ifdef PL_RIPPLES

// How far the surface leans along x and z: short waves from several sides, bent out of line so that no
// row of crests is seen. Far off they are finer than pixels: only their mean, a level surface, stays.
vec2 ripple_slope(vec2 at, float time_s, float eye_distance_m) {
    vec2 bent = at + 0.035 * sin(at.yx * vec2(13.0, 11.0) + vec2(1.9, -2.3) * time_s);
    vec2 lean = vec2(0.9, 0.4) * sin(dot(bent, vec2(21.0, 9.6)) - 7.5 * time_s);
    lean += vec2(-0.5, 0.9) * sin(dot(bent, vec2(-17.2, 28.5)) - 8.8 * time_s + 1.3);
    lean += vec2(0.3, -1.0) * sin(dot(bent, vec2(14.0, -43.0)) - 10.6 * time_s + 4.0);
    lean += vec2(-1.0, -0.2) * sin(dot(bent, vec2(-61.0, -19.0)) - 13.0 * time_s + 2.2);
    return lean * (0.7 * material.surface.z / (1.0 + 0.02 * eye_distance_m * eye_distance_m));
}

// Of light from above that water mirrors, Schlick's weight with its index of 1.33.
float water_fresnel(float cosine) {
    float m = clamp(1.0 - cosine, 0.0, 1.0);
    float m2 = m * m;
    return 0.02 + 0.98 * m2 * m2 * m;
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
