// How surfaces answer light.

struct Surface {
    vec3 base_color;
    float roughness;
    float metallic;
    vec3 normal;
    vec3 to_eye;
};

const float kPi = 3.14159265;

// What a surface mirrors head on; of colour only where it is metal.
#ifdef PL_METAL
#define Reflectance vec3
vec3 head_on(Surface s) { return mix(vec3(0.04), s.base_color, s.metallic); }
vec3 matt_color(Surface s) { return s.base_color * (1.0 - s.metallic); }
#else
#define Reflectance float
float head_on(Surface s) { return 0.04; }
vec3 matt_color(Surface s) { return s.base_color; }
#endif

// Schlick's fifth power. The clamp matters: a light at the eye makes the cosine reach 1 plus a
// rounding error, and the power of a negative number would be NaN.
float fresnel_weight(float cosine) {
    float m = clamp(1.0 - cosine, 0.0, 1.0);
    float m2 = m * m;
    return m2 * m2 * m;
}

#ifdef PL_PHONG

// The textbook's: `roughness` is the exponent, `metallic` the strength of the highlight, which is in
// the surface's colour or in the light's.
vec3 reflected(Surface s, vec3 to_light, vec3 light) {
    float mirrored = max(dot(reflect(-to_light, s.normal), s.to_eye), 0.0);
    float highlight = s.metallic * pow(mirrored, s.roughness);
    float matt = material.surface.w * max(dot(s.normal, to_light), 0.0);
    return light * (s.base_color * matt + mix(s.base_color, vec3(1.0), material.surface.z) * highlight);
}

vec3 reflected_back(Surface s, vec3 light) { return reflected(s, s.to_eye, light); }

#elif defined(PL_BLINN_PHONG)

// Light sent to the eye per unit of irradiance-like radiance `light` from direction to_light.
vec3 reflected(Surface s, vec3 to_light, vec3 light) {
    float n_l = max(dot(s.normal, to_light), 0.0);
    vec3 halfway = normalize(to_light + s.to_eye);
    float n_h = max(dot(s.normal, halfway), 0.0);
    // The exponent whose highlight is as wide as a rough surface's of that roughness.
    float r2 = max(s.roughness * s.roughness, 0.02);
    float exponent = 2.0 / (r2 * r2) - 1.9;
    float highlight = 0.04 * (exponent + 8.0) / 8.0 * pow(max(n_h, 1e-4), exponent);
    return (s.base_color + highlight) * light * n_l;
}

vec3 reflected_back(Surface s, vec3 light) { return reflected(s, s.to_eye, light); }

#else

// Cook-Torrance with GGX and Hammon's approximation of Smith's masking. Like all lights here,
// `light` is in units where a matt white surface facing it sends out `light` (pi is left out).
vec3 reflected(Surface s, vec3 to_light, vec3 light) {
    float towards_l = dot(s.normal, to_light);
    float towards_v = dot(s.normal, s.to_eye);
    float n_l = clamp(towards_l, 0.0, 1.0);
    float n_v = max(towards_v, 1e-3);
    // The halfway vector is (to_light + to_eye) / sqrt(h2): nothing but its cosines is needed.
    float h2 = max(2.0 + 2.0 * dot(to_light, s.to_eye), 1e-6);
    float n_h = max(towards_l + towards_v, 0.0);  // times sqrt(h2)
    float v_h = min(0.5 * sqrt(h2), 1.0);
    float alpha = max(s.roughness * s.roughness, 0.002);
    float a2 = alpha * alpha;
    float d = min(n_h * n_h, h2) * (a2 - 1.0) + h2;  // times h2
    float masking = mix(2.0 * n_l * n_v, n_l + n_v, alpha);
    float lobe = a2 * h2 * h2 / (d * d * max(masking, 1e-4)) * 0.5;
    Reflectance f0 = head_on(s);
    Reflectance fresnel = f0 + (1.0 - f0) * fresnel_weight(v_h);
    return (matt_color(s) + lobe * fresnel) * light * n_l;
}

// The same of a light at the eye: halfway lies the eye.
vec3 reflected_back(Surface s, vec3 light) {
    float n_v = clamp(dot(s.normal, s.to_eye), 1e-3, 1.0);
    float alpha = max(s.roughness * s.roughness, 0.002);
    float a2 = alpha * alpha;
    float d = n_v * n_v * (a2 - 1.0) + 1.0;
    float masking = 2.0 * n_v * mix(n_v, 1.0, alpha);
    float lobe = a2 / (d * d * max(masking, 1e-4)) * 0.5;
    return (matt_color(s) + lobe * head_on(s)) * light * n_v;
}

#endif

// Sunlight through a leaf or petal: diffuse only, from behind, tinted as chlorophyll does.
vec3 transmitted(Surface s, vec3 to_light, vec3 light, float share) {
    float behind = max(-dot(s.normal, to_light), 0.0);
    float glow = max(-dot(s.to_eye, to_light), 0.0);
    return s.base_color * vec3(1.05, 1.0, 0.55) * light * share * (behind + 0.5 * glow * glow);
}

// The share of ambient light that a surface mirrors: Schlick's weight flattened by roughness.
Reflectance ambient_fresnel(Surface s) {
    Reflectance f0 = head_on(s);
    float n_v = clamp(dot(s.normal, s.to_eye), 0.0, 1.0);
    float gloss = 1.0 - s.roughness;
    return f0 + (max(Reflectance(gloss), f0) - f0) * fresnel_weight(n_v) * gloss;
}

// Falls as the square of the distance, gently bent down to reach zero at the light's radius.
float windowed_falloff(float distance2, float inverse_radius) {
    float x = distance2 * inverse_radius * inverse_radius;
    float window = clamp(1.0 - x * x, 0.0, 1.0);
    return window * window / max(distance2, 0.01);
}
