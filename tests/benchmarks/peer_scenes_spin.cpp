// A torque-free body against Euler's equations.
#include "engine/core/math.h"
#include "tests/benchmarks/peer_scenes_meters.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::bench {

namespace {

/// Orientation and spin about the body's own axes.
struct Turning {
    Quatd orientation{1, 0, 0, 0};
    Vec3d spin{0, 0, 0};
};

Turning rate_of(const Turning& now, const Vec3d& inertia) {
    const Quatd spin(0.0, now.spin.x, now.spin.y, now.spin.z);
    return {0.5 * (now.orientation * spin), glm::cross(inertia * now.spin, now.spin) / inertia};
}

Turning moved(const Turning& from, const Turning& rate, double step_s) {
    return {from.orientation + rate.orientation * step_s, from.spin + rate.spin * step_s};
}

/// Classic Runge-Kutta of fourth order, 1e-4 s a step.
Turning reference_after(Turning turning, const Vec3d& inertia, double time_s) {
    constexpr double kStep_s = 1e-4;
    const auto steps = std::lround(time_s / kStep_s);
    for (long i = 0; i < steps; ++i) {
        const Turning k1 = rate_of(turning, inertia);
        const Turning k2 = rate_of(moved(turning, k1, kStep_s / 2), inertia);
        const Turning k3 = rate_of(moved(turning, k2, kStep_s / 2), inertia);
        const Turning k4 = rate_of(moved(turning, k3, kStep_s), inertia);
        const Turning mean{
            (k1.orientation + 2.0 * k2.orientation + 2.0 * k3.orientation + k4.orientation) / 6.0,
            (k1.spin + 2.0 * k2.spin + 2.0 * k3.spin + k4.spin) / 6.0};
        turning = moved(turning, mean, kStep_s);
        turning.orientation = glm::normalize(turning.orientation);
    }
    return turning;
}

double angle_between_deg(const Quatd& a, const Quatd& b) {
    const Quatd apart = glm::conjugate(a) * b;
    const double sine = std::sqrt(apart.x * apart.x + apart.y * apart.y + apart.z * apart.z);
    return degrees_from_radians(2 * std::atan2(sine, std::abs(apart.w)));
}

class SpinMeter final : public Meter {
public:
    explicit SpinMeter(const PeerScene& scene) : inertia_(scene.bodies[0].inertia_kgm2()) {
        const BodyView start = start_views(scene)[0];
        const Turning turning{start.orientation,
                              glm::conjugate(start.orientation) * start.angular_velocity_radps};
        for (Moment& moment : moments_) {
            moment.expected = reference_after(turning, inertia_, moment.at_s).orientation;
        }
        energy_J_ = energy_of(turning.spin);
        momentum_ = start.orientation * (inertia_ * turning.spin);
        side_ = turning.spin.y;
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
                moment.error_deg = angle_between_deg(now.orientation, moment.expected);
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
