// A torque-free body against Euler's equations.
#include "engine/core/math.h"
#include "engine/study/angle_between.h"
#include "engine/study/scenarios/families/tops.h"
#include "tests/benchmarks/peer_scenes_meters.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::bench {

namespace {

class SpinMeter final : public Meter {
public:
    explicit SpinMeter(const PeerScene& scene) : inertia_(scene.bodies[0].inertia_kgm2()) {
        const BodyView start = start_views(scene)[0];
        const Vec3d spin = glm::conjugate(start.orientation) * start.angular_velocity_radps;
        for (Moment& moment : moments_) {
            moment.expected =
                study::turned_for({start.orientation, spin}, inertia_, moment.at_s).turn;
        }
        energy_J_ = energy_of(spin);
        momentum_ = start.orientation * (inertia_ * spin);
        side_ = spin.y;
    }

    void sample(double time_s, const std::vector<BodyView>& views) override {
        const BodyView& now = views[0];
        const Vec3d spin = glm::conjugate(now.orientation) * now.angular_velocity_radps;
        const Vec3d momentum = now.orientation * (inertia_ * spin);
        const double energy = std::abs(energy_of(spin) / energy_J_ - 1);
        momentum_error_ = glm::length(momentum - momentum_) / glm::length(momentum_);
        most_energy_ = std::max(most_energy_, energy);
        most_momentum_ = std::max(most_momentum_, momentum_error_);
        if (spin.y * side_ < 0) {
            side_ = spin.y;
            ++flips_;
        }
        for (Moment& moment : moments_) {
            if (std::abs(time_s - moment.at_s) < 1e-6) {
                moment.error_deg = degrees_from_radians(
                    study::angle_between_rad(now.orientation, moment.expected));
            }
        }
    }

    std::vector<Metric> results() const override {
        return {{"E_max_pct", most_energy_ * 100},
                {"L_max_pct", most_momentum_ * 100},
                {"L_end_pct", momentum_error_ * 100},
                {"flips", static_cast<double>(flips_)},
                {"orient_err_1s_deg", moments_[0].error_deg},
                {"orient_err_10s_deg", moments_[1].error_deg}};
    }

private:
    struct Moment {
        double at_s{0};
        Quatd expected{1, 0, 0, 0};
        double error_deg{-1};  ///< -1: the run was too short, or no step ended there
    };

    double energy_of(const Vec3d& spin) const { return 0.5 * glm::dot(spin, inertia_ * spin); }

    Vec3d inertia_;
    std::array<Moment, 2> moments_{{{.at_s = 1}, {.at_s = 10}}};
    Vec3d momentum_{0, 0, 0};
    double energy_J_{0};
    double side_{0};
    double most_energy_{0};
    double most_momentum_{0};
    double momentum_error_{0};
    int flips_{0};
};

}  // namespace

std::unique_ptr<Meter> make_spin_meter(const PeerScene& scene) {
    return std::make_unique<SpinMeter>(scene);
}

}  // namespace plumbline::bench
