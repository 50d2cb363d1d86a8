// The sky's light by its first four harmonics; the five of order 2 add a few hundredths and cost as
// much as a texture lookup on software GL.

#ifdef PL_SKY_LIGHT

vec3 sky_middle() {
    return 0.282095 * frame.sky_light[0].rgb;
}

// How much more comes from there than on average; linear in the direction.
vec3 sky_slope(vec3 d) {
    return 0.488603 * (frame.sky_light[1].rgb * d.y + frame.sky_light[2].rgb * d.z +
                       frame.sky_light[3].rgb * d.x);
}

// What a matt white surface sends out under the sky, by the slope of its normal.
vec3 sky_diffuse(vec3 middle, vec3 slope) {
    return max(middle + 0.6666667 * slope, 0.0);
}

// Where no normal map turns the normal, slopes come from the vertices: they are linear, and reading
// their uniforms in every pixel is dear on software GL.
#if !defined(PL_NORMAL_MAP) && (!defined(PL_TWO_SIDED) || defined(PL_ALPHA_MASK))
#define PL_SKY_BY_VERTEX 1
#endif

#endif
