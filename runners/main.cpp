// plumbline-engines: runs a scene with Bullet or ODE as Debian packages them, for `plumbline study --engines`. It reads
// line after line and answers each (engine/study/engines/engine_process.h).
#include "engine/core/time/stopwatch.h"

#include "runners/engine_world.h"
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace plumbline::engines {
namespace {

void say(const Json& json) {
    std::cout << json.dump() << std::endl;  // whoever asked waits for it
}

/// Does the steps that are asked for, and says what they cost and led to.
Json advance(EngineWorld& world, const Json& scene, const Json& request) {
    if (request.contains("set")) {
        for (const std::vector<double> numbers : request.at("set"))
            world.set_state(static_cast<std::size_t>(numbers.at(0)),
                            std::span(numbers).subspan(1).first<kNumbers>());
    }
    if (request.contains("gravity_mps2")) world.set_gravity(request.at("gravity_mps2"));
    std::vector<double> step_ms;
    const CpuTimer cpu;
    LapTimer wall;
    wall.start();
    for (int i = 0; i < request.at("steps"); ++i) {
        world.step();
        step_ms.push_back(wall.lap_ms());
    }
    const double cpu_ms = cpu.ms();
    const std::vector<std::size_t> moving = scene.at("moving");
    std::vector<double> states(moving.size() * kNumbers);
    for (std::size_t i = 0; i < moving.size(); ++i)
        world.get_state(moving[i], std::span(states).subspan(i * kNumbers).first<kNumbers>());
    return {{"cpu_ms", cpu_ms}, {"step_ms", step_ms}, {"states", states}};
}

void answer_lines(const Engine& engine) {
    say({{"version", engine.version}});
    Json scene;
    std::unique_ptr<EngineWorld> world;
    for (std::string line; std::getline(std::cin, line);) {
        const Json request = Json::parse(line);
        if (!request.contains("scene")) {
            if (world == nullptr) throw std::runtime_error("expected a scene first");
            say(advance(*world, scene, request));
            continue;
        }
        world.reset();
        scene = request.at("scene");
        world = engine.make(scene);
        say(Json::object());
    }
}

int run_engine(std::string_view name) {
    std::vector<Engine> engines{bullet_engine()};
#ifdef PLUMBLINE_HAS_ODE
    engines.push_back(ode_engine());
#endif
    const auto engine = std::ranges::find(engines, name, &Engine::name);
    try {
        if (engine == engines.end())
            throw std::runtime_error(
                fmt::format("this build has no {}; with Debian's lib{}-dev installed, build again",
                            name,
                            name));
        answer_lines(*engine);
    } catch (const Lacks& lacks) {
        say({{"lacks", lacks.what()}});
    } catch (const std::exception& error) {
        say({{"failed", error.what()}});
    }
    return 0;
}

}  // namespace
}  // namespace plumbline::engines

int main(int count, char** words) {
    if (count == 2) return plumbline::engines::run_engine(words[1]);
    std::cerr
        << "plumbline-engines is run by `plumbline study --engines`; its argument is an engine\n";
    return 2;
}
