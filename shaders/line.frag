// Debug lines, blended by `opacity`. Passes: lines.
#include "include/color.glsl"

in vec3 line_color;
uniform float opacity;
layout(location = 0) out vec4 out_color;

void main() {
    out_color = vec4(srgb_from_linear(line_color), opacity);
}
