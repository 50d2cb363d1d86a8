// Bullet's constraint solvers, counting the rows they solve.
#pragma once

#include "engine/physics/physics_world.h"

#include <BulletDynamics/ConstraintSolver/btNNCGConstraintSolver.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <BulletDynamics/MLCPSolvers/btMLCPSolver.h>

namespace plumbline::physics {

/// Adds contacts to StepCost as `Base` ends, and tells its rows. A clock-free measure of work: CI can
/// compare it on a busy machine.
template <class Base>
class CountingBase : public Base {
public:
    template <class... Args>
    explicit CountingBase(StepCost& cost, Args... args) : Base(args...), cost_(cost) {}

protected:
    btScalar solveGroupCacheFriendlyFinish(btCollisionObject** bodies,
                                           int body_count,
                                           const btContactSolverInfo& info) override {
        cost_.contacts += static_cast<std::uint32_t>(this->m_tmpSolverContactConstraintPool.size());
        return Base::solveGroupCacheFriendlyFinish(bodies, body_count, info);
    }

    std::uint64_t rows() const {
        const auto count = [](const auto& pool) { return static_cast<std::uint64_t>(pool.size()); };
        return count(this->m_tmpSolverContactConstraintPool) +
               count(this->m_tmpSolverContactFrictionConstraintPool) +
               count(this->m_tmpSolverContactRollingFrictionConstraintPool) +
               count(this->m_tmpSolverNonContactConstraintPool);
    }

    StepCost& cost_;
};

/// Every sweep over the rows counts as it is made.
template <class Base>
class CountingSolver final : public CountingBase<Base> {
public:
    using CountingBase<Base>::CountingBase;

protected:
    // NOLINTNEXTLINE(readability-function-size): Bullet's parameters
    btScalar solveSingleIteration(int iteration,
                                  btCollisionObject** bodies,
                                  int body_count,
                                  btPersistentManifold** manifolds,
                                  int manifold_count,
                                  btTypedConstraint** constraints,
                                  int constraint_count,
                                  const btContactSolverInfo& info,
                                  btIDebugDraw* drawer) override {
        this->cost_.row_solves += this->rows();
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
};

/// The matrix solvers sweep inside their own loops: every row counts once per sweep asked for.
class CountingMatrixSolver final : public CountingBase<btMLCPSolver> {
public:
    CountingMatrixSolver(StepCost& cost, btMLCPSolverInterface* inner, int sweeps)
        : CountingBase(cost, inner), sweeps_(static_cast<std::uint64_t>(sweeps)) {}

protected:
    // NOLINTNEXTLINE(readability-function-size): Bullet's parameters
    btScalar solveGroupCacheFriendlyIterations(btCollisionObject** bodies,
                                               int body_count,
                                               btPersistentManifold** manifolds,
                                               int manifold_count,
                                               btTypedConstraint** constraints,
                                               int constraint_count,
                                               const btContactSolverInfo& info,
                                               btIDebugDraw* drawer) override {
        cost_.row_solves += sweeps_ * rows();
        return btMLCPSolver::solveGroupCacheFriendlyIterations(bodies,
                                                               body_count,
                                                               manifolds,
                                                               manifold_count,
                                                               constraints,
                                                               constraint_count,
                                                               info,
                                                               drawer);
    }

private:
    std::uint64_t sweeps_;
};

}  // namespace plumbline::physics
