// The ropes of a running scene: pieces as bodies of their own, held by elastic joints.
#include "engine/physics/query.h"
#include "engine/scene/build/entity_builder.h"
#include "engine/scene/build/rope_layout.h"
#include "engine/scene/simulation.h"
#include "engine/scene/simulation/entity_lookup.h"
#include "engine/scene/simulation/saved_thing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace plumbline::scene {
namespace {

constexpr int kMostPieces = 200;
constexpr int kHeldPieces = 3;  // next to an end: these may begin inside what holds it
constexpr Real kPressedDecay_per_s = 2000;

/// Of manila, two fingers thick, and loose enough to hang visibly between ends on one level.
RopeDescription tied_rope(const std::string& name, const RopeEnds& ends) {
    RopeDescription rope{.name = name, .a = ends.names[0], .b = ends.names[1]};
    rope.anchor_a_m = ends.anchors_world_m[0];
    rope.anchor_b_m = ends.anchors_world_m[1];
    rope.length_m = 1.01 * ends.apart_m();
    rope.radius_m = 0.015;
    rope.mass_kg = 0.5 * rope.length_m;
    rope.friction = 0.6;
    rope.material = "rope";
    rope.location.file = std::make_shared<const std::string>("play");
    return rope;
}

/// As many as the fidelity asks for, at least by number and at most by length; no piece is thicker than long.
int pieces_of(const RopeDescription& rope, Fidelity fidelity) {
    if (rope.pieces) return *rope.pieces;
    const auto level = static_cast<std::size_t>(fidelity);
    const int least = std::array{8, 20, 40}[level];
    const double longest_m = std::array{0.5, 0.25, 0.125}[level];
    const double by_length = std::ceil(rope.length_m / longest_m);
    const double by_thickness = std::floor(rope.length_m / (2 * rope.radius_m));
    const double wanted = std::min({std::max(by_length, static_cast<double>(least)),
                                    static_cast<double>(kMostPieces),
                                    by_thickness});
    return std::max(2, static_cast<int>(wanted));
}

EntityDescription piece_of(const RopeDescription& rope, std::size_t pieces, double piece_m) {
    const double mass_kg = rope.mass_kg / static_cast<double>(pieces);
    // About its axis too: rope twists less than a rod of its thickness, and round bodies turn at less cost.
    const double moment_kgm2 =
        mass_kg * (piece_m * piece_m / 12 + rope.radius_m * rope.radius_m / 4);
    BodyDescription body;
    body.mass_kg = static_cast<Real>(mass_kg);
    body.inertia_kgm2 = Vec3(static_cast<Real>(moment_kgm2));
    body.friction = static_cast<Real>(rope.friction);
    body.restitution = Real{0};
    // A piece swept along a surface that it slides on would stop the whole rope there.
    body.ccd = physics::ContinuousCollision::Off;
    body.group = "(ropes)";
    body.avoids_own_group = true;
    EntityDescription piece;
    piece.visual = physics::CapsuleShape{.radius_m = static_cast<Real>(rope.radius_m),
                                         .height_m = static_cast<Real>(piece_m)};
    piece.material = rope.material;
    piece.label = "rope";
    piece.body = body;
    piece.location = rope.location;
    return piece;
}

/// The bodies that a piece begins inside of and is tied to: those at the rope's ends; for pieces next to an end that the
/// world holds, what stands still there.
std::vector<physics::BodyId> begins_inside(const Simulation& simulation,
                                           physics::BodyId piece,
                                           const std::array<physics::BodyId, 2>& ends,
                                           bool next_to_world) {
    const physics::ShapeId shape = simulation.moving_bodies().back().shape;
    const Pose pose = simulation.physics.state(piece).world_from_body;
    std::vector<physics::BodyId> found;
    for (const physics::OverlapHit& hit :
         physics::overlaps(simulation.physics, shape, pose, Real{0}, {.ignored = piece})) {
        const bool is_end = hit.body == ends[0] || hit.body == ends[1];
        const bool is_still = simulation.physics.state(hit.body).kind == physics::BodyKind::Static;
        if (is_end || (next_to_world && is_still)) found.push_back(hit.body);
    }
    return found;
}

}  // namespace

Result<Done> Simulation::add_rope(const RopeDescription& description) {
    const auto refuse = [&description](const std::string& why) {
        return Error{
            fmt::format("{}: rope {}: {}", to_string(description.location), description.name, why),
            ExitCode::Refused};
    };
    const int pieces = pieces_of(description, description_.forces.fidelity.rope);
    const RopeLayout layout = lay_rope(description, pieces, Vec3d(physics.def().gravity_mps2));
    Rope rope{.name = description.name,
              .piece_m = layout.piece_m,
              .ends = {},
              .anchors_m = {},
              .pieces = {},
              .joints = {}};
    std::array<physics::BodyId, 2>& ends = rope.ends;
    for (const bool is_b : {false, true}) {
        const std::string& name = is_b ? description.b : description.a;
        if (name.empty() || name == "world") continue;
        const Result<physics::BodyId> end = end_of_joint(name);
        if (!end) return refuse(end.error().message);
        ends[is_b ? 1 : 0] = *end;
    }
    rope.anchors_m = {anchor_in(ends[0], description.anchor_a_m),
                      anchor_in(ends[1], description.anchor_b_m)};
    EntityDescription piece =
        piece_of(description, static_cast<std::size_t>(pieces), layout.piece_m);
    for (const Pose& pose : layout.pieces()) {
        piece.world_from_body = pose;
        const Result<physics::BodyId> made = make_piece(piece, rope);
        if (!made) return made.error();
        rope.pieces.push_back(*made);
        const auto made_so_far = static_cast<int>(rope.pieces.size());
        const bool next_to_world = (description.a == "world" && made_so_far <= kHeldPieces) ||
                                   (description.b == "world" && made_so_far > pieces - kHeldPieces);
        for (const physics::BodyId held :
             begins_inside(*this, rope.pieces.back(), ends, next_to_world)) {
            // A spring without stiffness: the two do not touch.
            const auto tie = physics.create_joint({.kind = JointKind::Spring,
                                                   .a = rope.pieces.back(),
                                                   .b = held,
                                                   .anchor_a_world = pose.position,
                                                   .anchor_b_world = pose.position});
            if (!tie) return refuse(tie.error().message);
        }
    }
    if (const Result<Done> joined = join_rope(description, layout, rope); !joined)
        return refuse(joined.error().message);
    bodies_.ropes.push_back(std::move(rope));
    return Done{};
}

Result<physics::BodyId> Simulation::make_piece(const EntityDescription& piece, const Rope& rope) {
    const Result<ecs::Entity> made =
        builder_->build(piece, fmt::format("{}.{}", rope.name, rope.pieces.size()));
    if (!made) return made.error();
    registry.add<PartOf>(*made,
                         PartOf{.whole = PartOf::Whole::Rope,
                                .index = static_cast<std::uint32_t>(bodies_.ropes.size())});
    return registry.get<BodyRef>(*made).body;
}

Vec3 Simulation::anchor_in(physics::BodyId end, const Vec3& anchor_world) const {
    return end ? transform_point(invert(physics.state(end).world_from_body), anchor_world)
               : anchor_world;
}

Result<Done> Simulation::join_rope(const RopeDescription& description,
                                   const RopeLayout& layout,
                                   Rope& rope) {
    const std::array<physics::BodyId, 2>& ends = rope.ends;
    const std::size_t pieces = rope.pieces.size();
    const auto fidelity = static_cast<std::size_t>(description_.forces.fidelity.rope);
    const Vec3 half{0, static_cast<Real>(layout.piece_m / 2), 0};
    const auto tip = [&](std::size_t piece, Real side) {
        return transform_point(physics.state(rope.pieces[piece]).world_from_body, half * side);
    };
    for (std::size_t i = 0; i <= pieces; ++i) {
        const bool is_end = i == 0 || i == pieces;
        if (i == pieces && description.b.empty()) break;
        // The end pieces are between their anchor and half of their own length.
        const double span_m = is_end ? layout.piece_m / 2 : layout.piece_m;
        physics::JointDef joint{.kind = JointKind::Elastic};
        joint.a = rope.pieces[i == 0 ? 0 : i - 1];
        joint.anchor_a_world = i == 0 ? tip(0, -1) : tip(i - 1, 1);
        joint.b = i == 0 ? ends[0] : i == pieces ? ends[1] : rope.pieces[i];
        joint.anchor_b_world = i == 0        ? description.anchor_a_m
                               : i == pieces ? description.anchor_b_m
                                             : tip(i, -1);
        joint.stiffness_Npm = static_cast<Real>(description.stiffness_N / span_m);
        if (!is_end) joint.bend_Nmprad = static_cast<Real>(description.bend_Nm2 / span_m);
        joint.pressed_decay_per_s = kPressedDecay_per_s;
        joint.damping_s = static_cast<Real>(description.damping_s);
        joint.substeps = std::array{0, 4, 16}[fidelity];
        joint.straight = true;
        joint.break_N = static_cast<Real>(description.break_N);
        joint.user = mark_of_rope(bodies_.ropes.size());
        const Result<physics::JointId> made = physics.create_joint(joint);
        if (!made) return made.error();
        rope.joints.push_back(*made);
    }
    return Done{};
}

Result<Done> Simulation::tie_rope(const RopeEnds& ends) {
    const std::size_t number = bodies_.ropes.size();
    std::string name;
    do {
        name = fmt::format("rope#{}", ++names_.spawned["rope"]);
    } while (names_.entities.contains(name + ".0"));
    description_.forces.ropes.push_back(tied_rope(name, ends));
    const Result<Done> made = add_rope(description_.forces.ropes.back());
    if (!made) {
        description_.forces.ropes.pop_back();
        for (auto [entity, part] : registry.view<const PartOf>()) {
            if (part.whole == PartOf::Whole::Rope && part.index == number)
                registry.mark_for_destruction(entity);
        }
        return made;
    }
    Rope& rope = bodies_.ropes.back();
    rope.tied = true;
    for (const physics::BodyId piece : rope.pieces)
        registry.add<Dropped>(entity_of(*this, piece), Dropped{});
    return made;
}

bool Simulation::tie_again(const SavedRope& saved) {
    const double apart_m = saved.ends.apart_m();
    if (apart_m < RopeEnds::kShortest_m || apart_m > RopeEnds::kLongest_m) return false;
    const RopeDescription description = tied_rope(saved.name, saved.ends);
    const int pieces = pieces_of(description, description_.forces.fidelity.rope);
    if (saved.pieces.size() != static_cast<std::size_t>(pieces)) return false;
    const RopeLayout layout = lay_rope(description, pieces, Vec3d(physics.def().gravity_mps2));
    const EntityDescription piece =
        piece_of(description, static_cast<std::size_t>(pieces), layout.piece_m);
    Rope rope{.name = saved.name,
              .piece_m = layout.piece_m,
              .ends = {},
              .anchors_m = {},
              .pieces = {},
              .joints = std::vector<physics::JointId>(saved.pieces.size() + 1),
              .tied = true};
    for (const Made& made : saved.pieces) {
        rope.pieces.push_back(made.body);
        if (!made.entity) continue;  // it went
        rope.pieces.pop_back();
        if (!reserve(*this, {made})) return false;
        const Result<physics::BodyId> body = make_piece(piece, rope);
        if (!body || *body != made.body) return false;
        registry.add<Dropped>(made.entity, Dropped{});
        rope.pieces.push_back(*body);
    }
    description_.forces.ropes.push_back(description);
    bodies_.ropes.push_back(std::move(rope));
    return true;
}

std::vector<Vec3d> Simulation::points_of(const Rope& rope) const {
    const auto half_m = static_cast<Real>(rope.piece_m / 2);
    const auto end = [&](std::size_t side) {
        const physics::BodyId body = rope.ends[side];
        const Vec3& anchor_m = rope.anchors_m[side];
        if (!body) return Vec3d(anchor_m);
        return Vec3d(transform_point(physics.state(body).world_from_body, anchor_m));
    };
    const auto holds = [&](std::size_t joint) {
        return joint < rope.joints.size() && physics.contains(rope.joints[joint]) &&
               !physics.joint(rope.joints[joint]).state.broken;
    };
    std::vector<Vec3d> points;
    Vec3d before{0, 0, 0};
    for (std::size_t i = 0; i < rope.pieces.size(); ++i) {
        if (!physics.contains(rope.pieces[i])) continue;
        const Pose pose = physics.state(rope.pieces[i]).world_from_body;
        const Vec3d start(transform_point(pose, Vec3{0, -half_m, 0}));
        points.push_back(!points.empty() ? (before + start) * 0.5 : holds(0) ? end(0) : start);
        before = Vec3d(transform_point(pose, Vec3{0, half_m, 0}));
    }
    if (!points.empty()) points.push_back(holds(rope.pieces.size()) ? end(1) : before);
    return points;
}

}  // namespace plumbline::scene
