// A small scene made in code, with the effects that it calls for: what references are measured in.
#pragma once

#include "engine/assets/asset_library.h"
#include "engine/study/played_scene.h"

#include <memory>
#include <string>

namespace plumbline::study {

/// A dynamic body of that mass.
scene::EntityDescription ball_of(const std::string& name,
                                 const Vec3& position_m,
                                 double radius_m,
                                 double mass_kg);
scene::EntityDescription box_of(const std::string& name,
                                const Vec3& position_m,
                                const Vec3& size_m,
                                double mass_kg);
/// Static, its top at y = 0.
scene::EntityDescription floor_of(const Vec3& size_m);

class FieldWorld {
public:
    explicit FieldWorld(const scene::SceneDescription& description);

    void step();
    /// Until at least so many seconds have passed.
    void run_to(double seconds);

    double time_s() const { return simulation().time_s(); }
    physics::BodyState state(const std::string& name) const;
    Vec3d velocity_mps(const std::string& name) const { return Vec3d(state(name).velocity_mps); }
    Vec3d position_m(const std::string& name) const {
        return Vec3d(state(name).world_from_body.position);
    }
    /// Kinetic, and potential in gravity and in all fields.
    double energy_J() const;
    /// CPU time of all steps so far for each simulated second.
    double cpu_ms_per_s() const { return cpu_ms_ / time_s(); }
    scene::Simulation& simulation() const { return played_.simulation(); }

private:
    std::unique_ptr<assets::AssetLibrary> library_;
    PlayedScene played_;
    double cpu_ms_{0};
};

/// The mean time between every other zero of a number that is asked after each step, s.
template <class Number>
double period_s(FieldWorld& world, double seconds, const Number& number) {
    double first_s = -1;
    double last_s = 0;
    int crossings = -1;
    double before = number();
    while (world.time_s() < seconds) {
        const double from_s = world.time_s();
        world.step();
        const double now = number();
        if (before * now < 0) {
            last_s = from_s + (world.time_s() - from_s) * before / (before - now);
            if (first_s < 0) first_s = last_s;
            ++crossings;
        }
        if (now != 0) before = now;
    }
    return crossings > 0 ? 2 * (last_s - first_s) / crossings : 0;
}

}  // namespace plumbline::study
