// Vectors, quaternions and matrices.
//
// SI units, right-handed, +Y up, cameras look down -Z, radians, column-major, linear colour.
// `Real` is float; in plumbline-f64 (PL_DOUBLE_PRECISION) it is double. What the simulation keeps
// or computes is Real; what the GPU reads is float (Vec3f, Mat4f).
#pragma once

#include "engine/core/portable_math.h"

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cmath>

namespace plumbline {

#ifdef PL_DOUBLE_PRECISION
using Real = double;
inline constexpr const char* kPrecisionName = "float64";
#else
using Real = float;
inline constexpr const char* kPrecisionName = "float32";
#endif

using Vec2 = glm::vec<2, Real>;
using Vec3 = glm::vec<3, Real>;
using Vec4 = glm::vec<4, Real>;
using Mat3 = glm::mat<3, 3, Real>;
using Mat4 = glm::mat<4, 4, Real>;
using Quat = glm::qua<Real>;

using Vec2f = glm::vec2;
using Vec3f = glm::vec3;
using Vec4f = glm::vec4;
using Mat3f = glm::mat3;
using Mat4f = glm::mat4;
using Quatf = glm::quat;
using Vec3d = glm::dvec3;
using Quatd = glm::dquat;

/// A number at Real's own precision: 0.1_r is 0.1F or 0.1, never a widened float.
constexpr Real operator""_r(long double value) {
    return static_cast<Real>(value);
}

inline constexpr Real kPi = 3.14159265358979323846_r;
inline const Quat kNoRotation{Real{1}, Real{0}, Real{0}, Real{0}};

/// Degrees, as files and people write angles, to radians, as code keeps them.
template <class T>
constexpr T radians_from_degrees(T angle_deg) {
    return angle_deg * static_cast<T>(3.14159265358979323846 / 180.0);
}

template <class T>
constexpr T degrees_from_radians(T angle_rad) {
    return angle_rad * static_cast<T>(180.0 / 3.14159265358979323846);
}

template <class T>
bool is_finite(const glm::vec<3, T>& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

template <class T>
bool is_finite(const glm::qua<T>& q) {
    return std::isfinite(q.w) && std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z);
}

/// The unit vector along v, or `fallback` where v is too short to have a direction.
template <class T>
glm::vec<3, T> normalize_or(const glm::vec<3, T>& v, const glm::vec<3, T>& fallback) {
    const T length = glm::length(v);
    return length > static_cast<T>(1e-12) ? v / length : fallback;
}

/// The rotation by an angle about a unit axis; glm::angleAxis without the C library's sine.
template <class T>
glm::qua<T> portable_angle_axis(T angle_rad, const glm::vec<3, T>& axis) {
    const T half_rad = angle_rad * static_cast<T>(0.5);
    return {portable_cos(half_rad), axis * portable_sin(half_rad)};
}

/// From a (0) to b (1) at a steady rate along the shorter arc; glm::slerp without the C library's sine.
template <class T>
glm::qua<T> portable_slerp(const glm::qua<T>& a, glm::qua<T> b, T share) {
    T cosine = glm::dot(a, b);
    if (cosine < 0) {
        b = -b;
        cosine = -cosine;
    }
    // So near that the sines of both shares are the shares themselves.
    if (cosine > 1 - glm::epsilon<T>()) return a * (1 - share) + b * share;
    const T angle_rad = portable_acos(cosine);
    return (a * portable_sin((1 - share) * angle_rad) + b * portable_sin(share * angle_rad)) /
           portable_sin(angle_rad);
}

/// Rotation about x, then y, then z, as scene files give it; degrees.
inline Quat quat_from_euler_deg(const Vec3& angles_deg) {
    const Quat about_x = portable_angle_axis(radians_from_degrees(angles_deg.x), Vec3{1, 0, 0});
    const Quat about_y = portable_angle_axis(radians_from_degrees(angles_deg.y), Vec3{0, 1, 0});
    const Quat about_z = portable_angle_axis(radians_from_degrees(angles_deg.z), Vec3{0, 0, 1});
    return about_z * about_y * about_x;
}

}  // namespace plumbline
