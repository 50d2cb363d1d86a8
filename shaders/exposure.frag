// How bright the scene is: the mean of the logarithm of the luminance over one cell of the image.
// Passes: post. Reads the scene's image.
#include "include/color.glsl"
#include "shared/limits.h"

uniform sampler2D source_image;

layout(location = 0) out vec4 out_color;

void main() {
    const int kSide = 4;
    vec2 cell_px = vec2(textureSize(source_image, 0)) / vec2(PL_METER_X, PL_METER_Y);
    float sum = 0.0;
    for (int i = 0; i < kSide * kSide; ++i) {
        vec2 at = floor(gl_FragCoord.xy) + (vec2(i % kSide, i / kSide) + 0.5) / float(kSide);
        vec3 light = texelFetch(source_image, ivec2(at * cell_px), 0).rgb;
        sum += log2(clamp(dot(light, kLuminance), 0.0005, 8.0));
    }
    out_color = vec4(sum / float(kSide * kSide));
}
