// The surface of a box of water as its own modes: waves that its walls reflect.
#pragma once

#include "engine/core/math.h"
#include "engine/scene/environment/field_description.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace plumbline {
class Archive;
class Hasher;
}  // namespace plumbline

namespace plumbline::scene {

/// Of a body's radius: waves shorter than some five times that pass it by, and it makes none.
inline constexpr double kFeltOfRadius = 0.5;

/// Heights above the level, as the sum of a_mn cos(m pi x / L) cos(n pi z / W). Each mode swings by itself with omega^2 = g k tanh(k H)
/// (Lamb, Hydrodynamics, 228) and is stepped exactly: no length of a step is too long. Short waves decay. Bodies raise the
/// surface by what they displace, and feel and make no waves shorter than themselves.
class WaveField {
public:
    /// `modes`: along each side; more are shorter. `gravity_mps2`: downwards; 0: nothing swings.
    WaveField(const WaterDescription& water, int modes, double gravity_mps2);

    /// Everything that `seconds` bring.
    void advance(double seconds);
    /// Lifts the surface round a place (world) by `volume_m3`, as a body of about that radius does; the mean level stays.
    void displace(const Vec3d& place, double radius_m, double volume_m3);
    /// Bodies have `volume_m3` more under water than before.
    void raise_level(double volume_m3);

    /// Above the level of still water, m, as a body of that radius feels it; 0: a point.
    double height_m(double x, double z, double radius_m = 0) const;
    /// By how much a cubic metre displaced there raises what is felt there, m.
    double response_pm2(double x, double z, double radius_m) const;
    /// Of the same, along x and z.
    glm::dvec2 slope(double x, double z, double radius_m = 0) const;

    /// Kinetic and potential; 0 at rest, whatever the mean level.
    double energy_J() const;
    /// Of what lies above the level on average.
    double raised_J() const;
    struct Range {
        double min_m{0};
        double mean_m{0};
        double max_m{0};
    };
    /// Over a grid of 33 x 33 places.
    Range range() const;
    /// Heights above the level at `side` x `side` places from wall to wall, row by row along z. `blend`: 0: as they were after the
    /// step before the latest, 1: as they are.
    void sample(std::size_t side, double blend, std::span<double> heights_m) const;
    /// Whether nothing has moved by a tenth of a millimetre, or was displaced, for a second: then it lies level and costs
    /// nothing.
    bool is_asleep() const { return quiet_s_ >= 1; }

    void serialize(Archive& archive);
    void hash(Hasher& hasher) const;

private:
    struct Mode {
        double height_m{0};
        double speed_mps{0};  ///< of the height
        double k_pm{0};
        double omega_radps{0};
    };
    /// What `turned_s_` makes of a mode, with what is kept of it.
    struct Turn {
        double cosine;
        double sine;
    };
    /// cos(m pi x / L) for all m, less what a body of that radius does not feel.
    struct Shapes {
        std::vector<double> along_x;
        std::vector<double> along_z;
    };
    Shapes shapes_at(
        double x, double z, double radius_m, bool slope_x = false, bool slope_z = false) const;
    double sum(const Shapes& shapes) const;
    /// The mean square of cos(m pi x / L) from wall to wall.
    static double norm(std::size_t m);
    void find_turns(double seconds);
    void fall_asleep(double seconds);
    void remember();

    Vec3d min_m_;
    Vec3d size_m_;
    double density_kgpm3_;
    double gravity_mps2_;
    std::size_t count_;        ///< modes along each side
    std::vector<Mode> modes_;  ///< m * count_ + n; the first is the mean level
    std::vector<Turn> turns_;  ///< of `modes_`; empty until the first step
    double turned_s_{0};
    double quiet_s_{0};
    std::array<std::vector<double>, 2>
        drawn_m_;  ///< of the modes, after the latest two steps; not saved
};

}  // namespace plumbline::scene
