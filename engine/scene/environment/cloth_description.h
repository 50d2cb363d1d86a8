// What a scene file says of a sheet of cloth, as plain data in SI units.
#pragma once

#include "engine/core/math.h"
#include "engine/core/pose.h"
#include "engine/core/text/source_location.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::scene {

/// A point, or all along an edge, that something holds.
struct ClothPinDescription {
    /// From x0, y0 to x1, y1: shares of the width from the left and of the height from the top.
    std::array<double, 4> along{0, 0, 0, 0};
    std::string to;  ///< an entity; empty: the world
};

/// `[[cloth]]`.
struct ClothDescription {
    std::string name;
    std::array<double, 2> size_m{1, 1};  ///< along its x and y
    int folds{0};      ///< that it hangs in from the start, creased along its y; 0: it is flat
    double gather{1};  ///< of its width, what it takes up in folds
    Pose pose{};       ///< of its middle, at the start
    std::optional<std::array<int, 2>> cells{};  ///< none: by fidelity
    double density_kgpm2{0.2};
    double stretch_Npm{2000};           ///< force per width and engineering strain
    std::optional<double> shear_Npm{};  ///< none: a third of stretch_Npm
    double bend_Nm{1e-4};
    double thickness_m{0.004};
    double friction{0.5};
    double damping_s{0};
    double drag{1.2};  ///< coefficient across the air; 0: none
    bool self_collision{false};
    bool asleep{false};  ///< at the start
    double tear_Npm{0};  ///< 0: never
    std::vector<ClothPinDescription> pins;
    std::string material;  ///< what it looks like
    SourceLocation location{};
};

}  // namespace plumbline::scene
