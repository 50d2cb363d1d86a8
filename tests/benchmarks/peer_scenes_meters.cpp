// The list of scenes, and the meters of chains and single bodies.
#include "tests/benchmarks/peer_scenes_meters.h"

#include "engine/core/math.h"
#include "engine/study/scenarios/families/rolling.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::bench {

namespace {

constexpr std::string_view kHeavy =
    "stands t_fall pen_max pen_max_all pen_final top_drop drift_h_all vrms_end";
constexpr std::string_view kPile =
    "pen_max pen_final pen_mean_final drift_h_all com_y vrms_end KE_end_J";
constexpr std::string_view kChain =
    "stretch_max_pct stretch_end_pct joint_err_max_m E_end_rel vrms_end";

constexpr std::array<SceneCase, 17> kCases{{
    {"stack", 60, 0.1, "stands t_fall top_drop drift_h_all pen_max pen_final vrms_end"},
    {"pyramid", 20, 0.1, "stands drift_h_after1s drift_h_all moved pen_max pen_final vrms_end"},
    {"heavy1", 10, 0.1, kHeavy},
    {"heavy10", 10, 0.1, kHeavy},
    {"heavy100", 10, 0.1, kHeavy},
    {"heavy1000", 10, 0.1, kHeavy},
    {"chainv", 20, 0, kChain},
    {"chainh", 20, 0, kChain},
    {"bounce", 60, 0, "apex1_err_pct apex_end_err_pct apex_max_err_pct"},
    {"slideroll", 3, 0, "x_err_max_mm v_err_max v_final_err_pct"},
    {"flatroll", 3, 0, "y_up_mm y_down_mm lateral_mm along_err_mm speed_err_pct"},
    {"dzhani", 60, 0, "E_max_pct L_max_pct L_end_pct flips orient_err_1s_deg orient_err_10s_deg"},
    {"s666", 10, 0.1, "mean_sumsq_pen pen_max_all pen_final vrms_end"},
    {"arch", 20, 0.1, "stands t_fall sag_mm drift_h_after1s vrms_end"},
    {"cards", 10, 0.1, "stands moved_10cm t_fall pen_max top_drop vrms_end"},
    {"pile", 10, 1, kPile},
    {"rubble", 10, 1, kPile},
}};

std::size_t only_dynamic(const PeerScene& scene) {
    const auto found =
        std::ranges::find_if(scene.bodies, [](const PeerBody& body) { return body.dynamic(); });
    return static_cast<std::size_t>(found - scene.bodies.begin());
}

double gravity_of(const PeerScene& scene) {
    return -static_cast<double>(scene.description.gravity_mps2.y);
}

/// Gaps between the anchors, were each rigidly part of its body.
class ChainMeter final : public Meter {
public:
    ChainMeter(const PeerScene& scene, double end_s) : scene_(scene), end_s_(end_s) {
        const std::vector<BodyView> start = start_views(scene);
        for (const PeerJoint& joint : scene.joints) {
            const Vec3d anchor(joint.anchor_m);
            anchors_.push_back({local(start[joint.a], anchor), local(start[joint.b], anchor)});
        }
        for (const PeerBody& body : scene.bodies) mass_kg_ += body.dynamic() ? body.mass_kg() : 0;
        start_J_ = energy_J(start);
    }

    void sample(double time_s, const std::vector<BodyView>& views) override {
        gaps_m_ = 0;
        for (std::size_t i = 0; i < anchors_.size(); ++i) {
            const BodyView& a = views[scene_.joints[i].a];
            const BodyView& b = views[scene_.joints[i].b];
            const double gap_m = glm::length(a.position + a.orientation * anchors_[i][0] -
                                             b.position - b.orientation * anchors_[i][1]);
            gaps_m_ += gap_m;
            widest_m_ = std::max(widest_m_, gap_m);
        }
        most_gaps_m_ = std::max(most_gaps_m_, gaps_m_);
        last_ = views;
        constexpr double kTail_s = 2;
        if (time_s < end_s_ - kTail_s + 1e-9) return;
        tail_gaps_m_ += gaps_m_;
        tail_speed_squares_ += mean_square_speed(views);
        ++in_tail_;
    }

    std::vector<Metric> results() const override {
        constexpr double kLength_m = 20;
        const double last = static_cast<double>(std::max<std::size_t>(1, in_tail_));
        // Relative to what the whole mass would gain on the chain's length.
        const double scale_J = mass_kg_ * gravity_of(scene_) * kLength_m;
        return {{"stretch_max_pct", most_gaps_m_ / kLength_m * 100},
                {"stretch_end_pct", tail_gaps_m_ / last / kLength_m * 100},
                {"joint_err_max_m", widest_m_},
                {"E_end_rel", (energy_J(last_) - start_J_) / scale_J},
                {"vrms_end", std::sqrt(tail_speed_squares_ / last)}};
    }

private:
    static Vec3d local(const BodyView& view, const Vec3d& point) {
        return glm::conjugate(view.orientation) * (point - view.position);
    }
    double energy_J(const std::vector<BodyView>& views) const {
        double sum_J = 0;
        for (std::size_t i = 0; i < views.size(); ++i) {
            const PeerBody& body = scene_.bodies[i];
            if (!body.dynamic()) continue;
            const BodyView& view = views[i];
            const Vec3d spin = glm::conjugate(view.orientation) * view.angular_velocity_radps;
            sum_J += body.mass_kg() * (0.5 * glm::dot(view.velocity_mps, view.velocity_mps) +
                                       gravity_of(scene_) * view.position.y) +
                     0.5 * glm::dot(spin, body.inertia_kgm2() * spin);
        }
        return sum_J;
    }
    double mean_square_speed(const std::vector<BodyView>& views) const {
        double sum = 0;
        std::size_t count = 0;
        for (std::size_t i = 0; i < views.size(); ++i) {
            if (!scene_.bodies[i].dynamic()) continue;
            sum += glm::dot(views[i].velocity_mps, views[i].velocity_mps);
            ++count;
        }
        return sum / static_cast<double>(count);
    }

    const PeerScene& scene_;
    double end_s_;
    std::vector<std::array<Vec3d, 2>> anchors_;
    std::vector<BodyView> last_;
    double mass_kg_{0};
    double start_J_{0};
    double gaps_m_{0};
    double most_gaps_m_{0};
    double widest_m_{0};
    double tail_gaps_m_{0};
    double tail_speed_squares_{0};
    std::size_t in_tail_{0};
};

/// Height at each apex, from the energy of the sample next to it: h + v^2 / 2g.
class BounceMeter final : public Meter {
public:
    explicit BounceMeter(const PeerScene& scene)
        : scene_(scene), ball_(only_dynamic(scene)), before_(start_views(scene)[ball_]) {
        const auto& shape = std::get<physics::SphereShape>(scene.bodies[ball_].shape);
        radius_m_ = static_cast<double>(shape.radius_m);
        drop_m_ = before_.position.y - radius_m_;
    }

    void sample(double /*time_s*/, const std::vector<BodyView>& views) override {
        const BodyView& now = views[ball_];
        if (before_.velocity_mps.y > 0 && now.velocity_mps.y <= 0) {
            const bool before_is_nearer =
                std::abs(before_.velocity_mps.y) < std::abs(now.velocity_mps.y);
            const BodyView& apex = before_is_nearer ? before_ : now;
            const double v = apex.velocity_mps.y;
            const double height_m = apex.position.y - radius_m_ + v * v / (2 * gravity_of(scene_));
            errors_pct_.push_back((height_m / drop_m_ - 1) * 100);
        }
        before_ = now;
    }

    std::vector<Metric> results() const override {
        // Dead on the ground: all of the height is gone.
        const bool dead = before_.position.y - radius_m_ < 0.01 * drop_m_ &&
                          std::abs(before_.velocity_mps.y) < 0.1;
        const double last = errors_pct_.empty() || dead ? -100.0 : errors_pct_.back();
        double most = last;
        for (const double error : errors_pct_) {
            if (std::abs(error) > std::abs(most)) most = error;
        }
        return {{"apex1_err_pct", errors_pct_.empty() ? -100.0 : errors_pct_.front()},
                {"apex_end_err_pct", last},
                {"apex_max_err_pct", most}};
    }

private:
    const PeerScene& scene_;
    std::size_t ball_;
    BodyView before_;
    double radius_m_{0};
    double drop_m_{0};
    std::vector<double> errors_pct_;
};

/// Against SlideToRoll; a ball that starts rolling just goes on.
class RollMeter final : public Meter {
public:
    explicit RollMeter(const PeerScene& scene)
        : ball_(only_dynamic(scene)), start_(start_views(scene)[ball_]) {
        const PeerBody& ball = scene.bodies[ball_];
        start_.velocity_mps = Vec3d(ball.body.velocity_mps);
        law_.speed_mps = glm::length(start_.velocity_mps);
        along_ = start_.velocity_mps / law_.speed_mps;
        const bool rolls = glm::length(ball.body.angular_velocity_radps) > 0;
        law_.mu = rolls ? 0 : static_cast<double>(ball.body.friction.value_or(Real{0}));
    }

    void sample(double time_s, const std::vector<BodyView>& views) override {
        const BodyView& now = views[ball_];
        const double speed_mps = law_.speed_at_mps(time_s);
        const Vec3d displacement = now.position - start_.position;
        along_error_m_ = glm::dot(displacement, along_) - law_.path_m(time_s);
        most_along_m_ = std::max(most_along_m_, std::abs(along_error_m_));
        speed_error_mps_ = glm::dot(now.velocity_mps, along_) - speed_mps;
        most_speed_mps_ = std::max(most_speed_mps_, std::abs(speed_error_mps_));
        expected_mps_ = speed_mps;
        up_m_ = std::max(up_m_, displacement.y);
        down_m_ = std::min(down_m_, displacement.y);
        const Vec3d side = displacement - along_ * glm::dot(displacement, along_);
        lateral_m_ = std::max(lateral_m_, std::hypot(side.x, side.z));
    }

    std::vector<Metric> results() const override {
        const double speed_pct = std::abs(speed_error_mps_) / expected_mps_ * 100;
        if (law_.mu > 0) {
            return {{"x_err_max_mm", most_along_m_ * 1e3},
                    {"v_err_max", most_speed_mps_},
                    {"v_final_err_pct", speed_pct}};
        }
        return {{"y_up_mm", up_m_ * 1e3},
                {"y_down_mm", down_m_ * 1e3},
                {"lateral_mm", lateral_m_ * 1e3},
                {"along_err_mm", most_along_m_ * 1e3},
                {"speed_err_pct", speed_pct}};
    }

private:
    std::size_t ball_;
    BodyView start_;
    Vec3d along_{1, 0, 0};
    study::SlideToRoll law_;  ///< without friction: it rolls from the start
    double expected_mps_{1};
    double along_error_m_{0};
    double most_along_m_{0};
    double speed_error_mps_{0};
    double most_speed_mps_{0};
    double up_m_{0};
    double down_m_{0};
    double lateral_m_{0};
};

}  // namespace

std::span<const SceneCase> scene_cases() {
    return kCases;
}

const SceneCase* find_scene_case(std::string_view name) {
    const auto* found = std::ranges::find(kCases, name, &SceneCase::name);
    return found == kCases.end() ? nullptr : &*found;
}

std::vector<BodyView> start_views(const PeerScene& scene) {
    std::vector<BodyView> views;
    for (const PeerBody& body : scene.bodies) {
        views.push_back({.position = Vec3d(body.start.position),
                         .orientation = Quatd(body.start.orientation),
                         .velocity_mps = Vec3d(body.body.velocity_mps),
                         .angular_velocity_radps = Vec3d(body.body.angular_velocity_radps)});
    }
    return views;
}

std::unique_ptr<Meter> make_chain_meter(const PeerScene& scene, double end_s) {
    return std::make_unique<ChainMeter>(scene, end_s);
}

std::unique_ptr<Meter> make_bounce_meter(const PeerScene& scene) {
    return std::make_unique<BounceMeter>(scene);
}

std::unique_ptr<Meter> make_roll_meter(const PeerScene& scene) {
    return std::make_unique<RollMeter>(scene);
}

std::unique_ptr<Meter> make_meter(const PeerScene& scene, double end_s) {
    if (scene.name.starts_with("chain")) return make_chain_meter(scene, end_s);
    if (scene.name == "bounce") return make_bounce_meter(scene);
    if (scene.name.ends_with("roll")) return make_roll_meter(scene);
    if (scene.name == "dzhani") return make_spin_meter(scene);
    return make_heap_meter(scene, end_s);
}

}  // namespace plumbline::bench
