// Water: ripples that run over it, and what it mirrors.

#ifdef PL_RIPPLES

// How far the surface leans along x and z; waves of several lengths, of capillary and gravity speed.
vec2 ripple_slope(vec2 at, float time_s) {
    vec2 lean = vec2(0.9, 0.4) * sin(dot(at, vec2(19.0, 8.6)) - 14.1 * time_s);
    lean += vec2(-0.5, 0.9) * sin(dot(at, vec2(-14.2, 25.5)) - 16.8 * time_s + 1.3);
    lean += vec2(0.3, -1.0) * sin(dot(at, vec2(11.0, -37.0)) - 19.6 * time_s + 4.0);
    lean += vec2(-1.0, -0.2) * sin(dot(at, vec2(-53.0, -9.0)) - 23.0 * time_s + 2.2);
    return lean * (0.7 * material.surface.z);
}

// Of light from above that water mirrors, Schlick's weight with its index of 1.33.
float water_fresnel(float cosine) {
    float m = clamp(1.0 - cosine, 0.0, 1.0);
    float m2 = m * m;
    return 0.02 + 0.98 * m2 * m2 * m;
}

#endif
