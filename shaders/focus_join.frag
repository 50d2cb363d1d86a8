// The sharp scene where it is in focus, the blurred one elsewhere. Passes: focus. Reads the scene's
// image, the depth image and the blurred scene.
#include "include/blocks.glsl"
#include "include/view_depth.glsl"
#include "include/scene_light.glsl"

in vec2 screen_uv;
in vec3 ray_world;
uniform sampler2D blurred_image;
uniform vec4 lens;  // radius in pixels = x - y / metres; at most z

layout(location = 0) out vec4 out_color;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec2 texel = 0.75 / vec2(textureSize(blurred_image, 0));
    vec4 blurred = 0.25 * (texture(blurred_image, screen_uv + texel * vec2(-1.0, -1.0)) +
                           texture(blurred_image, screen_uv + texel * vec2(1.0, -1.0)) +
                           texture(blurred_image, screen_uv + texel * vec2(-1.0, 1.0)) +
                           texture(blurred_image, screen_uv + texel * vec2(1.0, 1.0)));
    float own = abs(lens.x - lens.y / view_depth(texelFetch(depth_image, at, 0).r));
    // What stands before it may spread over what is sharp itself.
    float radius_px = max(own, 2.0 * blurred.a);
    out_color = vec4(mix(scene_light(at), blurred.rgb, smoothstep(0.5, 2.5, radius_px)), 1.0);
}
