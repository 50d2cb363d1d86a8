// Loops where things roll and scrape, by what both are made of, how fast and under what load.
#include "engine/core/hash.h"
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/effects/sound/sound_bank.h"
#include "engine/scene/simulation/entity_lookup.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace plumbline::effects {

namespace {

constexpr float kFullScrape_W = 180.0F;  ///< friction's power: 30 kg on wood, pushed at 1 m/s
constexpr float kFullRoll_W = 900.0F;    ///< load times speed: a steel drum at 2.6 m/s
constexpr float kLeastLoopGain = 0.02F;
constexpr float kLeastWay_mps = 0.05F;  ///< slower is rest that has not quite ended
constexpr double kSwell_s = 0.08;       ///< contacts come and go from step to step; loops do not
constexpr std::size_t kLoopsHeard = 6;
constexpr std::size_t kPairsHeard = 2'048;

struct RollingLoop {
    audio::LoopCue cue{};  ///< without its gain
    float wanted{0.0F};
    float level{0.0F};
};

/// How one pair is heard, and where on each of its bodies it touched last.
struct TouchingPair {
    RollingLoop scrape;
    RollingLoop roll;
    Vec3 point_on_a{0, 0, 0};
    Vec3 point_on_b{0, 0, 0};
    bool touches{false};
    bool touched_before{false};
};

/// Over a body's own surface, how fast a point of contact goes. Turning alone is no rolling (a box
/// tips about an edge), nor is another corner that presses hardest while nothing turns.
float rolling_mps(const physics::PhysicsWorld& world,
                  physics::BodyId body,
                  const physics::ContactEvent& contact,
                  Vec3& point_before_body,
                  bool touched_before) {
    const physics::BodyState state = world.state(body);
    if (state.kind != physics::BodyKind::Dynamic) return 0.0F;
    const Vec3 arm = contact.point_world - state.center_of_mass_world();
    const Vec3 turning = glm::cross(state.angular_velocity_radps, arm);
    const Vec3 along = turning - contact.normal_world * glm::dot(turning, contact.normal_world);
    const Vec3 here_body = transform_point(invert(state.world_from_body), contact.point_world);
    const auto step_s = static_cast<Real>(world.def().step_s);
    const Real moved_mps =
        touched_before ? glm::distance(here_body, point_before_body) / step_s : Real{0};
    point_before_body = here_body;
    return static_cast<float>(std::min(glm::length(along), moved_mps));
}

class RollingSounds final : public Effect {
public:
    explicit RollingSounds(scene::Simulation& simulation)
        : simulation_(simulation), listener_(simulation, "effect rolling_sounds") {}

    void after_step(scene::Simulation& simulation, const scene::Game&) override {
        const physics::PhysicsWorld& world = simulation.physics;
        for (auto& [key, pair] : pairs_) {
            pair.touched_before = std::exchange(pair.touches, false);
            pair.scrape.wanted = 0.0F;
            pair.roll.wanted = 0.0F;
        }
        for (const physics::ContactEvent& contact : world.report().contacts) {
            if (is_moving(world, contact.a) || is_moving(world, contact.b)) listen_to(contact);
        }
        const auto share = static_cast<float>(1.0 - std::exp(-world.def().step_s / kSwell_s));
        for (auto at = pairs_.begin(); at != pairs_.end();) {
            TouchingPair& pair = at->second;
            for (RollingLoop* loop : {&pair.scrape, &pair.roll})
                loop->level += share * (loop->wanted - loop->level);
            const bool is_heard = std::max(pair.scrape.level, pair.roll.level) >= kLeastLoopGain;
            at = pair.touches || is_heard ? std::next(at) : pairs_.erase(at);
        }
    }

    void sound(const scene::Simulation&, const scene::ViewPoint&, SoundFrame& frame) override {
        std::vector<audio::LoopCue> loops;
        for (const auto& [key, pair] : pairs_) {
            for (const RollingLoop* loop : {&pair.scrape, &pair.roll}) {
                if (loop->level < kLeastLoopGain) continue;
                loops.push_back(loop->cue);
                loops.back().gain = loop->level;
                loops.back().radius_m = 10.0F + 25.0F * loop->level;
            }
        }
        std::ranges::sort(loops, std::greater{}, &audio::LoopCue::gain);
        loops.resize(std::min(loops.size(), kLoopsHeard));
        work_.calls += loops.size();
        frame.loops.insert(frame.loops.end(), loops.begin(), loops.end());
    }

    std::uint64_t bytes_held() const override {
        return bank_.bytes() + pairs_.size() * sizeof(*pairs_.begin());
    }

private:
    using Marks = std::pair<std::uint64_t, std::uint64_t>;

    static bool is_moving(const physics::PhysicsWorld& world, physics::BodyId body) {
        return world.contains(body) && world.state(body).kind == physics::BodyKind::Dynamic &&
               world.state(body).awake;
    }

    static audio::SoundMakers marks_of_moving(const physics::PhysicsWorld& world,
                                              const physics::ContactEvent& contact) {
        return {is_moving(world, contact.a) ? contact.user_a : 0,
                is_moving(world, contact.b) ? contact.user_b : 0};
    }
    static Vec3 velocity_of_moving(const physics::PhysicsWorld& world,
                                   const physics::ContactEvent& contact) {
        return world.state(is_moving(world, contact.a) ? contact.a : contact.b).velocity_mps;
    }

    const scene::Surface& surface_of(std::uint64_t mark) const {
        return simulation_.surfaces().get(surface_of_mark(simulation_, mark));
    }

    void listen_to(const physics::ContactEvent& contact) {
        const Marks marks{contact.user_a, contact.user_b};
        auto found = pairs_.find(marks);
        if (found == pairs_.end()) {
            if (pairs_.size() >= kPairsHeard) return;
            found = pairs_.emplace(marks, TouchingPair{}).first;
        }
        TouchingPair& pair = found->second;
        const physics::PhysicsWorld& world = simulation_.physics;
        const float rolling =
            std::max(rolling_mps(world, contact.a, contact, pair.point_on_a, pair.touched_before),
                     rolling_mps(world, contact.b, contact, pair.point_on_b, pair.touched_before));
        pair.touches = true;

        const scene::Surface& a = surface_of(contact.user_a);
        const scene::Surface& b = surface_of(contact.user_b);
        const auto load_N =
            static_cast<float>(static_cast<double>(contact.impulse_Ns) / world.def().step_s);
        const auto sliding = static_cast<float>(contact.sliding_speed_mps);
        const Real grip = std::sqrt(a.friction * b.friction);
        const float dulled = std::sqrt(a.loudness * b.loudness);
        const auto swell =
            [&](RollingLoop& loop, auto file, const char* verb, float share, float speed_mps) {
                const bool by_a =
                    !(a.*file).empty() && ((b.*file).empty() || a.loudness > b.loudness);
                const std::filesystem::path& path = by_a ? a.*file : b.*file;
                if (path.empty() || speed_mps < kLeastWay_mps) return;
                loop.cue.sound = bank_.get(simulation_, path);
                loop.cue.position_world = Vec3f(contact.point_world);
                loop.cue.made_by = marks_of_moving(world, contact);
                const Vec3 velocity_mps = velocity_of_moving(world, contact);
                loop.cue.velocity_mps = Vec3f(velocity_mps);
                loop.cue.pitch = std::clamp(0.7F + 0.2F * speed_mps, 0.7F, 1.5F);
                loop.cue.caption = (by_a ? a : b).name + verb;
                loop.wanted = std::min(dulled * std::sqrt(share), 1.0F);
            };
        pair.scrape.cue.key = key_of(marks, 0);
        pair.roll.cue.key = key_of(marks, 1);
        swell(pair.scrape,
              &scene::Surface::scrape_sound,
              " scrapes",
              static_cast<float>(grip) * load_N * sliding / kFullScrape_W,
              sliding);
        swell(pair.roll,
              &scene::Surface::roll_sound,
              " rolls",
              load_N * rolling / kFullRoll_W,
              rolling);
    }

    /// No entity's mark: those name the loops of ambient_sounds.
    static std::uint64_t key_of(const Marks& marks, std::uint64_t which) {
        Hasher hasher;
        hasher.add(&marks, sizeof(marks));
        hasher.add(&which, sizeof(which));
        return hasher.digest() | (std::uint64_t{1} << 63U);
    }

    scene::Simulation& simulation_;
    ContactListener listener_;
    SoundBank bank_;
    std::map<Marks, TouchingPair> pairs_;
};

Callers callers_of_rolling_sounds(const scene::Simulation& simulation) {
    return dynamic_bodies_of(simulation, [](const scene::SurfaceTable& surfaces, std::uint16_t i) {
        return !surfaces.get(i).roll_sound.empty() || !surfaces.get(i).scrape_sound.empty();
    });
}

}  // namespace

EffectRow rolling_sounds() {
    return with_effect<RollingSounds>({.called_for_by = &callers_of_rolling_sounds});
}

}  // namespace plumbline::effects
