// Bullet's constraint solvers, counting the rows they solve.
#pragma once

#include "engine/physics/physics_world.h"

#include <BulletDynamics/ConstraintSolver/btNNCGConstraintSolver.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <BulletDynamics/MLCPSolvers/btMLCPSolver.h>

namespace plumbline::physics {

/// Adds rows and sweeps to StepCost as `Base` works. A clock-free measure of work: CI can compare
/// it on a busy machine.
template <class Base>
class CountingSolver final : public Base {
public:
    template <class... Args>
    explicit CountingSolver(StepCost& cost, Args... args) : Base(args...), cost_(cost) {}

protected:
    btScalar solveSingleIteration(int iteration,
                                  btCollisionObject** bodies,
                                  int body_count,
                                  btPersistentManifold** manifolds,
                                  int manifold_count,
                                  btTypedConstraint** constraints,
                                  int constraint_count,
                                  const btContactSolverInfo& info,
                                  btIDebugDraw* drawer) override {
        cost_.row_solves += rows();
        return Base::solveSingleIteration(iteration,
                                          bodies,
                                          body_count,
                                          manifolds,
                                          manifold_count,
                                          constraints,
                                          constraint_count,
                                          info,
                                          drawer);
    }

    btScalar solveGroupCacheFriendlyFinish(btCollisionObject** bodies,
                                           int body_count,
                                           const btContactSolverInfo& info) override {
        cost_.contacts += static_cast<std::uint32_t>(this->m_tmpSolverContactConstraintPool.size());
        return Base::solveGroupCacheFriendlyFinish(bodies, body_count, info);
    }

    std::uint64_t rows() const {
        return static_cast<std::uint64_t>(
            this->m_tmpSolverContactConstraintPool.size() +
            this->m_tmpSolverContactFrictionConstraintPool.size() +
            this->m_tmpSolverContactRollingFrictionConstraintPool.size() +
            this->m_tmpSolverNonContactConstraintPool.size());
    }

    StepCost& cost_;
};

/// The matrix solvers sweep inside their own loops: every row counts once per sweep asked for.
class CountingMatrixSolver final : public btMLCPSolver {
public:
    CountingMatrixSolver(StepCost& cost, btMLCPSolverInterface* inner, int sweeps)
        : btMLCPSolver(inner), cost_(cost), sweeps_(static_cast<std::uint64_t>(sweeps)) {}

protected:
    btScalar solveGroupCacheFriendlyIterations(btCollisionObject** bodies,
                                               int body_count,
                                               btPersistentManifold** manifolds,
                                               int manifold_count,
                                               btTypedConstraint** constraints,
                                               int constraint_count,
                                               const btContactSolverInfo& info,
                                               btIDebugDraw* drawer) override {
        cost_.row_solves += sweeps_ * static_cast<std::uint64_t>(
                                          m_tmpSolverContactConstraintPool.size() +
                                          m_tmpSolverContactFrictionConstraintPool.size() +
                                          m_tmpSolverContactRollingFrictionConstraintPool.size() +
                                          m_tmpSolverNonContactConstraintPool.size());
        return btMLCPSolver::solveGroupCacheFriendlyIterations(bodies,
                                                               body_count,
                                                               manifolds,
                                                               manifold_count,
                                                               constraints,
                                                               constraint_count,
                                                               info,
                                                               drawer);
    }

    btScalar solveGroupCacheFriendlyFinish(btCollisionObject** bodies,
                                           int body_count,
                                           const btContactSolverInfo& info) override {
        cost_.contacts += static_cast<std::uint32_t>(m_tmpSolverContactConstraintPool.size());
        return btMLCPSolver::solveGroupCacheFriendlyFinish(bodies, body_count, info);
    }

private:
    StepCost& cost_;
    std::uint64_t sweeps_;
};

}  // namespace plumbline::physics
