// Chains that hang: A14, A15.
#include "engine/study/scenarios/integrate.h"
#include "engine/study/scenarios/scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::study {
namespace {

using physics::BodyId;
using physics::JointId;

double widest_gap_m(const ScenarioWorld& world, const std::vector<JointId>& joints) {
    double widest = 0;
    for (const JointId joint : joints) widest = std::max(widest, world.joint(joint).error_m);
    return widest;
}

constexpr int kRods = 10;
constexpr double kRod_m = 0.2;
constexpr double kSpan_m = 1.6;

/// Angle of rod i (from 0) of a chain with the horizontal pull `pull_N`.
double rod_rad(int i, double pull_N) {
    return std::atan((i + 0.5 - kRods / 2.0) * kG_mps2 / pull_N);
}

/// The pull at which the chain spans what it spans, by halving.
double catenary_pull_N() {
    return threshold_of(1, 1000, 200, [](double pull_N) {
        double span = 0;
        for (int rod = 0; rod < kRods; ++rod) span += kRod_m * std::cos(rod_rad(rod, pull_N));
        return span >= kSpan_m;
    });
}

Scenario catenary() {
    static constexpr double kSeconds = 4;
    static const double pull_N = catenary_pull_N();
    static const double end_N = std::hypot(pull_N, kRods / 2.0 * kG_mps2);
    return {
        .id = "A14",
        .title = "A chain between two nails",
        .set_up =
            "10 rods of 0.2 m and 1 kg hang between two points 1.6 m apart at one height, "
            "and start where they balance.",
        .reference =
            "tan a_i = (i - 1/2) m g / H from the middle, H so that the span is 1.6 m: "
            "33.089237 N",
        .metrics = {{"pull at a nail, mean of the last second", "59.17 N"},
                    {"sag at 4 s", "0.5337 m"},
                    {"largest gap", "a rod, 0.2 m"}},
        .run = [](Stepper& stepper) -> Errors {
            ScenarioWorld world(stepper.setting());
            std::vector<JointId> joints;
            Vec3d end{0, 0, 0};
            BodyId before{};
            double sag_m = 0;
            for (int i = 0; i < kRods; ++i) {
                const double angle = rod_rad(i, pull_N);
                const Vec3d along{std::cos(angle), std::sin(angle), 0};
                const BodyId rod =
                    world.box(end + along * (kRod_m / 2),
                              {kRod_m, 0.02, 0.02},
                              {.turn = glm::angleAxis(angle, Vec3d{0, 0, 1}), .touches = false});
                joints.push_back(world.join_at(end, rod, before));
                end += along * kRod_m;
                sag_m = std::max(sag_m, -end.y);
                before = rod;
            }
            joints.push_back(world.join_at(end, before));
            double sum_N = 0;
            int count = 0;
            double gap_m = 0;
            stepper.run(world, kSeconds, {.after = [&](int i) {
                            gap_m = std::max(gap_m, widest_gap_m(world, joints));
                            if ((i + 1) * world.step_s() <= kSeconds - 1) return;
                            sum_N += static_cast<double>(world.joint(joints.front()).force_N);
                            ++count;
                        }});
            // The middle joint is the end of rod 5.
            const BodyId middle = world.movers[kRods / 2 - 1];
            const Vec3d lowest = world.at(middle) + world.turn(middle) * Vec3d{kRod_m / 2, 0, 0};
            return {sum_N / std::max(1, count) / end_N - 1, -lowest.y / sag_m - 1, gap_m / kRod_m};
        },
        .notes = {"small_step and float64 start from rounding: what is left is how well the "
                  "balance is kept, which is no balance that the chain could fall out of"}};
}

/// A chain that hangs straight down from the world with a ball at its end.
struct Hanging {
    int links;
    double link_m;
    double end_kg;
};

Errors hang(const Hanging& chain, double seconds, Stepper& stepper) {
    ScenarioWorld world(stepper.setting());
    std::vector<JointId> joints;
    BodyId before{};
    for (int i = 0; i < chain.links; ++i) {
        const Vec3d top{0, -i * chain.link_m, 0};
        const BodyId link = world.box(
            top - Vec3d{0, chain.link_m / 2, 0}, {0.1, chain.link_m, 0.1}, {.touches = false});
        joints.push_back(world.join_at(top, link, before));
        before = link;
    }
    const double length_m = chain.links * chain.link_m;
    const Vec3d end{0, -length_m, 0};
    const BodyId ball =
        world.sphere(end - Vec3d{0, 0.25, 0}, 0.25, {.mass_kg = chain.end_kg, .touches = false});
    joints.push_back(world.join_at(end, ball, before));
    const double weight_N = (chain.links + chain.end_kg) * kG_mps2;
    double sum_N = 0;
    double squares_m2 = 0;
    double stretch_m = 0;
    int count = 0;
    stepper.run(world, seconds, {.after = [&](int i) {
                    const double off_m = -world.at(ball).y - length_m - 0.25;
                    stretch_m = std::max(stretch_m, std::abs(off_m));
                    if ((i + 1) * world.step_s() <= seconds - 2) return;
                    sum_N += static_cast<double>(world.joint(joints.front()).force_N);
                    squares_m2 += glm::dot(world.velocity(ball), world.velocity(ball));
                    ++count;
                }});
    const double off_m = -world.at(ball).y - length_m - 0.25;
    return {off_m / length_m,
            stretch_m / length_m,
            sum_N / std::max(1, count) / weight_N - 1,
            std::sqrt(squares_m2 / std::max(1, count)) / std::sqrt(kG_mps2 * length_m)};
}

Scenario heavy_chain(std::string id, const Hanging& chain, double seconds) {
    return {.id = std::move(id),
            .title = fmt::format("A chain with {} kg at its end", chain.end_kg),
            .set_up = fmt::format("{} links of {} m and 1 kg hang straight with {} kg at the end.",
                                  chain.links,
                                  chain.link_m,
                                  chain.end_kg),
            .reference = "it stays as long as it is, and its first joint carries the whole weight",
            .metrics = {{fmt::format("stretch at {} s", seconds), "the length"},
                        {"largest stretch", "the length"},
                        {"load on the first joint, mean of 2 s", "the weight below it"},
                        {"speed of the end, rms of the last 2 s", "sqrt(g l)"}},
            .run = [=](Stepper& stepper) { return hang(chain, seconds, stepper); },
            .knobs = {.most_hz = chain.links > 10 ? 240 : 960}};
}

}  // namespace

std::vector<Scenario> chains_family() {
    return {catenary(),
            heavy_chain("A15 100:1", {10, 0.5, 100}, 5),
            heavy_chain("A15 1000:1", {50, 0.4, 1000}, 5)};
}

}  // namespace plumbline::study
