// Places one drop as a streak that faces the eye, or one ring on level water. Passes: drops.
#include "include/blocks.glsl"
#include "include/fog.glsl"

layout(location = 0) in vec4 place;  // w: radius; below 0: a ring
layout(location = 1) in vec4 trail;  // w: opacity

uniform float pixel_rad;

out vec2 shape_at;  // -1…1 across and along
flat out vec4 drop_color;
flat out vec3 ring_to_eye;  // level, unit; z: 1 for a ring

// Water spreads light from behind it forwards, and shows the sky all round.
vec3 drop_light(vec3 to_eye) {
    vec3 light = frame.ambient.rgb * 1.1;
    float ahead = max(-dot(to_eye, frame.to_sun_world.xyz), 0.0);
    light += frame.sun_radiance.rgb * (0.22 + 0.9 * ahead * ahead * ahead);
    vec3 from_light = place.xyz - frame.flashlight_position.xyz;
    float distance2 = max(dot(from_light, from_light), 0.01);
    float cosine = dot(from_light * inversesqrt(distance2), frame.flashlight_direction.xyz);
    float cone = clamp((cosine - frame.flashlight_direction.w) * frame.flashlight_intensity.w, 0.0, 1.0);
    float reach = distance2 * frame.flashlight_position.w * frame.flashlight_position.w;
    light += frame.flashlight_intensity.rgb * (0.25 * cone * clamp(1.0 - reach, 0.0, 1.0) / distance2);
    return light;
}

void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    shape_at = corner;
    vec3 to_eye = frame.camera_world.xyz - place.xyz;
    float distance_m = max(length(to_eye), 0.01);
    to_eye /= distance_m;
    bool is_ring = place.w < 0.0;
    vec3 position_world;
    float opacity = trail.w;
    if (is_ring) {
        position_world = place.xyz + vec3(corner.x * place.w, 0.003, corner.y * place.w);
        ring_to_eye = vec3(-normalize(to_eye.xz + 1e-4), 1.0);
    } else {
        // Thinner than a pixel it would come and go: it is drawn a pixel thick, and fainter.
        float least = 0.5 * pixel_rad * distance_m;
        float thick = max(place.w, least);
        opacity *= place.w / thick;
        vec3 along = trail.xyz;
        float length_m = length(along);
        along = length_m > 1e-4 ? along / length_m : vec3(0.0, 1.0, 0.0);
        vec3 across = cross(along, to_eye);
        float foreshortened = length(across);
        across = foreshortened > 1e-3 ? across / foreshortened : vec3(1.0, 0.0, 0.0);
        along = cross(to_eye, across);
        position_world = place.xyz + across * (corner.x * thick) +
                         along * (corner.y * (thick + 0.5 * length_m * foreshortened));
        ring_to_eye = vec3(0.0);
    }
    vec3 color = drop_light(to_eye);
    color = mix(frame.fog.rgb, color, fog_transmittance(distance_m));
    drop_color = vec4(color, opacity);
    gl_Position = frame.clip_from_world * vec4(position_world, 1.0);
}
