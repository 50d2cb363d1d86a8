// Manifolds as constraints of the small-step solver, and the impulses back.
#pragma once

#include "engine/physics/collision/manifold.h"
#include "engine/physics/dynamics/contact/contact_set.h"

#include <cstdint>
#include <vector>

namespace plumbline::physics {

/// The bodies of a manifold in the island's arrays.
struct ManifoldEnds {
    std::uint32_t a{kWorldBody};
    std::uint32_t b{kWorldBody};
    std::uint32_t belt{0};  ///< ContactConstraint::belt
    bool a_moves{true};     ///< forces can move it; else they can move b
};

/// Points that come anew while their pair goes on pressing (a sphere that rolled on, a box that slid
/// on) share what the pair's lost points carried.
class ContactBridge {
public:
    /// Before an island of the step of this number; steps are numbered from 1.
    void begin_island(std::uint64_t step);
    /// Appends the manifold's constraints; `h`: sub-step, s. The manifold stays where it is until
    /// write_back().
    void add(Manifold& manifold, ManifoldEnds ends, Real h, ContactSet& contacts);
    /// Impulses and totals back to the points.
    void write_back(const ContactSet& contacts, Real h);
    /// After sub-steps shorter than those to come: a mean force that stopped an impact within them would not fit. Each
    /// manifold's load becomes at most `share` of it, or what it goes on carrying.
    void ease_loads(Real share);
    /// Of impacts, which leave no lasting load: into the points' sums over the step.
    void count_impulses(const ContactSet& contacts);
    /// What the pair goes on carrying between impacts; 0 while it is new.
    Real lasting_load_N(const Manifold& manifold) const;
    /// Contact points added since begin_island().
    std::uint32_t point_count() const { return static_cast<std::uint32_t>(entries_.size()); }

private:
    struct Entry {
        ManifoldPoint* point{nullptr};
        Manifold* manifold{nullptr};
        std::uint32_t constraint{0};
        std::uint32_t lane{0};
    };
    const ManifoldLoad* last_load(const Manifold& manifold) const;
    void share_lost(const ManifoldLoad& last,
                    Real h,
                    ContactSet& contacts,
                    std::size_t first_constraint,
                    std::size_t first_entry) const;

    std::vector<Entry> entries_;
    std::vector<Manifold*> manifolds_;  ///< of the island
    std::uint64_t step_{0};             ///< its number
};

}  // namespace plumbline::physics
