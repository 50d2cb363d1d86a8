// Bullet's constraint solvers, counting the rows they solve.
#pragma once

#include "engine/physics/physics_world.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
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

/// Rows of the largest matrix that is made: a few of it take 1 GB. A heap of a thousand bodies on one spot
/// would ask for 300 GB.
inline constexpr std::uint64_t kMostMatrixRows = 8192;

/// The matrix solvers sweep inside their own loops: every row counts once per sweep asked for.
/// Islands of too many rows are swept as by bullet_si.
class CountingMatrixSolver final : public CountingBase<btMLCPSolver> {
public:
    CountingMatrixSolver(StepCost& cost, btMLCPSolverInterface* inner, int sweeps)
        : CountingBase(cost, inner), sweeps_(static_cast<std::uint64_t>(sweeps)) {}

protected:
    // NOLINTNEXTLINE(readability-function-size): Bullet's parameters
    btScalar solveGroupCacheFriendlySetup(btCollisionObject** bodies,
                                          int body_count,
                                          btPersistentManifold** manifolds,
                                          int manifold_count,
                                          btTypedConstraint** constraints,
                                          int constraint_count,
                                          const btContactSolverInfo& info,
                                          btIDebugDraw* drawer) override {
        std::uint64_t rows = 6 * static_cast<std::uint64_t>(constraint_count);
        for (int i = 0; i < manifold_count; ++i)
            rows += 3 * static_cast<std::uint64_t>(manifolds[i]->getNumContacts());
        is_oversized_ = rows > kMostMatrixRows;
        if (is_oversized_) {
            ++cost_.interventions.oversized_islands;
            // NOLINTNEXTLINE(bugprone-parent-virtual-call): on purpose past the matrix
            return btSequentialImpulseConstraintSolver::solveGroupCacheFriendlySetup(
                bodies,
                body_count,
                manifolds,
                manifold_count,
                constraints,
                constraint_count,
                info,
                drawer);
        }
        return btMLCPSolver::solveGroupCacheFriendlySetup(bodies,
                                                          body_count,
                                                          manifolds,
                                                          manifold_count,
                                                          constraints,
                                                          constraint_count,
                                                          info,
                                                          drawer);
    }

    // NOLINTNEXTLINE(readability-function-size): Bullet's parameters
    btScalar solveGroupCacheFriendlyIterations(btCollisionObject** bodies,
                                               int body_count,
                                               btPersistentManifold** manifolds,
                                               int manifold_count,
                                               btTypedConstraint** constraints,
                                               int constraint_count,
                                               const btContactSolverInfo& info,
                                               btIDebugDraw* drawer) override {
        if (is_oversized_) {
            cost_.row_solves += static_cast<std::uint64_t>(info.m_numIterations) * rows();
            // NOLINTNEXTLINE(bugprone-parent-virtual-call): likewise
            return btSequentialImpulseConstraintSolver::solveGroupCacheFriendlyIterations(
                bodies,
                body_count,
                manifolds,
                manifold_count,
                constraints,
                constraint_count,
                info,
                drawer);
        }
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
    bool is_oversized_{false};  ///< the island at work
};

}  // namespace plumbline::physics
