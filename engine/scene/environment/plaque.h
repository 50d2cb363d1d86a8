// Plaques of a museum: what a formula says, beside what is measured while the scene runs.
#pragma once

#include "engine/core/io/archive.h"

#include <cstdint>
#include <optional>
#include <string>

namespace plumbline::scene {

/// What is measured of an entity.
enum class PlaqueQuantity : std::uint8_t {
    Period,    ///< s, between two maxima of a coordinate
    Height,    ///< m, of its origin
    Speed,     ///< m/s, of its origin
    Distance,  ///< m, of its origin from that of another entity
    Lean,  ///< degrees, of the line from another entity's origin to its own, against the vertical
    Spin,  ///< degrees a second
};

/// `plaque` of an entity.
struct PlaqueDescription {
    std::string title;
    std::string formula;
    std::string of;    ///< entity that is measured
    std::string from;  ///< the other entity, where there is one
    PlaqueQuantity quantity{PlaqueQuantity::Height};
    int axis{0};         ///< of a period: the world coordinate 0, 1 or 2
    double expected{0};  ///< by the formula
    std::string effect;  ///< whose cost is told; empty: that of the rigid bodies' step
};

/// What is measured, step by step. A quantity is its mean over about the latest second; a period is the mean of those since
/// the last that differed from the mean by a tenth.
class PlaqueMeter {
public:
    void note(PlaqueQuantity quantity, double value, double step_s);
    /// None: nothing was noted yet, or no period is over.
    std::optional<double> measured() const { return measured_; }
    /// That the mean is of.
    int periods() const { return periods_; }
    void serialize(Archive& archive);

private:
    void note_coordinate(double value, double step_s);
    void note_maximum(double time_s);

    std::optional<double> measured_{};
    double before_{0};  ///< coordinates of the two steps before
    double last_{0};
    int samples_{0};
    double time_s_{0};  ///< of the step before
    std::optional<double> maximum_s_{};
    int periods_{0};
};

/// What a person reads.
struct PlaqueReading {
    PlaqueDescription says;
    std::optional<double> measured{};
    int periods{0};
};

}  // namespace plumbline::scene
