// What every pixel reads of the frame and the material. Uniforms are dear in the pixels of software GL,
// so things of few plain faces hand it on from their vertices.

#ifdef PL_FACETED
#ifdef PL_SUN
HANDED vec4 handed_to_sun;
HANDED vec4 handed_sun_radiance;
#endif
#ifdef PL_FLASHLIGHT
HANDED vec4 handed_flashlight_direction;
HANDED vec4 handed_flashlight_intensity;
HANDED float handed_flashlight_reach;
#endif
#ifdef PL_SKY_LIGHT
HANDED vec3 handed_sky_middle;
#endif
HANDED vec2 handed_surface;
#else
#define handed_to_sun frame.to_sun_world
#define handed_sun_radiance frame.sun_radiance
#define handed_flashlight_direction frame.flashlight_direction
#define handed_flashlight_intensity frame.flashlight_intensity
#define handed_flashlight_reach frame.flashlight_position.w
#define handed_sky_middle sky_middle()
#define handed_surface material.surface.xy
#endif
