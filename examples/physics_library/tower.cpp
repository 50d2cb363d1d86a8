// Ten boxes that get heavier upwards, on a floor: how far the tower sinks at two settings of the solver,
// and what that costs. Built against the installed library: docs/LIBRARY.md.
#include "engine/physics/physics_world.h"

#include <cstdio>
#include <vector>

using namespace plumbline;

constexpr int kBoxes = 10;
constexpr Real kEdge_m = 0.5_r;

/// How far below its place the uppermost box is after 5 s; `cpu_ms`: of all steps.
double sinks_m(const physics::WorldDef& def, double& cpu_ms) {
    physics::PhysicsWorld world(def);
    const auto floor = world.create_shape(physics::PlaneShape{.size_m = {20, 20}});
    const auto box = world.create_shape(physics::BoxShape{.size_m = {kEdge_m, kEdge_m, kEdge_m}});
    if (!floor || !box) {
        std::fprintf(stderr, "%s\n", (floor ? box : floor).error().message.c_str());
        return 0;
    }
    world.create_body({.shape = *floor});
    std::vector<physics::BodyId> tower;
    for (int i = 0; i < kBoxes; ++i) {
        tower.push_back(
            world.create_body({.kind = physics::BodyKind::Dynamic,
                               .shape = *box,
                               .world_from_body = {.position = {0, (i + 0.5_r) * kEdge_m, 0}},
                               .mass_kg = static_cast<Real>(1 << i)}));
    }
    cpu_ms = 0;
    for (double time_s = 0; time_s < 5; time_s += def.step_s) {
        world.step();
        cpu_ms += world.report().cost.total_ms;
    }
    const Real top_m = world.state(tower.back()).world_from_body.position.y;
    return static_cast<double>((kBoxes - 0.5_r) * kEdge_m - top_m);
}

int main() {
    physics::WorldDef ours;  // small_step, 60 Hz, sub-steps on demand
    physics::WorldDef bullet;
    bullet.solver = physics::Solver::BulletSi;
    bullet.substeps = 1;
    bullet.iterations = 10;
    for (const physics::WorldDef& def : {ours, bullet}) {
        double cpu_ms = 0;
        const double sunk_m = sinks_m(def, cpu_ms);
        const std::string_view name = physics::solver_name(def.solver);
        std::printf("%-10.*s %9.3f mm lower after 5 s, %7.2f ms of CPU\n",
                    static_cast<int>(name.size()),
                    name.data(),
                    sunk_m * 1e3,
                    cpu_ms);
    }
}
