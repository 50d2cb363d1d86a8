// A computed sky: the air's light on a dome, and what lights the clouds before it. Passes: sky.
#include "include/blocks.glsl"

layout(location = 0) in vec3 direction_world;
layout(location = 1) in vec3 sky;
layout(location = 2) in vec3 ambient;
layout(location = 3) in vec3 light;

out vec3 sky_radiance;
#ifdef PL_CLOUDS
out vec3 cloud_direction;
out vec3 cloud_ambient;
out vec3 cloud_light;
#endif

void main() {
    sky_radiance = sky;
#ifdef PL_CLOUDS
    cloud_direction = direction_world;
    cloud_ambient = ambient;
    cloud_light = light;
#endif
    // Without the camera's place: as far away as can be.
    gl_Position = (frame.clip_from_world * vec4(direction_world, 0.0)).xyww;
}
