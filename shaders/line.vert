// Debug lines. Passes: lines.
#include "include/blocks.glsl"

layout(location = 0) in vec3 position_world;
layout(location = 1) in vec3 color;
out vec3 line_color;

void main() {
    line_color = color;
    gl_Position = frame.clip_from_world * vec4(position_world, 1.0);
}
