// Water in the air: drops that leave nozzles, fly with drag and end in pools or on what they hit, and
// the rings that they raise. Plain data, stepped in fixed steps by its own random numbers: the same
// steps leave the same drops whatever is drawn. Touches no body.
#pragma once

#include "engine/core/io/pose_archive.h"
#include "engine/core/math.h"
#include "engine/core/random.h"
#include "engine/scene/nature_description.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace plumbline::effects {

struct Drop {
    Vec3f position_world{0.0F};
    Vec3f velocity_mps{0.0F};
    float radius_m{0.003F};
    float drag_per_m{0.0F};  ///< deceleration by air is this times the speed squared
    float age_s{0.0F};
    float ends_at_s{1e9F};   ///< the age at which it meets a body
    float looks_at_s{0.0F};  ///< the age at which it looks for bodies next
    float held_l{0.0F};      ///< water of the jet that it stands for; splashes hold none
    float rank{0.0F};        ///< 0…1, even: where fewer are drawn, the low ones stay

    void serialize(Archive& archive) {
        archive(position_world, velocity_mps, radius_m, drag_per_m, age_s);
        archive(ends_at_s, looks_at_s, held_l, rank);
    }
};

/// A ring on a pool, from the place where a drop fell in.
struct WaterRing {
    Vec3f center_world{0.0F};
    float age_s{0.0F};
    float strength{1.0F};  ///< 0…1
    float reach_m{0.3F};   ///< to the pool's edge

    void serialize(Archive& archive) { archive(center_world, age_s, strength, reach_m); }
};

/// Litres since the start: in_l = held_l + out_l to rounding.
struct WaterFlow {
    double in_l{0};
    double held_l{0};
    double out_l{0};
};

/// The share of the way from one point to another that is free, if something stands in it.
using Obstacles = std::function<std::optional<float>(const Vec3f& from, const Vec3f& to)>;

class Drops {
public:
    /// More a second than kMostPerSecond leave no nozzle: each then stands for more water.
    Drops(std::span<const scene::FountainDescription> fountains,
          scene::Fidelity fidelity,
          const Vec3f& gravity_mps2);

    /// `wind_mps`: of the air that the drops fly through.
    void step(float step_s, const Obstacles& obstacles, const Vec3f& wind_mps = Vec3f{0.0F});

    const std::vector<Drop>& drops() const { return drops_; }
    const std::vector<WaterRing>& rings() const { return rings_; }
    WaterFlow flow() const;
    void serialize(Archive& archive);
    std::size_t bytes() const;

    static constexpr float kMostPerSecond = 4000.0F;  ///< of all nozzles together
    static constexpr float kLongestFlight_s = 4.0F;   ///< after which a drop is mist
    static constexpr float kRingLife_s = 0.9F;

private:
    struct Nozzle {
        Vec3f position_world;
        Vec3f direction;
        Vec3f axis_x;  ///< these two across the direction
        Vec3f axis_z;
        std::optional<scene::NozzleRing> ring;
        float speed_mps;
        float spread_rad;
        float drops_per_s;
        float held_l;  ///< of each
        float radius_m;
        float drag_per_m;
        float due{0.0F};  ///< share of the next drop
    };
    struct Pool {
        Vec3f center_world;
        float radius_m;
    };

    void emit(Nozzle& nozzle, float step_s);
    Drop leaving(const Nozzle& nozzle);
    void integrate(Drop& drop, float step_s) const;
    struct PoolHit {
        Vec3f place_world;
        float reach_m;  ///< to the pool's edge
    };
    /// Where the way from `from` goes down through a pool.
    std::optional<PoolHit> pool_met(const Vec3f& from, const Vec3f& to) const;
    void look_ahead(Drop& drop, float step_s, const Obstacles& obstacles) const;
    void raise_ring(const PoolHit& hit);
    void splash(const Vec3f& place, const Drop& drop);

    Random random_{0x57A7E2};
    Vec3f gravity_mps2_;
    Vec3f wind_mps_{0.0F};  ///< of the step under way
    std::vector<Nozzle> nozzles_;
    std::vector<Pool> pools_;
    std::vector<Drop> drops_;
    std::vector<WaterRing> rings_;
    std::vector<Drop> splashes_;  ///< of the step under way
    double in_l_{0};
    double out_l_{0};
};

}  // namespace plumbline::effects
