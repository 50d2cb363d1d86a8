// Adds a smaller level, smoothed, to the one above it. Passes: post. Reads the smaller level.
#include "include/blocks.glsl"

in vec2 screen_uv;
in vec3 ray_world;
uniform sampler2D source_image;
layout(location = 0) out vec4 out_color;

void main() {
    vec2 texel = 0.5 / vec2(textureSize(source_image, 0));
    vec3 sum = texture(source_image, screen_uv + texel * vec2(-1.0, -1.0)).rgb +
               texture(source_image, screen_uv + texel * vec2(1.0, -1.0)).rgb +
               texture(source_image, screen_uv + texel * vec2(-1.0, 1.0)).rgb +
               texture(source_image, screen_uv + texel * vec2(1.0, 1.0)).rgb;
    out_color = vec4(sum * 0.25, 0.5);
}
