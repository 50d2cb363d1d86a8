// The state file and the trace of `simulate`, field for field as docs/SCENE-FORMAT.md says.
#pragma once

#include "engine/physics/totals.h"
#include "engine/scene/simulation.h"

#include <string>
#include <vector>

namespace plumbline::scene {

/// Collects per-step costs while a run goes on: medians and percentiles come from here.
struct CostHistory {
    std::vector<float> step_ms;
    double cpu_ms_total{0};   ///< of all threads
    double wall_ms_total{0};  ///< on the clock
    double broad_ms{0};
    double narrow_ms{0};
    double solve_ms{0};
    double integrate_ms{0};
    std::uint64_t row_solves{0};
    std::uint32_t contacts_max{0};
    physics::Interventions interventions{};  ///< of all steps
    physics::StepCost recent{};  ///< ms of phases and threads, smoothed over some thirty steps

    void add(const physics::StepCost& cost);
};

/// "0.31 J braked in 5 islands, 3 bodies clamped": what was done to motion beside solving for it.
/// Empty: nothing was.
std::string interventions_text(const physics::Interventions& done);

/// Of the newest frame or step in a figure that is smoothed.
inline constexpr double kShareOfNewest = 1.0 / 30.0;

struct Percentiles {
    double median{0};
    double p95{0};
    double p99{0};
    double max{0};
};
Percentiles percentiles_of(std::vector<float> values);

/// Of everything that moves, and of fields.
struct Totals {
    physics::Energy energy{};  ///< of bodies, cloths and soft bodies
    double water_J{0};         ///< what displaced water has risen by, and waves
    double magnetic_J{0};
    Vec3d momentum_kgmps{0, 0, 0};
    Vec3d angular_momentum_kgm2ps{0, 0, 0};

    double energy_J() const { return energy.total_J() + water_J + magnetic_J; }
};
Totals totals_of(const Simulation& simulation);

/// One JSON object as text. `effects_json`: the ledger, already JSON (effects/ledger.h).
std::string state_json(const Simulation& simulation,
                       const CostHistory& costs,
                       const std::string& effects_json,
                       double lost_time_s,
                       bool one_line);
std::string interventions_json(const physics::Interventions& done);
/// The "cost" object alone, as JSON text: play and render reports use it for "physics".
std::string cost_json(const CostHistory& costs);

}  // namespace plumbline::scene
