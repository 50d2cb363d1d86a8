// Air between the eye and far things: their light goes over into the sky's at the horizon behind them.
// Nothing happens within PL_AERIAL_FROM_M, so near things go without.

#ifdef PL_AERIAL

// rgb: what the air adds; a: what it lets through.
vec4 aerial_light(vec3 to_eye) {
    float through = exp(-frame.aerial[0].w * max(length(to_eye) - PL_AERIAL_FROM_M, 0.0));
    vec2 way = -to_eye.xz;
    vec2 light_way = vec2(frame.aerial[1].w, frame.aerial[2].w);
    float cosine = dot(way, light_way) * inversesqrt(max(dot(way, way), 1e-6));
    vec3 horizon = frame.aerial[0].rgb + cosine * (frame.aerial[1].rgb + cosine * frame.aerial[2].rgb);
    return vec4(max(horizon, 0.0) * (1.0 - through), through);
}

#endif
