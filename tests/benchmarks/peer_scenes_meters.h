// What is measured on each of the peer scenes, from the bodies' poses and velocities alone.
// Names and definitions are those of the table that the other engines' figures are in.
#pragma once

#include "tests/benchmarks/peer_scenes_world.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::bench {

struct Metric {
    std::string name;
    double value{0};
};

class Meter {
public:
    virtual ~Meter() = default;
    Meter(const Meter&) = delete;
    Meter& operator=(const Meter&) = delete;

    virtual void sample(double time_s, const std::vector<BodyView>& views) = 0;
    virtual std::vector<Metric> results() const = 0;

protected:
    Meter() = default;
};

/// One of the peer scenes.
struct SceneCase {
    std::string_view name;
    double seconds{10};
    double sample_every_s{0};  ///< 0: after every step
    std::string_view metrics;  ///< in words, for --list
};

std::span<const SceneCase> scene_cases();
const SceneCase* find_scene_case(std::string_view name);

/// `end_s`: how long the run will be. The scene must outlive the meter.
std::unique_ptr<Meter> make_meter(const PeerScene& scene, double end_s);

// One family each, for make_meter().
std::unique_ptr<Meter> make_heap_meter(const PeerScene& scene, double end_s);
std::unique_ptr<Meter> make_chain_meter(const PeerScene& scene, double end_s);
std::unique_ptr<Meter> make_bounce_meter(const PeerScene& scene);
std::unique_ptr<Meter> make_roll_meter(const PeerScene& scene);
std::unique_ptr<Meter> make_spin_meter(const PeerScene& scene);

std::vector<BodyView> start_views(const PeerScene& scene);

}  // namespace plumbline::bench
