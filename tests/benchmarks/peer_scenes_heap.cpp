// Things that stand or lie on each other: stack, pyramid, heavy, arch, cards, pile, rubble, 666 balls.
#include "tests/benchmarks/peer_scenes_meters.h"
#include "tests/benchmarks/peer_scenes_overlap.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace plumbline::bench {

namespace {

constexpr double kFall_m = 0.45;    ///< a body that sank or strayed by more has fallen
constexpr double kSettled_s = 1.0;  ///< penetration and creep count from here on
constexpr double kEnd_s = 2.0;      ///< the last stretch, for the rms speed

double level(const Vec3d& displacement) {
    return std::hypot(displacement.x, displacement.z);
}

class HeapMeter final : public Meter {
public:
    HeapMeter(const PeerScene& scene, double end_s)
        : scene_(scene), end_s_(end_s), start_(start_views(scene)) {
        for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
            if (!scene.bodies[i].dynamic()) continue;
            if (!scene.bodies[top_].dynamic() ||
                start_[i].position.y > start_[top_].position.y + 1e-9) {
                top_ = i;
            }
        }
    }

    void sample(double time_s, const std::vector<BodyView>& views) override {
        // The sample at 1 s is the last of the settling and the first place to creep from.
        const bool settled = time_s > kSettled_s + 1e-9;
        if (!settled) settled_ = views;
        watch_places(time_s, settled, views);
        watch_overlaps(settled, views);
        if (time_s > end_s_ - kEnd_s - 1e-9) add_speeds(views);
        last_ = views;
    }

    std::vector<Metric> results() const override {
        if (last_.empty()) return {};
        const bool stands = fall_s_ < 0 && drift_m_ < kFall_m;
        const std::map<std::string, double, std::less<>> known{
            {"stands", stands ? 1 : 0},
            {"t_fall", fall_s_},
            {"top_drop", start_[top_].position.y - last_[top_].position.y},
            {"sag_mm", (start_[top_].position.y - last_[top_].position.y) * 1e3},
            {"drift_h_all", drift_m_},
            {"drift_h_after1s", creep_m_},
            {"moved", static_cast<double>(moved(kFall_m))},
            {"moved_10cm", static_cast<double>(moved(0.1))},
            {"pen_max", deepest_m_},
            {"pen_max_all", deepest_ever_m_},
            {"pen_final", final_.deepest_m},
            {"pen_mean_final",
             final_.pairs > 0 ? final_.sum_m / static_cast<double>(final_.pairs) : 0.0},
            {"mean_sumsq_pen", squares_m2_ / static_cast<double>(samples_)},
            {"vrms_end",
             speeds_ > 0 ? std::sqrt(speed_squares_ / static_cast<double>(speeds_)) : 0},
            {"KE_end_J", kinetic_J()},
            {"com_y", center_y_m()},
        };
        std::vector<Metric> metrics;
        const std::string_view wanted = find_scene_case(scene_.name)->metrics;
        for (std::size_t begin = 0; begin < wanted.size();) {
            const std::size_t end = std::min(wanted.find(' ', begin), wanted.size());
            const std::string name(wanted.substr(begin, end - begin));
            metrics.push_back({name, known.at(name)});
            begin = end + 1;
        }
        return metrics;
    }

private:
    void watch_places(double time_s, bool settled, const std::vector<BodyView>& views) {
        for (std::size_t i = 0; i < views.size(); ++i) {
            const Vec3d& now = views[i].position;
            drift_m_ = std::max(drift_m_, level(now - start_[i].position));
            if (settled) creep_m_ = std::max(creep_m_, level(now - settled_[i].position));
        }
        const double drop_m = start_[top_].position.y - views[top_].position.y;
        if (fall_s_ < 0 && drop_m > kFall_m) fall_s_ = time_s;
    }

    void watch_overlaps(bool settled, const std::vector<BodyView>& views) {
        final_ = overlaps_of(scene_, views);
        deepest_ever_m_ = std::max(deepest_ever_m_, final_.deepest_m);
        if (settled) deepest_m_ = std::max(deepest_m_, final_.deepest_m);
        squares_m2_ += final_.sum_of_squares_m2;
        ++samples_;
    }

    void add_speeds(const std::vector<BodyView>& views) {
        for (std::size_t i = 0; i < views.size(); ++i) {
            if (!scene_.bodies[i].dynamic()) continue;
            speed_squares_ += glm::dot(views[i].velocity_mps, views[i].velocity_mps);
            ++speeds_;
        }
    }

    std::size_t moved(double by_m) const {
        std::size_t count = 0;
        for (std::size_t i = 0; i < last_.size(); ++i) {
            if (glm::length(last_[i].position - start_[i].position) > by_m) ++count;
        }
        return count;
    }

    double kinetic_J() const {
        double sum_J = 0;
        for (std::size_t i = 0; i < last_.size(); ++i) {
            const PeerBody& body = scene_.bodies[i];
            if (!body.dynamic()) continue;
            const BodyView& view = last_[i];
            const Vec3d spin = glm::conjugate(view.orientation) * view.angular_velocity_radps;
            sum_J += 0.5 * body.mass_kg() * glm::dot(view.velocity_mps, view.velocity_mps) +
                     0.5 * glm::dot(spin, body.inertia_kgm2() * spin);
        }
        return sum_J;
    }

    double center_y_m() const {
        double sum = 0;
        double mass_kg = 0;
        for (std::size_t i = 0; i < last_.size(); ++i) {
            if (!scene_.bodies[i].dynamic()) continue;
            sum += scene_.bodies[i].mass_kg() * last_[i].position.y;
            mass_kg += scene_.bodies[i].mass_kg();
        }
        return sum / mass_kg;
    }

    const PeerScene& scene_;
    double end_s_;
    std::vector<BodyView> start_;
    std::vector<BodyView> settled_;
    std::vector<BodyView> last_;
    std::size_t top_{0};  ///< the highest at the start
    double fall_s_{-1};   ///< -1: not yet
    double drift_m_{0};
    double creep_m_{0};
    double deepest_m_{0};
    double deepest_ever_m_{0};
    Overlaps final_{};
    double squares_m2_{0};
    std::size_t samples_{1};  ///< with the start, at which nothing overlaps
    double speed_squares_{0};
    std::size_t speeds_{0};
};

}  // namespace

std::unique_ptr<Meter> make_heap_meter(const PeerScene& scene, double end_s) {
    return std::make_unique<HeapMeter>(scene, end_s);
}

}  // namespace plumbline::bench
