#include "engine/render/sky/atmosphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace plumbline::render {
namespace {

constexpr float kGround_m = 6'360e3F;
constexpr float kTop_m = 6'460e3F;
constexpr float kAir_m = kTop_m - kGround_m;
constexpr Vec3f kAirScatters_perm{5.802e-6F, 13.558e-6F, 33.1e-6F};
constexpr float kHazeScatters_perm = 3.996e-6F;
constexpr float kHazeLoses_perm = 4.440e-6F;
constexpr Vec3f kOzoneAbsorbs_perm{0.650e-6F, 1.881e-6F, 0.085e-6F};
constexpr float kHazeForward = 0.8F;
// Half the sun's breadth, and what the air lifts it at the horizon.
constexpr float kDisc = 0.0047F;
constexpr Vec3f kGroundReflects{0.25F, 0.25F, 0.2F};

constexpr std::size_t kAltitudes = 24;
constexpr std::size_t kColumns = 128;
constexpr std::size_t kOftenAltitudes = 12;
constexpr std::size_t kOftenSines = 32;

/// How far a ray from `altitude_m` runs to the top of the air; `meets_ground` ends it there.
float path_m(float altitude_m, float sin_height, bool& meets_ground) {
    const float r = kGround_m + altitude_m;
    // r sin, and what is left of a sphere's radius squared; by differences, for r is large.
    const float b = r * sin_height;
    const float over_ground = altitude_m * (2.0F * kGround_m + altitude_m);
    const float below_top = (kTop_m - r) * (kTop_m + r);
    const float ground = b * b - over_ground;
    meets_ground = sin_height < 0.0F && ground >= 0.0F;
    if (meets_ground) return -b - std::sqrt(ground);
    return -b + std::sqrt(b * b + below_top);
}

/// Altitude and sine against the vertical there, so far along a ray.
struct Along {
    float altitude_m;
    float sine_up;  ///< of the ray against the horizontal there
};
Along along(float altitude_m, float sin_height, float way) {
    const float r = kGround_m + altitude_m;
    const float rise =
        way * (2.0F * r * sin_height + way) + altitude_m * (2.0F * kGround_m + altitude_m);
    const float at = rise / (std::sqrt(kGround_m * kGround_m + rise) + kGround_m);
    return {std::max(at, 0.0F), (r * sin_height + way) / (kGround_m + std::max(at, 0.0F))};
}

/// A table's place: between two neighbours.
struct Between {
    std::size_t first;
    float share;
};
Between between(float at, std::size_t count) {
    const float place = std::clamp(at, 0.0F, 1.0F) * static_cast<float>(count - 1);
    const auto first = std::min(static_cast<std::size_t>(place), count - 2);
    return {first, place - static_cast<float>(first)};
}

Vec3f looked_up(const std::vector<Vec3f>& table, Between row, Between column, std::size_t columns) {
    const Vec3f* low = table.data() + row.first * columns + column.first;
    const Vec3f* high = low + columns;
    return glm::mix(glm::mix(low[0], low[1], column.share),
                    glm::mix(high[0], high[1], column.share),
                    row.share);
}

// Tables are finest where light changes fastest: near the ground, near its horizon.
float row_of(float altitude_m) {
    return std::sqrt(std::clamp(altitude_m / kAir_m, 0.0F, 1.0F));
}
float altitude_of(float row) {
    return row * row * kAir_m;
}
float horizon_sine(float altitude_m) {
    const float r = kGround_m + altitude_m;
    return -std::sqrt(std::max(altitude_m * (2.0F * kGround_m + altitude_m), 0.0F)) / r;
}
/// From the horizon up: rays that meet the ground have no place.
float column_of(float sine, float horizon) {
    return std::sqrt(std::max(sine - horizon, 0.0F) / (1.0F - horizon));
}
float sine_of(float column, float horizon) {
    return horizon + column * column * (1.0F - horizon);
}

Vec3f exp_of(const Vec3f& depth) {
    return {std::exp(-depth.x), std::exp(-depth.y), std::exp(-depth.z)};
}

constexpr float kOftenLowest = -0.4F;
float often_column(float light_sine) {
    return (light_sine - kOftenLowest) / (1.0F - kOftenLowest);
}

}  // namespace

float Atmosphere::rayleigh_phase(float cosine) {
    return 3.0F / (16.0F * glm::pi<float>()) * (1.0F + cosine * cosine);
}

float Atmosphere::haze_phase(float cosine) {
    // Cornette and Shanks, as in the paper.
    constexpr float g2 = kHazeForward * kHazeForward;
    const float narrow = 1.0F + g2 - 2.0F * kHazeForward * cosine;
    return 3.0F / (8.0F * glm::pi<float>()) * (1.0F - g2) * (1.0F + cosine * cosine) /
           ((2.0F + g2) * narrow * std::sqrt(narrow));
}

Atmosphere::Medium Atmosphere::medium_at(float altitude_m) const {
    const Vec3f air = kAirScatters_perm * std::exp(-altitude_m / 8e3F);
    const float haze = haze_ * std::exp(-altitude_m / 1.2e3F);
    const float ozone = std::max(1.0F - std::abs(altitude_m - 25e3F) / 15e3F, 0.0F);
    return {.air = air,
            .haze = kHazeScatters_perm * haze,
            .lost = air + Vec3f{kHazeLoses_perm * haze} + kOzoneAbsorbs_perm * ozone};
}

Atmosphere::Atmosphere(float haze) : haze_(std::clamp(haze, 0.0F, 20.0F)) {
    transmittance_.reserve(kAltitudes * kColumns);
    for (std::size_t i = 0; i < kAltitudes; ++i) {
        const float altitude_m =
            altitude_of(static_cast<float>(i) / static_cast<float>(kAltitudes - 1));
        const float horizon = horizon_sine(altitude_m);
        for (std::size_t k = 0; k < kColumns; ++k) {
            const float column = static_cast<float>(k) / static_cast<float>(kColumns - 1);
            transmittance_.push_back(transmittance_along(altitude_m, sine_of(column, horizon)));
        }
    }
    often_.reserve(kOftenAltitudes * kOftenSines);
    for (std::size_t i = 0; i < kOftenAltitudes; ++i) {
        const float row = static_cast<float>(i) / static_cast<float>(kOftenAltitudes - 1);
        for (std::size_t k = 0; k < kOftenSines; ++k) {
            const float column = static_cast<float>(k) / static_cast<float>(kOftenSines - 1);
            often_.push_back(
                often_from(altitude_of(row), kOftenLowest + column * (1.0F - kOftenLowest)));
        }
    }
}

Vec3f Atmosphere::transmittance_along(float altitude_m, float sin_height) const {
    constexpr int kSteps = 40;
    bool meets_ground = false;
    const float whole_m = path_m(altitude_m, sin_height, meets_ground);
    Vec3f depth{0.0F};
    float before = 0.0F;
    for (int i = 1; i <= kSteps; ++i) {
        // Short steps first: low air is thick.
        const float share = static_cast<float>(i) / kSteps;
        const float end = whole_m * share * share;
        const float middle = 0.5F * (before + end);
        depth += medium_at(along(altitude_m, sin_height, middle).altitude_m).lost * (end - before);
        before = end;
    }
    return exp_of(depth);
}

Vec3f Atmosphere::transmittance(float sin_height, float altitude_m) const {
    const float horizon = horizon_sine(altitude_m);
    const float above = std::clamp((sin_height - horizon) / kDisc * 0.5F + 0.5F, 0.0F, 1.0F);
    if (above <= 0.0F) return Vec3f{0.0F};
    return above * looked_up(transmittance_,
                             between(row_of(altitude_m), kAltitudes),
                             between(column_of(sin_height, horizon), kColumns),
                             kColumns);
}

Vec3f Atmosphere::often_at(float altitude_m, float light_sin_height) const {
    if (light_sin_height <= kOftenLowest) return Vec3f{0.0F};
    return looked_up(often_,
                     between(row_of(altitude_m), kOftenAltitudes),
                     between(often_column(light_sin_height), kOftenSines),
                     kOftenSines);
}

/// Hillaire 2020, equations 5 to 10: what is scattered twice, and how much each further time keeps.
Vec3f Atmosphere::often_from(float altitude_m, float light_sin_height) const {
    constexpr int kSines = 8;
    constexpr int kTurns = 4;
    constexpr int kSteps = 16;
    const float light_cos = std::sqrt(std::max(1.0F - light_sin_height * light_sin_height, 0.0F));
    Vec3f twice{0.0F};
    Vec3f kept{0.0F};
    for (int i = 0; i < kSines * kTurns; ++i) {
        const float sine = 2.0F * (static_cast<float>(i / kTurns) + 0.5F) / kSines - 1.0F;
        const float turn = glm::pi<float>() * (static_cast<float>(i % kTurns) + 0.5F) / kTurns;
        const float cosine = std::sqrt(1.0F - sine * sine);
        bool meets_ground = false;
        const float whole_m = path_m(altitude_m, sine, meets_ground);
        Vec3f through{1.0F};
        for (int k = 0; k < kSteps; ++k) {
            const float step_m = whole_m / kSteps;
            const float at_m = step_m * (static_cast<float>(k) + 0.5F);
            const Along here = along(altitude_m, sine, at_m);
            // The light against the vertical there, which leans with the ray's way over the ground.
            const float lean = at_m * cosine / (kGround_m + here.altitude_m);
            const float light = light_sin_height + lean * light_cos * std::cos(turn);
            const Medium medium = medium_at(here.altitude_m);
            const Vec3f lost = exp_of(medium.lost * step_m);
            const Vec3f scatters = medium.air + Vec3f{medium.haze};
            const Vec3f share = through * (1.0F - lost) * scatters / medium.lost;
            twice += share * transmittance(std::clamp(light, -1.0F, 1.0F), here.altitude_m) /
                     (4.0F * glm::pi<float>());
            kept += share;
            through *= lost;
        }
        if (meets_ground) {
            const float lean = whole_m * cosine / kGround_m;
            const float light = light_sin_height + lean * light_cos * std::cos(turn);
            twice += through * transmittance(std::clamp(light, -1.0F, 1.0F)) *
                     std::max(light, 0.0F) * kGroundReflects * glm::one_over_pi<float>();
        }
    }
    constexpr float kShare = 1.0F / (kSines * kTurns);
    return twice * kShare / (1.0F - glm::min(kept * kShare, Vec3f{0.95F}));
}

Atmosphere::Scattered Atmosphere::scattered(float sin_height,
                                            float cos_between,
                                            float light_sin_height) const {
    constexpr int kSteps = 24;
    constexpr float kEye_m = 2.0F;
    const float sine = std::max(sin_height, 0.0F);
    const float cosine = std::sqrt(std::max(1.0F - sine * sine, 0.0F));
    const float light_cos = std::sqrt(std::max(1.0F - light_sin_height * light_sin_height, 0.0F));
    bool meets_ground = false;
    const float whole_m = path_m(kEye_m, sine, meets_ground);
    Scattered sum{};
    Vec3f through{1.0F};
    float before = 0.0F;
    for (int i = 1; i <= kSteps; ++i) {
        const float share = static_cast<float>(i) / kSteps;
        const float end = whole_m * share * share;
        const float at_m = 0.5F * (before + end);
        const float step_m = end - before;
        before = end;
        const Along here = along(kEye_m, sine, at_m);
        // The vertical there, against the eye's: it leans the way of the ray.
        const float lean_sin = at_m * cosine / (kGround_m + here.altitude_m);
        const float lean_cos = std::sqrt(1.0F - lean_sin * lean_sin);
        const float light = light_sin_height * lean_cos + light_cos * cos_between * lean_sin;
        const Medium medium = medium_at(here.altitude_m);
        const Vec3f lost = exp_of(medium.lost * step_m);
        const Vec3f share_here = through * (1.0F - lost) / medium.lost;
        const Vec3f reached = transmittance(light, here.altitude_m);
        sum.air += share_here * medium.air * reached;
        sum.haze += share_here * medium.haze * reached;
        sum.often +=
            share_here * (medium.air + Vec3f{medium.haze}) * often_at(here.altitude_m, light);
        through *= lost;
    }
    return sum;
}

}  // namespace plumbline::render
