// How the cost of a step grows with the number of bodies: heaps of boxes that fall and come to rest, as many more as there
// is more ground, none asleep.
//
//   scaling                 one thread
//   scaling 1 2             these numbers of threads, one after the other
//
// Each line: mean ms per step of two simulated seconds, CPU of all threads and on the clock, and of the last half second.
// Below: the exponent k of the fit ms = c N^k through the logarithms (least squares), of all steps' CPU time.
#include "engine/core/random.h"
#include "engine/core/threads/team.h"
#include "engine/physics/physics_world.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

namespace {

using namespace plumbline;
using namespace plumbline::physics;

constexpr int kCounts[] = {100, 300, 1'000, 3'000, 10'000, 30'000};
constexpr int kHigh = 5;  ///< boxes above each other
constexpr int kSteps = 120;
constexpr int kLastSteps = 30;
constexpr Real kApart_m = 1.6_r;
constexpr float kStagger_m = 0.35F;

struct Measured {
    double cpu_ms{0};
    double clock_ms{0};
    double last_clock_ms{0};
};

void add_heaps(int count, PhysicsWorld& world) {
    const int side = static_cast<int>(std::ceil(std::sqrt(count / kHigh)));
    const auto half_m = static_cast<Real>(side) * kApart_m / 2;
    const ShapeId ground = *world.create_shape(BoxShape{.size_m = {4 * half_m, 2, 4 * half_m}});
    const ShapeId box = *world.create_shape(BoxShape{});
    world.create_body({.shape = ground, .world_from_body = {.position = {0, -1, 0}}});
    Random random(7);
    const auto stagger_m = [&] { return random.uniform(-kStagger_m, kStagger_m); };
    for (int i = 0; i < count; ++i) {
        const int column = i / kHigh;
        const Vec3 place{static_cast<Real>(column % side) * kApart_m - half_m + stagger_m(),
                         0.6_r + 1.3_r * static_cast<Real>(i % kHigh),
                         static_cast<Real>(column / side) * kApart_m - half_m + stagger_m()};
        world.create_body({.kind = BodyKind::Dynamic,
                           .shape = box,
                           .world_from_body = {.position = place},
                           .can_sleep = false});
    }
}

Measured measure(int count, int threads) {
    PhysicsWorld world(WorldDef{.threads = threads});
    add_heaps(count, world);
    Measured sum;
    for (int step = 0; step < kSteps; ++step) {
        world.step();
        const StepCost& cost = world.report().cost;
        sum.cpu_ms += cost.total_ms / kSteps;
        sum.clock_ms += cost.wall_ms / kSteps;
        if (step >= kSteps - kLastSteps) sum.last_clock_ms += cost.wall_ms / kLastSteps;
    }
    return sum;
}

/// Least squares of log(ms) over log(count).
double exponent_of(const std::vector<Measured>& measured) {
    const auto count = static_cast<double>(measured.size());
    double sum_x = 0;
    double sum_y = 0;
    double sum_xx = 0;
    double sum_xy = 0;
    for (std::size_t i = 0; i < measured.size(); ++i) {
        const double x = std::log(static_cast<double>(kCounts[i]));
        const double y = std::log(measured[i].cpu_ms);
        sum_x += x;
        sum_y += y;
        sum_xx += x * x;
        sum_xy += x * y;
    }
    return (count * sum_xy - sum_x * sum_y) / (count * sum_xx - sum_x * sum_x);
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<int> threads;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word(argv[i]);
        int number = 0;
        std::from_chars(word.data(), word.data() + word.size(), number);
        if (number < 1 || number > 64) {
            fmt::print(stderr, "expected numbers of threads, from 1 to 64, not \"{}\"\n", word);
            return 2;
        }
        threads.push_back(number);
    }
    if (threads.empty()) threads.push_back(1);
    for (const int number : threads) {
        fmt::print("{} threads of {} usable cores\n{:>8} {:>12} {:>14} {:>20}\n",
                   number,
                   usable_cores(),
                   "bodies",
                   "CPU ms/step",
                   "clock ms/step",
                   "clock, last 0.5 s");
        std::vector<Measured> all;
        for (const int count : kCounts) {
            all.push_back(measure(count, number));
            const Measured& at = all.back();
            fmt::print("{:>8} {:>12.4f} {:>14.4f} {:>20.4f}\n",
                       count,
                       at.cpu_ms,
                       at.clock_ms,
                       at.last_clock_ms);
        }
        fmt::print("exponent {:.3f}\n", exponent_of(all));
    }
    return 0;
}
