// Lines of points that stiff threads or bending tie together, solved line by line.
#pragma once

#include "engine/core/math.h"

#include <cstdint>
#include <span>
#include <vector>

namespace plumbline::physics {

/// A spring between two points.
struct Thread {
    std::uint32_t a{0};
    std::uint32_t b{0};
    double rest_m{0};
    double stiffness_Npm{0};   ///< 0: torn
    double width_m{0};         ///< of the sheet that it stands for
    double length_m{0};        ///< as measured
    Vec3d direction{0, 0, 0};  ///< likewise: unit, from a to b; none where it has no length
    Vec3d yields_a{0, 0, 0};   ///< of the direction, what its ends yield to
    Vec3d yields_b{0, 0, 0};
};

/// Lines of threads, as long as each other, one after the other; within a line each thread begins where the one before ends.
class ThreadFamily {
public:
    std::vector<Thread> threads;
    std::size_t per_line{1};

    /// Sets the length and the direction of each.
    void measure(std::span<const Vec3d> positions_m);
    /// By point the normal along which it does not yield, or zero. After measure(), which undoes it.
    void brace(std::span<const Vec3d> normals);

    /// Of 1 + W K scale, K the stiffness of the threads as they are measured and braced: for the tensions of each line a
    /// tridiagonal system.
    void factor(double scale_s2, std::span<const double> inverse_masses);
    /// Velocities become the inverse of what was factored times what they are. What threads pull at points that do not yield is
    /// added to `held_Ns`.
    void relax(std::span<const double> inverse_masses,
               std::span<Vec3d> velocities_mps,
               std::span<Vec3d> held_Ns);

private:
    /// Of a thread's row.
    struct Factors {
        double stiff_kg{0};
        double lower{0};
        double upper{0};
        double inverse{0};  ///< of the diagonal
    };
    template <std::size_t kLines>
    void factor_lines(std::size_t first, double scale_s2, std::span<const double> inverse_masses);
    template <std::size_t kLines>
    void find_pulls(std::size_t first, std::span<const Vec3d> velocities_mps);
    /// Calls `visit` for lines side by side, so that each waits for its own divisions.
    template <class F>
    void for_lines(const F& visit) const;

    bool is_braced_{false};
    std::vector<Factors> factors_;  // by thread
    std::vector<double> pulls_Ns_;  // scratch, by thread
};

/// A point at which a line is clamped, with one neighbour, bends over half of a cell only: twice as stiffly. By the inverse masses.
constexpr double clamp_factor(double first, double middle, double last) {
    return middle == 0 && (first == 0) != (last == 0) ? 2 : 1;
}

/// Lines of points that bend.
class StripFamily {
public:
    struct Strip {
        std::uint32_t first{0};   ///< point
        std::uint32_t stride{1};  ///< from a point to the next
        std::uint32_t count{0};
        double stiffness_Npm{
            0};  ///< energy is half of it times the square of each second difference
    };
    std::vector<Strip> strips;

    /// As ThreadFamily::relax, with the stiffness of second differences: five diagonals.
    void relax(double scale_s2,
               std::span<const double> inverse_masses,
               std::span<Vec3d> velocities_mps);

private:
    struct Row {
        double diagonal{0};
        double next{0};  // factors of the two rows after
        double second{0};
        Vec3d momentum{0, 0, 0};
    };
    std::vector<Row> rows_;
};

}  // namespace plumbline::physics
