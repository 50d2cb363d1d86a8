// What effects that bodies feel are held to: closed forms, each measured in a scene of its own.
#pragma once

#include "engine/scene/screen_effects_description.h"

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace plumbline::study {

inline constexpr double kFieldGravity_mps2 = 9.81;
inline constexpr double kPi_rad = 3.14159265358979323846;

/// What one run came to.
struct FieldOutcome {
    double error{0};  ///< of what was measured, relative to what the reference says
    double cpu_ms_per_s{0};
};

struct FieldReference {
    std::string_view effect;  ///< its row: "drag"
    std::string_view name;    ///< "terminal speed"
    std::string_view formula;
    std::array<double, 3> tolerance;  ///< of the error: draft, balanced, precise
    FieldOutcome (*run)(scene::Fidelity fidelity);
};

/// 5 %, 1 % and 0.1 %: where nothing says otherwise.
inline constexpr std::array kByFidelity{0.05, 0.01, 0.001};

std::span<const FieldReference> air_references();
std::span<const FieldReference> belt_references();
std::span<const FieldReference> magnet_references();
std::span<const FieldReference> water_references();
std::span<const FieldReference> blast_references();
std::span<const FieldReference> rope_references();
std::span<const FieldReference> cloth_references();
std::span<const FieldReference> soft_references();
std::span<const FieldReference> vehicle_references();
std::span<const FieldReference> fracture_references();

/// All of them, in the order of the effects' names.
std::vector<FieldReference> field_references();

}  // namespace plumbline::study
