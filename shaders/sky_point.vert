// Sun, moon and stars as points, behind clouds. Passes: sky. Reads the clouds' cube map.
#include "include/blocks.glsl"

layout(location = 0) in vec3 direction_world;
layout(location = 1) in vec3 radiance;
layout(location = 2) in vec3 toward_light;
layout(location = 3) in float breadth_rad;
#ifdef PL_CLOUDS
uniform samplerCube sky_map;
uniform float cloud_share;
#endif

flat out vec3 point_radiance;
flat out vec3 point_to_light;  // right, up, towards the eye; 0: it shines itself
flat out float point_edge;     // half its breadth, px

void main() {
    point_radiance = radiance;
#ifdef PL_CLOUDS
    point_radiance *= 1.0 - textureLod(sky_map, direction_world, 0.0).a * cloud_share;
#endif
    vec3 right = frame.world_from_ray[0].xyz;
    vec3 up = frame.world_from_ray[1].xyz;
    point_to_light = vec3(dot(toward_light, normalize(right)), dot(toward_light, normalize(up)),
                          -dot(toward_light, direction_world));
    float height_px = float(PL_CLUSTERS_Y) / frame.clusters.y;
    float breadth_px = breadth_rad * 0.5 * height_px / length(up);
    // What is smaller than a pixel's diagonal is as much fainter.
    float shown_px = max(breadth_px, 1.5);
    point_radiance *= breadth_px * breadth_px / (shown_px * shown_px);
    point_edge = 0.5 * shown_px;
    gl_PointSize = shown_px + 1.0;
    gl_Position = (frame.clip_from_world * vec4(direction_world, 0.0)).xyww;
}
