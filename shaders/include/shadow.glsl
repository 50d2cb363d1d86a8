// Lookups in shadow maps: 1 is fully lit. Every tap is a hardware comparison of four texels.


#ifdef PL_SOFT_SHADOWS

// Four taps half a texel off centre weigh 3 x 3 texels like a tent.
float sun_shadow(sampler2DShadow map, vec3 at, float texel) {
    float h = 0.5 * texel;
    float lit = texture(map, at + vec3(-h, -h, 0.0)) + texture(map, at + vec3(h, -h, 0.0)) +
                texture(map, at + vec3(-h, h, 0.0)) + texture(map, at + vec3(h, h, 0.0));
    return 0.25 * lit;
}

float flashlight_shadow(sampler2DShadow map, vec3 at, float texel) {
    return sun_shadow(map, at, texel);
}

#elif defined(PL_HARD_SHADOWS)

float sun_shadow(sampler2DShadow map, vec3 at, float texel) {
    return texture(map, at);
}

float flashlight_shadow(sampler2DShadow map, vec3 at, float texel) {
    return texture(map, at);
}

#else

// Two taps across one diagonal: most of the smoothness at half the cost.
float sun_shadow(sampler2DShadow map, vec3 at, float texel) {
    float h = 0.5 * texel;
    return 0.5 * (texture(map, at + vec3(-h, h, 0.0)) + texture(map, at + vec3(h, -h, 0.0)));
}

// The flashlight's map is fine where its light is strong.
float flashlight_shadow(sampler2DShadow map, vec3 at, float texel) {
    return texture(map, at);
}

#endif
