// Numbers that shaders and C++ share. Only #define lines: GLSL reads this file too.
#define PL_MAX_LIGHTS 256
#define PL_MAX_SHADOWED_LIGHTS 8
#define PL_LIGHT_SHADOW_NEAR_M 0.04F
#define PL_LIGHT_SHADOW_MARGIN_PX 3.0F
#define PL_CLUSTERS_X 16
#define PL_CLUSTERS_Y 9
#define PL_CLUSTERS_Z 20
#define PL_CLUSTER_NEAR_M 1.0F
#define PL_CLUSTERS_PER_OCTAVE 3.0F
#define PL_MAX_CASCADES 4
#define PL_SUN_MAP_DEPTH 2.0F
#define PL_SKY_COEFFICIENTS 9
#define PL_GUST_WAVES 2
#define PL_METER_X 32
#define PL_METER_Y 18
#define PL_AERIAL_FROM_M 20.0F
