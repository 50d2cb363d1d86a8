// Bullet's contact manifolds as blocks of the small-step solver, and the impulses back.
#pragma once

#include "engine/core/pose_archive.h"
#include "engine/physics/dynamics/contact/contact_set.h"

#include <btBulletDynamicsCommon.h>

#include <cstdint>
#include <span>
#include <vector>

namespace plumbline::physics {

/// What carries over from step to step stands on the manifold points as mean forces (N), so that it
/// fits sub-steps of any length. Points that come anew while their pair goes on pressing (a ball
/// that rolled on, a box that slid on) share what the pair's lost points carried.
class ContactBridge {
public:
    /// Before the islands of a step.
    void begin_step();
    /// Before one island.
    void begin_island();
    /// Appends the manifold's blocks. `a`, `b`: the bodies' places in the island; `h`: sub-step, s.
    void add(btPersistentManifold& manifold,
             std::uint32_t a,
             std::uint32_t b,
             Real h,
             ContactSet& contacts);
    /// Impulses and totals back to the points.
    void write_back(const ContactSet& contacts, Real h);

    /// What the pairs carried in the latest step. `manifolds`: of all pairs.
    void serialize(Archive& archive, std::span<btPersistentManifold* const> manifolds);

    /// What the pair goes on carrying between blows; 0 while it is new.
    Real lasting_load_N(const btPersistentManifold& manifold) const;

    /// Contact points added since begin_island().
    std::uint32_t point_count() const { return static_cast<std::uint32_t>(entries_.size()); }

private:
    struct Entry {
        btManifoldPoint* point{nullptr};
        std::uint32_t block{0};
        std::uint32_t lane{0};
        std::uint32_t load{0};  ///< its pair's place in loads_
    };
    /// What a pair carried in a step, N; world axes.
    struct PairLoad {
        const btPersistentManifold* manifold{nullptr};
        Real normal_N{0};
        Real lasting_N{0};  ///< what it goes on carrying between blows
        Vec3 friction_N{0, 0, 0};
        Vec3 rolling_Nm{0, 0, 0};  ///< on the first block's a
        std::uint32_t age{0};      ///< steps

        void serialize(Archive& archive) {
            archive(normal_N, lasting_N, friction_N, rolling_Nm, age);
        }
    };

    const PairLoad* last_load(const btPersistentManifold& manifold) const;
    void start_block(const btManifoldPoint& from, bool swapped, ContactBlock& block) const;
    void carry_over(btPersistentManifold& manifold,
                    Real h,
                    ContactSet& contacts,
                    std::size_t first_block,
                    std::size_t first_entry) const;

    std::vector<Entry> entries_;
    std::vector<PairLoad> last_loads_;
    std::vector<PairLoad> loads_;
    std::size_t island_loads_{0};  ///< where the island's own begin in loads_
};

}  // namespace plumbline::physics
