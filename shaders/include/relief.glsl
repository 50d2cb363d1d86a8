// Height maps as parallax. For mesh.frag, which reads them.

const float kReliefEnds_m = 9.0;

// Where the eye's way meets what the height map says, below the surface: steps down, then a straight line
// through the last two (parallax occlusion mapping: Brawley and Tatarchuk, 2004). Flat from afar.
vec2 below_relief(vec2 uv, vec3 to_eye, float eye_distance_m) {
    vec2 texels = vec2(textureSize(height_map, 0)) * max(fwidth(uv.x), fwidth(uv.y));
    float lod = log2(max(max(texels.x, texels.y), 1.0));
    float depth = material.relief.x * clamp(2.0 - 2.0 * eye_distance_m / kReliefEnds_m, 0.0, 1.0);
    if (depth <= 0.0) return uv;
    vec3 n = normalize(surface_normal_world);
    vec3 t = normalize(surface_tangent_world.xyz - n * dot(n, surface_tangent_world.xyz));
    vec3 b = cross(n, t) * surface_tangent_world.w;
    // Green is up in the image, where v is less.
    vec2 way = vec2(-dot(to_eye, t), dot(to_eye, b)) * (depth / max(dot(to_eye, n), 0.15));
    const int kSteps = 12;
    float before = 0.0;
    for (int i = 1; i <= kSteps; ++i) {
        float at = float(i) / float(kSteps);
        float below = 1.0 - textureLod(height_map, uv + way * at, lod).r - at;
        if (below <= 0.0) {
            float back = below / (below - before);
            return uv + way * (at - back / float(kSteps));
        }
        before = below;
    }
    return uv + way;
}
