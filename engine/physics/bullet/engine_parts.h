// What BulletEngine is made of, in the order in which the parts need each other.
#pragma once

#include "engine/physics/bullet/contact/nearest_pairs.h"
#include "engine/physics/bullet/contact/pair_filter.h"
#include "engine/physics/bullet/contact/pair_list.h"
#include "engine/physics/bullet/engine.h"
#include "engine/physics/bullet/step_world.h"

#include <BulletDynamics/MLCPSolvers/btMLCPSolverInterface.h>
#include <btBulletDynamicsCommon.h>

#include <memory>
#include <vector>

namespace plumbline::physics {

struct BulletEngine::Parts {
    std::unique_ptr<btDefaultCollisionConfiguration> configuration;
    std::unique_ptr<btCollisionDispatcher> dispatcher;
    std::unique_ptr<PairFilter> pair_filter;
    std::unique_ptr<btOverlappingPairCache> pairs;
    PairList* own_pairs{nullptr};  ///< small_step: `pairs`
    std::unique_ptr<btDbvtBroadphase> broadphase;
    std::unique_ptr<NearestPairs> nearest;
    StepReport* report{nullptr};  ///< the world's
    std::unique_ptr<btMLCPSolverInterface> pivot_solver;
    std::unique_ptr<btConstraintSolver> solver;
    std::unique_ptr<StepWorld> world;
    std::vector<BodyRecord*> moving;  ///< as list_moving() found them
};

}  // namespace plumbline::physics
