// Numbers that shaders and C++ share. Only #define lines: GLSL reads this file too.
#define PL_MAX_LIGHTS 256
#define PL_MAX_LIGHTS_PER_DRAW 8
#define PL_SKY_COEFFICIENTS 9
