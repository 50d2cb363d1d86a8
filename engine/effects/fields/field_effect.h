// An effect that is a force field: steps ask it for as long as it lives.
#pragma once

#include "engine/core/io/archive.h"
#include "engine/core/time/stopwatch.h"
#include "engine/effects/effect_table.h"
#include "engine/physics/force_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::effects {

/// The bodies that a field acts on, each with what the field keeps of it. Found by id without a search.
template <class T>
class Receivers {
public:
    struct Entry {
        physics::BodyId body{};
        T own{};

        void serialize(Archive& archive) { archive(body, own); }
    };

    void clear() {
        entries_.clear();
        number_.assign(number_.size(), kNone);
    }
    void add(physics::BodyId body, T own) {
        if (number_.size() <= body.index) number_.resize(body.index + 1, kNone);
        number_[body.index] = entries_.size();
        entries_.push_back({body, std::move(own)});
    }
    /// By their ids, whatever the order in which they were added.
    void sort() {
        std::ranges::sort(entries_, {}, &Entry::body);
        for (std::size_t i = 0; i < entries_.size(); ++i) number_[entries_[i].body.index] = i;
    }
    /// Null where it is none of them.
    Entry* find(physics::BodyId body) {
        const std::size_t at = place_of(body);
        return at == kNone ? nullptr : &entries_[at];
    }
    const Entry* find(physics::BodyId body) const {
        const std::size_t at = place_of(body);
        return at == kNone ? nullptr : &entries_[at];
    }
    bool has(physics::BodyId body) const { return place_of(body) != kNone; }
    std::vector<Entry>& all() { return entries_; }
    const std::vector<Entry>& all() const { return entries_; }

private:
    static constexpr std::size_t kNone = ~std::size_t{0};

    std::size_t place_of(physics::BodyId body) const {
        if (body.index >= number_.size() || number_[body.index] == kNone) return kNone;
        const std::size_t at = number_[body.index];
        return entries_[at].body == body ? at : kNone;
    }

    std::vector<Entry> entries_;
    std::vector<std::size_t> number_;  ///< by the index of the body's id
};

/// The sub-steps that a field asks for at a fidelity.
constexpr int field_substeps(scene::Fidelity fidelity) {
    return by_fidelity(fidelity, std::array{1, 4, 16});
}

/// What a force that is stiff in position gives in a sub-step, as a share of what it gives in the middle: a spring swings at its
/// own frequency for every h up to half a period, and beyond does not grow (Gautschi 1961: (sin(w h / 2) / (w h / 2))^2).
inline double stiff_share(double stiffness, double inertia, double h) {
    const double half_rad = 0.5 * std::sqrt(stiffness / inertia) * h;
    if (half_rad < 1e-4) return 1;
    const double sine = portable_sin(std::min(half_rad, static_cast<double>(kPi) / 2));
    return sine * sine / (half_rad * half_rad);
}

/// Keeps its receivers up to date, counts what the steps ask it and wakes its receivers when it goes.
template <class T>
class FieldEffect : public Effect, public physics::ForceField {
public:
    FieldEffect(scene::Simulation& simulation, std::string_view name)
        : simulation_(simulation), name_(name) {
        simulation.force_fields.add(name_, *this);
    }
    ~FieldEffect() override {
        simulation_.force_fields.remove(name_);
        for (const auto& entry : receivers_.all()) {
            if (simulation_.physics.contains(entry.body)) simulation_.physics.wake(entry.body);
        }
    }
    FieldEffect(const FieldEffect&) = delete;
    FieldEffect& operator=(const FieldEffect&) = delete;

    bool acts_on(physics::BodyId body) const override { return receivers_.has(body); }

    void before_step(scene::Simulation& simulation) override {
        if (listed_revision_ != simulation.revision()) list_now();
        prepare();
    }

    void act(std::span<physics::BodyInField* const> bodies, const physics::FieldTime& time) final {
        lap_.start();
        push(bodies, time);
        work_.calls += bodies.size();
        work_.cpu_ms += lap_.lap_ms();
    }

    std::uint64_t bytes_held() const override {
        return receivers_.all().capacity() * sizeof(typename Receivers<T>::Entry);
    }

protected:
    /// For constructors of what may be asked before the first step.
    void list_now() {
        listed_revision_ = simulation_.revision();
        list_receivers();
        receivers_.sort();
    }
    /// For what has taken up receivers of a saved game: they are compared with those there are before the next step.
    void list_before_next_step() { listed_revision_ = ~std::uint64_t{0}; }
    /// Fills receivers_ anew.
    virtual void list_receivers() = 0;
    /// Before each step: wakes what rests and should not any more.
    virtual void prepare() {}
    /// As ForceField::act.
    virtual void push(std::span<physics::BodyInField* const> bodies,
                      const physics::FieldTime& time) = 0;

    scene::Simulation& simulation_;
    Receivers<T> receivers_;

private:
    std::string name_;
    std::uint64_t listed_revision_{~std::uint64_t{0}};
    LapTimer lap_;
};

/// Calls fn(body, component) for each dynamic body that has the component, in the order of entities.
template <class Component, class Fn>
void each_dynamic_body(scene::Simulation& simulation, Fn&& fn) {
    simulation.registry.view<const Component, const scene::BodyRef>().each(
        [&](ecs::Entity, const Component& component, const scene::BodyRef& ref) {
            if (simulation.physics.state(ref.body).kind == physics::BodyKind::Dynamic)
                fn(ref.body, component);
        });
}

}  // namespace plumbline::effects
