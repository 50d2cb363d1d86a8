// A thing at several moments while the shutter was open, and its way. Passes: motion_blur.
#include "include/blocks.glsl"

layout(location = 0) in vec3 position_body;
layout(location = 5) in vec4 world_from_body_x;
layout(location = 6) in vec4 world_from_body_y;
layout(location = 7) in vec4 world_from_body_z;
layout(location = 8) in vec4 moment;  // x: 0 as the shutter closes, 1 as it opened

uniform mat4 clip_before_from_body;

out vec4 place_now;
out vec4 place_before;
flat out float surface_moment;

void main() {
    vec4 body = vec4(position_body, 1.0);
    vec4 world = vec4(dot(world_from_body_x, body), dot(world_from_body_y, body),
                      dot(world_from_body_z, body), 1.0);
    place_now = frame.clip_from_world * world;
    place_before = clip_before_from_body * body;
    surface_moment = moment.x;
    gl_Position = mix(place_now, place_before, surface_moment);
}
