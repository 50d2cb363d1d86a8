// The rigid-body-spring network of a body's pieces: what loads do to its bonds.
#include "engine/physics/collision/shape/mass.h"
#include "engine/physics/dynamics/joint/block/block_ldlt.h"
#include "engine/physics/fracture/bond_stress.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::physics {
namespace {

/// Of a column's own stiffness.
constexpr double kLeastPivot = 1e-13;

/// v -> r x v.
glm::dmat3 cross_matrix(const Vec3d& r) {
    return {0, r.z, -r.y, -r.z, 0, r.x, r.y, -r.x, 0};
}

Block3 block_of(const glm::dmat3& m) {
    const glm::dmat3 rows = glm::transpose(m);
    return {{rows[0], rows[1], rows[2]}};
}

void add_matrix(Symmetric3& to, const glm::dmat3& m) {
    to.xx += m[0][0];
    to.xy += m[1][0];
    to.xz += m[2][0];
    to.yy += m[1][1];
    to.yz += m[2][1];
    to.zz += m[2][2];
}

/// Pieces that hang together, as one rigid body.
struct Cluster {
    SolidMass solid;
    Vec3d force_N{0, 0, 0};
    Vec3d torque_Nm{0, 0, 0};  ///< about the centre
    Vec3d acceleration_mps2{0, 0, 0};
    Vec3d turning_radps2{0, 0, 0};
};

/// What pulls a piece, about its seed.
struct Pull {
    Vec3d force_N{0, 0, 0};
    Vec3d torque_Nm{0, 0, 0};
};

}  // namespace

struct FractureNetwork::Impl {
    const FracturePattern& pattern;
    std::vector<std::uint32_t> pieces;
    std::vector<bool> cracked;
    double density_kgpm3{1};

    std::vector<std::uint32_t> node_of;     ///< by piece of the pattern; ~0: not ours
    std::vector<std::uint32_t> cluster_of;  ///< by node
    std::uint32_t clusters{0};
    std::vector<std::uint32_t> place;  ///< by block (two of a node) in the order of elimination
    std::vector<bool> is_whole;        ///< by bond: all that holds its two sides together
    BlockPattern filled;
    BlockLdlt matrix;
    bool factored{false};

    bool holds(const FractureBond& bond, std::size_t number) const {
        return !cracked[number] && node_of[bond.pieces[0]] != ~0U && node_of[bond.pieces[1]] != ~0U;
    }
    template <class Fn>
    void each_bond(Fn&& fn) const {
        for (std::size_t i = 0; i < pattern.bonds.size(); ++i) {
            if (holds(pattern.bonds[i], i)) fn(i, pattern.bonds[i]);
        }
    }

    void find_clusters() {
        std::vector<std::uint32_t> root(pieces.size());
        for (std::uint32_t i = 0; i < root.size(); ++i) root[i] = i;
        // Each node's root is the least of its cluster.
        for (bool changed = true; changed;) {
            changed = false;
            each_bond([&](std::size_t, const FractureBond& bond) {
                std::uint32_t& a = root[node_of[bond.pieces[0]]];
                std::uint32_t& b = root[node_of[bond.pieces[1]]];
                if (a == b) return;
                a = b = std::min(a, b);
                changed = true;
            });
        }
        clusters = 0;
        cluster_of.resize(root.size());
        for (std::uint32_t i = 0; i < root.size(); ++i)
            cluster_of[i] = root[i] == i ? clusters++ : cluster_of[root[i]];
    }

    /// Bridges of the graph (Tarjan, "A note on finding the bridges of a graph", 1974).
    void find_whole_sections() {
        is_whole.assign(pattern.bonds.size(), false);
        std::vector<std::vector<std::pair<std::uint32_t, std::size_t>>> next(pieces.size());
        each_bond([&](std::size_t number, const FractureBond& bond) {
            const std::uint32_t a = node_of[bond.pieces[0]];
            const std::uint32_t b = node_of[bond.pieces[1]];
            next[a].emplace_back(b, number);
            next[b].emplace_back(a, number);
        });
        std::vector<std::uint32_t> entered(pieces.size(), 0);
        std::vector<std::uint32_t> reaches(pieces.size(), 0);
        std::uint32_t count = 0;
        const auto visit = [&](const auto& self, std::uint32_t node, std::size_t came_by) -> void {
            entered[node] = reaches[node] = ++count;
            for (const auto& [other, number] : next[node]) {
                if (number == came_by) continue;
                if (entered[other] == 0) {
                    self(self, other, number);
                    reaches[node] = std::min(reaches[node], reaches[other]);
                    is_whole[number] = reaches[other] > entered[node];
                } else {
                    reaches[node] = std::min(reaches[node], entered[other]);
                }
            }
        };
        for (std::uint32_t i = 0; i < pieces.size(); ++i) {
            if (entered[i] == 0) visit(visit, i, pattern.bonds.size());
        }
    }

    void order() {
        std::vector<std::vector<std::uint32_t>> neighbours(2 * pieces.size());
        const auto join = [&](std::uint32_t a, std::uint32_t b) {
            neighbours[a].push_back(b);
            neighbours[b].push_back(a);
        };
        for (std::uint32_t i = 0; i < pieces.size(); ++i) join(2 * i, 2 * i + 1);
        each_bond([&](std::size_t, const FractureBond& bond) {
            const std::uint32_t a = 2 * node_of[bond.pieces[0]];
            const std::uint32_t b = 2 * node_of[bond.pieces[1]];
            for (const std::uint32_t i : {a, a + 1}) {
                for (const std::uint32_t j : {b, b + 1}) join(i, j);
            }
        });
        for (auto& list : neighbours) std::ranges::sort(list);
        const std::vector<std::uint32_t> weights(neighbours.size(), 1);
        const EliminationOrder eliminated =
            minimum_degree_order(std::move(neighbours), weights, HUGE_VAL);
        place.resize(eliminated.order.size());
        for (std::uint32_t i = 0; i < place.size(); ++i) place[eliminated.order[i]] = i;
        std::vector<std::vector<std::uint32_t>> columns(place.size());
        for (std::uint32_t block = 0; block < place.size(); ++block) {
            auto& rows = columns[place[block]];
            for (const std::uint32_t other : eliminated.later[block]) rows.push_back(place[other]);
            std::ranges::sort(rows);
        }
        filled = BlockPattern::from_columns(columns);
        matrix.fit(filled);
    }

    /// m stands at (row, column), and transposed at (column, row).
    void add_at(std::uint32_t row, std::uint32_t column, const glm::dmat3& m) {
        const std::uint32_t i = place[row];
        const std::uint32_t j = place[column];
        if (i == j) return add_matrix(matrix.diagonal[i], m);
        if (i > j)
            add(matrix.below[filled.block_at(i, j)], block_of(m));
        else
            add(matrix.below[filled.block_at(j, i)], block_of(glm::transpose(m)));
    }

    void factor() {
        find_clusters();
        find_whole_sections();
        order();
        std::ranges::fill(matrix.diagonal, Symmetric3{});
        matrix.clear_below(0, filled.columns);
        each_bond([&](std::size_t, const FractureBond& bond) { add_bond(bond); });
        hold_clusters();
        std::vector<double> floor;
        for (const Symmetric3& d : matrix.diagonal)
            floor.push_back(kLeastPivot * std::max({d.xx, d.yy, d.zz, 1e-300}));
        matrix.factor(0, filled.columns, floor);
        factored = true;
    }

    void add_bond(const FractureBond& bond) {
        const double per_m = 1 / bond.distance_m;
        const double k = bond.area_m2 * per_m;
        const glm::dmat3 one{k};
        std::array<glm::dmat3, 2> arms;  ///< the gap is that of u - arm turn
        for (std::size_t s = 0; s < 2; ++s)
            arms[s] = cross_matrix(bond.center_m - pattern.pieces[bond.pieces[s]].seed_m);
        for (std::size_t s = 0; s < 2; ++s) {
            const std::uint32_t u = 2 * node_of[bond.pieces[s]];
            const glm::dmat3 turned = glm::transpose(arms[s]) * (k * arms[s]);
            add_at(u, u, one);
            add_at(u, u + 1, -k * arms[s]);
            add_at(u + 1, u + 1, turned + per_m * bond.second_m4);
        }
        const std::uint32_t a = 2 * node_of[bond.pieces[0]];
        const std::uint32_t b = 2 * node_of[bond.pieces[1]];
        add_at(a, b, -one);
        add_at(a, b + 1, k * arms[1]);
        add_at(a + 1, b, k * glm::transpose(arms[0]));
        add_at(a + 1, b + 1, -(glm::transpose(arms[0]) * (k * arms[1]) + per_m * bond.second_m4));
    }

    /// Loads and accelerations balance: what holds a cluster at its first piece carries nothing.
    void hold_clusters() {
        std::vector<bool> held(clusters, false);
        for (std::uint32_t i = 0; i < pieces.size(); ++i) {
            if (held[cluster_of[i]]) continue;
            held[cluster_of[i]] = true;
            for (const std::uint32_t block : {2 * i, 2 * i + 1}) {
                Symmetric3& d = matrix.diagonal[place[block]];
                const double most = std::max({d.xx, d.yy, d.zz});
                add_matrix(d, glm::dmat3{most > 0 ? most : 1.0});
            }
        }
    }

    std::vector<Pull> pulls_of(std::span<const BodyLoad> loads, const Vec3d& spin_radps) const {
        std::vector<Pull> pulls(pieces.size());
        std::vector<Cluster> all = clusters_alone();
        for (const BodyLoad& load : loads) {
            const std::uint32_t piece = pattern.piece_at(load.point_m, pieces);
            const Vec3d arm_m = load.point_m - pattern.pieces[piece].seed_m;
            Pull& pull = pulls[node_of[piece]];
            pull.force_N += load.force_N;
            pull.torque_Nm += load.torque_Nm + glm::cross(arm_m, load.force_N);
            Cluster& cluster = all[cluster_of[node_of[piece]]];
            cluster.force_N += load.force_N;
            cluster.torque_Nm +=
                load.torque_Nm + glm::cross(load.point_m - cluster.solid.center_m, load.force_N);
        }
        for (Cluster& cluster : all) {
            cluster.acceleration_mps2 = cluster.force_N / (density_kgpm3 * cluster.solid.volume_m3);
            const glm::dmat3 inertia_kgm2 = density_kgpm3 * cluster.solid.inertia;
            const Vec3d spun = glm::cross(spin_radps, inertia_kgm2 * spin_radps);
            cluster.turning_radps2 = glm::inverse(inertia_kgm2) * (cluster.torque_Nm - spun);
        }
        for (std::uint32_t i = 0; i < pieces.size(); ++i)
            resist(i, all[cluster_of[i]], spin_radps, pulls[i]);
        return pulls;
    }

    /// By its inertia (d'Alembert).
    void resist(std::uint32_t node, const Cluster& cluster, const Vec3d& spin, Pull& pull) const {
        const FracturePiece& piece = pattern.pieces[pieces[node]];
        const Vec3d arm_m = piece.center_m - cluster.solid.center_m;
        const Vec3d& turning = cluster.turning_radps2;
        const Vec3d mps2 = cluster.acceleration_mps2 + glm::cross(turning, arm_m) +
                           glm::cross(spin, glm::cross(spin, arm_m));
        const Vec3d force_N = -density_kgpm3 * piece.volume_m3 * mps2;
        const glm::dmat3 inertia = density_kgpm3 * piece.inertia_m5;
        pull.force_N += force_N;
        pull.torque_Nm += glm::cross(piece.center_m - piece.seed_m, force_N) - inertia * turning -
                          glm::cross(spin, inertia * spin);
    }

    std::vector<Cluster> clusters_alone() const {
        std::vector<Cluster> all(clusters);
        for (std::uint32_t i = 0; i < pieces.size(); ++i) {
            const FracturePiece& piece = pattern.pieces[pieces[i]];
            SolidMass& solid = all[cluster_of[i]].solid;
            solid = joined(solid,
                           {.volume_m3 = piece.volume_m3,
                            .center_m = piece.center_m,
                            .inertia = piece.inertia_m5});
        }
        return all;
    }

    std::vector<double> stress_Pa(std::span<const BodyLoad> loads, const Vec3d& spin_radps) {
        if (!factored) factor();
        const std::vector<Pull> pulls = pulls_of(loads, spin_radps);
        std::vector<Vec3d> x(place.size());
        for (std::uint32_t i = 0; i < pulls.size(); ++i) {
            x[place[2 * i]] = pulls[i].force_N;
            x[place[2 * i + 1]] = pulls[i].torque_Nm;
        }
        matrix.solve(0, filled.columns, x);
        std::vector<double> stress(pattern.bonds.size(), 0.0);
        each_bond([&](std::size_t number, const FractureBond& bond) {
            Vec3d gap{0, 0, 0};
            Vec3d turn{0, 0, 0};
            for (const double sign : {-1.0, 1.0}) {
                const std::uint32_t piece = bond.pieces[sign < 0 ? 0 : 1];
                const std::uint32_t node = node_of[piece];
                const Vec3d turned = x[place[2 * node + 1]];
                const Vec3d arm_m = bond.center_m - pattern.pieces[piece].seed_m;
                gap += sign * (x[place[2 * node]] + glm::cross(turned, arm_m));
                turn += sign * turned;
            }
            gap /= bond.distance_m;
            turn /= bond.distance_m;
            stress[number] = principal_Pa(bond, gap, turn, is_whole[number]);
        });
        return stress;
    }
};

FractureNetwork::FractureNetwork(const FracturePattern& pattern,
                                 std::vector<std::uint32_t> pieces,
                                 std::span<const std::uint32_t> cracked,
                                 double density_kgpm3)
    : impl_(std::make_unique<Impl>(
          Impl{.pattern = pattern, .pieces = std::move(pieces), .density_kgpm3 = density_kgpm3})) {
    impl_->cracked.assign(pattern.bonds.size(), false);
    for (const std::uint32_t bond : cracked) impl_->cracked[bond] = true;
    impl_->node_of.assign(pattern.pieces.size(), ~0U);
    for (std::uint32_t i = 0; i < impl_->pieces.size(); ++i) impl_->node_of[impl_->pieces[i]] = i;
}
FractureNetwork::~FractureNetwork() = default;
FractureNetwork::FractureNetwork(FractureNetwork&&) noexcept = default;
FractureNetwork& FractureNetwork::operator=(FractureNetwork&&) noexcept = default;

std::vector<double> FractureNetwork::stress_Pa(std::span<const BodyLoad> loads,
                                               const Vec3d& spin_radps) {
    return impl_->stress_Pa(loads, spin_radps);
}

bool FractureNetwork::crack(std::span<const BodyLoad> loads,
                            const Vec3d& spin_radps,
                            double strength_Pa,
                            double share,
                            int rounds) {
    bool any = false;
    for (int round = 0; round < rounds; ++round) {
        const std::vector<double> stress = impl_->stress_Pa(loads, spin_radps);
        std::vector<std::size_t> over;
        for (std::size_t i = 0; i < stress.size(); ++i) {
            if (stress[i] > strength_Pa) over.push_back(i);
        }
        if (over.empty()) break;
        std::ranges::stable_sort(
            over, std::ranges::greater{}, [&](std::size_t i) { return stress[i]; });
        const double part = std::ceil(share * static_cast<double>(over.size()));
        over.resize(std::max<std::size_t>(static_cast<std::size_t>(part), 1));
        for (const std::size_t bond : over) impl_->cracked[bond] = true;
        impl_->factored = false;
        any = true;
    }
    return any;
}

std::vector<std::uint32_t> FractureNetwork::cracked() const {
    std::vector<std::uint32_t> bonds;
    for (std::uint32_t i = 0; i < impl_->cracked.size(); ++i) {
        if (impl_->cracked[i]) bonds.push_back(i);
    }
    return bonds;
}

std::vector<std::vector<std::uint32_t>> FractureNetwork::parts() const {
    impl_->find_clusters();
    std::vector<std::vector<std::uint32_t>> parts(impl_->clusters);
    for (std::uint32_t i = 0; i < impl_->pieces.size(); ++i)
        parts[impl_->cluster_of[i]].push_back(impl_->pieces[i]);
    return parts;
}

}  // namespace plumbline::physics
