// What a scene file says of forces that bodies feel, as plain data in SI units and radians.
#pragma once

#include "engine/core/math.h"
#include "engine/core/text/source_location.h"
#include "engine/scene/environment/cloth_description.h"
#include "engine/scene/environment/fracture_description.h"
#include "engine/scene/environment/rope_description.h"
#include "engine/scene/environment/soft_description.h"
#include "engine/scene/environment/vehicle_description.h"
#include "engine/scene/screen_effects_description.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace plumbline {
class Archive;
}

namespace plumbline::scene {

/// `drag` of a body: how air pushes it. Also a component.
struct Drag {
    Real coefficient{0.47_r};
    Real area_m2{0};      ///< 0: the shape's silhouette along the stream
    Real spin_lift{0};    ///< k of the Magnus force 0.5 rho k area r (w x v), r = sqrt(area / pi)
    bool buoyant{false};  ///< the air that it displaces carries it: a balloon
};

/// `magnet` of a body: a dipole at the centre of mass. Also a component.
struct Magnet {
    Vec3 moment_Am2{0, 0, 0};  ///< body frame
};

/// `[[wind_zone]]`: inside the box the air has this velocity on top of the share of the wind that blows there.
struct WindZone {
    Vec3 min_m{0, 0, 0};
    Vec3 max_m{0, 0, 0};
    Vec3 velocity_mps{0, 0, 0};
    Real wind_share{1};  ///< 0: a closed room
    SourceLocation location{};
};

enum class WaterSurface : std::uint8_t { Flat, Waves };

/// How a surface with waves begins, at rest: amplitude cos(nx pi x / L) cos(nz pi z / W) above the level.
struct WaveStart {
    Real amplitude_m{0};
    int nx{0};
    int nz{0};
};

/// `[[water]]`: a box of water, or what an entity's mesh holds.
struct WaterDescription {
    std::string name;
    std::string basin;  ///< the entity; empty: the box
    Vec3 min_m{0, 0, 0};
    Vec3 max_m{0, 0, 0};  ///< y: the level, of a basin too, which has the rest from its mesh
    Real density_kgpm3{1000};
    WaterSurface surface{WaterSurface::Flat};
    WaveStart start{};  ///< of waves
    Real drag{1};       ///< times all that resists motion in it; 0: buoyancy alone
    Vec3 flow_mps{0, 0, 0};
    std::vector<Vec2> probes_m;  ///< world x and z
    std::string material;        ///< what its surface looks like; empty: it is not drawn
    SourceLocation location{};
};

/// `[[explosion]]`.
struct ExplosionDescription {
    std::string name;              ///< triggers set it off by it
    std::optional<double> at_s{};  ///< none: no time sets it off
    Vec3 position_m{0, 0, 0};
    Real impulse_Ns{1000};  ///< over the whole sphere
    Real reach_m{30};       ///< to a body's surface
    SourceLocation location{};
};

/// [effects.NAME] fidelity.
struct FieldFidelity {
    Fidelity wind{Fidelity::Balanced};
    Fidelity drag{Fidelity::Balanced};
    Fidelity buoyancy{Fidelity::Balanced};
    Fidelity water{Fidelity::Balanced};
    Fidelity explosion{Fidelity::Balanced};
    Fidelity fracture{Fidelity::Balanced};
    Fidelity conveyor{Fidelity::Balanced};
    Fidelity magnets{Fidelity::Balanced};
    Fidelity rope{Fidelity::Balanced};
    Fidelity cloth{Fidelity::Balanced};
    Fidelity soft{Fidelity::Balanced};
    Fidelity vehicles{Fidelity::Balanced};
};

/// What stands in for the fidelity of one effect.
struct EffectFidelity {
    std::string effect;
    Fidelity fidelity{Fidelity::Balanced};

    void serialize(Archive& archive);
    friend bool operator==(const EffectFidelity&, const EffectFidelity&) = default;
};

/// What pushes and pulls bodies beside gravity, contacts and joints.
struct ForceDescription {
    Real air_density_kgpm3{1.204_r};
    Vec3 magnetic_field_T{0, 0, 0};  ///< uniform
    std::vector<WindZone> wind_zones{};
    std::vector<WaterDescription> waters{};
    std::vector<ExplosionDescription> explosions{};
    std::vector<RopeDescription> ropes{};
    std::vector<ClothDescription> cloths{};
    std::vector<SoftDescription> softs{};
    std::vector<VehicleDescription> vehicles{};
    FieldFidelity fidelity{};
};

}  // namespace plumbline::scene
