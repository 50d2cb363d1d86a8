// Places one instance of a mesh in a shadow map. Passes: shadows.
#include "include/blocks.glsl"

layout(location = 0) in vec3 position_body;
#ifdef PL_ALPHA_MASK
layout(location = 3) in vec2 uv;
out vec2 surface_uv;
#endif
layout(location = 5) in vec4 world_from_body_x;
layout(location = 6) in vec4 world_from_body_y;
layout(location = 7) in vec4 world_from_body_z;

uniform mat4 clip_from_world;

void main() {
    vec4 body = vec4(position_body, 1.0);
    vec4 world = vec4(dot(world_from_body_x, body), dot(world_from_body_y, body),
                      dot(world_from_body_z, body), 1.0);
#ifdef PL_ALPHA_MASK
    surface_uv = uv;
#endif
    gl_Position = clip_from_world * world;
}
