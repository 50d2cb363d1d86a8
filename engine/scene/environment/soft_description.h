// What a scene file says of a soft body, as plain data in SI units.
#pragma once

#include "engine/core/math.h"
#include "engine/core/pose.h"
#include "engine/core/text/source_location.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::scene {

/// What lies in a box at the start is held.
struct SoftPinDescription {
    Vec3 min_m{0, 0, 0};
    Vec3 max_m{0, 0, 0};
    std::string to;  ///< an entity; empty: the world
};

enum class SoftForm : std::uint8_t { Box, Ellipsoid, Model };

/// `[[soft]]`.
struct SoftDescription {
    std::string name;
    SoftForm form{SoftForm::Box};
    Vec3d size_m{1, 1, 1};  ///< of a box its sides, of an ellipsoid its half axes
    std::filesystem::path model;
    std::filesystem::path model_root;  ///< confinement for what the model's file names
    Pose pose{};
    std::optional<double> cell_m{};  ///< none: by fidelity
    double density_kgpm3{1000};
    double young_Pa{1e5};
    double poisson{0.45};
    double damping_s{0};
    double friction{0.5};
    std::vector<SoftPinDescription> pins;
    std::string material;  ///< what it looks like
    SourceLocation location{};
};

}  // namespace plumbline::scene
