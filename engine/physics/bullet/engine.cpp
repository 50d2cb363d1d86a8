#include "engine/physics/bullet/convert.h"
#include "engine/physics/bullet/counting_solver.h"
#include "engine/physics/bullet/engine_parts.h"
#include "engine/physics/dynamics/body_motion.h"
#include "engine/physics/world/body_record.h"

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btSolveProjectedGaussSeidel.h>
#include <LinearMath/btAlignedAllocator.h>

#include <cstdlib>
#include <new>
#include <utility>

namespace plumbline::physics {
namespace {

// Bullet does not check whether it got the memory that it asked for.
void* allocate_or_throw(std::size_t bytes) {
    void* memory = std::malloc(bytes);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}

/// Before main(), as a program with allocators of its own sets them there.
[[maybe_unused]] const bool kMemoryIsChecked = [] {
    btAlignedAllocSetCustom(allocate_or_throw, std::free);
    return true;
}();

Material material_of(const btCollisionObject& a, const btCollisionObject& b) {
    return combined(record_of(a).traits.material, record_of(b).traits.material);
}

/// Its own solvers get materials combined through global function pointers, for every world of the
/// process. Setting them again to the same functions is harmless.
void install_material_callbacks() {
    using Object = btCollisionObject;
    gCalculateCombinedFrictionCallback = [](const Object* a, const Object* b) -> btScalar {
        return material_of(*a, *b).friction;
    };
    gCalculateCombinedRestitutionCallback = [](const Object* a, const Object* b) -> btScalar {
        return material_of(*a, *b).restitution;
    };
    gCalculateCombinedRollingFrictionCallback = [](const Object* a, const Object* b) -> btScalar {
        return material_of(*a, *b).rolling_m;
    };
    gCalculateCombinedSpinningFrictionCallback = [](const Object* a, const Object* b) -> btScalar {
        return material_of(*a, *b).spinning_m;
    };
}

// From so many bodies on, and after each so many, the broad phase's tree is made anew while bodies are added.
constexpr int kManyBodies = 4096;
constexpr int kBodiesBetween = 1024;

void make_solver(const WorldDef& def, BulletEngine::Parts& parts) {
    StepCost& cost = parts.report->cost;
    parts.solver.reset();
    parts.pivot_solver.reset();
    switch (def.solver) {
        case Solver::SmallStep:
        case Solver::BulletSi: {
            auto made = std::make_unique<CountingSolver<btSequentialImpulseConstraintSolver>>(cost);
            made->setRandSeed(def.seed);
            parts.solver = std::move(made);
            break;
        }
        case Solver::BulletNncg: {
            auto made = std::make_unique<CountingSolver<btNNCGConstraintSolver>>(cost);
            made->setRandSeed(def.seed);
            parts.solver = std::move(made);
            break;
        }
        case Solver::BulletDantzig:
            parts.pivot_solver = std::make_unique<btDantzigSolver>();
            parts.solver =
                std::make_unique<CountingMatrixSolver>(cost, parts.pivot_solver.get(), 1);
            break;
        case Solver::BulletPgs:
            parts.pivot_solver = std::make_unique<btSolveProjectedGaussSeidel>();
            parts.solver = std::make_unique<CountingMatrixSolver>(
                cost, parts.pivot_solver.get(), def.iterations);
            break;
    }
}

void set_up_solver(const WorldDef& def, const BulletEngine::Parts& parts) {
    btContactSolverInfo& info = parts.world->getSolverInfo();
    info.m_numIterations = def.iterations;
    // A matrix grows with the square of a batch: one island at a time.
    info.m_minimumSolverBatchSize =
        parts.pivot_solver ? 1 : btContactSolverInfo().m_minimumSolverBatchSize;
}

ManifoldPoint copied(const btManifoldPoint& from) {
    ManifoldPoint point{.age_steps = from.getLifeTime(),
                        .normal_world = from_bullet(from.m_normalWorldOnB),
                        .distance_m = from.getDistance(),
                        .normal_Ns = from.getAppliedImpulse()};
    point.a.surface_m = from_bullet(from.getPositionWorldOnA());
    point.a.local_m = from_bullet(from.m_localPointA);
    point.b.surface_m = from_bullet(from.getPositionWorldOnB());
    point.b.local_m = from_bullet(from.m_localPointB);
    return point;
}

void copy_manifold(const btPersistentManifold& from, Manifold& to) {
    to.a = &record_of(*from.getBody0());
    to.b = &record_of(*from.getBody1());
    to.points.clear();
    for (int i = 0; i < from.getNumContacts(); ++i)
        to.points.push_back(copied(from.getContactPoint(i)));
}

void scale_impulses(btPersistentManifold& manifold, btScalar factor) {
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        btManifoldPoint& point = manifold.getContactPoint(i);
        point.m_appliedImpulse *= factor;
        point.m_appliedImpulseLateral1 *= factor;
        point.m_appliedImpulseLateral2 *= factor;
    }
}

/// Bullet's own 4.4 MB of contacts, which take longer to make than many a world to simulate, only for what uses them.
btDefaultCollisionConstructionInfo pools_for(Solver solver) {
    btDefaultCollisionConstructionInfo info;
    if (solver != Solver::SmallStep) return info;
    info.m_defaultMaxPersistentManifoldPoolSize = 1;
    info.m_defaultMaxCollisionAlgorithmPoolSize = 1;
    return info;
}

}  // namespace

BulletEngine::BulletEngine(const WorldDef& def, StepReport& report)
    : parts_(std::make_unique<Parts>()) {
    if (def.solver != Solver::SmallStep) install_material_callbacks();
    Parts& parts = *parts_;
    parts.report = &report;
    parts.pair_filter = std::make_unique<PairFilter>();
    parts.pair_filter->rules = def.pair_rules;
    parts.configuration = std::make_unique<btDefaultCollisionConfiguration>(pools_for(def.solver));
    parts.dispatcher = std::make_unique<btCollisionDispatcher>(parts.configuration.get());
    if (def.solver == Solver::SmallStep) {
        auto pairs = std::make_unique<PairList>(*parts.pair_filter);
        parts.own_pairs = pairs.get();
        parts.pairs = std::move(pairs);
    } else {
        parts.pairs = std::make_unique<CountedPairs>(*parts.pair_filter);
    }
    parts.broadphase = std::make_unique<btDbvtBroadphase>(parts.pairs.get());
    parts.nearest =
        std::make_unique<NearestPairs>(*parts.broadphase, *parts.pairs, *parts.pair_filter);
    make_solver(def, parts);
    parts.world = std::make_unique<StepWorld>(parts.dispatcher.get(),
                                              parts.broadphase.get(),
                                              parts.solver.get(),
                                              parts.configuration.get(),
                                              *parts.nearest,
                                              report);
    parts.world->set_gravity(def.gravity_mps2);
    set_up_solver(def, parts);
}

BulletEngine::~BulletEngine() = default;

void BulletEngine::add(BodyRecord& record) {
    // The pair filter reads the record; Bullet's own two masks must only not say no.
    parts_->world->addRigidBody(record.rigid.get(), -1, -1);
    // Bodies made one beside the other, as arrays are, make its tree a list, and the next one walks along it.
    const int count = parts_->world->getNumCollisionObjects();
    if (count >= kManyBodies && count % kBodiesBetween == 0) parts_->broadphase->optimize();
    record.rigid->setDeactivationTime(0);
}

void BulletEngine::remove(BodyRecord& record) {
    parts_->world->removeRigidBody(record.rigid.get());
    record.crowd.reset();
}

void BulletEngine::refresh_box(BodyRecord& record) {
    parts_->world->updateSingleAabb(record.rigid.get());
}

void BulletEngine::forget_pair(const BodyRecord& a, const BodyRecord& b) {
    parts_->pairs->removeOverlappingPair(
        a.rigid->getBroadphaseProxy(), b.rigid->getBroadphaseProxy(), parts_->dispatcher.get());
}

void BulletEngine::admit_pair(const BodyRecord& a, const BodyRecord& b) {
    parts_->pairs->addOverlappingPair(a.rigid->getBroadphaseProxy(), b.rigid->getBroadphaseProxy());
}

void BulletEngine::each_manifold(const std::function<void(const Manifold&)>& visit) const {
    if (parts_->own_pairs != nullptr) return parts_->own_pairs->each_manifold(visit);
    Manifold copy;
    for (int i = 0; i < parts_->dispatcher->getNumManifolds(); ++i) {
        copy_manifold(*parts_->dispatcher->getManifoldByIndexInternal(i), copy);
        visit(copy);
    }
}

StepWorld& BulletEngine::world() const {
    return *parts_->world;
}

void BulletEngine::find_pairs() {
    parts_->world->computeOverlappingPairs();
}

void BulletEngine::set_box(const BodyRecord& record, const Box& box) {
    parts_->broadphase->setAabb(record.rigid->getBroadphaseProxy(),
                                to_bullet(box.low),
                                to_bullet(box.high),
                                parts_->dispatcher.get());
}

NearestPairs& BulletEngine::nearest_pairs() const {
    return *parts_->nearest;
}

void BulletEngine::drop(Pair& pair) {
    parts_->own_pairs->remove(pair);
}

void BulletEngine::begin_step(const WorldFeatures& features, std::function<void()> after_solve) {
    StepWorld& world = *parts_->world;
    world.features = features;
    world.after_solve = std::move(after_solve);
    bool any_turns = false;
    for (BodyRecord* record : moving()) {
        write_rigid_start(*record);
        any_turns = any_turns || feels_gyro(*record, features);
    }
    if (features.gyro_waits_for_spin) world.features.gyroscopic_torque = any_turns;
}

void BulletEngine::advance(Real substep_s, bool last) {
    parts_->world->last_substep = last;
    parts_->world->advance(substep_s);
}

void BulletEngine::change(const WorldDef& before, const WorldDef& after) {
    Parts& parts = *parts_;
    make_solver(after, parts);
    parts.world->setConstraintSolver(parts.solver.get());
    set_up_solver(after, parts);
    parts.world->set_gravity(after.gravity_mps2);
    const double factor = (after.step_s / after.substeps) / (before.step_s / before.substeps);
    if (factor == 1) return;
    for (int i = 0; i < parts.dispatcher->getNumManifolds(); ++i)
        scale_impulses(*parts.dispatcher->getManifoldByIndexInternal(i), btScalar(factor));
}

void BulletEngine::list_moving() {
    const auto& rigids = parts_->world->getNonStaticRigidBodies();
    parts_->moving.resize(static_cast<std::size_t>(rigids.size()));
    for (int i = 0; i < rigids.size(); ++i)
        parts_->moving[static_cast<std::size_t>(i)] = &record_of(*rigids[i]);
}

std::span<BodyRecord* const> BulletEngine::moving() const {
    return parts_->moving;
}

}  // namespace plumbline::physics
