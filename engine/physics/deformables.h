// The deforming bodies of a world, as one force field: those that may touch each other take their sub-steps together.
#pragma once

#include "engine/physics/deformable.h"
#include "engine/physics/force_field.h"

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <span>
#include <vector>

namespace plumbline {
class Archive;
}

namespace plumbline::physics {

class PhysicsWorld;

/// Bodies enter for each step anew; what does not stays as it is, and nothing that deforms touches it.
class Deformables final : public ForceField {
public:
    /// The world outlives it.
    explicit Deformables(PhysicsWorld& world);
    ~Deformables() override;
    Deformables(const Deformables&) = delete;
    Deformables& operator=(const Deformables&) = delete;

    /// For the coming step; what it touches gets `substeps` at least.
    void enter(Deformable& body, int substeps);
    /// It is about to go: between steps.
    void leave(const Deformable& body);
    bool empty() const { return bodies_.empty(); }
    /// Before the world's own step.
    void begin_step(double step_s);
    /// After it: what no sub-step of bodies has done. Those that entered leave.
    void end_step();
    /// What a body took of the latest step.
    double cpu_ms(const Deformable& body) const;

    bool acts_on(BodyId body) const override;
    void act(std::span<BodyInField* const> bodies, const FieldTime& time) override;
    void list_pairs(std::vector<Pair>& pairs) const override;
    double added_mass_kg(BodyId body) const override;
    int substeps() const override { return substeps_; }
    bool carries() const override { return true; }

    /// What two of `all`, which are all there are, remember of each other.
    void serialize(Archive& archive, std::span<Deformable* const> all);

private:
    /// Two that are near each other.
    struct Touch {
        Deformable* first{nullptr};
        Deformable* second{nullptr};
        std::unique_ptr<PartContacts> contacts;
    };
    /// Those that may touch each other within the step, directly or by others.
    struct Group {
        std::vector<Deformable*> bodies;
        std::vector<PartContacts*> contacts;  ///< of one with itself, too
        std::vector<BodyId> movable;
        double done_s{0};
        double cpu_ms{0};

        bool is_asleep() const { return bodies.front()->is_asleep(); }
    };
    /// How often each body of a group feels forces: in one of so many sub-steps of the group.
    struct Rhythm {
        std::uint32_t cycles{1};  ///< until they are planned anew
        std::uint32_t beats{1};   ///< sub-steps of a cycle
        double beat_s{0};
        std::vector<std::uint32_t> every;  ///< by body: beats, a divisor of all of them
    };

    void find_touches();
    Touch* touch_of(const Deformable& first, const Deformable& second);
    void add_touch(Deformable& first, Deformable& second);
    void list_groups();
    void act(Group& group, std::span<BodyInField* const> bodies, double seconds);
    static Rhythm rhythm_of(Group& group, double left_s);
    static void substep(Group& group,
                        const Rhythm& rhythm,
                        std::uint32_t beat,
                        const Vec3d& gravity_mps2,
                        double left_s);

    PhysicsWorld& world_;
    std::vector<Deformable*> bodies_;  ///< of the step, as they entered
    std::list<Touch> touches_;
    std::vector<Group> groups_;   ///< of the latest step
    std::vector<BodyId> pushed_;  ///< sorted
    int substeps_{1};
    double step_s_{0};
};

}  // namespace plumbline::physics
