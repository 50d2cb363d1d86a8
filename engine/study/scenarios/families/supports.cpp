// What holds what up: A35, A36, A39, and a box that tips (A38 v).
#include "engine/study/scenarios/families/supports.h"

#include "engine/study/scenarios/families/sliding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::study {

using physics::BodyId;

double four_balls_mu() {
    return std::sqrt(3.0) - std::sqrt(2.0);
}
double four_balls_floor_mu() {
    return four_balls_mu() / 4;
}

bool four_balls_stand(const FourBalls& mu, Stepper& stepper) {
    constexpr double kRadius_m = 0.5;
    ScenarioWorld world(stepper.setting());
    world.floor(mu.on_floor * mu.on_floor / mu.between);  // pairs get sqrt(a b)
    const double out_m = 2 * kRadius_m / std::sqrt(3.0);
    for (int i = 0; i < 3; ++i) {
        const double angle = i * 2 * kPi_d / 3;
        world.sphere({out_m * std::cos(angle), kRadius_m, out_m * std::sin(angle)},
                     kRadius_m,
                     {.friction = mu.between});
    }
    const double top_m = kRadius_m + 2 * kRadius_m * std::sqrt(2.0 / 3);
    const BodyId top = world.sphere({0, top_m, 0}, kRadius_m, {.friction = mu.between});
    const auto fallen = [&] { return world.at(top).y < top_m - 0.02; };
    stepper.run(world, 5, {.until = fallen});
    return !fallen();
}

Overhang::Overhang(const Setting& setting, int blocks, double reach) : world(setting) {
    world.fixed_box({-0.5, -0.5, 0}, {1, 1, 1});  // a table whose edge is x = 0
    double edge_m = 0;
    for (int k = blocks; k >= 1; --k) {
        edge_m += reach * 0.5 / k;
        starts_m.push_back({edge_m - 0.5, 0.1 + 0.2 * (blocks - k), 0});
        world.box(starts_m.back(), {1, 0.2, 0.5});
    }
}

double Overhang::moved_m() const {
    double most_m = 0;
    for (std::size_t i = 0; i < starts_m.size(); ++i)
        most_m = std::max(most_m, glm::distance(world.at(world.movers[i]), starts_m[i]));
    return most_m;
}

double Overhang::fallen_m() const {
    return starts_m.back().y - world.at(world.movers.back()).y;
}

double impulse_between_Ns(const ScenarioWorld& world, BodyId a, BodyId b) {
    double sum = 0;
    for (const physics::ContactEvent& event : world.physics.report().contacts) {
        if ((event.a == a && event.b == b) || (event.a == b && event.b == a))
            sum += static_cast<double>(event.impulse_Ns);
    }
    return sum;
}

namespace {

/// Two bodies and the impulse that a step should pass between them.
struct Face {
    BodyId below;
    BodyId above;
    double expected_Ns;
    double sum{0};      ///< of errors, relative
    double squares{0};  ///< of errors
};

PressErrors press(ScenarioWorld& world, std::vector<Face>& faces, Stepper& stepper) {
    stepper.run(world, 2);
    int count = 0;
    stepper.run(world, 1, {.after = [&](int) {
                    for (Face& face : faces) {
                        const double found = impulse_between_Ns(world, face.below, face.above);
                        const double off = found / face.expected_Ns - 1;
                        face.sum += off;
                        face.squares += off * off;
                    }
                    ++count;
                }});
    PressErrors worst{0, 0};
    for (const Face& face : faces) {
        worst.mean = std::max(worst.mean, std::abs(face.sum) / std::max(1, count));
        worst.rms = std::max(worst.rms, std::sqrt(face.squares / std::max(1, count)));
    }
    return worst;
}

}  // namespace

PressErrors tower_presses(Stepper& stepper) {
    constexpr int kBoxes = 10;
    ScenarioWorld world(stepper.setting());
    BodyId below = world.floor();
    std::vector<Face> faces;
    for (int i = 0; i < kBoxes; ++i) {
        const BodyId box = world.box({0, 0.5 + i, 0}, {1, 1, 1}, {.mass_kg = 3});
        world.physics.set_contact_events(box, true);
        faces.push_back({below, box, 3 * kG_mps2 * (kBoxes - i) * world.step_s()});
        below = box;
    }
    return press(world, faces, stepper);
}

PressErrors beam_presses(Stepper& stepper) {
    ScenarioWorld world(stepper.setting());
    const BodyId left = world.fixed_sphere({-1.5, 0.5, 0}, 0.5);
    const BodyId right = world.fixed_sphere({0.5, 0.5, 0}, 0.5);
    const BodyId beam = world.box({0, 1.1, 0}, {4, 0.2, 1}, {.mass_kg = 12});
    world.physics.set_contact_events(beam, true);
    const double weight_Ns = 12 * kG_mps2 * world.step_s();
    std::vector<Face> faces{{left, beam, weight_Ns / 4}, {right, beam, weight_Ns * 0.75}};
    return press(world, faces, stepper);
}

namespace {

Scenario four_balls() {
    return {.id = "A35",
            .title = "Four balls in a pyramid",
            .set_up =
                "Three balls touch on the floor, a fourth lies on them. From which friction on do "
                "they stand for 5 s? By halving, to 0.4 %; what never stands up to mu = 1.6 "
                "counts as that.",
            .reference = "between balls sqrt 3 - sqrt 2 = 0.31784, on the floor a quarter of it",
            .metrics = {{"critical friction between balls", "0.3178"},
                        {"critical friction on the floor", "0.0795"}},
            .run = [](Stepper& stepper) -> Errors {
                const double found = threshold_of(0.2, 1.6, 10, [&](double mu) {
                    return four_balls_stand({mu, 0.5}, stepper);
                });
                const double on_floor = threshold_of(0.05, 0.4, 10, [&](double mu) {
                    return four_balls_stand({1, mu}, stepper);
                });
                return {found / four_balls_mu() - 1, on_floor / four_balls_floor_mu() - 1};
            },
            .knobs = {.iterations = false, .most_hz = 240, .doubled = false}};
}

bool overhang_falls(int blocks, double reach, Stepper& stepper) {
    Overhang leans(stepper.setting(), blocks, reach);
    const auto fallen = [&] { return leans.fallen_m() > 0.1; };
    stepper.run(leans.world, 10, {.until = fallen});
    return fallen();
}

Scenario overhang(int blocks) {
    return {
        .id = fmt::format("A36 n={}", blocks),
        .title = "Blocks that lean out over an edge",
        .set_up = fmt::format("{} blocks, each as far out over the next as the same share of what "
                              "is possible. From which share on do they fall within 10 s? By "
                              "halving between 0.5 and 1.2, to 0.6 %.",
                              blocks),
        .reference = "(L/2) sum 1/k",
        .metrics = {{"share at which they fall", "the most that is possible"}},
        .run = [=](Stepper& stepper) -> Errors {
            return {
                threshold_of(0.5,
                             1.2,
                             7,
                             [&](double reach) { return overhang_falls(blocks, reach, stepper); }) -
                1};
        },
        .knobs = {.iterations = false, .most_hz = 240, .doubled = false}};
}

bool box_tips(double slope, Stepper& stepper) {
    const Slope plane(std::atan(slope));
    ScenarioWorld world(stepper.setting());
    world.fixed_box(plane.out * -1.0, {20, 2, 20}, {.friction = 2, .turn = plane.turn});
    const BodyId box =
        world.box(plane.out * 0.5, {0.5, 1, 0.5}, {.friction = 2, .turn = plane.turn});
    const auto tipped = [&] { return glm::dot(world.turn(box) * Vec3d{0, 1, 0}, plane.out) < 0.9; };
    stepper.run(world, 5, {.until = tipped});
    return tipped();
}

Scenario tipping_box() {
    return {.id = "A38 box tips",
            .title = "A box on a slope tips over",
            .set_up =
                "A box of 0.5 x 1 x 0.5 m on a slope, friction 2. From which slope on does it tip "
                "within 5 s? By halving between tan a = 0.3 and 0.7, to 0.3 %.",
            .reference = "tan a > w / h = 0.5",
            .metrics = {{"critical slope", "0.5"}},
            .run = [](Stepper& stepper) -> Errors {
                const double found = threshold_of(
                    0.3, 0.7, 8, [&](double slope) { return box_tips(slope, stepper); });
                return {found / 0.5 - 1};
            },
            .knobs = {.iterations = false, .most_hz = 240, .doubled = false}};
}

const std::vector<Metric> kPressMetrics{{"worst mean of 1 s", "the load itself"},
                                        {"worst rms of the steps of 1 s", "the load itself"}};

Scenario tower() {
    return {.id = "A39 tower",
            .title = "What a tower presses with",
            .set_up =
                "10 cubes of 3 kg stand on each other; after 2 s the impulses between them are "
                "read for 1 s.",
            .reference = "the weight above each face",
            .metrics = kPressMetrics,
            .run = [](Stepper& stepper) -> Errors {
                const auto [mean, rms] = tower_presses(stepper);
                return {mean, rms};
            },
            .knobs = {.most_hz = 240}};
}

Scenario beam() {
    return {
        .id = "A39 beam",
        .title = "What a beam presses with on two supports",
        .set_up =
            "A beam of 4 m and 12 kg lies on two fixed balls, 1.5 m left and 0.5 m right of its "
            "middle.",
        .reference = "the lever rule: a quarter and three quarters of its weight",
        .metrics = kPressMetrics,
        .run = [](Stepper& stepper) -> Errors {
            const auto [mean, rms] = beam_presses(stepper);
            return {mean, rms};
        },
        .knobs = {.most_hz = 240}};
}

}  // namespace

std::vector<Scenario> supports_family() {
    return {four_balls(), overhang(1), overhang(2), overhang(4), tipping_box(), tower(), beam()};
}

}  // namespace plumbline::study
