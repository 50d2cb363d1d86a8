// A round point of light before the sky; the moon shows the side that the sun shines on. Passes: sky.

flat in vec3 point_radiance;
flat in vec3 point_to_light;
flat in float point_edge;

layout(location = 0) out vec4 out_color;

void main() {
    vec2 at = (gl_PointCoord * 2.0 - 1.0) * vec2(1.0, -1.0) * (point_edge + 0.5);
    float radius = length(at);
    float share = clamp(point_edge + 0.5 - radius, 0.0, 1.0);
    vec3 normal = vec3(at / point_edge, 0.0);
    normal.z = sqrt(max(1.0 - dot(normal.xy, normal.xy), 0.0));
    if (dot(point_to_light, point_to_light) > 0.0)
        share *= 0.015 + 0.985 * clamp(2.0 * dot(normal, point_to_light), 0.0, 1.0);
    out_color = vec4(point_radiance * share, 1.0);
}
