// Transfer curves, fitted to the standard's for speed: each says how far off it is.

// How bright linear light looks, by channel (ITU-R BT.709).
const vec3 kLuminance = vec3(0.2126, 0.7152, 0.0722);

// sRGB code values to light; within 0.002 of the standard's curve.
vec3 linear_from_srgb(vec3 c) {
    return c * (0.0160 + c * (0.6670 + c * 0.3170));
}

// Light to sRGB code values; within a tenth of one 8-bit step. A polynomial of the square root where
// the standard's curve has a power: much cheaper on software GL. Light above 1 gets codes above 1, which
// images of 8 bits cut off.
vec3 srgb_from_linear(vec3 light) {
    vec3 c = max(light, 0.0);
    vec3 s = sqrt(c);
    vec3 curve = -0.0401097 + s * (1.5179518 + s * (-1.4027401 + s * (2.0315797 + s * (-1.6236606 + s * 0.5173026))));
    return mix(curve, 12.92 * c, lessThanEqual(c, vec3(0.0031308)));
}

// Keeps middle grey (0.18) and its contrast of 1.1, opens the shadows, rolls highlights off to 1.
// x(ax+b) / (x(ax+c)+1) with a, b, c solved from those conditions.
vec3 tone_curve(vec3 x) {
    return x * (6.7474777 * x + 0.6) / (x * (6.7474777 * x + 3.3107095) + 1.0);
}

// What the screen shows of a radiance. Very bright colours lose some colour, as on film.
vec3 tone_mapped(vec3 radiance, float exposure) {
    vec3 c = max(radiance, 0.0) * exposure;
    float luminance = dot(c, kLuminance);
    c = mix(c, vec3(luminance), 0.35 * luminance / (luminance + 4.0));
    return tone_curve(c);
}
