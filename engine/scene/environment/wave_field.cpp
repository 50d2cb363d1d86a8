#include "engine/scene/environment/wave_field.h"

#include "engine/core/hash.h"
#include "engine/core/io/archive.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plumbline::scene {
namespace {

constexpr double kHalfTurn_rad = 3.14159265358979323846;
constexpr double kStill_m = 1e-4;
constexpr double kNothing_m = 1e-9;
/// Waves decay by 2 nu k2 a second (Lamb, 349), with what stirred water has: waves of 10 m by half in five hours, of 1 m in 40 s.
constexpr double kViscosity_m2ps = 2e-4;
constexpr int kPlaces = 33;

double tanh_of(double x) {
    const double grown = portable_expm1(2 * std::min(x, 20.0));
    return grown / (grown + 2);
}

}  // namespace

WaveField::WaveField(const WaterDescription& water, int modes, double gravity_mps2)
    : min_m_(water.min_m),
      size_m_(Vec3d(water.max_m) - Vec3d(water.min_m)),
      density_kgpm3_(static_cast<double>(water.density_kgpm3)),
      gravity_mps2_(gravity_mps2),
      count_(static_cast<std::size_t>(modes)),
      modes_(count_ * count_) {
    for (std::size_t m = 0; m < count_; ++m) {
        for (std::size_t n = 0; n < count_; ++n) {
            Mode& mode = modes_[m * count_ + n];
            mode.k_pm = kHalfTurn_rad * glm::length(glm::dvec2{static_cast<double>(m) / size_m_.x,
                                                               static_cast<double>(n) / size_m_.z});
            mode.omega_radps = std::sqrt(gravity_mps2 * mode.k_pm * tanh_of(mode.k_pm * size_m_.y));
        }
    }
    const WaveStart& start = water.start;
    const auto nx = static_cast<std::size_t>(start.nx);
    const auto nz = static_cast<std::size_t>(start.nz);
    if (nx < count_ && nz < count_ && nx + nz > 0)
        modes_[nx * count_ + nz].height_m = static_cast<double>(start.amplitude_m);
    remember();
    remember();
}

void WaveField::advance(double seconds) {
    if (seconds != turned_s_) find_turns(seconds);
    for (std::size_t i = 0; i < modes_.size(); ++i) {
        Mode& mode = modes_[i];
        if (mode.height_m == 0 && mode.speed_mps == 0) continue;
        if (mode.omega_radps == 0) continue;
        const auto [cosine, sine] = turns_[i];
        const double height = mode.height_m * cosine + mode.speed_mps / mode.omega_radps * sine;
        mode.speed_mps = mode.speed_mps * cosine - mode.height_m * mode.omega_radps * sine;
        mode.height_m = height;
    }
    fall_asleep(seconds);
    remember();
}

void WaveField::find_turns(double seconds) {
    turned_s_ = seconds;
    turns_.clear();
    for (const Mode& mode : modes_) {
        const double angle = mode.omega_radps * seconds;
        const double kept = portable_exp(-2 * kViscosity_m2ps * mode.k_pm * mode.k_pm * seconds);
        turns_.push_back(
            {.cosine = kept * portable_cos(angle), .sine = kept * portable_sin(angle)});
    }
}

void WaveField::remember() {
    std::swap(drawn_m_[0], drawn_m_[1]);
    drawn_m_[1].resize(modes_.size());
    for (std::size_t i = 0; i < modes_.size(); ++i) drawn_m_[1][i] = modes_[i].height_m;
}

void WaveField::fall_asleep(double seconds) {
    double most_m = 0;
    for (const Mode& mode : modes_) {
        if (mode.omega_radps > 0)
            most_m += glm::length(glm::dvec2{mode.height_m, mode.speed_mps / mode.omega_radps});
    }
    quiet_s_ = most_m < kStill_m ? quiet_s_ + seconds : 0;
    if (!is_asleep()) return;
    for (std::size_t i = 1; i < modes_.size(); ++i) modes_[i].height_m = modes_[i].speed_mps = 0;
}

void WaveField::displace(const Vec3d& place, double radius_m, double volume_m3) {
    const double rise_m = volume_m3 / (size_m_.x * size_m_.z);
    if (std::abs(rise_m) < kNothing_m) return;
    const double mean_m = modes_.front().height_m;
    const Shapes shapes = shapes_at(place.x, place.z, radius_m);
    for (std::size_t m = 0; m < count_; ++m) {
        const double row_m = rise_m * shapes.along_x[m] / norm(m);
        for (std::size_t n = 0; n < count_; ++n)
            modes_[m * count_ + n].height_m += row_m * shapes.along_z[n] / norm(n);
    }
    modes_.front().height_m = mean_m;
    quiet_s_ = 0;
}

void WaveField::raise_level(double volume_m3) {
    modes_.front().height_m += volume_m3 / (size_m_.x * size_m_.z);
}

WaveField::Shapes WaveField::shapes_at(
    double x, double z, double radius_m, bool slope_x, bool slope_z) const {
    // Mode m has m times the first one's angle, and of what is felt its m2-th power: both by multiplication.
    const auto fill = [&](double at, double length, bool slope, std::vector<double>& shapes) {
        shapes.resize(count_);
        const double k = kHalfTurn_rad / length;
        const double cosine_of_1 = portable_cos(k * at);
        const double sine_of_1 = portable_sin(k * at);
        const double felt_of_1 = portable_exp(-0.5 * k * k * radius_m * radius_m);
        double cosine = 1;
        double sine = 0;
        double felt = 1;
        double next = felt_of_1;
        for (std::size_t m = 0; m < count_; ++m) {
            shapes[m] = felt * (slope ? -k * static_cast<double>(m) * sine : cosine);
            felt *= std::exchange(next, next * felt_of_1 * felt_of_1);
            const double before = std::exchange(cosine, cosine * cosine_of_1 - sine * sine_of_1);
            sine = sine * cosine_of_1 + before * sine_of_1;
        }
    };
    Shapes shapes;
    fill(std::clamp(x - min_m_.x, 0.0, size_m_.x), size_m_.x, slope_x, shapes.along_x);
    fill(std::clamp(z - min_m_.z, 0.0, size_m_.z), size_m_.z, slope_z, shapes.along_z);
    return shapes;
}

double WaveField::sum(const Shapes& shapes) const {
    double sum = 0;
    for (std::size_t m = 0; m < count_; ++m) {
        double row = 0;
        for (std::size_t n = 0; n < count_; ++n)
            row += modes_[m * count_ + n].height_m * shapes.along_z[n];
        sum += row * shapes.along_x[m];
    }
    return sum;
}

double WaveField::norm(std::size_t m) {
    return m == 0 ? 1 : 0.5;
}

double WaveField::height_m(double x, double z, double radius_m) const {
    return sum(shapes_at(x, z, radius_m));
}

double WaveField::response_pm2(double x, double z, double radius_m) const {
    const Shapes shapes = shapes_at(x, z, radius_m);
    const auto squares = [](const std::vector<double>& along) {
        double sum = 0;
        for (std::size_t m = 0; m < along.size(); ++m) sum += along[m] * along[m] / norm(m);
        return sum;
    };
    // Of all modes but the first, which is 1 everywhere.
    const double sum = squares(shapes.along_x) * squares(shapes.along_z) - 1;
    return sum / (size_m_.x * size_m_.z);
}

glm::dvec2 WaveField::slope(double x, double z, double radius_m) const {
    return {sum(shapes_at(x, z, radius_m, true, false)),
            sum(shapes_at(x, z, radius_m, false, true))};
}

double WaveField::energy_J() const {
    double sum = 0;
    for (std::size_t i = 1; i < modes_.size(); ++i) {
        const Mode& mode = modes_[i];
        if (mode.omega_radps == 0) continue;
        const double swing_m2 =
            mode.height_m * mode.height_m +
            mode.speed_mps * mode.speed_mps / (mode.omega_radps * mode.omega_radps);
        sum += norm(i / count_) * norm(i % count_) * swing_m2;
    }
    return 0.5 * density_kgpm3_ * gravity_mps2_ * size_m_.x * size_m_.z * sum;
}

double WaveField::raised_J() const {
    const double rise_m = modes_.front().height_m;
    return 0.5 * density_kgpm3_ * gravity_mps2_ * size_m_.x * size_m_.z * rise_m * rise_m;
}

WaveField::Range WaveField::range() const {
    Range range{.min_m = HUGE_VAL, .mean_m = modes_.front().height_m, .max_m = -HUGE_VAL};
    for (int i = 0; i < kPlaces; ++i) {
        for (int j = 0; j < kPlaces; ++j) {
            const double height = height_m(min_m_.x + size_m_.x * i / (kPlaces - 1),
                                           min_m_.z + size_m_.z * j / (kPlaces - 1));
            range.min_m = std::min(range.min_m, height);
            range.max_m = std::max(range.max_m, height);
        }
    }
    return range;
}

void WaveField::sample(std::size_t side, double blend, std::span<double> heights_m) const {
    const std::size_t half = side - 1;
    std::vector<double> turn(2 * half);
    for (std::size_t i = 0; i < turn.size(); ++i)
        turn[i] = portable_cos(kHalfTurn_rad * static_cast<double>(i) / static_cast<double>(half));
    std::vector<double> shapes(side * count_);  // cos(m pi i / half), the same along both sides
    for (std::size_t i = 0; i < side; ++i) {
        for (std::size_t m = 0; m < count_; ++m) shapes[i * count_ + m] = turn[m * i % turn.size()];
    }
    std::vector<double> along_z(side * count_, 0);  // summed over n: by row, then m
    for (std::size_t m = 0; m < count_; ++m) {
        for (std::size_t n = 0; n < count_; ++n) {
            const std::size_t mode = m * count_ + n;
            const double height_m = glm::mix(drawn_m_[0][mode], drawn_m_[1][mode], blend);
            for (std::size_t row = 0; row < side; ++row)
                along_z[row * count_ + m] += height_m * shapes[row * count_ + n];
        }
    }
    for (std::size_t row = 0; row < side; ++row) {
        for (std::size_t column = 0; column < side; ++column) {
            double sum = 0;
            for (std::size_t m = 0; m < count_; ++m)
                sum += along_z[row * count_ + m] * shapes[column * count_ + m];
            heights_m[row * side + column] = sum;
        }
    }
}

void WaveField::serialize(Archive& archive) {
    for (Mode& mode : modes_) archive(mode.height_m, mode.speed_mps);
    archive(quiet_s_);
}

void WaveField::hash(Hasher& hasher) const {
    for (const Mode& mode : modes_) {
        const double numbers[] = {mode.height_m, mode.speed_mps};
        hasher.add(numbers, sizeof numbers);
    }
}

}  // namespace plumbline::scene
