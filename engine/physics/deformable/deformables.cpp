#include "engine/physics/deformables.h"

#include "engine/core/io/archive.h"
#include "engine/core/time/stopwatch.h"
#include "engine/physics/deformable/part_contacts.h"
#include "engine/physics/physics_world.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace plumbline::physics {
namespace {

/// Sub-steps between two plans, and of the time what is none.
constexpr std::uint32_t kPlanned = 8;
constexpr double kNoTime = 1e-9;

/// The largest divisor of `beats` that leaves `wanted` of `total`.
std::uint32_t beats_between(std::uint32_t beats, std::uint32_t total, std::uint32_t wanted) {
    std::uint32_t every = beats;
    while (every > 1 && (beats % every != 0 || total / every < wanted)) --every;
    return every;
}

}  // namespace

Deformables::Deformables(PhysicsWorld& world) : world_(world) {}
Deformables::~Deformables() = default;

void Deformables::enter(Deformable& body, int substeps) {
    if (bodies_.empty()) substeps_ = 1;
    bodies_.push_back(&body);
    substeps_ = std::max(substeps_, substeps);
}

void Deformables::leave(const Deformable& body) {
    std::erase(bodies_, &body);
    touches_.remove_if([&](const Touch& touch) {
        if (touch.first != &body && touch.second != &body) return false;
        (touch.first == &body ? touch.second : touch.first)->stir();
        return true;
    });
    groups_.clear();
}

void Deformables::begin_step(double step_s) {
    step_s_ = step_s;
    for (Deformable* body : bodies_) body->begin_step(world_, step_s);
    find_touches();
    list_groups();
    pushed_.clear();
    for (Group& group : groups_) {
        const bool sleeps = std::ranges::all_of(group.bodies, &Deformable::is_calm);
        for (Deformable* body : group.bodies) {
            body->fall_asleep(sleeps);
            const auto movable = body->movable();
            group.movable.insert(group.movable.end(), movable.begin(), movable.end());
        }
        pushed_.insert(pushed_.end(), group.movable.begin(), group.movable.end());
    }
    std::ranges::sort(pushed_);
}

/// Who comes near or goes wakes the other.
void Deformables::find_touches() {
    const auto is_near = [this](const Deformable& a, const Deformable& b) {
        const bool have_entered = std::ranges::find(bodies_, &a) != bodies_.end() &&
                                  std::ranges::find(bodies_, &b) != bodies_.end();
        return have_entered && glm::all(glm::lessThanEqual(a.reach_.low_m, b.reach_.high_m)) &&
               glm::all(glm::lessThanEqual(b.reach_.low_m, a.reach_.high_m));
    };
    touches_.remove_if([&](const Touch& touch) {
        if (is_near(*touch.first, *touch.second)) return false;
        touch.first->disturb();
        touch.second->disturb();
        return true;
    });
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        for (std::size_t j = i + 1; j < bodies_.size(); ++j) {
            Deformable& a = *bodies_[i];
            Deformable& b = *bodies_[j];
            if (touch_of(a, b) != nullptr || !is_near(a, b)) continue;
            add_touch(a, b);
            if (a.is_asleep() && b.is_asleep()) continue;  // as they do at the start
            a.disturb();
            b.disturb();
        }
    }
}

Deformables::Touch* Deformables::touch_of(const Deformable& first, const Deformable& second) {
    const auto found = std::ranges::find_if(touches_, [&](const Touch& touch) {
        return touch.first == &first && touch.second == &second;
    });
    return found == touches_.end() ? nullptr : &*found;
}

/// Halfway between both in thickness; friction as of any pair.
void Deformables::add_touch(Deformable& first, Deformable& second) {
    const SurfaceTraits& a = first.def_.surface;
    const SurfaceTraits& b = second.def_.surface;
    const SurfaceTraits traits{.thickness_m = (a.thickness_m + b.thickness_m) / 2,
                               .friction = std::sqrt(a.friction * b.friction)};
    touches_.push_back(
        {&first, &second, std::make_unique<PartContacts>(*first.body_, *second.body_, traits)});
}

void Deformables::list_groups() {
    groups_.clear();
    std::vector<std::size_t> group_of(bodies_.size());
    std::iota(group_of.begin(), group_of.end(), 0U);
    const auto number_of = [this](const Deformable* body) {
        return static_cast<std::size_t>(std::ranges::find(bodies_, body) - bodies_.begin());
    };
    for (const Touch& touch : touches_) {
        const std::size_t a = group_of[number_of(touch.first)];
        const std::size_t b = group_of[number_of(touch.second)];
        std::ranges::replace(group_of, std::max(a, b), std::min(a, b));
    }
    std::vector<std::size_t> place(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (group_of[i] == i) {
            place[i] = groups_.size();
            groups_.emplace_back();
        }
        Group& group = groups_[place[group_of[i]]];
        group.bodies.push_back(bodies_[i]);
        if (PartContacts* own = bodies_[i]->self_contacts_.get()) group.contacts.push_back(own);
    }
    for (Group& group : groups_) {
        for (std::size_t i = 1; i < group.bodies.size(); ++i) {
            for (std::size_t k = 0; k < i; ++k) group.bodies[i]->share_motions(*group.bodies[k]);
        }
    }
    for (Touch& touch : touches_)
        groups_[place[group_of[number_of(touch.first)]]].contacts.push_back(touch.contacts.get());
}

bool Deformables::acts_on(BodyId body) const {
    return std::ranges::binary_search(pushed_, body);
}

void Deformables::list_pairs(std::vector<Pair>& pairs) const {
    for (const Group& group : groups_) {
        for (std::size_t i = 1; i < group.movable.size(); ++i)
            pairs.emplace_back(group.movable[0], group.movable[i]);
    }
}

double Deformables::added_mass_kg(BodyId body) const {
    double sum = 0;
    for (const Deformable* each : bodies_) sum += each->pinned_kg(body);
    return sum;
}

void Deformables::act(std::span<BodyInField* const> bodies, const FieldTime& time) {
    for (Group& group : groups_) {
        const bool is_here =
            !group.movable.empty() &&
            std::ranges::find(bodies, group.movable[0], &BodyInField::id) != bodies.end();
        if (is_here) act(group, bodies, time.h_s);
    }
}

void Deformables::end_step() {
    for (Group& group : groups_) {
        const double left_s = step_s_ - group.done_s;
        if (left_s > kNoTime * step_s_) act(group, {}, left_s);
    }
    for (Deformable* body : bodies_) body->end_step(step_s_);
    bodies_.clear();
}

double Deformables::cpu_ms(const Deformable& body) const {
    const auto work_of = [](const Deformable& of) {
        return static_cast<double>(of.substeps() * of.body().positions_m().size());
    };
    for (const Group& group : groups_) {
        if (std::ranges::find(group.bodies, &body) == group.bodies.end()) continue;
        double all = 0;
        for (const Deformable* each : group.bodies) all += work_of(*each);
        return all > 0 ? group.cpu_ms * work_of(body) / all : 0;
    }
    return 0;
}

void Deformables::act(Group& group, std::span<BodyInField* const> bodies, double seconds) {
    const bool is_first = group.done_s == 0;
    group.done_s += seconds;
    if (group.is_asleep()) return;
    LapTimer lap;
    lap.start();
    for (Deformable* body : group.bodies) body->begin_act(world_, bodies, seconds);
    if (is_first) {
        for (PartContacts* contacts : group.contacts) contacts->begin_step(step_s_);
    }
    const Vec3d gravity_mps2(world_.def().gravity_mps2);
    const auto is_sound = [](const Deformable* body) { return body->body_->is_sound(); };
    for (double left_s = seconds;
         left_s > kNoTime * seconds && std::ranges::all_of(group.bodies, is_sound);) {
        // Tension grows as it is drawn: planned anew every few sub-steps.
        const Rhythm rhythm = rhythm_of(group, left_s);
        for (std::uint32_t i = 0; i < rhythm.cycles * rhythm.beats; ++i) {
            substep(group, rhythm, i, gravity_mps2, left_s);
            left_s -= rhythm.beat_s;
        }
    }
    const bool are_sound = std::ranges::all_of(group.bodies, is_sound);
    for (Deformable* body : group.bodies) {
        if (!are_sound) body->body_->put_back(body->kept_m_);
        body->end_act(gravity_mps2, seconds);
    }
    group.cpu_ms += lap.lap_ms();
}

/// Whoever wants fewer sub-steps than another feels forces more rarely and moves as often (Verlet-I, r-RESPA: Tuckerman, Berne and
/// Martyna 1992).
Deformables::Rhythm Deformables::rhythm_of(Group& group, double left_s) {
    std::vector<std::uint32_t> wanted;
    for (Deformable* body : group.bodies) wanted.push_back(std::max(body->plan(left_s), 1U));
    const auto [fewest, most] = std::ranges::minmax(wanted);
    Rhythm rhythm;
    rhythm.beats = (most + fewest - 1) / fewest;
    const std::uint32_t total = fewest * rhythm.beats;
    rhythm.cycles = std::clamp(fewest, 1U, std::max(kPlanned / rhythm.beats, 1U));
    rhythm.beat_s = left_s / total;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        rhythm.every.push_back(beats_between(rhythm.beats, total, wanted[i]));
        group.bodies[i]->body_->shorten_substeps(rhythm.beat_s * rhythm.every[i]);
    }
    return rhythm;
}

void Deformables::substep(Group& group,
                          const Rhythm& rhythm,
                          std::uint32_t beat,
                          const Vec3d& gravity_mps2,
                          double left_s) {
    for (std::size_t i = 0; i < group.bodies.size(); ++i) {
        Deformable& body = *group.bodies[i];
        body.lead(gravity_mps2, rhythm.beat_s, left_s);
        if (beat % rhythm.every[i] == 0) body.feel(gravity_mps2);
    }
    for (PartContacts* contacts : group.contacts) contacts->solve(rhythm.beat_s);
    for (Deformable* body : group.bodies) body->touch(rhythm.beat_s);
    for (Deformable* body : group.bodies) body->move(rhythm.beat_s);
    for (PartContacts* contacts : group.contacts) contacts->follow(rhythm.beat_s);
}

void Deformables::serialize(Archive& archive, std::span<Deformable* const> all) {
    const std::size_t count = archive.count(touches_.size());
    if (archive.reads()) touches_.clear();
    auto at = touches_.begin();
    for (std::size_t i = 0; i < count && !archive.failed(); ++i) {
        std::array<std::uint32_t, 2> numbers{};
        if (!archive.reads()) {
            for (std::size_t side = 0; side < 2; ++side) {
                const Deformable* body = side == 0 ? at->first : at->second;
                numbers[side] =
                    static_cast<std::uint32_t>(std::ranges::find(all, body) - all.begin());
            }
        }
        archive(numbers);
        const bool are_two =
            numbers[0] < all.size() && numbers[1] < all.size() && numbers[0] != numbers[1];
        if (!archive.expect(are_two, "what touches each other is not there")) return;
        if (archive.reads()) {
            add_touch(*all[numbers[0]], *all[numbers[1]]);
            at = std::prev(touches_.end());
        }
        at->contacts->serialize(archive);
        ++at;
    }
}

}  // namespace plumbline::physics
