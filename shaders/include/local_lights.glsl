// Point and spot lights, and their shadow maps. Needs surface_position_world().

#ifdef PL_LOCAL_LIGHTS
layout(std140) uniform LocalLights { LocalLight local_lights[PL_MAX_LIGHTS]; };
uniform usamplerBuffer light_masks;
#ifdef PL_LIGHT_SHADOWS
uniform sampler2DShadow light_shadow_map;
#endif
#endif

#ifdef PL_LOCAL_LIGHTS
vec3 local_light(Surface s, LocalLight light) {
    vec3 to_light = light.position_world.xyz - surface_position_world();
    float distance2 = max(dot(to_light, to_light), 1e-4);
    to_light *= inversesqrt(distance2);
    float cosine = -dot(to_light, light.direction_world.xyz);
    float cone = light.intensity.w < -1.5
                     ? 1.0
                     : clamp((cosine - light.intensity.w) * light.direction_world.w, 0.0, 1.0);
    float falloff = windowed_falloff(distance2, light.position_world.w);
    return reflected(s, to_light, light.intensity.rgb * (cone * cone * falloff));
}
#endif

#ifdef PL_LIGHT_SHADOWS
// The maps round a light lie as light_shadows.h says: an axis forward, the next to a side, the third up.
float local_light_lit(Surface s, LocalLight light) {
    vec3 from = surface_position_world() - light.position_world.xyz;
    vec3 size = abs(from);
    float reach = max(size.x, max(size.y, size.z));
    // Looked up a texel's breadth off the surface, more where light grazes it: no acne.
    float slope = clamp(1.0 + dot(s.normal, from) * inversesqrt(dot(from, from)), 0.0, 1.0);
    from += s.normal * (light.shadow.w * reach * (0.5 + 1.5 * slope));
    size = abs(from);
    bool is_x = size.x >= max(size.y, size.z);
    bool is_y = !is_x && size.y >= size.z;
    vec3 way = is_x ? from : (is_y ? from.yzx : from.zxy);
    float ahead = abs(way.x);
    float face = (is_x ? 0.0 : (is_y ? 2.0 : 4.0)) + float(way.x < 0.0);
    vec2 slopes = vec2(way.x < 0.0 ? way.y : -way.y, way.z) / ahead;
    vec2 texel = 1.0 / vec2(textureSize(light_shadow_map, 0));
    float side_px = 0.1666667 / texel.x;
    vec2 at_px = (vec2(face, light.shadow.x) + 0.5) * side_px + slopes / light.shadow.w;
    return filtered_shadow(
        light_shadow_map, vec3(at_px * texel, light.shadow.y - light.shadow.z / ahead), texel);
}
#endif

#ifdef PL_LOCAL_LIGHTS
// The exponent of a power of two is the number of its bit.
int bit_of(uint power) { return (floatBitsToInt(float(int(power))) >> 23 & 255) - 127; }

// The lights whose bits this part of the image has; light_clusters.h says how they lie.
vec3 local_lights_light(Surface s) {
    ivec2 tile = min(ivec2(gl_FragCoord.xy * frame.clusters.xy),
                     ivec2(PL_CLUSTERS_X - 1, PL_CLUSTERS_Y - 1));
    float near_share = 1.0 / (gl_FragCoord.w * PL_CLUSTER_NEAR_M);
    int slice = near_share < 1.0
                    ? 0
                    : min(1 + int(log2(near_share) * PL_CLUSTERS_PER_OCTAVE), PL_CLUSTERS_Z - 1);
    int words = textureSize(light_masks) / (PL_CLUSTERS_X * PL_CLUSTERS_Y * PL_CLUSTERS_Z);
    int first = ((slice * PL_CLUSTERS_Y + tile.y) * PL_CLUSTERS_X + tile.x) * words;
    vec3 color = vec3(0.0);
    int word = 0;
    uint bits = texelFetch(light_masks, first).r;
#ifdef PL_LIGHT_SHADOWS
    uint casting = bits & uint(frame.wind.w);
    bits ^= casting;
    while (casting != 0u) {
        uint lowest = casting & (~casting + 1u);
        LocalLight light = local_lights[bit_of(lowest)];
        color += local_light(s, light) * local_light_lit(s, light);
        casting ^= lowest;
    }
#endif
    // One loop: where threads share an instruction, inner loops would wait for each other's longest.
    for (;;) {
        while (bits == 0u && ++word < words) bits = texelFetch(light_masks, first + word).r;
        if (bits == 0u) break;
        uint lowest = bits & (~bits + 1u);
        color += local_light(s, local_lights[word * 32 + bit_of(lowest)]);
        bits ^= lowest;
    }
    return color;
}
#endif
