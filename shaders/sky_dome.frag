// A computed sky: clouds before the air's light. Passes: sky. Reads the clouds' cube map.

in vec3 sky_radiance;
#ifdef PL_CLOUDS
in vec3 cloud_direction;
in vec3 cloud_ambient;
in vec3 cloud_light;
uniform samplerCube sky_map;
uniform vec3 cloud_key;  // x, z of the way to their light; the clouds' share
#endif

layout(location = 0) out vec4 out_color;

void main() {
    vec3 color = sky_radiance;
#ifdef PL_CLOUDS
    // How much of the light it sends on, how much more per x and z of the light's way; its cover.
    vec4 cloud = texture(sky_map, cloud_direction);
    float lit = max(cloud.r + dot(cloud.gb - 0.5, cloud_key.xy), 0.0);
    color = mix(color, cloud_ambient + cloud_light * lit, cloud.a * cloud_key.z);
#endif
    out_color = vec4(color, 1.0);
}
