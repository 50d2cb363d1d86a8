// Bullet's deformable bodies on the problem that soft_peers.py writes: `bullet_soft PROBLEM` prints where the points are in the end and
// what a step cost. Edges are springs (btDeformableMassSpringForce), tetrahedra neo-Hookean (btDeformableNeoHookeanForce).
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableGravityForce.h>
#include <BulletSoftBody/btDeformableMassSpringForce.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btDeformableNeoHookeanForce.h>
#include <BulletSoftBody/btSoftBodyHelpers.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <btBulletDynamicsCommon.h>
#include <nlohmann/json.hpp>

#include <ctime>
#include <fstream>
#include <iostream>
#include <memory>

namespace {

using nlohmann::json;

btVector3 vector_of(const json& v) {
    return {v[0].get<btScalar>(), v[1].get<btScalar>(), v[2].get<btScalar>()};
}

struct World {
    btSoftBodyRigidBodyCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broad_phase;
    btDeformableBodySolver bodies;
    btDeformableMultiBodyConstraintSolver contacts;
    std::unique_ptr<btDeformableMultiBodyDynamicsWorld> world;

    explicit World(btScalar gravity_mps2) {
        contacts.setDeformableSolver(&bodies);
        world = std::make_unique<btDeformableMultiBodyDynamicsWorld>(
            &dispatcher, &broad_phase, &contacts, &configuration, &bodies);
        const btVector3 gravity(0, -gravity_mps2, 0);
        world->setGravity(gravity);
        world->getWorldInfo().m_gravity = gravity;
        world->getWorldInfo().m_sparsesdf.Initialize();
        world->setImplicit(false);  // its implicit mode left all points where they were (3.24)
        world->setLineSearch(false);
    }
};

/// Owned by the caller.
btSoftBody* soft_body_of(const json& problem, btSoftBodyWorldInfo& info) {
    btAlignedObjectArray<btVector3> points;
    btAlignedObjectArray<btScalar> masses_kg;
    for (const json& point : problem["points_m"]) points.push_back(vector_of(point));
    for (const json& mass_kg : problem["masses_kg"]) masses_kg.push_back(mass_kg.get<btScalar>());
    auto* body = new btSoftBody(&info, points.size(), &points[0], &masses_kg[0]);
    for (const json& edge : problem["edges"])
        body->appendLink(edge[0].get<int>(), edge[1].get<int>(), nullptr, true);
    for (const json& corners : problem["tetrahedra"])
        body->appendTetra(corners[0].get<int>(),
                          corners[1].get<int>(),
                          corners[2].get<int>(),
                          corners[3].get<int>());
    if (problem["tetrahedra"].empty()) {
        for (const json& corners : problem["faces"])
            body->appendFace(corners[0].get<int>(), corners[1].get<int>(), corners[2].get<int>());
    } else {
        btSoftBodyHelpers::generateBoundaryFaces(body);
        body->initializeDmInverse();
        body->m_tetraScratches.resize(body->m_tetras.size());
        body->m_tetraScratchesTn.resize(body->m_tetras.size());
    }
    body->m_sleepingThreshold = 0;
    return body;
}

double cpu_ms() {
    timespec used{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
    return static_cast<double>(used.tv_sec) * 1e3 + static_cast<double>(used.tv_nsec) / 1e6;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: bullet_soft PROBLEM\n";
        return 2;
    }
    json problem;
    std::ifstream(argv[1]) >> problem;
    const auto gravity_mps2 = problem["gravity_mps2"].get<btScalar>();
    World all(gravity_mps2);
    btSoftBody* body = soft_body_of(problem, all.world->getWorldInfo());
    all.world->addSoftBody(body);
    btDeformableGravityForce gravity(btVector3(0, -gravity_mps2, 0));
    all.world->addForce(body, &gravity);
    const auto young_Pa = problem["young_Pa"].get<btScalar>();
    const auto poisson = problem["poisson"].get<btScalar>();
    const auto damping_s = problem["damping_s"].get<btScalar>();
    const auto stiff_Npm = problem["spring_Npm"].get<btScalar>();
    btDeformableMassSpringForce springs(stiff_Npm, stiff_Npm * damping_s, false);
    btDeformableNeoHookeanForce solid(young_Pa / (2 * (1 + poisson)),
                                      young_Pa * poisson / ((1 + poisson) * (1 - 2 * poisson)),
                                      damping_s);
    if (problem["tetrahedra"].empty())
        all.world->addForce(body, &springs);
    else
        all.world->addForce(body, &solid);
    const auto hz = problem["hz"].get<double>();
    const auto timed = static_cast<int>(problem["timed_s"].get<double>() * hz);
    const auto steps = static_cast<int>(problem["seconds"].get<double>() * hz);
    const double start_ms = cpu_ms();
    double used_ms = 0;
    for (int i = 0; i < steps; ++i) {
        if (i == timed) used_ms = cpu_ms() - start_ms;
        all.world->stepSimulation(static_cast<btScalar>(1 / hz), 1, static_cast<btScalar>(1 / hz));
    }
    json result{{"points_m", json::array()}, {"step_ms", used_ms / timed}};
    for (int i = 0; i < body->m_nodes.size(); ++i) {
        const btVector3& at = body->m_nodes[i].m_x;
        result["points_m"].push_back({at.x(), at.y(), at.z()});
    }
    std::cout << result << '\n';
    all.world->removeSoftBody(body);
    delete body;
    return 0;
}
