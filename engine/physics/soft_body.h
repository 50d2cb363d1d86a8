// A solid that deforms: hexahedral cells of a stable neo-Hookean material. docs/PHYSICS.md, "Soft bodies".
//
// Each cell has one deformation gradient (uniform strain, Flanagan and Belytschko 1981), so that neither bending nor volume locks; what
// that leaves out, its bending and twisting, is as stiff as beam theory says. Energy: Smith, De Goes and Kim 2018, "Stable Neo-Hookean
// Flesh Simulation"; a cell may be flat or inside out and comes back.
#pragma once

#include "engine/physics/point_body.h"

#include <array>
#include <cstdint>
#include <vector>

namespace plumbline::physics {

/// Points and cells at rest. A cell's points: number i lies at its high side along x, y, z for the bits 1, 2, 4 of i.
struct SoftGrid {
    std::vector<Vec3d> points_m;
    std::vector<std::array<std::uint32_t, 8>> cells;
    /// Outer faces, each counter-clockwise from outside.
    struct Face {
        std::array<std::uint32_t, 4> points{};
        std::uint32_t side{0};  ///< faces of one side have smooth edges
    };
    std::vector<Face> faces;
};

struct SoftBodyDef {
    SoftGrid grid{};
    double density_kgpm3{1000};
    double young_Pa{1e5};
    double poisson{0.45};  ///< below 0.5
    double damping_s{0};   ///< of the material
};

class SoftBody final : public PointBody {
public:
    explicit SoftBody(SoftBodyDef def);

    const SoftGrid& grid() const { return def_.grid; }
    std::uint32_t plan(double seconds, std::uint32_t most) override;
    std::vector<SurfacePlace> places(std::uint32_t along) const override;
    void list_parts(SurfaceParts& parts) const override;
    double longest_side_m() const override { return longest_side_m_; }
    double volume_m3() const { return volume_of(positions_m_); }
    double rest_volume_m3() const { return volume_of(def_.grid.points_m); }

private:
    /// At rest; the first three of the modes that one gradient leaves out are products of two of its axes, the last of all three.
    struct Cell {
        std::array<Vec3d, 8> gradients_pm;  ///< of the points' shape functions, mean over the cell
        std::array<std::array<double, 8>, 4> modes{};     ///< weights of the points
        std::array<std::array<double, 3>, 4> mode_Npm{};  ///< stiffness, by mode and axis
        std::array<double, 3> contraction_Npm{};  ///< of what bends along two axes across this one
        std::array<Vec3d, 3> axes;                ///< unit
        double volume_m3{0};
        double steepest_pm2{0};  ///< square of the fastest wave's gradient
        double share{1};         ///< of its stiffness that the latest plan's sub-steps bear
    };
    /// How a cell is deformed.
    struct Strain {
        glm::dmat3 gradient{1.0};
        std::array<Vec3d, 4> modes_m;
    };

    using Modes = std::array<std::array<double, 3>, 4>;  ///< by mode and axis
    struct Load {
        glm::dmat3 stress_Nm{0.0};
        std::array<Vec3d, 4> pulls_N{};
    };
    Load elastic_load(const Cell& cell, const Strain& strain) const;
    void add_damping(const Cell& cell,
                     const Strain& strain,
                     const Strain& rate,
                     double lost_s,
                     Load& load) const;
    static void add_modes(const Cell& cell, const Strain& strain, const Modes& pulls_N, Load& load);
    Cell cell_of(std::size_t number) const;
    /// By how far the modes are displaced along the axes.
    Modes pulls_of(const Cell& cell, const Modes& bent_m) const;
    Strain strain_of(std::size_t cell, const std::vector<Vec3d>& of) const;
    double volume_of(const std::vector<Vec3d>& points_m) const;
    void damp() override;
    void damp_against(const std::vector<Vec3d>& velocities_mps);
    /// Of damped_Ns_: how the point yields to it, and what it does not yield to.
    Vec3d yielded_mps(std::size_t point) const {
        return (damped_Ns_[point] - braces_[point] * glm::dot(braces_[point], damped_Ns_[point])) *
               inverse_masses_[point];
    }
    Vec3d held_Ns(std::size_t point) const {
        return inverse_masses_[point] > 0
                   ? braces_[point] * glm::dot(braces_[point], damped_Ns_[point])
                   : damped_Ns_[point];
    }
    void spread(std::size_t number,
                const Load& load,
                double seconds,
                std::vector<Vec3d>& impulses_Ns) const;
    void add_forces() override;
    template <class F>
    void for_half_triangles(const std::vector<Vec3d>& points_m, const F& visit) const;
    std::array<double, 3> depths_m(const std::array<std::uint32_t, 3>& points) const;
    void add_water();
    void resist(double waterline_m2);
    double weight_of(std::size_t point) const override;
    void serialize_own(Archive& archive) override;
    double elastic_J() const override;
    double water_J() const override;
    double displaced_m3() const override;

    SoftBodyDef def_;
    double shear_Pa_;   ///< Lame's mu
    double volume_Pa_;  ///< lambda of the energy: Lame's + mu
    double longest_side_m_{0};
    double least_share_{1};        ///< of its stiffness
    std::uint32_t iterations_{0};  ///< of damp(), at most
    std::vector<Cell> cells_;
    std::vector<Strain> strains_;      // in the sub-step at hand
    std::vector<Vec3d> damped_Ns_;     // scratch, by point
    std::vector<Vec3d> residual_mps_;  // likewise
    std::vector<Vec3d> search_mps_;
    std::vector<Vec3d> image_mps_;
    std::vector<double> drag_kgps_;  ///< by point, in the sub-step at hand
    std::uint32_t substep_{0};       ///< counts
};

}  // namespace plumbline::physics
