// Elementary functions with the same bits on every processor and with every C library.
//
// The C library picks its variant of sin or exp by the processor (with or without FMA), and two
// versions of it round differently, so a state that came through them has another hash elsewhere.
// These use additions, multiplications, divisions and square roots of IEEE 754 alone, are off by
// less than one unit in the last place, and are what everything that feeds the simulation's state
// calls (`architecture.portable_math` looks for others). Of floats: computed in double, then rounded.
#pragma once

namespace plumbline {

double portable_sin(double angle_rad);
double portable_cos(double angle_rad);
double portable_asin(double sine);    ///< not a number beyond -1 and 1
double portable_acos(double cosine);  ///< not a number beyond -1 and 1
double portable_atan2(double y, double x);
double portable_exp(double x);
double portable_expm1(double x);  ///< exp(x) - 1, exact for small x too

inline float portable_sin(float angle_rad) {
    return static_cast<float>(portable_sin(static_cast<double>(angle_rad)));
}
inline float portable_cos(float angle_rad) {
    return static_cast<float>(portable_cos(static_cast<double>(angle_rad)));
}
inline float portable_asin(float sine) {
    return static_cast<float>(portable_asin(static_cast<double>(sine)));
}
inline float portable_acos(float cosine) {
    return static_cast<float>(portable_acos(static_cast<double>(cosine)));
}
inline float portable_atan2(float y, float x) {
    return static_cast<float>(portable_atan2(static_cast<double>(y), static_cast<double>(x)));
}
inline float portable_exp(float x) {
    return static_cast<float>(portable_exp(static_cast<double>(x)));
}

/// base to a whole power, by products.
template <class T>
constexpr T whole_power(T base, int exponent) {
    T factor = exponent < 0 ? T(1) / base : base;
    T result = T(1);
    for (unsigned left = exponent < 0 ? 0U - static_cast<unsigned>(exponent)
                                      : static_cast<unsigned>(exponent);
         left > 0;
         left /= 2) {
        if (left % 2 == 1) result *= factor;
        factor *= factor;
    }
    return result;
}

}  // namespace plumbline
