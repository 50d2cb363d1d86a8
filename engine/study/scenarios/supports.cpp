// What holds what up: A35, A36, A39, and a box that tips (A38 v).
#include "engine/study/scenarios/scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::study {
namespace {

using physics::BodyId;

/// The value in [low, high] above which `holds` is true, by halving.
double threshold_of(double low,
                    double high,
                    int halvings,
                    const std::function<bool(double)>& holds) {
    for (int i = 0; i < halvings; ++i) {
        const double middle = (low + high) / 2;
        (holds(middle) ? high : low) = middle;
    }
    return (low + high) / 2;
}

/// Three balls that touch each other on the floor and one on top of them.
bool four_balls_stand(double between, double on_floor, const Setting& setting, Course& course) {
    constexpr double kRadius_m = 0.5;
    Rig rig(setting);
    rig.floor(on_floor * on_floor / between);  // pairs get sqrt(a b)
    const double out_m = 2 * kRadius_m / std::sqrt(3.0);
    for (int i = 0; i < 3; ++i) {
        const double angle = i * 2 * kPi_d / 3;
        rig.ball({out_m * std::cos(angle), kRadius_m, out_m * std::sin(angle)},
                 kRadius_m,
                 {.friction = between});
    }
    const double top_m = kRadius_m + 2 * kRadius_m * std::sqrt(2.0 / 3);
    const BodyId top = rig.ball({0, top_m, 0}, kRadius_m, {.friction = between});
    const auto fallen = [&] { return rig.at(top).y < top_m - 0.02; };
    course.run(rig, 5, {.until = fallen});
    return !fallen();
}

Scenario four_balls() {
    static const double balls = std::sqrt(3.0) - std::sqrt(2.0);
    return {.id = "A35",
            .title = "Four balls in a pyramid",
            .set_up =
                "Three balls touch on the floor, a fourth lies on them. From which friction on do "
                "they stand for 5 s? By halving, to 0.4 %; what never stands up to mu = 1.6 "
                "counts as that.",
            .reference = "between balls sqrt 3 - sqrt 2 = 0.31784, on the floor a quarter of it",
            .metrics = {{"critical friction between balls", "0.3178"},
                        {"critical friction on the floor", "0.0795"}},
            .run = [](const Setting& setting, Course& course) -> Errors {
                const double found = threshold_of(0.2, 1.6, 10, [&](double mu) {
                    return four_balls_stand(mu, 0.5, setting, course);
                });
                const double on_floor = threshold_of(0.05, 0.4, 10, [&](double mu) {
                    return four_balls_stand(1, mu, setting, course);
                });
                return {found / balls - 1, on_floor / (balls / 4) - 1};
            },
            .knobs = {.iterations = false, .most_hz = 240, .doubled = false}};
}

/// Blocks of 1 m, each as far out over the next as the share `reach` of what is possible.
bool overhang_falls(int blocks, double reach, const Setting& setting, Course& course) {
    Rig rig(setting);
    rig.fixed_box({-0.5, -0.5, 0}, {1, 1, 1});  // a table whose edge is x = 0
    double edge_m = 0;
    for (int k = blocks; k >= 1; --k) {
        edge_m += reach * 0.5 / k;
        rig.box({edge_m - 0.5, 0.1 + 0.2 * (blocks - k), 0}, {1, 0.2, 0.5});
    }
    const BodyId top = rig.movers.back();
    const double top_m = rig.at(top).y;
    const auto fallen = [&] { return rig.at(top).y < top_m - 0.1; };
    course.run(rig, 10, {.until = fallen});
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
        .run = [=](const Setting& setting, Course& course) -> Errors {
            return {threshold_of(0.5,
                                 1.2,
                                 7,
                                 [&](double reach) {
                                     return overhang_falls(blocks, reach, setting, course);
                                 }) -
                    1};
        },
        .knobs = {.iterations = false, .most_hz = 240, .doubled = false}};
}

bool box_tips(double slope, const Setting& setting, Course& course) {
    const double angle = std::atan(slope);
    const Quatd turn = glm::angleAxis(-angle, Vec3d{0, 0, 1});
    const Vec3d out = turn * Vec3d{0, 1, 0};
    Rig rig(setting);
    rig.fixed_box(out * -1.0, {20, 2, 20}, {.friction = 2, .turn = turn});
    const BodyId box = rig.box(out * 0.5, {0.5, 1, 0.5}, {.friction = 2, .turn = turn});
    const auto tipped = [&] { return glm::dot(rig.turn(box) * Vec3d{0, 1, 0}, out) < 0.9; };
    course.run(rig, 5, {.until = tipped});
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
            .run = [](const Setting& setting, Course& course) -> Errors {
                const double found = threshold_of(
                    0.3, 0.7, 8, [&](double slope) { return box_tips(slope, setting, course); });
                return {found / 0.5 - 1};
            },
            .knobs = {.iterations = false, .most_hz = 240, .doubled = false}};
}

double impulse_between(const Rig& rig, BodyId a, BodyId b) {
    double sum = 0;
    for (const physics::ContactEvent& event : rig.world.contacts()) {
        if ((event.a == a && event.b == b) || (event.a == b && event.b == a))
            sum += static_cast<double>(event.impulse_Ns);
    }
    return sum;
}

/// Two bodies and the impulse that a step should pass between them.
struct Face {
    BodyId below;
    BodyId above;
    double expected_Ns;
    double sum{0};      ///< of errors, relative
    double squares{0};  ///< of errors
};

/// Steps for two seconds, then watches the faces for one: largest mean error, and largest rms.
Errors press(Rig& rig, std::vector<Face>& faces, Course& course) {
    course.run(rig, 2);
    int count = 0;
    course.run(rig, 1, {.after = [&](int) {
                   for (Face& face : faces) {
                       const double found = impulse_between(rig, face.below, face.above);
                       const double off = found / face.expected_Ns - 1;
                       face.sum += off;
                       face.squares += off * off;
                   }
                   ++count;
               }});
    Errors worst{0, 0};
    for (const Face& face : faces) {
        worst[0] = std::max(worst[0], std::abs(face.sum) / std::max(1, count));
        worst[1] = std::max(worst[1], std::sqrt(face.squares / std::max(1, count)));
    }
    return worst;
}

const std::vector<Metric> kPressMetrics{{"worst mean of 1 s", "the load itself"},
                                        {"worst rms of the steps of 1 s", "the load itself"}};

Scenario tower_presses() {
    return {.id = "A39 tower",
            .title = "What a tower presses with",
            .set_up =
                "10 cubes of 3 kg stand on each other; after 2 s the impulses between them are "
                "read for 1 s.",
            .reference = "the weight above each face",
            .metrics = kPressMetrics,
            .run =
                [](const Setting& setting, Course& course) {
                    constexpr int kBoxes = 10;
                    Rig rig(setting);
                    BodyId below = rig.floor();
                    std::vector<Face> faces;
                    for (int i = 0; i < kBoxes; ++i) {
                        const BodyId box = rig.box({0, 0.5 + i, 0}, {1, 1, 1}, {.mass_kg = 3});
                        rig.world.set_contact_events(box, true);
                        faces.push_back({below, box, 3 * kG_mps2 * (kBoxes - i) * rig.step_s()});
                        below = box;
                    }
                    return press(rig, faces, course);
                },
            .knobs = {.most_hz = 240}};
}

Scenario beam_presses() {
    return {
        .id = "A39 beam",
        .title = "What a beam presses with on two supports",
        .set_up =
            "A beam of 4 m and 12 kg lies on two fixed balls, 1.5 m left and 0.5 m right of its "
            "middle.",
        .reference = "the lever rule: a quarter and three quarters of its weight",
        .metrics = kPressMetrics,
        .run =
            [](const Setting& setting, Course& course) {
                Rig rig(setting);
                const BodyId left = rig.fixed_ball({-1.5, 0.5, 0}, 0.5);
                const BodyId right = rig.fixed_ball({0.5, 0.5, 0}, 0.5);
                const BodyId beam = rig.box({0, 1.1, 0}, {4, 0.2, 1}, {.mass_kg = 12});
                rig.world.set_contact_events(beam, true);
                const double weight_Ns = 12 * kG_mps2 * rig.step_s();
                std::vector<Face> faces{{left, beam, weight_Ns / 4},
                                        {right, beam, weight_Ns * 0.75}};
                return press(rig, faces, course);
            },
        .knobs = {.most_hz = 240}};
}

}  // namespace

void add_supports(std::vector<Scenario>& all) {
    all.push_back(four_balls());
    for (const int blocks : {1, 2, 4}) all.push_back(overhang(blocks));
    all.push_back(tipping_box());
    all.push_back(tower_presses());
    all.push_back(beam_presses());
}

}  // namespace plumbline::study
