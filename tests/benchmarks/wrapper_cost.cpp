// What PhysicsWorld costs over a bare Bullet loop: the pile of 1000 crates, both in one process,
// the same bodies and settings, steps taken in turns so that a busy machine slows both alike.
//
//   wrapper_cost                        rounds as Google Benchmark chooses
//   wrapper_cost --benchmark_repetitions=5
//
// "ratio" is the CPU time of the one over that of the other; at most 1.05 is promised.
#include "engine/core/time/stopwatch.h"
#include "engine/physics/physics_world.h"

#include <benchmark/benchmark.h>
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <memory>
#include <vector>

namespace {

using namespace plumbline;
using namespace plumbline::physics;

constexpr int kSide = 10;
constexpr float kSpacing_m = 1.1F;
constexpr float kFriction = 0.6F;
constexpr int kSteps = 600;

Vec3 place_of(int i) {
    const auto x = static_cast<float>(i % kSide);
    const auto y = static_cast<float>(i / (kSide * kSide));
    const auto z = static_cast<float>(i / kSide % kSide);
    return {(x - 4.5F) * kSpacing_m, 0.6F + kSpacing_m * y, (z - 4.5F) * kSpacing_m};
}

/// Stock Bullet, used as its own examples use it.
class BarePile {
public:
    explicit BarePile(bool sleep) {
        world_.setGravity({0, -9.81F, 0});
        // As PhysicsWorld: without it two runs of one program may differ.
        world_.getDispatchInfo().m_deterministicOverlappingPairs = true;
        add(ground_, {0, -1, 0}, 0, sleep);
        for (int i = 0; i < kSide * kSide * kSide; ++i) add(crate_, place_of(i), 1000, sleep);
    }
    ~BarePile() {
        for (const auto& body : bodies_) world_.removeRigidBody(body.get());
    }
    BarePile(const BarePile&) = delete;
    BarePile& operator=(const BarePile&) = delete;

    void step() { world_.stepSimulation(1.0F / 60.0F, 0); }

private:
    void add(btBoxShape& shape, const Vec3& place, float mass_kg, bool sleep) {
        btVector3 inertia(0, 0, 0);
        if (mass_kg > 0) shape.calculateLocalInertia(mass_kg, inertia);
        btRigidBody::btRigidBodyConstructionInfo info(mass_kg, nullptr, &shape, inertia);
        info.m_startWorldTransform.setOrigin({place.x, place.y, place.z});
        info.m_friction = std::sqrt(kFriction);  // Bullet multiplies the two
        info.m_linearSleepingThreshold = 0.05F;
        info.m_angularSleepingThreshold = 0.1F;
        bodies_.push_back(std::make_unique<btRigidBody>(info));
        if (!sleep && mass_kg > 0) bodies_.back()->setActivationState(DISABLE_DEACTIVATION);
        world_.addRigidBody(bodies_.back().get());
    }

    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    btBoxShape ground_{btVector3(100, 1, 100)};
    btBoxShape crate_{btVector3(0.5F, 0.5F, 0.5F)};
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

class OurPile {
public:
    explicit OurPile(bool sleep) {
        const ShapeId ground = *world_.create_shape(BoxShape{.size_m = {200, 2, 200}});
        const ShapeId crate = *world_.create_shape(BoxShape{});
        world_.create_body(
            {.shape = ground, .world_from_body = {.position = {0, -1, 0}}, .friction = kFriction});
        for (int i = 0; i < kSide * kSide * kSide; ++i) {
            world_.create_body({.kind = BodyKind::Dynamic,
                                .shape = crate,
                                .world_from_body = {.position = place_of(i)},
                                .mass_kg = 1000,
                                .friction = kFriction,
                                .can_sleep = sleep});
        }
    }
    void step() { world_.step(); }

private:
    PhysicsWorld world_{WorldDef{.substeps = 1, .iterations = 10, .solver = Solver::BulletSi}};
};

void pile(benchmark::State& state, bool sleep) {
    double bare_s = 0;
    double ours_s = 0;
    for (auto _ : state) {
        BarePile bare(sleep);
        OurPile ours(sleep);
        double round_s = 0;
        for (int i = 0; i < kSteps; ++i) {
            const double start_s = thread_cpu_s();
            bare.step();
            const double middle_s = thread_cpu_s();
            ours.step();
            const double end_s = thread_cpu_s();
            bare_s += middle_s - start_s;
            ours_s += end_s - middle_s;
            round_s += end_s - start_s;
        }
        state.SetIterationTime(round_s);
    }
    const auto steps = static_cast<double>(state.iterations()) * kSteps;
    state.counters["bare_ms_per_step"] = bare_s / steps * 1e3;
    state.counters["ours_ms_per_step"] = ours_s / steps * 1e3;
    state.counters["ratio"] = ours_s / bare_s;
}

BENCHMARK_CAPTURE(pile, sleep_off, false)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pile, sleep_on, true)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
