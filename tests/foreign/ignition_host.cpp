// Loads Gazebo's Bullet plugin, steps a world of an SDF file through it and prints where its bodies are.
//
//   ignition_host PLUGIN WORLD.sdf STEPS
//
// The plugin makes its world inside a shared pointer: std::make_shared<btDiscreteDynamicsWorld>(…). With PLUMBLINE set that
// constructor, which the plugin finds in this program first, makes a SmallStepDynamicsWorld on the same spot. Ours is
// larger by a pointer, so every allocation gets some bytes more.
#include "engine/bullet_world/small_step_dynamics_world.h"

#include <dlfcn.h>
#include <ignition/physics/ForwardStep.hh>
#include <ignition/physics/RequestEngine.hh>
#include <ignition/physics/sdf/ConstructCollision.hh>
#include <ignition/physics/sdf/ConstructJoint.hh>
#include <ignition/physics/sdf/ConstructLink.hh>
#include <ignition/physics/sdf/ConstructModel.hh>
#include <ignition/physics/sdf/ConstructWorld.hh>
#include <ignition/plugin/Loader.hh>
#include <sdf/Root.hh>
#include <sdf/World.hh>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <vector>

namespace {

constexpr std::size_t kMoreBytes = 64;
constexpr std::chrono::nanoseconds kStep(1'000'000'000 / 60);
constexpr const char* kConstructor =
    "_ZN23btDiscreteDynamicsWorldC1EP12btDispatcherP21btBroadphaseInterfaceP18btConstraintSolver"
    "P24btCollisionConfiguration";

using Construct = void (*)(
    void*, btDispatcher*, btBroadphaseInterface*, btConstraintSolver*, btCollisionConfiguration*);

std::vector<btDiscreteDynamicsWorld*>& worlds() {
    static std::vector<btDiscreteDynamicsWorld*> all;
    return all;
}

bool is_ours() {
    return std::getenv("PLUMBLINE") != nullptr;
}

}  // namespace

void* operator new(std::size_t bytes) {
    if (void* room = std::malloc(bytes + kMoreBytes)) return room;
    throw std::bad_alloc();
}
void operator delete(void* room) noexcept {
    std::free(room);
}
void operator delete(void* room, std::size_t) noexcept {
    std::free(room);
}

extern "C" void
_ZN23btDiscreteDynamicsWorldC1EP12btDispatcherP21btBroadphaseInterfaceP18btConstraintSolverP24btCollisionConfiguration(
    void* room,
    btDispatcher* dispatcher,
    btBroadphaseInterface* broadphase,
    btConstraintSolver* solver,
    btCollisionConfiguration* configuration) {
    if (is_ours())
        new (room) plumbline::SmallStepDynamicsWorld(dispatcher, broadphase, solver, configuration);
    else
        reinterpret_cast<Construct>(dlsym(RTLD_NEXT, kConstructor))(
            room, dispatcher, broadphase, solver, configuration);
    worlds().push_back(static_cast<btDiscreteDynamicsWorld*>(room));
}

int main(int count, char** words) {
    namespace physics = ignition::physics;
    using Features = physics::FeatureList<physics::ForwardStep,
                                          physics::sdf::ConstructSdfWorld,
                                          physics::sdf::ConstructSdfModel,
                                          physics::sdf::ConstructSdfLink,
                                          physics::sdf::ConstructSdfJoint,
                                          physics::sdf::ConstructSdfCollision>;
    if (count != 4) return 2;
    ignition::plugin::Loader loader;
    loader.LoadLib(words[1]);
    const auto engine = physics::RequestEngine3d<Features>::From(
        loader.Instantiate("ignition::physics::bullet::Plugin"));
    sdf::Root root;
    for (const sdf::Error& error : root.Load(words[2]))
        std::fprintf(stderr, "%s\n", error.Message().c_str());
    if (!engine || root.WorldCount() == 0) return 1;
    const auto world = engine->ConstructWorld(*root.WorldByIndex(0));
    physics::ForwardStep::Output output;
    physics::ForwardStep::State state;
    physics::ForwardStep::Input input;
    input.Get<std::chrono::steady_clock::duration>() = kStep;
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < std::atoi(words[3]); ++i) world->Step(output, state, input);
    const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - start;
    for (const btDiscreteDynamicsWorld* each : worlds()) {
        for (int i = 0; i < each->getNumCollisionObjects(); ++i) {
            const btVector3 at =
                each->getCollisionObjectArray()[i]->getWorldTransform().getOrigin();
            std::printf("body %.4f %.4f %.4f\n",
                        static_cast<double>(at.x()),
                        static_cast<double>(at.y()),
                        static_cast<double>(at.z()));
        }
        if (!is_ours()) continue;
        for (const std::string& note :
             static_cast<const plumbline::SmallStepDynamicsWorld*>(each)->notes())
            std::printf("note %s\n", note.c_str());
    }
    std::printf("ms %.1f\n", spent.count());
    return 0;
}
