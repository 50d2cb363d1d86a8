// Pushing and being pushed.
#include "engine/physics/character/character_state.h"

#include <algorithm>
#include <utility>

namespace plumbline::physics {

namespace {

constexpr Real kPushOut_mps = 2.5_r;         // how fast a person comes out of a wall
constexpr Real kSlop_m = 0.0005_r;           // deeper than this is worth a correction
constexpr Real kSteppable_kg = 25;           // lighter things are pushed, not climbed …
constexpr Real kSteppableHeight_m = 0.12_r;  // … unless they lie as flat as this
constexpr Real kHandHeight = 0.7_r;          // of the person's height
constexpr Real kArm_m = 0.1_r;               // beyond the person's own surface
constexpr Real kBeside = 0.8_r;              // of a normal's height: above or below, if more
constexpr int kPasses = 8;
// How far a person sees what arrives within the step, as a speed.
constexpr Real kArrives_mps = 15;
constexpr Real kOut_per_s = 10;  // of its depth, what the legs push a light thing out by

}  // namespace

Vec3 Character::Impl::point_velocity(BodyId other, const Vec3& point) const {
    if (!world.contains(other)) return {0, 0, 0};
    const BodyState body_state = world.state(other);
    if (body_state.kind == BodyKind::Static || body_state.frozen) return {0, 0, 0};
    return body_state.velocity_mps + glm::cross(body_state.angular_velocity_radps,
                                                point - body_state.world_from_body.position);
}

bool Character::Impl::gives_way_to_us(BodyId other) const {
    const BodyState body_state = world.state(other);
    return body_state.pushable() && body_state.mass.mass_kg < def.mass_kg;
}

bool Character::Impl::may_step_on(BodyId other, Real height_m) const {
    const BodyState body_state = world.state(other);
    return !body_state.pushable() || height_m <= kSteppableHeight_m ||
           body_state.mass.mass_kg >= kSteppable_kg;
}

Real Character::Impl::push(const CapsuleContact& hit, const Vec3& wanted_velocity) const {
    if (!world.state(hit.body).pushable()) return 0;
    const Vec3 into = normalize_or(-level(hit.normal), Vec3{0, 0, 0});
    const Real wanted = glm::dot(wanted_velocity, into);
    if (wanted <= 0 || std::abs(hit.normal.y) > kBeside) return 0;
    const auto away_of = [&](BodyId other) {
        return glm::dot(world.state(other).velocity_mps, into);
    };
    const Hands hands = hands_on(hit, into);
    const Real mass = world.state(hands.body).mass.mass_kg;
    const Real impulse = std::min(mass * (wanted - away_of(hands.body)), def.max_push_N * dt);
    if (impulse > 0) {
        world.wake(hands.body);
        push(hands.body, into * impulse, hands.point);
    }
    return std::clamp(away_of(hit.body), Real{0}, wanted);
}

/// On what stands at their height; else on what the person ran into, at the height of its middle, so that
/// crates slide and slabs topple.
Character::Impl::Hands Character::Impl::hands_on(const CapsuleContact& hit,
                                                 const Vec3& into) const {
    const Vec3 shoulders = Vec3(feet) + kUp * (kHandHeight * probe.height_m());
    const auto reached = probe.ray(shoulders, shoulders + into * (def.radius_m + kArm_m));
    if (reached && world.state(reached->body).pushable())
        return {.body = reached->body, .point = reached->point_world};
    Vec3 low{};
    Vec3 high{};
    bounds(world, hit.body, low, high);
    const Real foot = static_cast<Real>(feet.y);
    Vec3 point = hit.point;
    point.y = std::clamp((low.y + high.y) / 2, foot, foot + kHandHeight * probe.height_m());
    return {.body = hit.body, .point = point};
}

Real Character::Impl::move_swept(const Vec3& displacement, BodyId ignored) {
    const Real length = glm::length(displacement);
    if (length < 1e-7_r) return 0;
    const auto hit = probe.sweep(feet, displacement, ignored);
    const Real travel = hit ? hit->travel_m : length;
    feet += Vec3d(displacement * (travel / length));
    return travel;
}

Vec3 Character::Impl::slide_freely(const Vec3& displacement, BodyId ignored) {
    const Vec3d start = feet;
    PlaneSet planes;
    Vec3 rest = displacement;
    for (int i = 0; i < kPasses && glm::length(rest) > 1e-7_r; ++i) {
        const auto hit = probe.sweep(feet, rest, ignored);
        const Real share = hit ? hit->travel_m / glm::length(rest) : Real{1};
        feet += Vec3d(rest * share);
        if (!hit) break;
        planes.add({hit->normal, 0});
        rest = planes.limited(rest * (1 - share));
    }
    return Vec3(feet - start);
}

/// The body that others feel begins, round, above the feet: what is light and arrives below its sides, the legs stop.
void Character::Impl::stop_at_legs(std::span<const CapsuleContact> touches) const {
    if (footing != Footing::Ground) return;
    std::vector<BodyId> met;  // once each, where it is deepest
    for (const CapsuleContact& touch : touches) {
        const bool is_low =
            touch.point.y < static_cast<Real>(feet.y) + kBodyAboveFeet_m + def.radius_m;
        const bool is_beside = std::abs(touch.normal.y) < kBeside;
        if (!is_low || !is_beside || touch.body == ground.body || !gives_way_to_us(touch.body) ||
            std::ranges::find(met, touch.body) != met.end())
            continue;
        met.push_back(touch.body);
        const BodyState arriving = world.state(touch.body);
        const Vec3 away = normalize_or(-level(touch.normal), Vec3{0, 0, 0});
        const Real closing_mps = -glm::dot(arriving.velocity_mps, away);
        const Real allowed_mps =
            touch.gap_m > 0 ? touch.gap_m / dt : -std::min(-touch.gap_m * kOut_per_s, kPushOut_mps);
        if (closing_mps <= allowed_mps) continue;
        push(touch.body,
             away * (arriving.mass.mass_kg * (closing_mps - allowed_mps)),
             arriving.center_of_mass_world());
    }
}

/// How far the person has to come out, and how much of that the other arrives by within the step.
std::pair<Real, Real> Character::Impl::need_of(const CapsuleContact& touch) const {
    const bool underfoot =
        footing == Footing::Ground && touch.body == ground.body && touch.normal.y > 0.3_r;
    if (underfoot) return {Real{0}, Real{0}};
    // What gives way is pushed instead, until it really overlaps.
    if (gives_way_to_us(touch.body)) return {-touch.gap_m - kSkin_m, Real{0}};
    if (touch.user == kCharacterMark) return {-touch.gap_m, Real{0}};
    const Vec3 moving = point_velocity(touch.body, touch.point);
    const Real approach = std::max(glm::dot(moving, touch.normal), Real{0}) * dt;
    return {-touch.gap_m + approach, approach};
}

bool Character::Impl::give_way() {
    const Vec3d start = feet;
    Real budget = kPushOut_mps * dt;
    std::array<BodyId, kPasses> blocked{};
    std::size_t blocked_count = 0;
    Real worst_left = 0;
    for (int pass = 0; pass < kPasses; ++pass) {
        const CapsuleContact* worst = nullptr;
        Real worst_need = kSlop_m;
        Real worst_approach = 0;
        const auto touches = probe.touches(feet, kArrives_mps * dt);
        if (pass == 0) stop_at_legs(touches);
        for (const CapsuleContact& touch : touches) {
            const auto end = blocked.begin() + static_cast<std::ptrdiff_t>(blocked_count);
            if (std::find(blocked.begin(), end, touch.body) != end) continue;
            const auto [need, approach] = need_of(touch);
            if (need > worst_need) {
                worst = &touch;
                worst_need = need;
                worst_approach = approach;
            }
        }
        if (worst == nullptr) break;
        Vec3 out = worst->normal;
        if (out.y < 0 && footing == Footing::Ground) {
            // Something that comes down on the head presses into a crouch, not into the floor.
            if (out.y < -0.5_r && !crouched) change_posture(true);
            out = normalize_or(level(out), Vec3{0, 0, 0});
        }
        const Real step = std::min(worst_need, budget + worst_approach);
        const Real done = move_swept(out * step, worst->body);
        budget = std::max(budget - std::max(done - worst_approach, Real{0}), Real{0});
        const bool stopped = done < 0.1_r * step;
        if (stopped) worst_left = std::max(worst_left, worst_need);
        if (stopped || budget <= 0) {
            if (blocked_count < blocked.size()) blocked[blocked_count++] = worst->body;
        }
    }
    if (!is_finite(Vec3(feet))) feet = start;
    const bool squeezed = worst_left > 0.05_r;
    if (squeezed) escape();
    return squeezed;
}

std::optional<BodyId> Character::Impl::pinning_body() const {
    for (const CapsuleContact& touch : probe.touches(feet, -2 * kSkin_m)) {
        if (!gives_way_to_us(touch.body)) return touch.body;
    }
    return std::nullopt;
}

Vec3 Character::Impl::way_to_gaps() const {
    // Sweeps know the first thing in the way; what is passed at a flat angle may come too close.
    std::array<LimitPlane, kPasses> walls{};
    std::size_t count = 0;
    Real worst = 0;
    for (const CapsuleContact& touch : probe.touches(feet, kTouch_m)) {
        const bool underfoot =
            footing == Footing::Ground &&
            (touch.normal.y >= cos_limit ||
             (touch.body == ground.body && glm::dot(touch.normal, ground.contact_normal) > 0.98_r));
        const bool deep = touch.gap_m < -2 * kSkin_m;  // give_way() brings it out gently
        if (underfoot || deep || gives_way_to_us(touch.body) || count == walls.size()) continue;
        const Vec3 out = footing == Footing::Ground
                             ? normalize_or(level(touch.normal), Vec3{0, 0, 0})
                             : touch.normal;
        walls[count++] = {.normal = out, .room_m = -touch.gap_m};
        worst = std::max(worst, -touch.gap_m);
    }
    if (worst < 1e-4_r) return {0, 0, 0};
    // The least way out of all of them together; one after the other they would only take turns.
    Vec3 out{0, 0, 0};
    for (int pass = 0; pass < 2 * kPasses; ++pass) {
        for (std::size_t i = 0; i < count; ++i) {
            const Real missing = walls[i].room_m - glm::dot(out, walls[i].normal);
            if (missing > 0) out += walls[i].normal * missing;
        }
    }
    const Real length = glm::length(out);
    return length > 4 * kSkin_m ? out * (4 * kSkin_m / length) : out;
}

bool Character::Impl::escape() {
    // Sideways first, then up: the nearest place with room that can be reached past the mover.
    constexpr int kDirections = 16;
    for (int ring = 1; ring <= 12; ++ring) {
        const Real distance = 0.1_r * static_cast<Real>(ring);
        for (int i = 0; i <= kDirections; ++i) {
            const Real angle = 2 * kPi * static_cast<Real>(i) / kDirections;
            const Vec3 displacement =
                i == kDirections ? kUp * distance
                                 : Vec3{portable_cos(angle), 0, portable_sin(angle)} * distance;
            const Vec3d place = feet + Vec3d(displacement);
            if (!probe.is_free(place)) continue;
            const auto pinching = probe.touches(feet, 0);
            const BodyId mover = pinching.empty() ? BodyId{} : pinching.front().body;
            if (probe.sweep(feet, displacement, mover)) continue;
            const Real step = std::min(distance, 4 * dt);
            feet += Vec3d(displacement * (step / distance));
            return true;
        }
    }
    return false;
}

}  // namespace plumbline::physics
