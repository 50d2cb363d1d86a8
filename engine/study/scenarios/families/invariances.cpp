// The same scenes turned, moved away, carried along, scaled, made in another order and run backwards:
// A40 to A44. None needs a reference.
#include "engine/study/scenarios/families/invariances.h"

#include "engine/study/scenarios/scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::study {
namespace {

using physics::BodyId;
using physics::BodyKind;

Vec3d pendulum_end(const Frame& frame, Stepper& stepper) {
    FramedWorld framed(frame, stepper.setting());
    const std::size_t nail =
        framed.box(BodyKind::Static, {0, 0, 0}, {0.2, 0.2, 0.2}, {.touches = false});
    const std::size_t ball = framed.sphere({1, 0, 0}, 0.1, {.touches = false});
    framed.build();
    framed.join(ball, nail, {0, 0, 0});
    framed.run(stepper, 2);
    return framed.at(ball);
}

Vec3d bounce_end(const Frame& frame, Stepper& stepper) {
    FramedWorld framed(frame, stepper.setting());
    framed.floor(0.5, 0.8);
    const std::size_t ball = framed.sphere({0, 1.1, 0}, 0.1, {.restitution = 0.8});
    framed.build();
    framed.run(stepper, 0.9);  // about half-way between the first two contacts
    const double speed = framed.velocity(ball).y;
    const Vec3d at = framed.at(ball);
    return {at.x, at.y - 0.1 + speed * speed / (2 * kG_mps2), at.z};
}

Vec3d slide_end(const Frame& frame, Stepper& stepper) {
    FramedWorld framed(frame, stepper.setting());
    framed.floor(0.3);
    const std::size_t box = framed.box(
        BodyKind::Dynamic, {0, 0.25, 0}, {1, 0.5, 1}, {.friction = 0.3, .velocity_mps = {5, 0, 0}});
    framed.build();
    framed.run(stepper, 2.5);
    return framed.at(box);
}

Vec3d roll_end(const Frame& frame, Stepper& stepper) {
    FramedWorld framed(frame, stepper.setting());
    framed.floor(0.2);
    const std::size_t ball =
        framed.sphere({0, 0.5, 0}, 0.5, {.friction = 0.2, .velocity_mps = {5, 0, 0}});
    framed.build();
    framed.run(stepper, 3);
    return framed.at(ball);
}

/// The top of five cubes that come down a centimetre each.
Vec3d tower_end(const Frame& frame, Stepper& stepper) {
    FramedWorld framed(frame, stepper.setting());
    framed.floor(0.5);
    std::size_t top = 0;
    for (int i = 0; i < 5; ++i)
        top = framed.box(BodyKind::Dynamic, {0, 0.51 + 1.01 * i, 0}, {1, 1, 1}, {});
    framed.build();
    framed.run(stepper, 3);
    return framed.at(top);
}

constexpr std::array<FramedScene, 5> kScenes{{{"sliding box", 4.25, slide_end},
                                              {"pendulum", 1, pendulum_end},
                                              {"bounce", 0.64, bounce_end},
                                              {"slide to roll", 11.2, roll_end},
                                              {"tower of five", 4.5, tower_end}}};

}  // namespace

std::span<const FramedScene> framed_scenes() {
    return kScenes;
}

std::vector<Frame> turned_frames() {
    std::vector<Frame> frames;
    for (int i = 1; i < 24; ++i) {
        const Quatd yaw = glm::angleAxis(i * kPi_d / 12, Vec3d{0, 1, 0});
        const Quatd tilt = glm::angleAxis(0.3 * i, Vec3d{0.6, 0, 0.8});
        frames.push_back({.turn = tilt * yaw});
    }
    return frames;
}

Frame drifting_frame(double speed_mps) {
    return {.drift_mps = Vec3d{0.6, 0, 0.8} * speed_mps};
}

Frame far_frame(double distance_m) {
    return {.offset_m = {distance_m, 0, -distance_m}};
}

double back_in_time_m(double seconds, Stepper& stepper) {
    ScenarioWorld world(stepper.setting());
    world.room(2);
    const BodyId ball = world.sphere(
        {0.3, 0.2, 0.1}, 0.25, {.friction = 0, .restitution = 1, .velocity_mps = {3.1, 2.3, -1.7}});
    const Vec3d start = world.at(ball);
    stepper.run(world, seconds);
    world.physics.set_velocity(ball, vec(-world.velocity(ball)), {0, 0, 0});
    stepper.run(world, seconds);
    return glm::distance(world.at(ball), start);
}

namespace {

/// For every scene the furthest that any of the frames ends from the plain one.
Errors furthest_by_scene(std::span<const Frame> frames, Stepper& stepper) {
    Errors errors;
    for (const FramedScene& scene : kScenes) {
        const Vec3d plain = scene.end_m({}, stepper);
        double furthest = 0;
        for (const Frame& frame : frames)
            furthest = std::max(furthest, glm::distance(scene.end_m(frame, stepper), plain));
        errors.push_back(furthest / scene.scale_m);
    }
    return errors;
}

/// For every frame the furthest that any scene ends from the plain one, as a share of its way.
Errors furthest_by_frame(std::span<const Frame> frames, Stepper& stepper) {
    Errors errors(frames.size(), 0.0);
    for (const FramedScene& scene : kScenes) {
        const Vec3d plain = scene.end_m({}, stepper);
        for (std::size_t i = 0; i < frames.size(); ++i) {
            const double off = glm::distance(scene.end_m(frames[i], stepper), plain);
            errors[i] = std::max(errors[i], off / scene.scale_m);
        }
    }
    return errors;
}

constexpr const char* kSetUp =
    "A box that slides to a stop, a pendulum, a bounce, a ball that comes to roll and a tower of "
    "five: ";
constexpr Knobs kUpTo240Hz{.iterations = false, .most_hz = 240};

std::vector<Metric> metrics_by_scene() {
    std::vector<Metric> metrics;
    for (const FramedScene& scene : kScenes)
        metrics.push_back({scene.name, fmt::format("{:g} m", scene.scale_m)});
    return metrics;
}

Scenario by_scene(std::string id, std::string title, const char* how, std::vector<Frame> frames) {
    return {.id = std::move(id),
            .title = std::move(title),
            .set_up = fmt::format("{}{}", kSetUp, how),
            .reference = "the same scene as it is: furthest place at the end",
            .tier = Tier::Conserved,
            .metrics = metrics_by_scene(),
            .run = [frames = std::move(frames)](
                       Stepper& stepper) { return furthest_by_scene(frames, stepper); },
            .knobs = kUpTo240Hz};
}

/// One metric for each of `values`, named by `metric`: the world seen from frame_of(value).
Scenario by_value(std::string id,
                  std::string title,
                  const char* how,
                  const char* metric,
                  const std::vector<double>& values,
                  Frame (*frame_of)(double value)) {
    std::vector<Frame> frames;
    std::vector<Metric> metrics;
    for (const double value : values) {
        frames.push_back(frame_of(value));
        metrics.push_back({fmt::format(fmt::runtime(metric), value), "the path of the scene"});
    }
    return {.id = std::move(id),
            .title = std::move(title),
            .set_up = fmt::format("{}{}", kSetUp, how),
            .reference = "the same scene as it is: furthest place at the end, of any scene",
            .tier = Tier::Conserved,
            .metrics = std::move(metrics),
            .run = [frames = std::move(frames)](
                       Stepper& stepper) { return furthest_by_frame(frames, stepper); },
            .knobs = kUpTo240Hz};
}

Scenario turned() {
    return by_scene(
        "A40", "The world is turned", "turned 23 ways, gravity with them.", turned_frames());
}

Scenario far_away() {
    return by_value("A41",
                    "The world is far away",
                    "moved away along x and z.",
                    "{:g} m away",
                    {1e1, 1e2, 1e3, 1e4, 1e5},
                    far_frame);
}

Scenario carried_along() {
    return by_value("A42",
                    "The world moves along",
                    "with everything, floors too, moving at one velocity.",
                    "at {:g} m/s",
                    {1.0, 10.0, 100.0},
                    drifting_frame);
}

Scenario scaled() {
    return by_value("A43",
                    "The world is larger or smaller",
                    "lengths times s, times times sqrt s, steps too.",
                    "{:g} times as long",
                    {0.01, 0.1, 10.0, 100.0},
                    [](double scale) { return Frame{.scale = scale}; });
}

Scenario made_backwards() {
    return by_scene("A44 order",
                    "Bodies are made in another order",
                    "bodies made in the opposite order.",
                    {{.backwards = true}});
}

Scenario back_in_time() {
    return {.id = "A44 time",
            .title = "Time runs backwards",
            .set_up =
                "A ball flies about in a smooth elastic room for 2 s; then its velocity is turned "
                "round, for 2 s.",
            .reference = "it comes back to where it started",
            .tier = Tier::Conserved,
            .metrics = {{"distance from the start", "the room, 4 m"}},
            .run = [](Stepper& stepper) -> Errors { return {back_in_time_m(2, stepper) / 4}; },
            .knobs = {.iterations = false}};
}

}  // namespace

std::vector<Scenario> invariances_family() {
    return {turned(), far_away(), carried_along(), scaled(), made_backwards(), back_in_time()};
}

}  // namespace plumbline::study
