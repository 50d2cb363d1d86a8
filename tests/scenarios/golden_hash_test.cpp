// The same bits on every processor and with every C library: state hashes of scenes, per precision.
//
// PLUMBLINE_GOLDEN=FILE writes the lines of this precision there instead of comparing.
#include "engine/core/hash.h"
#include "tests/scenarios/scene_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>

namespace plumbline {
namespace {

using test::SceneRun;

constexpr int kSteps = 300;
const std::vector<std::string> kScenes{"falling_cube.toml",
                                       "joints.toml",
                                       "pile.toml",
                                       "playroom.toml",
                                       "bench/peers/stack.toml",
                                       "bench/peers/heavy1000.toml",
                                       "bench/peers/chainh.toml",
                                       "bench/peers/dzhani.toml",
                                       "bench/peers/s666.toml",
                                       "bench/peers/slideroll.toml"};

std::string hash_of(const std::string& scene, physics::Solver solver) {
    SceneRun run(scene, {.solver = solver});
    if (!run.simulation) return "";
    run.step(kSteps);
    return hex_of(run.simulation->state_hash());
}

/// "float32 small_step pile.toml" to the hash.
std::map<std::string, std::string> golden_hashes() {
    std::map<std::string, std::string> all;
    std::ifstream file(test::repository() / "tests/scenarios/golden_hashes.txt");
    for (std::string line; std::getline(file, line);) {
        const std::size_t space = line.rfind(' ');
        if (line.empty() || line.front() == '#' || space == std::string::npos) continue;
        all[line.substr(0, space)] = line.substr(space + 1);
    }
    return all;
}

TEST(GoldenHash, EveryStateIsTheOneWrittenDown) {
    const auto golden = golden_hashes();
    const char* written = std::getenv("PLUMBLINE_GOLDEN");
    std::ofstream out;
    if (written != nullptr) {
        out.open(written, std::ios::app);
    }
    for (const physics::Solver solver : {physics::Solver::SmallStep, physics::Solver::BulletSi}) {
        for (const std::string& scene : kScenes) {
            const std::string key =
                fmt::format("{} {} {}", kPrecisionName, physics::solver_name(solver), scene);
            const std::string hash = hash_of(scene, solver);
            if (written != nullptr)
                out << key << ' ' << hash << '\n';
            else
                EXPECT_EQ(hash, golden.contains(key) ? golden.at(key) : "") << key;
        }
    }
}

}  // namespace
}  // namespace plumbline
