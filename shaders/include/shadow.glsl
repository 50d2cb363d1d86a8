// Lookups in shadow maps: 1 is fully lit. Every tap is a hardware comparison of four texels.

// Four taps half a texel off centre weigh 3 x 3 texels like a tent.
float shadow_4_taps(sampler2DShadow map, vec3 at, float texel) {
    float h = 0.5 * texel;
    float lit = texture(map, at + vec3(-h, -h, 0.0)) + texture(map, at + vec3(h, -h, 0.0)) +
                texture(map, at + vec3(-h, h, 0.0)) + texture(map, at + vec3(h, h, 0.0));
    return 0.25 * lit;
}

// Two taps across one diagonal: most of the smoothness at half the cost.
float shadow_2_taps(sampler2DShadow map, vec3 at, float texel) {
    float h = 0.5 * texel;
    return 0.5 * (texture(map, at + vec3(-h, h, 0.0)) + texture(map, at + vec3(h, -h, 0.0)));
}
