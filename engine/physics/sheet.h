// A rectangular sheet of cloth: points on a grid, springs along the threads, shear of cells, bending. docs/PHYSICS.md, "Cloth".
#pragma once

#include "engine/physics/point_body.h"
#include "engine/physics/sheet_lines.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace plumbline {
class Archive;
}

namespace plumbline::physics {

struct SheetDef {
    std::array<double, 2> size_m{1, 1};          ///< along its x and y
    std::array<std::uint32_t, 2> cells{20, 20};  ///< likewise, >= 1
    std::uint32_t folds{0};     ///< that it hangs in from the start, creased along y; 0: it is flat
    double gather{1};           ///< of its width along x, what it takes up in folds; above 0
    Vec3d position_m{0, 0, 0};  ///< of its middle
    Quatd orientation{1, 0, 0, 0};
    double density_kgpm2{0.2};
    double stretch_Npm{2000};  ///< force per width and engineering strain, along x and along y
    double shear_Npm{667};
    double bend_Nm{1e-4};  ///< moment per width and curvature; no transverse contraction
    double damping_s{0};   ///< of the material
    double drag{0};        ///< coefficient of a triangle across the air
    double air_density_kgpm3{1.2};
    double tear_Npm{0};  ///< tension per width that a thread bears; 0: any
};

/// Points row by row from the top (+y), each from the left (-x).
class Sheet final : public PointBody {
public:
    explicit Sheet(const SheetDef& def);

    std::uint32_t columns() const { return columns_; }  ///< of points
    std::uint32_t rows() const { return rows_; }

    std::uint32_t plan(double seconds, std::uint32_t most) override;
    bool feels_air() const override { return def_.drag > 0; }
    std::vector<SurfacePlace> places(std::uint32_t along) const override;
    void list_parts(SurfaceParts& parts) const override;
    double longest_side_m() const override { return std::max(cell_m_[0], cell_m_[1]); }

    double area_m2() const;
    std::size_t torn() const { return torn_; }  ///< threads between two points
    /// Whether a cell has all of its threads.
    bool is_whole(std::uint32_t column, std::uint32_t row) const;

private:
    std::size_t at(std::uint32_t column, std::uint32_t row) const {
        return std::size_t{row} * columns_ + column;
    }
    void add_forces() override;
    double elastic_J() const override;
    void damp() override;
    void after_move() override;
    void serialize_own(Archive& archive) override;
    double weight_of(std::size_t point) const override {
        return weights_.empty() ? 1 : weights_[point];
    }
    /// Two triangles a cell; diagonals alternate.
    template <class F>
    void for_triangles(const F& visit) const;
    void add_threads();
    void find_across();
    double most_aligned() const;
    void add_stretch();
    void add_bending();
    void add_cell(std::uint32_t column, std::uint32_t row);
    void add_drag();
    Vec3d drag_Ns(std::size_t top) const;
    /// Of the cell below and to the right of a point: row by row.
    std::array<std::size_t, 4> corners_of(std::size_t top) const {
        return {top, top + 1, top + columns_, top + columns_ + 1};
    }
    /// A whole cell whose shear is damped, at its corners' places of now.
    struct ShearedCell {
        std::size_t top;
        Vec3d e;  ///< diagonals, over twice the area
        Vec3d f;
        double inverse_weight;
    };
    void find_sheared(double stiff_kgm2);
    ShearedCell sheared(std::size_t top, double stiff_kgm2) const;
    void damp_shear(const ShearedCell& cell);
    void push_at_once(std::size_t point, const Vec3d& impulse_Ns) {
        velocities_mps_[point] += impulse_Ns * inverse_masses_[point];
        if (!(inverse_masses_[point] > 0)) impulses_Ns_[point] += impulse_Ns;
    }

    std::uint32_t columns_;
    std::uint32_t rows_;
    std::array<double, 2> cell_m_;
    SheetDef def_;
    std::array<ThreadFamily, 2> families_;  ///< along x and along y
    std::array<StripFamily, 2> strips_;
    double bend_share_{1};  ///< as stiffness_share(), which is of stretch and shear
    double bend_lag_s_{0};  ///< damping of bending that forces bear; 0: lines damp it
    std::vector<double>
        weights_;  ///< of forces on points that tension pulls across too fast; empty: 1
    std::vector<double> across_radps2_;  ///< by point, of the latest plan
    std::vector<Vec3d> drags_Ns_;        // scratch, by cell
    std::vector<ShearedCell> sheared_;   // scratch
    std::size_t torn_{0};
};

}  // namespace plumbline::physics
