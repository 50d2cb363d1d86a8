// The sun's shadow on a surface: which cascade, and its lookup. For mesh.frag, which has the map.

#ifdef PL_CASCADES
// From the first cascade's coordinates to the place in the map where the cascade of that distance
// lies. One cascade goes over into the next pixel by pixel: half way through the last tenth of its
// range, half of the pixels.
vec3 in_cascade(vec3 at, float eye_distance_m) {
    float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    float distance_m = eye_distance_m * (1.0 + 0.1 * noise);
    int i = int(distance_m > frame.cascade_ends.x) + int(distance_m > frame.cascade_ends.y) +
            int(distance_m > frame.cascade_ends.z);
    vec4 cascade = frame.cascades[i];
    at = at * cascade.w + cascade.xyz;
    // Coarse texels want to be looked up further off the surface.
    at.z -= i > 0 ? frame.clusters.w : 0.0;
    return vec3((at.x + float(i)) * frame.clusters.z, at.yz);
}
#endif

#ifdef PL_SUN_SHADOW
// `at`: in the first cascade.
float sun_lit(vec3 at, float eye_distance_m) {
    float lit = 1.0;
#ifdef PL_HARD_SHADOWS
    // Half a pixel apart: what is thinner than a pixel is not lost in every other one.
    vec3 aside = 0.25 * dFdy(at);
    vec3 other = at - aside;
    at += aside;
#ifdef PL_CASCADES
    other = in_cascade(other, eye_distance_m);
#endif
#endif
#ifdef PL_CASCADES
    at = in_cascade(at, eye_distance_m);
#endif
#ifdef PL_CONTACT_HARDENING
    lit = disc_shadow(sun_shadow_map, sun_depth_map, vec3(at.xy, min(at.z, 1.0)),
                      dot(normalize(surface_normal_world), frame.to_sun_world.xyz));
#else
    vec2 texel = vec2(handed_sun_radiance.w);
#ifdef PL_CASCADES
    texel.x *= frame.clusters.z;  // they lie side by side
#endif
    lit = filtered_shadow(sun_shadow_map, vec3(at.xy, min(at.z, 1.0)), texel);
#ifdef PL_HARD_SHADOWS
    lit = 0.5 * (lit + filtered_shadow(sun_shadow_map, vec3(other.xy, min(other.z, 1.0)), texel));
#endif
#endif
    // The last tenth of the distance fades the shadow out.
    return mix(lit, 1.0, clamp(eye_distance_m * handed_to_sun.w * 10.0 - 9.0, 0.0, 1.0));
}
#endif
