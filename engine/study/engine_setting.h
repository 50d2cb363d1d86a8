// How another engine runs a scene.
#pragma once

#include <string>
#include <vector>

namespace plumbline::study {

/// A number of the engine's own: "iterations".
struct EngineKnob {
    std::string name;
    int value{0};

    friend bool operator==(const EngineKnob&, const EngineKnob&) = default;
};

struct EngineSetting {
    std::string engine;  ///< by its name in engines/engine_table.h
    int step_hz{60};
    std::vector<EngineKnob> knobs{};  ///< the rest is the engine's default

    friend bool operator==(const EngineSetting&, const EngineSetting&) = default;
};

}  // namespace plumbline::study
