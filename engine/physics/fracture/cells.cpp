// A body cut into Voronoi cells, by half-spaces.
#include "engine/core/limits.h"
#include "engine/core/random.h"
#include "engine/physics/fracture/polyhedron.h"
#include "engine/physics/world/world_state.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::physics {
namespace {

/// Steps towards cells whose seeds are their centres (Lloyd, "Least squares quantization in PCM", 1982).
constexpr int kEvenings = 6;
/// A piece's mean extent against the smallest size that a body may have.
constexpr double kRoom = 4;
/// Of the area of the largest: what is smaller holds nothing.
constexpr double kLeastArea = 1e-4;

struct Extent {
    Vec3d low_m;
    Vec3d high_m;
};

Extent extent_of(const Polyhedron& solid) {
    Extent box{Vec3d(std::numeric_limits<double>::max()),
               Vec3d(std::numeric_limits<double>::lowest())};
    for (const Vec3d& corner : solid.corners_m) {
        box.low_m = glm::min(box.low_m, corner);
        box.high_m = glm::max(box.high_m, corner);
    }
    return box;
}

bool holds(const Polyhedron& solid, const Vec3d& point_m) {
    return std::ranges::all_of(solid.faces, [&](const PolyhedronFace& face) {
        const Vec3d& a = solid.corners_m[face.corners[0]];
        const Vec3d& b = solid.corners_m[face.corners[1]];
        const Vec3d& c = solid.corners_m[face.corners[2]];
        return glm::dot(glm::cross(b - a, c - a), point_m - a) < 0;
    });
}

std::vector<Vec3d> scattered_in(const Polyhedron& solid, std::uint32_t count, std::uint64_t seed) {
    Random random(seed);
    const Extent box = extent_of(solid);
    std::vector<Vec3d> points;
    while (points.size() < count) {
        const double x = random.uniform();
        const double y = random.uniform();
        const double z = random.uniform();
        const Vec3d point_m = box.low_m + (box.high_m - box.low_m) * Vec3d{x, y, z};
        if (holds(solid, point_m)) points.push_back(point_m);
    }
    return points;
}

Polyhedron cell_of(const Polyhedron& solid, std::span<const Vec3d> seeds_m, std::size_t number) {
    // The nearest first: those beyond twice the cell's own reach cut nothing.
    std::vector<std::pair<double, std::size_t>> others;
    for (std::size_t i = 0; i < seeds_m.size(); ++i) {
        if (i != number) others.emplace_back(glm::distance(seeds_m[i], seeds_m[number]), i);
    }
    std::ranges::sort(others);
    Polyhedron cell = solid;
    for (const auto& [away_m, other] : others) {
        double reach_m = 0;
        for (const Vec3d& corner : cell.corners_m)
            reach_m = std::max(reach_m, glm::distance(corner, seeds_m[number]));
        if (away_m > 2 * reach_m) break;
        const Vec3d normal = (seeds_m[other] - seeds_m[number]) / away_m;
        const double offset_m = glm::dot(normal, (seeds_m[other] + seeds_m[number]) / 2.0);
        cut(cell, normal, offset_m, static_cast<int>(other));
    }
    return cell;
}

std::vector<FracturePiece> pieces_of(const Polyhedron& solid, std::vector<Vec3d> seeds_m) {
    std::vector<FracturePiece> pieces(seeds_m.size());
    for (int round = 0; round <= kEvenings; ++round) {
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            FracturePiece& piece = pieces[i];
            piece.solid = cell_of(solid, seeds_m, i);
            piece.seed_m = seeds_m[i];
            const SolidMass mass = mass_of(piece.solid);
            piece.center_m = mass.center_m;
            piece.volume_m3 = mass.volume_m3;
            piece.inertia_m5 = mass.inertia;
        }
        for (std::size_t i = 0; i < pieces.size(); ++i) seeds_m[i] = pieces[i].center_m;
    }
    return pieces;
}

/// Centre, area and second moments of a face, as triangles round its first corner.
FractureBond bond_across(const FracturePiece& piece, const PolyhedronFace& face) {
    FractureBond bond;
    for (const std::uint32_t corner : face.corners)
        bond.corners_m.push_back(piece.solid.corners_m[corner]);
    const std::vector<Vec3d>& p = bond.corners_m;
    const auto each_triangle = [&p](auto&& fn) {
        for (std::size_t i = 2; i < p.size(); ++i)
            fn(p[0], p[i - 1], p[i], glm::length(glm::cross(p[i - 1] - p[0], p[i] - p[0])) / 2);
    };
    each_triangle([&](const Vec3d& a, const Vec3d& b, const Vec3d& c, double area_m2) {
        bond.area_m2 += area_m2;
        bond.center_m += area_m2 / 3 * (a + b + c);
    });
    if (bond.area_m2 > 0) bond.center_m /= bond.area_m2;
    glm::dmat3 squares{0.0};
    each_triangle([&](Vec3d a, Vec3d b, Vec3d c, double area_m2) {
        a -= bond.center_m;
        b -= bond.center_m;
        c -= bond.center_m;
        for (const Vec3d& middle : {(a + b) / 2.0, (b + c) / 2.0, (c + a) / 2.0})
            squares += area_m2 / 3 * glm::outerProduct(middle, middle);
    });
    const double trace = squares[0][0] + squares[1][1] + squares[2][2];
    bond.second_m4 = trace * glm::dmat3{1.0} - squares;
    return bond;
}

/// Of a rectangle with the same second moments (Roark's Formulas for Stress and Strain, table 10.7, within 4 %).
double torsion_m3(const FractureBond& bond) {
    // In its plane the moments are those about its principal axes, the third their sum.
    const double polar = glm::dot(bond.normal, bond.second_m4 * bond.normal);
    const glm::dmat3& m = bond.second_m4;
    const double minors = m[0][0] * m[1][1] - m[0][1] * m[1][0] + m[1][1] * m[2][2] -
                          m[1][2] * m[2][1] + m[0][0] * m[2][2] - m[0][2] * m[2][0];
    const double product = std::max(minors - polar * polar, 0.0);
    const double apart = std::sqrt(std::max(polar * polar / 4 - product, 0.0));
    const double longer_m = std::sqrt(12 * (polar / 2 + apart) / bond.area_m2);
    const double shorter_m = std::sqrt(12 * std::max(polar / 2 - apart, 0.0) / bond.area_m2);
    return longer_m * shorter_m * shorter_m / (3 + 1.8 * shorter_m / longer_m);
}

std::vector<FractureBond> bonds_of(std::span<const FracturePiece> pieces) {
    std::vector<FractureBond> bonds;
    double largest_m2 = 0;
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
        for (const PolyhedronFace& face : pieces[i].solid.faces) {
            if (face.beyond <= static_cast<int>(i)) continue;
            FractureBond bond = bond_across(pieces[i], face);
            const FracturePiece& other = pieces[static_cast<std::size_t>(face.beyond)];
            bond.pieces = {i, static_cast<std::uint32_t>(face.beyond)};
            bond.distance_m = glm::distance(other.seed_m, pieces[i].seed_m);
            bond.normal = (other.seed_m - pieces[i].seed_m) / bond.distance_m;
            largest_m2 = std::max(largest_m2, bond.area_m2);
            bonds.push_back(std::move(bond));
        }
    }
    std::erase_if(bonds, [largest_m2](const FractureBond& bond) {
        return bond.area_m2 < kLeastArea * largest_m2;
    });
    for (FractureBond& bond : bonds) bond.torsion_m3 = torsion_m3(bond);
    return bonds;
}

/// In the body's frame.
Polyhedron solid_of(const BodyRecord& record) {
    const BodyGeometry& geometry = *record.traits.geometry;
    if (geometry.parts.size() != 1) return {};
    const GeometryPart& part = geometry.parts.front();
    Polyhedron solid = polyhedron_of(part.shape);
    const Pose& body_from_mass = record.traits.body_from_mass;
    const Quatd turn(body_from_mass.orientation);
    for (Vec3d& corner : solid.corners_m) {
        const Vec3d in_mass = Vec3d(part.mass_from_part.position_m) +
                              glm::dmat3(part.mass_from_part.rotation) * corner;
        corner = Vec3d(body_from_mass.position) + turn * in_mass;
    }
    return solid;
}

}  // namespace

std::uint32_t FracturePattern::piece_at(const Vec3d& point_m,
                                        std::span<const std::uint32_t> among) const {
    return *std::ranges::min_element(among, {}, [&](std::uint32_t piece) {
        const Vec3d away_m = pieces[piece].seed_m - point_m;
        return glm::dot(away_m, away_m);
    });
}

FracturePattern fracture_pattern(const PhysicsWorld& world,
                                 BodyId body,
                                 std::uint32_t pieces,
                                 std::uint64_t seed) {
    const Polyhedron solid = solid_of(internals(world).body(body));
    if (solid.empty()) return {};
    FracturePattern pattern;
    pattern.volume_m3 = mass_of(solid).volume_m3;
    const Extent box = extent_of(solid);
    const Vec3d size_m = box.high_m - box.low_m;
    pattern.longest_m = std::max({size_m.x, size_m.y, size_m.z});
    const double least_m = kRoom * limits::kSizeMin_m;
    const double fits = pattern.volume_m3 / (least_m * least_m * least_m);
    const auto count = static_cast<std::uint32_t>(
        std::clamp(static_cast<double>(pieces), 1.0, std::max(fits, 1.0)));
    pattern.pieces = pieces_of(solid, scattered_in(solid, count, seed));
    pattern.bonds = bonds_of(pattern.pieces);
    return pattern;
}

}  // namespace plumbline::physics
