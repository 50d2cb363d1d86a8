// Places one instance of a mesh. Passes: opaque, translucent.
#include "include/blocks.glsl"
#include "include/aerial.glsl"
#define HANDED flat out
#include "include/handed.glsl"
#include "include/sky_light.glsl"
#include "include/wind.glsl"

layout(location = 0) in vec3 position_body;
layout(location = 1) in vec3 normal_body;
layout(location = 2) in vec4 tangent_body;
layout(location = 3) in vec2 uv;
layout(location = 4) in vec4 color;
layout(location = 5) in vec4 world_from_body_x;
layout(location = 6) in vec4 world_from_body_y;
layout(location = 7) in vec4 world_from_body_z;
layout(location = 8) in vec4 tint;
#ifdef PL_SWAYS
layout(location = 9) in vec4 wind_weights;
#endif

// Drawn in two parts, a surface must have the same depth in both.
invariant gl_Position;

#if defined(PL_VERTEX_COLOR) && !defined(PL_FACETED)
out vec3 surface_color;
#else
flat out vec3 surface_color;
#endif
out vec3 surface_to_eye;
#ifdef PL_AERIAL
out vec4 surface_aerial;
#endif
#ifndef PL_UNLIT
#if defined(PL_FLAT) || defined(PL_FACETED)
flat out vec3 surface_normal_world;
#else
out vec3 surface_normal_world;
#endif
#endif
#if defined(PL_BASE_MAP) || defined(PL_NORMAL_MAP) || defined(PL_ORM_MAP) || defined(PL_EMISSIVE_MAP)
out vec2 surface_uv;
#endif
#ifdef PL_VARIATION
flat out float surface_mean;  // of the base colour map's green
uniform sampler2D base_color_map;
#endif
#ifdef PL_NORMAL_MAP
out vec4 surface_tangent_world;
#endif
#if defined(PL_SKY_BY_VERTEX) && !defined(PL_UNLIT)
#ifdef PL_FACETED
flat out vec3 surface_sky_slope;
flat out vec3 surface_sky_diffuse;
#else
out vec3 surface_sky_slope;
#endif
out vec3 surface_sky_slope_to_eye;
#endif
#ifdef PL_INDIRECT
out vec3 surface_in_grid;
#endif
#ifdef PL_SUN_SHADOW
out vec3 surface_sun_shadow;
#endif
#if defined(PL_FLASHLIGHT) && !defined(PL_FLASHLIGHT_AT_EYE)
out vec4 surface_flashlight_shadow;
#endif

vec3 to_world(vec4 body) {
    return vec3(dot(world_from_body_x, body), dot(world_from_body_y, body),
                dot(world_from_body_z, body));
}

void main() {
    vec3 position_world = to_world(vec4(position_body, 1.0));
#if !defined(PL_UNLIT) || defined(PL_SWAYS)
    // Normals turn with the matrix of cofactors, which is right for uneven scales too.
    vec3 x = world_from_body_x.xyz;
    vec3 y = world_from_body_y.xyz;
    vec3 z = world_from_body_z.xyz;
    vec3 normal_world = normalize(vec3(dot(cross(y, z), normal_body), dot(cross(z, x), normal_body),
                                       dot(cross(x, y), normal_body)));
#endif
#ifdef PL_SWAYS
    position_world = swayed(position_world, wind_weights.xyz, normal_world);
#endif
    surface_to_eye = frame.camera_world.xyz - position_world;
#ifdef PL_AERIAL
    // tint.a is 0 where the instance is near: the vertices of a large thing are too few to say.
    surface_aerial = mix(vec4(0.0, 0.0, 0.0, 1.0), aerial_light(surface_to_eye), tint.a);
#endif
    surface_color = tint.rgb * material.base_color.rgb;
#ifdef PL_VERTEX_COLOR
    surface_color *= color.rgb * color.rgb;  // packed as its square root
#endif
#if defined(PL_BASE_MAP) || defined(PL_NORMAL_MAP) || defined(PL_ORM_MAP) || defined(PL_EMISSIVE_MAP)
    surface_uv = uv;
#endif
#ifdef PL_VARIATION
    surface_mean = max(textureLod(base_color_map, vec2(0.5), 20.0).g, 0.05);
#endif
#ifdef PL_FACETED
#ifdef PL_SUN
    handed_to_sun = frame.to_sun_world;
    handed_sun_radiance = frame.sun_radiance;
#endif
#ifdef PL_FLASHLIGHT
    handed_flashlight_direction = frame.flashlight_direction;
    handed_flashlight_intensity = frame.flashlight_intensity;
    handed_flashlight_reach = frame.flashlight_position.w;
#endif
#ifdef PL_SKY_LIGHT
    handed_sky_middle = sky_middle();
#endif
    handed_surface = material.surface.xy;
#endif
#ifndef PL_UNLIT
    surface_normal_world = normal_world;
#ifdef PL_SKY_BY_VERTEX
    surface_sky_slope = sky_slope(normal_world);
    surface_sky_slope_to_eye = sky_slope(surface_to_eye);
#ifdef PL_FACETED
    surface_sky_diffuse = sky_diffuse(handed_sky_middle, surface_sky_slope);
#endif
#endif
#ifdef PL_NORMAL_MAP
    surface_tangent_world = vec4(to_world(vec4(tangent_body.xyz, 0.0)), tangent_body.w);
#endif
#ifdef PL_INDIRECT
    surface_in_grid =
        (position_world + frame.grid[0].w * normal_world) * frame.grid[0].xyz + frame.grid[1].xyz;
#endif
#ifdef PL_SUN_SHADOW
    // Looked up a texel's breadth off the surface, more where light grazes it: no acne.
    float slope = 1.0 - clamp(dot(normal_world, frame.to_sun_world.xyz), 0.0, 1.0);
    vec3 off_surface = position_world + normal_world * (frame.camera_world.w * (0.3 + slope));
    surface_sun_shadow = (frame.sun_shadow_from_world * vec4(off_surface, 1.0)).xyz;
#endif
#if defined(PL_FLASHLIGHT) && !defined(PL_FLASHLIGHT_AT_EYE)
    surface_flashlight_shadow =
        frame.flashlight_shadow_from_world * vec4(position_world + 0.01 * normal_world, 1.0);
#endif
#endif
    gl_Position = frame.clip_from_world * vec4(position_world, 1.0);
}
