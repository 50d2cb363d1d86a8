#include "engine/physics/deformable.h"

#include "engine/core/io/archive.h"
#include "engine/core/io/pose_archive.h"
#include "engine/physics/deformable/part_contacts.h"
#include "engine/physics/dynamics/rotation.h"
#include "engine/physics/medium.h"
#include "engine/physics/physics_world.h"
#include "engine/physics/query.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace plumbline::physics {
namespace {

/// A sheet none of whose points has moved farther for so long loses speed at a rate, and then sleeps.
constexpr double kCalm_m = 1e-3;
constexpr double kSettling_s = 1;
constexpr double kSettling_per_s = 2;
/// Slower air keeps no sheet awake.
constexpr double kStill_mps = 0.05;
/// Of its weight: what a sheet's push on a sleeping body must have changed by for it to wake.
constexpr double kWakingShare = 0.05;
/// Places along a cell's side that may touch a small body, or one that has edges there; what is hardly wider than thick has none.
constexpr std::uint32_t kMostPlaces = 4;
constexpr std::uint32_t kPlacesAtEdges = 3;
constexpr double kRound = 1.05;
/// Of the speed that a push would give a free body: what one that is held gets at least.
constexpr double kLeastYield = 1e-3;
constexpr double kPushed_mps = 1e-4;
/// How far bodies are looked for beyond what they and the sheet move in a step.
constexpr double kMargin_m = 0.02;
/// Bodies are looked for so far off: at 60 Hz those up to 180 m/s.
constexpr double kAhead_m = 3;

/// Whether its motion may bring a body's box to the other one within the time.
bool may_reach(
    const PhysicsWorld& world, BodyId id, const Vec3d& low, const Vec3d& high, double seconds) {
    Vec3 own_low;
    Vec3 own_high;
    bounds(world, id, own_low, own_high);
    const double moved_m = static_cast<double>(glm::length(world.state(id).velocity_mps)) * seconds;
    return glm::all(glm::lessThanEqual(Vec3d(own_low) - moved_m, high)) &&
           glm::all(glm::greaterThanEqual(Vec3d(own_high) + moved_m, low));
}

}  // namespace

Deformable::Deformable(const PhysicsWorld& world,
                       std::unique_ptr<PointBody> body,
                       const DeformableDef& def)
    : body_(std::move(body)),
      def_(def),
      rest_{.places_m = {body_->positions_m().begin(), body_->positions_m().end()},
            .calm_s = def.asleep ? 2 * kCalm_s : 0,
            .asleep = def.asleep} {
    def_.pins.clear();
    if (def.self_collision) self_contacts_ = std::make_unique<PartContacts>(*body_, def_.surface);
    for (const DeformablePin& pin : def.pins) {
        if (body_->inverse_mass(pin.point) == 0) continue;
        body_->pin(pin.point);
        Vec3d at = body_->positions_m()[pin.point];
        if (pin.to) {
            const Vec3d center_m(world.state(pin.to).center_of_mass_world());
            at = glm::conjugate(world_from_mass(world, pin.to)) * (at - center_m);
        }
        holders_.push_back({.point = pin.point, .to = pin.to, .in_mass_m = at});
    }
}

Deformable::~Deformable() = default;

void Deformable::strike(std::size_t point, const Vec3d& impulse_Ns) {
    body_->change_velocity(point, impulse_Ns * body_->inverse_mass(point));
    wake();
}

void Deformable::grip(std::span<const std::uint32_t> points) {
    let_go();
    for (const std::uint32_t point : points) {
        if (body_->inverse_mass(point) == 0) continue;
        body_->pin(point);
        grip_.points.push_back(point);
        grip_.places_m.push_back(body_->positions_m()[point]);
    }
    wake();
}

void Deformable::lead_grip(const Vec3d& by_m) {
    for (Vec3d& place : grip_.places_m) place += by_m;
}

void Deformable::let_go() {
    for (const std::uint32_t point : grip_.points) body_->unpin(point);
    grip_ = {};
}

void Deformable::set_frozen(bool frozen) {
    std::vector<std::uint32_t> all(frozen ? body_->positions_m().size() : 0);
    std::iota(all.begin(), all.end(), 0U);
    grip(all);
    grip_.is_frost = frozen;
}

void Deformable::begin_step(PhysicsWorld& world, double step_s) {
    if (!rest_.asleep) wake_touched(world);
    done_ = {};
    find_reach(step_s);
    list_near(world, step_s);
    bool disturbed =
        std::exchange(is_stirred_, false) || !movable_.empty() || is_gripped() || is_blown();
    grip_.pulled_Ns = {0, 0, 0};
    std::vector<BodyId> seen;
    for (const NearBody& near : near_) {
        seen.push_back(near.id);
        disturbed = disturbed || near.carries();
    }
    // What sleeps at the start knows what it hangs beside.
    disturbed = disturbed || (seen_ ? seen != *seen_ : !def_.asleep);
    seen_ = std::move(seen);
    note_rest(step_s, disturbed);
}

bool Deformable::is_blown() const {
    return body_->feels_air() &&
           std::ranges::any_of(body_->fluids(), [](const FluidAtPoint& fluid) {
               return glm::length(fluid.air_mps) > kStill_mps;
           });
}

void Deformable::list_near(const PhysicsWorld& world, double step_s) {
    std::erase_if(holders_, [&](const Holder& holder) {
        const bool gone = holder.to && !world.contains(holder.to);
        if (gone) body_->unpin(holder.point);
        return gone;
    });
    near_.clear();
    movable_.clear();
    for (Holder& holder : holders_) {
        if (!holder.to) continue;
        const auto known = std::ranges::find(near_, holder.to, &NearBody::id);
        holder.near = static_cast<std::size_t>(known - near_.begin());
        if (known != near_.end()) continue;
        add_near(world, holder.to);
        near_.back().touches = false;
    }
    const auto& [low, high] = reach_;
    for (const BodyId id : bodies_in_box(world, Vec3(low - kAhead_m), Vec3(high + kAhead_m))) {
        if (std::ranges::find(near_, id, &NearBody::id) == near_.end() &&
            may_reach(world, id, low, high, step_s))
            add_near(world, id);
    }
}

void Deformable::find_reach(double step_s) {
    const auto [low, high] = bounds_of(body_->positions_m());
    const double around_m =
        kMargin_m + def_.surface.thickness_m + fastest_mps(body_->velocities_mps()) * step_s;
    reach_ = {low - around_m, high + around_m};
}

/// Along a cell's side. Between two points the surface cuts off what edges and corners of a body are among them; a body that reaches
/// beyond the surface on four sides, as a floor does, has none there.
std::uint32_t Deformable::places_against(const PhysicsWorld& world,
                                         BodyId id,
                                         BodyKind kind) const {
    Vec3 low;
    Vec3 high;
    bounds(world, id, low, high);
    const glm::bvec3 below = glm::lessThanEqual(Vec3d(low), reach_.low_m);
    const glm::bvec3 above = glm::greaterThanEqual(Vec3d(high), reach_.high_m);
    const int covered = (below.x && above.x) + (below.y && above.y) + (below.z && above.z);
    std::uint32_t fewest = covered >= 2 ? 1 : kPlacesAtEdges;
    if (kind != BodyKind::Dynamic) return fewest;
    const double smallest_m = 2 * thinnest_half_m(world, id);
    if (2 * radius_m(world, id) < kRound * smallest_m) fewest = 1;
    const double places = std::ceil(3 * body_->longest_side_m() / std::max(smallest_m, 1e-3));
    return static_cast<std::uint32_t>(
        std::clamp(places, static_cast<double>(fewest), static_cast<double>(kMostPlaces)));
}

void Deformable::add_near(const PhysicsWorld& world, BodyId id) {
    const BodyState state = world.state(id);
    NearBody near{.id = id,
                  .own = {.center_m = Vec3d(state.center_of_mass_world()),
                          .world_from_mass = world_from_mass(world, id),
                          .spin_radps = Vec3d(state.angular_velocity_radps)}};
    const Vec3d arm = near.own.center_m - Vec3d(state.world_from_body.position);
    if (state.kind != BodyKind::Static)
        near.own.velocity_mps = Vec3d(state.velocity_mps) + glm::cross(near.own.spin_radps, arm);
    near.is_kinematic = state.kind == BodyKind::Kinematic;
    near.belt = surface_motion(world, id);
    near.friction = std::sqrt(def_.surface.friction * friction_of(world, id));
    near.places = places_against(world, id, state.kind);
    if (state.kind == BodyKind::Dynamic) {
        if (state.pushable() && state.awake) movable_.push_back(id);
        near.can_wake = state.pushable() && !state.awake;
    }
    near_.push_back(near);
}

/// A body that fell asleep with the sheet on it wakes where what the sheet does to it changes.
void Deformable::wake_touched(PhysicsWorld& world) {
    std::vector<Load> loads;
    for (const Load& now : felt_) {
        if (!world.contains(now.body)) continue;
        const auto before = std::ranges::find(loads_, now.body, &Load::body);
        loads.push_back(before != loads_.end() ? *before : now);
        const double weight_N =
            static_cast<double>(world.state(now.body).mass.mass_kg) * kStandardGravity_mps2;
        if (glm::length(now.force_N - loads.back().force_N) > kWakingShare * weight_N)
            world.wake(now.body);
    }
    loads_ = std::move(loads);
}

void Deformable::note_rest(double step_s, bool disturbed) {
    const auto now = body_->positions_m();
    const auto is_same = [](const Vec3d& a, const Vec3d& b) {
        return glm::distance(a, b) <= kCalm_m;
    };
    if (disturbed || !std::ranges::equal(now, rest_.places_m, is_same)) {
        rest_.places_m.assign(now.begin(), now.end());
        disturb();
    }
    rest_.calm_s += step_s;
    if (rest_.calm_s > kSettling_s) slow_down(*body_, portable_exp(-kSettling_per_s * step_s));
}

void Deformable::fall_asleep(bool sleeps) {
    if (sleeps && !rest_.asleep) slow_down(*body_, 0);
    rest_.asleep = sleeps;
}

Vec3d Deformable::force_on(BodyId body) const {
    const auto found = std::ranges::find(borne_, body, &Load::body);
    return found == borne_.end() ? Vec3d{0, 0, 0} : found->force_N;
}

double Deformable::pinned_kg(BodyId body) const {
    double sum = 0;
    for (const Holder& holder : holders_)
        sum += holder.to == body ? body_->mass_kg(holder.point) : 0;
    return sum;
}

void Deformable::begin_act(const PhysicsWorld& world,
                           std::span<BodyInField* const> bodies,
                           double seconds) {
    place_near(bodies, seconds);
    contacts_.find(world, *body_, near_, def_.surface.thickness_m, seconds);
    kept_m_.assign(body_->positions_m().begin(), body_->positions_m().end());
    done_.taken = 0;
    done_.most = static_cast<std::uint32_t>(std::max(1.0, def_.substeps_per_s * seconds));
}

std::uint32_t Deformable::plan(double left_s) {
    return body_->plan(left_s, done_.most > done_.taken ? done_.most - done_.taken : 1);
}

void Deformable::end_act(const Vec3d& gravity_mps2, double seconds) {
    done_.substeps += done_.taken;
    note_expected(gravity_mps2, seconds);
}

void Deformable::end_step(double step_s) {
    felt_.clear();
    if (!rest_.asleep) borne_.clear();
    for (const NearBody& near : near_) {
        const Load load{.body = near.id, .force_N = near.felt_Ns / step_s};
        if (near.can_wake) felt_.push_back(load);
        if (near.is_kinematic && load.force_N != Vec3d{0, 0, 0}) borne_.push_back(load);
    }
}

void Deformable::share_motions(Deformable& first) {
    for (NearBody& near : near_) {
        const auto same = std::ranges::find(first.near_, near.id, &NearBody::id);
        if (near.shared == nullptr && same != first.near_.end()) near.shared = &same->motion();
    }
}

void Deformable::place_near(std::span<BodyInField* const> bodies, double seconds) {
    for (NearBody& near : near_) {
        if (near.shared != nullptr) continue;
        const auto found = std::ranges::find(bodies, near.id, &BodyInField::id);
        near.own.start(found == bodies.end() ? nullptr : *found, seconds);
        if (near.own.state != nullptr) near.own.give_way(yield_of(near.id, near.own.start_mps));
    }
}

/// The share of the speed that a push gives it if it is free.
double Deformable::yield_of(BodyId body, const Vec3d& start_mps) const {
    const auto known = std::ranges::find(expected_, body, &Expected::body);
    if (known == expected_.end()) return 1;
    const double pushed2 = glm::dot(known->pushed_mps, known->pushed_mps);
    if (pushed2 < kPushed_mps * kPushed_mps) return 1;
    const double held = glm::dot(known->velocity_mps - start_mps, known->pushed_mps) / pushed2;
    return std::clamp(1 - held, kLeastYield, 1.0);
}

void Deformable::note_expected(const Vec3d& gravity_mps2, double seconds) {
    expected_.clear();
    for (const NearBody& near : near_) {
        const NearMotion& motion = near.own;
        if (near.shared != nullptr || motion.state == nullptr) continue;
        const Vec3d pushed_mps = motion.pushed_Ns / motion.state->mass_kg;
        expected_.push_back(
            {.body = near.id,
             .pushed_mps = pushed_mps,
             .velocity_mps = motion.start_mps + gravity_mps2 * seconds + pushed_mps});
    }
}

void Deformable::lead(const Vec3d& gravity_mps2, double h, double left_s) {
    for (NearBody& near : near_) {
        if (near.shared == nullptr && near.own.falls) near.own.velocity_mps += gravity_mps2 * h;
    }
    lead_pins(h, left_s);
}

void Deformable::feel(const Vec3d& gravity_mps2) {
    body_->accelerate(gravity_mps2);
    load_holders();
    ++done_.taken;
}

void Deformable::touch(double h) {
    contacts_.solve(*body_, near_, h);
}

void Deformable::move(double h) {
    body_->move(h);
    contacts_.follow(*body_, near_, h);
    for (NearBody& near : near_) {
        if (near.shared == nullptr) near.own.move(h);
    }
}

/// As what holds them moves; what they have fallen behind, as it may jump, they make up for in the rest of the bodies' sub-step.
void Deformable::lead_pins(double h, double left_s) {
    for (const Holder& holder : holders_) {
        Vec3d start = holder.in_mass_m;
        Vec3d end = start;
        if (holder.to) {
            const NearMotion& near = near_[holder.near].motion();
            const Quatd then = turn_by(near.spin_radps, h) * near.world_from_mass;
            start = near.center_m + near.world_from_mass * holder.in_mass_m;
            end = near.center_m + near.velocity_mps * h + then * holder.in_mass_m;
        }
        const Vec3d behind = start - body_->positions_m()[holder.point];
        physics::lead(*body_, holder.point, (end - start) / h + behind / std::max(left_s, h));
    }
    for (std::size_t i = 0; i < grip_.points.size(); ++i) {
        const Vec3d behind = grip_.places_m[i] - body_->positions_m()[grip_.points[i]];
        physics::lead(*body_, grip_.points[i], behind / std::max(left_s, h));
    }
}

void Deformable::load_holders() {
    for (const Holder& holder : holders_) {
        if (!holder.to) continue;
        NearBody& near = near_[holder.near];
        near.push(body_->support_Ns(holder.point),
                  body_->positions_m()[holder.point] - near.motion().center_m);
    }
    for (const std::uint32_t point : grip_.points) grip_.pulled_Ns += body_->support_Ns(point);
}

void Deformable::Expected::serialize(Archive& archive) {
    archive(body, pushed_mps, velocity_mps);
}

void Deformable::Load::serialize(Archive& archive) {
    archive(body, force_N);
}

void Deformable::Grip::serialize(Archive& archive) {
    archive(points, places_m, pulled_Ns, is_frost);
}

void Deformable::serialize(Archive& archive) {
    body_->serialize(archive);
    archive(
        grip_, rest_.places_m, rest_.calm_s, rest_.asleep, seen_, loads_, felt_, borne_, expected_);
    const std::size_t count = body_->positions_m().size();
    archive.expect(
        grip_.points.size() == grip_.places_m.size() &&
            std::ranges::all_of(grip_.points, [&](std::uint32_t point) { return point < count; }),
        "what a hand holds is not there");
    if (archive.failed()) grip_ = {};
    if (self_contacts_) self_contacts_->serialize(archive);
}

}  // namespace plumbline::physics
