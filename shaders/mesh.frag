// Shades a surface. Passes: opaque, translucent. Reads the material's maps, the shadow maps and,
// where it mirrors, the sky; each only in the variants that need it.
#include "include/blocks.glsl"
#include "include/color.glsl"
#ifdef PL_BLEND
#include "include/fog.glsl"
#endif
#define HANDED flat in
#include "include/handed.glsl"
#include "include/lighting.glsl"
#include "include/shadow.glsl"
#include "include/sky_light.glsl"
#include "include/water.glsl"

#if defined(PL_VERTEX_COLOR) && !defined(PL_FACETED)
in vec3 surface_color;
#else
flat in vec3 surface_color;
#endif
in vec3 surface_to_eye;
#ifdef PL_AERIAL
in vec4 surface_aerial;
#endif
#ifndef PL_UNLIT
#if defined(PL_FLAT) || defined(PL_FACETED)
flat in vec3 surface_normal_world;
#else
in vec3 surface_normal_world;
#endif
#endif
#if defined(PL_BASE_MAP) || defined(PL_NORMAL_MAP) || defined(PL_ORM_MAP) || defined(PL_EMISSIVE_MAP)
in vec2 surface_uv;
#endif
#ifdef PL_NORMAL_MAP
in vec4 surface_tangent_world;
uniform sampler2D normal_map;
#endif
#ifdef PL_BASE_MAP
uniform sampler2D base_color_map;
#endif
#ifdef PL_VARIATION
flat in float surface_mean;
#endif
#ifdef PL_ORM_MAP
uniform sampler2D orm_map;
#endif
#ifdef PL_EMISSIVE_MAP
uniform sampler2D emissive_map;
#endif
#if defined(PL_SKY_BY_VERTEX) && !defined(PL_UNLIT)
#ifdef PL_FACETED
flat in vec3 surface_sky_slope;
flat in vec3 surface_sky_diffuse;
#else
in vec3 surface_sky_slope;
#endif
in vec3 surface_sky_slope_to_eye;
#endif
#ifdef PL_INDIRECT
in vec3 surface_in_grid;
uniform sampler3D grid_means;
uniform sampler3D grid_slopes;
#endif
#ifdef PL_SUN_SHADOW
in vec3 surface_sun_shadow;
uniform sampler2DShadow sun_shadow_map;
#ifdef PL_CONTACT_HARDENING
uniform sampler2D sun_depth_map;
#endif
#endif
#if defined(PL_FLASHLIGHT) && !defined(PL_FLASHLIGHT_AT_EYE)
in vec4 surface_flashlight_shadow;
uniform sampler2DShadow flashlight_shadow_map;
#endif
#ifdef PL_SKY_REFLECTION
uniform samplerCube sky_map;
#endif
#ifdef PL_PARALLAX
uniform sampler2D height_map;
vec2 shown_uv;  // set by main
#else
#define shown_uv surface_uv
#endif

layout(location = 0) out vec4 out_color;

#ifdef PL_OCCLUSION
float light_from_everywhere = 0.0;  // its luminance, set by lit_color
#endif

vec3 emitted_light() {
#ifdef PL_EMISSIVE_MAP
    return material.emissive.rgb * linear_from_srgb(texture(emissive_map, shown_uv).rgb);
#elif defined(PL_EMISSIVE)
    return material.emissive.rgb;
#else
    return vec3(0.0);
#endif
}

// Uniforms are dear on software GL: a shader that does not ask reads no camera.
vec3 surface_position_world() { return frame.camera_world.xyz - surface_to_eye; }

#ifndef PL_UNLIT

vec3 shading_normal() {
#ifdef PL_FACETED
    vec3 n = surface_normal_world;
#else
    vec3 n = normalize(surface_normal_world);
#endif
#if defined(PL_TWO_SIDED) && !defined(PL_ALPHA_MASK)
    // Leaf cards keep their normals, which bend outwards from the crown, on both sides.
    n = gl_FrontFacing ? n : -n;
#endif
#ifdef PL_RIPPLES
    vec2 lean = ripple_slope(surface_position_world().xz, frame.wind.z, length(surface_to_eye));
    n = normalize(n - vec3(lean.x, 0.0, lean.y) * n.y);
#endif
#ifdef PL_NORMAL_MAP
    vec3 t = normalize(surface_tangent_world.xyz - n * dot(n, surface_tangent_world.xyz));
    vec3 b = cross(n, t) * surface_tangent_world.w;
    vec3 m = texture(normal_map, shown_uv).xyz * 2.0 - 1.0;
    n = normalize(t * m.x + b * m.y + n * m.z);
#endif
    return n;
}

#ifdef PL_PARALLAX
#include "include/relief.glsl"
#endif
#include "include/sun_shadow.glsl"

#ifdef PL_SUN
vec3 sun_light(Surface s, float eye_distance_m) {
    float lit = 1.0;
#ifdef PL_SUN_SHADOW
    lit = sun_lit(surface_sun_shadow, eye_distance_m);
#endif
    vec3 light = handed_sun_radiance.rgb * lit;
    vec3 color = reflected(s, handed_to_sun.xyz, light);
#ifdef PL_LEAF
    color += transmitted(s, handed_to_sun.xyz, light, material.surface.z);
#endif
    return color;
}
#endif

#ifdef PL_FLASHLIGHT
vec3 flashlight_light(Surface s, float eye_distance_m) {
#ifdef PL_FLASHLIGHT_AT_EYE
    vec3 to_light = s.to_eye;
    float distance2 = max(eye_distance_m * eye_distance_m, 1e-4);
    float lit = 1.0;  // what the eye sees, such a light sees too
#else
    vec3 to_light = frame.flashlight_position.xyz - surface_position_world();
    float distance2 = max(dot(to_light, to_light), 1e-4);
    to_light *= inversesqrt(distance2);
    vec3 at = surface_flashlight_shadow.xyz / max(surface_flashlight_shadow.w, 1e-4);
    float lit = flashlight_shadow(flashlight_shadow_map, vec3(at.xy, min(at.z, 1.0)), frame.ambient.w);
#endif
    float cosine = -dot(to_light, handed_flashlight_direction.xyz);
    // 0 at the rim, 1 inside the inner cone; squared, so that the rim is soft.
    float cone = clamp((cosine - handed_flashlight_direction.w) * handed_flashlight_intensity.w, 0.0, 1.0);
    // A real torch throws a faint ring around a brighter middle.
    // cos(18 cone) by a smooth step up and down: a cosine is dear on software GL.
    float turn = abs(fract(cone * 2.8648) * 2.0 - 1.0);
    float ring = turn * turn * (6.0 - 4.0 * turn) - 1.0;
    float cookie = cone * cone * (0.85 + 0.15 * ring * (1.0 - cone));
    float falloff = windowed_falloff(distance2, handed_flashlight_reach);
    vec3 light = handed_flashlight_intensity.rgb * (cookie * lit * falloff);
#ifdef PL_FLASHLIGHT_AT_EYE
    return reflected_back(s, light);
#else
    return reflected(s, to_light, light);
#endif
}
#endif

#include "include/local_lights.glsl"

#if defined(PL_RIPPLES) || defined(PL_GLASS)
#define PL_CLEAR 1
float clear_mirrors = 0.0;  // a share of what comes from above, set by lit_color
#endif

// Light from everywhere. Either way a surface turned every way gets frame.ambient on average: the
// sky says where it comes from; without one, more comes from above than from below.
vec3 ambient_light(Surface s, float eye_distance_m, float occlusion) {
#ifdef PL_PHONG
    return frame.ambient.rgb * s.base_color;
#else
#ifdef PL_SKY_LIGHT
#ifdef PL_SKY_BY_VERTEX
#ifdef PL_FACETED
    vec3 slope = surface_sky_slope;
#else
    vec3 slope = surface_sky_slope *
                 inversesqrt(dot(surface_normal_world, surface_normal_world));
#endif
    vec3 slope_to_eye = surface_sky_slope_to_eye / max(eye_distance_m, 1e-4);
#else
    vec3 slope = sky_slope(s.normal);
    vec3 slope_to_eye = sky_slope(s.to_eye);
#endif
#if defined(PL_SKY_BY_VERTEX) && defined(PL_FACETED)
    vec3 diffuse = surface_sky_diffuse;
#else
    vec3 diffuse = sky_diffuse(handed_sky_middle, slope);
#endif
#ifdef PL_SKY_REFLECTION
    vec3 direction = reflect(-s.to_eye, s.normal);
#ifdef PL_RIPPLES
    direction.y = abs(direction.y);
#endif
    vec3 reflection = textureLod(sky_map, direction, s.roughness * frame.tone.z).rgb * frame.tone.w;
#else
    // The sky blurred as a rough surface mirrors it: the slope is that of the mirrored direction.
    vec3 mirrored_slope = 2.0 * dot(s.normal, s.to_eye) * slope - slope_to_eye;
    vec3 reflection = max(handed_sky_middle + 0.85 * mirrored_slope, 0.0);
#endif
#else
    vec3 diffuse = frame.ambient.rgb * (1.0 + 0.3 * s.normal.y);
    vec3 reflection = frame.ambient.rgb;
#endif
#ifdef PL_INDIRECT
    // Walls are thick: what lies a fiftieth of the box outside of it is not indoors any more.
    vec3 beyond = abs(surface_in_grid - 0.5) - 0.5;
    float indoors = clamp(1.0 - 50.0 * max(max(beyond.x, beyond.y), beyond.z), 0.0, 1.0);
    vec3 middle = texture(grid_means, surface_in_grid).rgb * frame.grid[1].w;
    float facing = dot(texture(grid_slopes, surface_in_grid).xyz, s.normal);
    diffuse = mix(diffuse, middle * max(1.0 + 0.6666667 * facing, 0.1), indoors);
    reflection *= mix(1.0, dot(middle, kLuminance) / max(dot(sky_middle(), kLuminance), 1e-5), indoors);
#endif
#ifdef PL_CLEAR
    float upwards = reflect(-s.to_eye, s.normal).y;
#ifdef PL_RIPPLES
    upwards = abs(upwards);
#endif
    reflection = mix(frame.ambient.rgb * kShores, reflection, over_shores(upwards));
    return diffuse * matt_color(s) + reflection * clear_mirrors;
#else
    // What is mirrored does not get in: no surface sends out more than falls on it.
    Reflectance mirrored = ambient_fresnel(s);
    return (diffuse * matt_color(s) * (1.0 - mirrored) + reflection * mirrored) * occlusion;
#endif
#endif
}

#ifdef PL_REFRACTION
BelowWater below;
#endif

#ifdef PL_REFRACTION
// Caustics gather the sun's share of the light below.
float caustic_light(float eye_distance_m) {
    float lit = 1.0;
#ifdef PL_SUN_SHADOW
    lit = sun_lit((frame.sun_shadow_from_world * vec4(below.place, 1.0)).xyz, eye_distance_m);
#endif
    float sun = dot(frame.sun_radiance.rgb, kLuminance) * max(frame.to_sun_world.y, 0.0) * lit;
#ifdef PL_SKY_LIGHT
    float sky = dot(sky_middle(), kLuminance);
#else
    float sky = dot(frame.ambient.rgb, kLuminance);
#endif
    float share = sun / max(sun + sky, 1e-5);
    return mix(1.0, gathered_light(below.place, below.depth_m), share);
}
#endif

#ifdef PL_CLEAR
// What gets through to the eye from behind.
vec3 clear_shows(float alpha) {
#ifdef PL_REFRACTION
    return through_water(below) * (1.0 - clear_mirrors);
#else
    return vec3((1.0 - alpha) * (1.0 - clear_mirrors));
#endif
}
#endif

vec3 lit_color(vec3 base_color, float alpha, float eye_distance_m, vec3 to_eye) {
    Surface s;
    s.base_color = base_color;
    s.roughness = handed_surface.x;
    s.metallic = handed_surface.y;
    s.normal = shading_normal();
    s.to_eye = to_eye;
#ifdef PL_RIPPLES
    clear_mirrors = water_fresnel(dot(s.normal, to_eye));
#endif
#ifdef PL_GLASS
    clear_mirrors = pane_fresnel(material.relief.y, dot(s.normal, to_eye));
#endif
#ifdef PL_REFRACTION
    below = below_water(surface_position_world(), s.normal, to_eye, eye_distance_m);
    s.base_color *= (1.0 - through_water(below)) * (1.0 - clear_mirrors);
#elif defined(PL_CLEAR)
    s.base_color *= alpha * (1.0 - clear_mirrors);
#endif
    float occlusion = 1.0;
#ifdef PL_ORM_MAP
    vec3 orm = texture(orm_map, shown_uv).rgb;
    occlusion = mix(1.0, orm.r, material.surface.w);
    s.roughness *= orm.g;
    s.metallic *= orm.b;
#endif
    vec3 color = ambient_light(s, eye_distance_m, occlusion);
#ifdef PL_OCCLUSION
    light_from_everywhere = dot(color, kLuminance);
#endif
    color += emitted_light();
#ifdef PL_SUN
    color += sun_light(s, eye_distance_m);
#endif
#ifdef PL_FLASHLIGHT
    color += flashlight_light(s, eye_distance_m);
#endif
#ifdef PL_LOCAL_LIGHTS
    color += local_lights_light(s);
#endif
    return color;
}

#endif

#ifdef PL_OCCLUSION
// What may be taken away where things hide the sky: passes after this one find it in alpha.
float occludable_share(vec3 color) {
    float light = light_from_everywhere;
#ifdef PL_AERIAL
    light *= surface_aerial.a;
#endif
    return clamp(light / max(dot(color, kLuminance), 1e-5), 0.0, 1.0);
}
#endif

void main() {
    vec3 to_eye = surface_to_eye;
    float eye_distance_m = length(to_eye);
#ifdef PL_PARALLAX
    shown_uv = below_relief(surface_uv, to_eye / max(eye_distance_m, 1e-4), eye_distance_m);
#endif
    vec4 base = vec4(surface_color, material.base_color.a);
#ifdef PL_BASE_MAP
    vec4 texel = texture(base_color_map, shown_uv);
#ifdef PL_VARIATION
    // The map again, larger and turned, says where it is lighter and darker than on average.
    float there = texture(base_color_map, shown_uv.yx * vec2(-0.137, 0.163) + 0.37).g;
    texel.rgb *= 1.0 + material.surface.z * (there / surface_mean - 1.0);
#endif
    base *= vec4(linear_from_srgb(texel.rgb), texel.a);
#ifdef PL_COVERAGE
    // As wide as a pixel, the mask's edge covers a share of its samples.
    float coverage = (base.a - material.emissive.w) / max(fwidth(base.a), 1e-3) + 0.5;
    if (coverage <= 0.0) discard;
#elif defined(PL_ALPHA_MASK)
    if (base.a < material.emissive.w) discard;
#endif
#endif
#ifdef PL_UNLIT
    vec3 color = base.rgb + emitted_light();
#else
    vec3 color = lit_color(base.rgb, base.a, eye_distance_m, to_eye / max(eye_distance_m, 1e-4));
#endif
#ifdef PL_CLEAR
    // Blending takes the share that hides what is behind: what is mirrored came with its own.
    vec3 shows = clear_shows(base.a);
    float hides = max(1.0 - dot(shows, kLuminance), 1e-3);
    color /= hides;
#endif
#ifdef PL_AERIAL
    color = color * surface_aerial.a + surface_aerial.rgb;
#endif
#ifdef PL_BLEND
    // The fog pass, which ran before, reads the depth of opaque surfaces.
    color = mix(frame.fog.rgb, color, fog_transmittance(eye_distance_m));
#endif
#ifdef PL_CODES
    color = srgb_from_linear(color);
#endif
#ifdef PL_BLEND
#ifdef PL_REFRACTION
    shows *= below.light * caustic_light(eye_distance_m);
    out_color = vec4(color * hides + shows, 1.0);
#elif defined(PL_CLEAR)
    out_color = vec4(color, hides);
#else
    out_color = vec4(color, base.a);
#endif
#elif defined(PL_COVERAGE)
    out_color = vec4(color, min(coverage, 1.0));
#elif defined(PL_OCCLUSION)
    out_color = vec4(color, occludable_share(color));
#else
    out_color = vec4(color, 1.0);
#endif
}
