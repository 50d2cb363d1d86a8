// Volumes in which something happens when a body comes in: once for each time that it does, however fast it is. They stop nothing.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/physics/medium.h"
#include "engine/physics/query.h"
#include "engine/scene/simulation/entity_lookup.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace plumbline::effects {
namespace {

using physics::BodyId;
using scene::TriggerVolume;

/// Places along a step's way at which a fast body is looked for, at most.
constexpr double kMostPlaces = 256;

class Triggers final : public Effect {
public:
    void after_step(scene::Simulation& simulation, const scene::Game&) override {
        // All volumes see the world as the step left it; what follows from it comes after.
        struct Event {
            double when{1};
            ecs::Entity volume{};
            BodyId body{};
        };
        std::vector<Event> events;
        find_flights(simulation);
        for (auto [entity, volume, transform] :
             simulation.registry.view<TriggerVolume, const scene::Transform>()) {
            std::vector<BodyId> inside = bodies_in(simulation, volume, transform.world_from_body);
            for (const auto& [when, body] :
                 came_in(simulation, volume, transform.world_from_body, inside)) {
                if (volume.times_left == 0) break;
                --volume.times_left;
                events.push_back({when, entity, body});
            }
            volume.inside = std::move(inside);
        }
        std::ranges::stable_sort(events, {}, &Event::when);
        for (const Event& event : events) {
            // A copy: what is made may move the component.
            const scene::TriggerDescription says =
                simulation.registry.get<TriggerVolume>(event.volume).says;
            const Vec3 at =
                simulation.registry.get<scene::Transform>(event.volume).world_from_body.position;
            act(simulation, says, event.body, at);
            ++work_.calls;
        }
    }

private:
    using Entry = std::pair<double, BodyId>;  ///< when in the step, and who

    static bool counts(const scene::Simulation& simulation,
                       const TriggerVolume& volume,
                       BodyId body) {
        if (simulation.physics.state(body).kind != physics::BodyKind::Dynamic) return false;
        const ecs::Entity entity = entity_of(simulation, body);
        if (!simulation.registry.alive(entity)) return false;
        const std::string& name = simulation.registry.get<scene::Name>(entity).text;
        const std::vector<std::string>& of = volume.says.of;
        return of.empty() || std::ranges::find(of, name) != of.end();
    }

    static std::vector<BodyId> bodies_in(const scene::Simulation& simulation,
                                         const TriggerVolume& volume,
                                         const Pose& pose) {
        std::vector<BodyId> bodies;
        for (const physics::OverlapHit& hit :
             physics::overlaps(simulation.physics, volume.shape, pose, Real{0})) {
            if (counts(simulation, volume, hit.body)) bodies.push_back(hit.body);
        }
        std::ranges::sort(bodies);
        bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
        return bodies;
    }

    /// A body on its way through a step.
    struct Flight {
        const scene::MovingBody* moving{nullptr};
        Vec3d from{0, 0, 0};
        Vec3d way{0, 0, 0};
        double length_m{0};
    };

    /// Those that moved farther than some volume is thick.
    void find_flights(const scene::Simulation& simulation) {
        flights_.clear();
        double thinnest_m = HUGE_VAL;
        for (auto [entity, volume] : simulation.registry.view<const TriggerVolume>())
            thinnest_m = std::min(thinnest_m, volume.thinnest_m);
        for (const scene::MovingBody& moving : simulation.moving_bodies()) {
            if (!moving.awake || !simulation.physics.contains(moving.body)) continue;
            const auto* previous =
                simulation.registry.find<scene::PreviousTransform>(moving.entity);
            if (previous == nullptr) continue;
            const Vec3d from(previous->world_from_body.position);
            const Vec3d way =
                Vec3d(simulation.physics.state(moving.body).world_from_body.position) - from;
            const double length_m = glm::length(way);
            if (length_m > thinnest_m) flights_.push_back({&moving, from, way, length_m});
        }
    }

    std::vector<Entry> came_in(const scene::Simulation& simulation,
                               const TriggerVolume& volume,
                               const Pose& pose,
                               const std::vector<BodyId>& inside) const {
        const auto was_inside = [&volume](BodyId body) {
            return std::ranges::binary_search(volume.inside, body);
        };
        std::vector<Entry> entries;
        for (const BodyId body : inside) {
            if (!was_inside(body)) entries.emplace_back(1, body);
        }
        for (const Flight& flight : flights_) {
            const BodyId body = flight.moving->body;
            if (was_inside(body)) continue;
            const std::optional<double> when = passed_at(simulation, volume, pose, flight);
            if (!when || !counts(simulation, volume, body)) continue;
            const auto known = std::ranges::find(entries, body, &Entry::second);
            if (known == entries.end())
                entries.emplace_back(*when, body);
            else
                known->first = *when;
        }
        return entries;
    }

    /// When a body that moved farther than the volume is thick was first in it. The volume is moved instead of the body:
    /// where it would have to be for the body to meet it now as it did then.
    static std::optional<double> passed_at(const scene::Simulation& simulation,
                                           const TriggerVolume& volume,
                                           const Pose& pose,
                                           const Flight& flight) {
        const auto& [moving, from, way, length_m] = flight;
        if (length_m <= volume.thinnest_m) return {};
        const Vec3d center(pose.position);
        const double nearest =
            std::clamp(glm::dot(center - from, way) / (length_m * length_m), 0.0, 1.0);
        if (glm::distance(center, from + way * nearest) >
            volume.radius_m + physics::radius_m(simulation.physics, moving->body))
            return {};
        const double inner_m = static_cast<double>(moving->inner_radius_m);
        const auto places = static_cast<int>(
            std::clamp(std::ceil(length_m / (volume.thinnest_m / 2 + inner_m)), 2.0, kMostPlaces));
        for (int place = 0; place < places; ++place) {
            const double when = static_cast<double>(place) / places;
            Pose there = pose;
            there.position += Vec3(way * (1 - when));
            const auto hits = physics::overlaps(simulation.physics, volume.shape, there, Real{0});
            if (std::ranges::find(hits, moving->body, &physics::OverlapHit::body) != hits.end())
                return when;
        }
        return {};
    }

    static void turn_light(scene::Simulation& simulation, ecs::Entity lamp) {
        auto* light = simulation.registry.find<scene::PointLight>(lamp);
        if (light == nullptr) return;
        light->on =
            light->on == scene::LampOn::Always ? scene::LampOn::Never : scene::LampOn::Always;
    }

    static void act(scene::Simulation& simulation,
                    const scene::TriggerDescription& says,
                    BodyId body,
                    const Vec3& at) {
        if (says.count) ++simulation.counted;
        if (!says.sound.empty())
            simulation.bursts.push_back(
                {.kind = scene::Burst::Kind::Trigger, .point_world = at, .sound = says.sound});
        if (!says.spawn.empty()) {
            scene::EntityDescription made = simulation.description().prefabs.at(says.spawn);
            made.world_from_body.position = says.at_m;
            simulation.spawn(made);
        }
        if (says.impulse_Ns && simulation.physics.contains(body))
            simulation.physics.apply_impulse(body, *says.impulse_Ns);
        if (says.gravity_mps2) {
            physics::WorldDef world = simulation.physics.def();
            world.gravity_mps2 = *says.gravity_mps2;
            simulation.set_accuracy(world);
        }
        if (!says.explode.empty()) simulation.charges_lit.push_back(says.explode);
        if (const ecs::Entity lamp = simulation.find(says.light); simulation.registry.alive(lamp))
            turn_light(simulation, lamp);
        if (!says.message.empty()) simulation.messages.push_back(says.message);
        if (says.remove && simulation.physics.contains(body))
            simulation.registry.destroy(entity_of(simulation, body));
    }

    std::vector<Flight> flights_;  // of the latest step
};

}  // namespace

EffectRow triggers() {
    return with_effect<Triggers>({.called_for_by = &entities_with<TriggerVolume>});
}

}  // namespace plumbline::effects
