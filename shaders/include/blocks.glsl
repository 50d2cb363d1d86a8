// Uniform blocks, std140. Mirrored in engine/render/shader_blocks.h, which says what each w holds.
#include "shared/limits.h"

layout(std140) uniform Frame {
    mat4 clip_from_world;
    mat4 world_from_ray;
    mat4 sun_shadow_from_world;
    mat4 flashlight_shadow_from_world;
    vec4 camera_world;
    vec4 to_sun_world;
    vec4 sun_radiance;
    vec4 ambient;
    vec4 fog;
    vec4 flashlight_position;
    vec4 flashlight_direction;
    vec4 flashlight_intensity;
    vec4 tone;
    vec4 clusters;
    vec4 wind;
    vec4 gusts[PL_GUST_WAVES];
    vec4 cascade_ends;
    vec4 cascades[PL_MAX_CASCADES];
    vec4 sky_light[PL_SKY_COEFFICIENTS];
    vec4 aerial[3];
    vec4 grid[2];
} frame;

layout(std140) uniform Material {
    vec4 base_color;
    vec4 emissive;
    vec4 surface;
    vec4 relief;
} material;

struct LocalLight {
    vec4 position_world;
    vec4 intensity;
    vec4 direction_world;
    vec4 shadow;
};
