// Distance fog: the share of light that gets through falls as exp(-(density * distance)^2).

float fog_transmittance(float distance_m) {
    float depth = frame.fog.w * distance_m;
    return exp(-depth * depth);
}

// A ray towards the sky leaves the fog, which lies 30 m thick, sooner the steeper it climbs: the
// horizon is all fog, where the ground fades into it, and overhead the sky shows through.
float sky_transmittance(vec3 direction_world) {
    return fog_transmittance(30.0 / max(direction_world.y, 0.02));
}
