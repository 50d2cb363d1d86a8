// Shades a drop as a soft streak, or a ring by which of its sides mirrors the sky. Passes: drops.
in vec2 shape_at;
flat in vec4 drop_color;
flat in vec3 ring_to_eye;

layout(location = 0) out vec4 out_color;

void main() {
    float reach2 = dot(shape_at, shape_at);
    // Of a ring: -1 on its inner rim, 0 on its crest, 1 on its outer rim.
    float slope = clamp(sqrt(reach2) * 5.0 - 4.0, -1.0, 1.0);
    float away = slope * dot(shape_at, ring_to_eye.xy);
    float crest = (1.0 - slope * slope) * drop_color.a;
    vec2 soft = 1.0 - shape_at * shape_at;
    float streak = soft.x * soft.y * drop_color.a;
    float is_ring = ring_to_eye.z;
    // The side that faces away mirrors the bright sky low down, the near side shows the depth.
    vec3 color = drop_color.rgb * mix(1.0, 0.75 + 0.75 * away, is_ring);
    out_color = vec4(color, clamp(mix(streak, crest, is_ring), 0.0, 1.0));
}
