#include "engine/render/sky/computed_sky.h"

#include "engine/core/color.h"

#include <algorithm>
#include <cmath>

namespace plumbline::render {
namespace {

constexpr std::size_t kRows = 40;
constexpr std::size_t kDirections = 33;
constexpr float kMoved = 0.99999962F;  // cosine of a twentieth of a degree

// Scenes give lamps in the units of an image of the day, some thousand times too bright beside the
// sun. So that they shine at dusk and not at noon, the fall of the evening's light, which is true in
// itself, is flattened as eyes flatten it: what the sky sends down goes as this power of what it
// truly would.
constexpr float kFall = 0.42F;
// What it does on level ground while the sun is some ten degrees high, of 1 outside the air.
constexpr float kEveningSky = 0.05F;
// The night's lights, of the sun's: brighter than true for the same reason.
constexpr Vec3f kMoonlight{0.0125F, 0.0145F, 0.0185F};
constexpr Vec3f kNightGlow{0.00028F, 0.0004F, 0.00075F};
// How far the moon goes before the point opposite the sun: nearly full, and high at dusk.
constexpr float kMoonAhead_rad = 0.87F;

constexpr Vec3f kGround{0.1F, 0.115F, 0.06F};
constexpr float kFlatLit = 0.3F;       // of clouds, by light that comes in level
constexpr float kSteepEnough = 0.25F;  // as a sine: from there on all of them
constexpr float kCloudAltitude_m = 2e3F;

float sine_from_degrees(float degrees) {
    return std::sin(radians_from_degrees(degrees));
}

float row_sine(std::size_t row) {
    const float v = static_cast<float>(row) / static_cast<float>(kRows - 1);
    return v * v;
}

}  // namespace

bool ComputedSky::want(const SkyModel& model, const Vec3f& sun_irradiance) {
    const bool same = atmosphere_ && sun_irradiance == sun_irradiance_ &&
                      model.haze == model_.haze && model.clouds == model_.clouds &&
                      model.pole_world == model_.pole_world &&
                      glm::dot(model.to_sun_world, model_.to_sun_world) > kMoved;
    if (same) return false;
    if (!atmosphere_ || model.haze != model_.haze) atmosphere_.emplace(model.haze);
    model_ = model;
    model_.to_sun_world = normalize_or(model.to_sun_world, Vec3f{0.0F, -1.0F, 0.0F});
    sun_irradiance_ = sun_irradiance;
    const float height = model_.to_sun_world.y;
    to_moon_ = glm::angleAxis(-kMoonAhead_rad, -model_.pole_world) * -model_.to_sun_world;
    light_up(sun_,
             model_.to_sun_world,
             height > sine_from_degrees(-20.0F) ? sun_irradiance : Vec3f{0.0F});
    find_level();
    // The moon's light comes once the sun's is gone.
    const float night = glm::smoothstep(sine_from_degrees(-3.0F), sine_from_degrees(-9.0F), height);
    const float moon_up =
        glm::smoothstep(sine_from_degrees(-6.0F), sine_from_degrees(4.0F), to_moon_.y);
    light_up(moon_, to_moon_, sun_irradiance * kMoonlight * (night * moon_up));
    night_glow_ = sun_irradiance * kNightGlow * night;
    stars_ = glm::smoothstep(sine_from_degrees(-4.0F), sine_from_degrees(-12.0F), height);
    find_key_light();
    return true;
}

void ComputedSky::light_up(LitAir& air, const Vec3f& to_light, const Vec3f& irradiance) const {
    air.to_light = to_light;
    air.irradiance = irradiance;
    if (irradiance == Vec3f{0.0F}) {
        air.table.clear();
        return;
    }
    air.table.resize(kRows * kDirections);
    for (std::size_t row = 0; row < kRows; ++row) {
        for (std::size_t column = 0; column < kDirections; ++column) {
            const float u = static_cast<float>(column) / static_cast<float>(kDirections - 1);
            air.table[row * kDirections + column] =
                atmosphere_->scattered(row_sine(row), 1.0F - 2.0F * u * u, to_light.y);
        }
    }
}

Vec3f ComputedSky::LitAir::at(const Vec3f& direction) const {
    if (table.empty()) return Vec3f{0.0F};
    const float sine = std::clamp(direction.y, 0.0F, 1.0F);
    const Vec2f way{direction.x, direction.z};
    const Vec2f light_heading{to_light.x, to_light.z};
    const float lengths = std::sqrt(glm::dot(way, way) * glm::dot(light_heading, light_heading));
    const float cosine =
        lengths > 1e-6F ? std::clamp(glm::dot(way, light_heading) / lengths, -1.0F, 1.0F) : 0.0F;
    const float row = std::sqrt(sine) * static_cast<float>(kRows - 1);
    const float column = std::sqrt(0.5F * (1.0F - cosine)) * static_cast<float>(kDirections - 1);
    const auto i = std::min(static_cast<std::size_t>(row), kRows - 2);
    const auto k = std::min(static_cast<std::size_t>(column), kDirections - 2);
    const float down = row - static_cast<float>(i);
    const float across = column - static_cast<float>(k);
    const Atmosphere::Scattered* low = table.data() + i * kDirections + k;
    const Atmosphere::Scattered* high = low + kDirections;
    const auto mixed = [&](Vec3f Atmosphere::Scattered::*part) {
        return glm::mix(glm::mix(low[0].*part, low[1].*part, across),
                        glm::mix(high[0].*part, high[1].*part, across),
                        down);
    };
    const float between = glm::dot(direction, to_light);
    return irradiance * (mixed(&Atmosphere::Scattered::air) * Atmosphere::rayleigh_phase(between) +
                         mixed(&Atmosphere::Scattered::haze) * Atmosphere::haze_phase(between) +
                         mixed(&Atmosphere::Scattered::often));
}

/// On level ground, from the whole dome.
Vec3f ComputedSky::gathered(const LitAir& air) const {
    constexpr int kSines = 10;
    constexpr int kTurns = 16;
    Vec3f sum{0.0F};
    for (int i = 0; i < kSines * kTurns; ++i) {
        const float sine = (static_cast<float>(i / kTurns) + 0.5F) / kSines;
        const float turn =
            2.0F * glm::pi<float>() * (static_cast<float>(i % kTurns) + 0.5F) / kTurns;
        const float cosine = std::sqrt(1.0F - sine * sine);
        sum += air.at({cosine * std::cos(turn), sine, cosine * std::sin(turn)}) * sine;
    }
    return sum * (2.0F * glm::pi<float>() / (kSines * kTurns));
}

/// Flattens the evening's fall: the sun outside the air shines as bright as it must for that.
void ComputedSky::find_level() {
    if (sun_.table.empty()) return;
    const float whole = std::max(luminance(sun_.irradiance), 1e-12F);
    const float share = luminance(gathered(sun_)) / (whole * kEveningSky);
    if (share > 0.0F && share < 1.0F) sun_.irradiance *= std::pow(share, kFall - 1.0F);
    if (share <= 0.0F) sun_ = {.to_light = sun_.to_light};
}

void ComputedSky::find_key_light() {
    const Vec3f sun = sun_.irradiance * atmosphere_->transmittance(sun_.to_light.y);
    const Vec3f moon = moon_.irradiance * atmosphere_->transmittance(moon_.to_light.y);
    key_light_ = sun != Vec3f{0.0F} ? KeyLight{sun_.to_light, sun} : KeyLight{moon_.to_light, moon};
    if (key_light_.irradiance == Vec3f{0.0F}) key_light_.to_light_world = {0.0F, 1.0F, 0.0F};

    const Vec3f high_sun =
        sun_.irradiance * atmosphere_->transmittance(sun_.to_light.y, kCloudAltitude_m);
    const Vec3f high_moon =
        moon_.irradiance * atmosphere_->transmittance(moon_.to_light.y, kCloudAltitude_m);
    cloud_key_ = luminance(high_sun) >= luminance(high_moon) ? KeyLight{sun_.to_light, high_sun}
                                                             : KeyLight{moon_.to_light, high_moon};

    const Vec3f sky = gathered(sun_) + gathered(moon_) + night_glow_ * glm::pi<float>();
    overhead_ = sky * glm::one_over_pi<float>();
    irradiance_ = sky + key_light_.irradiance * std::max(key_light_.to_light_world.y, 0.0F);
    ground_ = kGround * irradiance_ * glm::one_over_pi<float>();
}

Vec3f ComputedSky::above(const Vec3f& direction) const {
    const float low = 1.0F - std::clamp(direction.y, 0.0F, 1.0F);
    return sun_.at(direction) + moon_.at(direction) + night_glow_ * (1.0F + 1.5F * low * low * low);
}

Vec3f ComputedSky::radiance(const Vec3f& direction) const {
    const Vec3f sky = above(direction);
    if (direction.y >= 0.0F) return sky;
    return glm::mix(sky, ground_, glm::smoothstep(0.0F, 0.06F, -direction.y));
}

ComputedSky::CloudLight ComputedSky::cloud_light(const Vec3f& direction) const {
    // Thin edges shine towards the light behind them.
    const float ahead = std::max(glm::dot(direction, cloud_key_.to_light_world), 0.0F);
    const float silver = 1.0F + 1.4F * std::pow(ahead, 10.0F);
    // The flatter light comes in, the more clouds stand in each other's.
    const float met =
        glm::mix(kFlatLit, 1.0F, glm::smoothstep(0.0F, kSteepEnough, cloud_key_.to_light_world.y));
    return {.ambient = 0.75F * overhead_ + 0.5F * ground_,
            .light = cloud_key_.irradiance * (silver * met * glm::one_over_pi<float>())};
}

Vec2f ComputedSky::light_heading() const {
    const Vec3f& to = sun_.table.empty() ? moon_.to_light : sun_.to_light;
    const float length = std::sqrt(to.x * to.x + to.z * to.z);
    return length > 1e-4F ? Vec2f{to.x, to.z} / length : Vec2f{1.0F, 0.0F};
}

std::array<Vec3f, 3> ComputedSky::horizon() const {
    // Not at the light itself: its glow is much narrower than a square of the cosine can be.
    constexpr float kBeside = 0.64F;  // 50 degrees
    const Vec2f way = light_heading();
    const auto seen = [&](float cosine) {
        const float sine = std::sqrt(1.0F - cosine * cosine);
        const Vec2f flat = way * cosine + Vec2f{-way.y, way.x} * sine;
        return above(glm::normalize(Vec3f{flat.x, 0.035F, flat.y}));
    };
    const Vec3f across = seen(0.0F);
    const Vec3f beside = seen(kBeside) - across;
    const Vec3f away = seen(-1.0F) - across;
    const Vec3f curve = (beside + kBeside * away) / (kBeside * kBeside + kBeside);
    return {across, curve - away, curve};
}

std::vector<RadianceImage> ComputedSky::faces() const {
    std::vector<RadianceImage> faces;
    for (std::size_t face = 0; face < 6; ++face) {
        RadianceImage image{.width = kSide, .height = kSide, .pixels = {}};
        image.pixels.reserve(std::size_t{kSide} * kSide);
        for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
            const float u = (static_cast<float>(i % kSide) + 0.5F) / kSide;
            const float v = (static_cast<float>(i / kSide) + 0.5F) / kSide;
            const Vec3f direction = cube_direction(face, u, v);
            Vec3f light = radiance(direction);
            if (!clouds_.empty() && direction.y > 0.0F) {
                const CloudTexel& cloud = clouds_[face * kSide * kSide + i];
                const CloudLight shone = cloud_light(direction);
                const Vec3f& to = cloud_key_.to_light_world;
                const float lit = cloud.lit + glm::dot(cloud.toward, Vec2f{to.x, to.z});
                light = glm::mix(light,
                                 shone.ambient + shone.light * std::max(lit, 0.0F),
                                 cloud.cover * model_.clouds);
            }
            image.pixels.push_back(light);
        }
        faces.push_back(std::move(image));
    }
    return faces;
}

Vec3f ComputedSky::sun_disc() const {
    // As bright as half floats and the bloom of a bright spot can take; truly 14 000 times the
    // irradiance.
    return sun_.irradiance * atmosphere_->transmittance(sun_.to_light.y) * 30.0F;
}

Vec3f ComputedSky::moon_disc() const {
    const Vec3f through = atmosphere_->transmittance(to_moon_.y);
    return sun_irradiance_ * through * Vec3f{0.26F, 0.25F, 0.235F} * std::max(stars_, 0.12F);
}

}  // namespace plumbline::render
