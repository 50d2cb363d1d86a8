// The wind, and how what sways obeys it. Mirrors scene/environment/wind_field.h: gusts are waves that the mean
// carries along, each across its own direction, so that air neither piles up nor thins out.

#ifdef PL_SWAYS

vec2 wind_at(vec3 position_world) {
    vec2 velocity = frame.wind.xy;
    for (int i = 0; i < PL_GUST_WAVES; ++i) {
        vec4 wave = frame.gusts[i];
        velocity += vec2(-wave.y, wave.x) *
                    (wave.w * sin(dot(wave.xy, position_world.xz) + wave.z));
    }
    return velocity;
}

const float kStrongest_mps = 15.0;

// weights: sway, phase, flutter. A free tip is carried 1 m in 10 m/s, as the square of the speed, and
// swings about that; leaves tremble across their surface, which turns it a little: `normal_world`.
vec3 swayed(vec3 position_world, vec3 weights, inout vec3 normal_world) {
    vec2 wind = wind_at(position_world);
    float speed = length(wind);
    // In a gale nothing bends further than in kStrongest_mps.
    wind *= min(1.0, kStrongest_mps / max(speed, 0.01));
    speed = min(speed, kStrongest_mps);
    float turns = weights.y * 6.2831853;
    float swing = 1.0 + 0.35 * sin(frame.wind.z * 2.3 + turns);
    vec2 carried = wind * (speed * 0.01 * weights.x * weights.x * swing);
    float beat = frame.wind.z * 8.5 - turns * 3.0 + dot(position_world, vec3(2.1, 3.3, 2.7));
    float tremble = weights.z * weights.z * min(speed * 0.1, 1.0);
    vec3 moved = position_world + normal_world * (0.25 * tremble * sin(beat));
    moved += vec3(carried.x, -0.3 * length(carried), carried.y);
    normal_world += vec3(wind.x, 0.0, wind.y) * (0.25 * tremble * cos(beat) / max(speed, 0.1));
    return moved;
}

#endif
