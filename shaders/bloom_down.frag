// Halves an image with a wide filter. Passes: post. Reads the next larger level.
#include "include/blocks.glsl"

in vec2 screen_uv;
in vec3 ray_world;
uniform sampler2D source_image;
layout(location = 0) out vec4 out_color;

void main() {
    // Four bilinear taps one source texel apart average 4 x 4 texels.
    vec2 texel = 1.0 / vec2(textureSize(source_image, 0));
    vec3 sum = texture(source_image, screen_uv + texel * vec2(-1.0, -1.0)).rgb +
               texture(source_image, screen_uv + texel * vec2(1.0, -1.0)).rgb +
               texture(source_image, screen_uv + texel * vec2(-1.0, 1.0)).rgb +
               texture(source_image, screen_uv + texel * vec2(1.0, 1.0)).rgb;
    out_color = vec4(min(sum * 0.25, 64.0), 1.0);
}
