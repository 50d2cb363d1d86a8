#include "engine/scene/sections/scene_parts.h"

#include <fmt/format.h>

namespace plumbline::scene {
namespace {

/// Beyond this a float's step is about a millimetre.
constexpr Real kFar_m{1e4};

Quat read_orientation(TableReader& table) {
    constexpr std::string_view kExpected = "[w, x, y, z], a quaternion of length 1";
    const TomlNode* node = table.find("orientation");
    const TomlArray* array = node->array();
    if (array == nullptr || array->size() != 4) {
        table.error("orientation", "{}; expected {}", found(*node), kExpected);
        return kNoRotation;
    }
    constexpr Range kPart{-1e6, 1e6, "a finite number"};
    double parts[4] = {1, 0, 0, 0};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto part = number_of((*array)[i],
                                    fmt::format("{}[{}]", table.path_of("orientation"), i),
                                    kPart,
                                    table.faults());
        if (!part) return kNoRotation;
        parts[i] = *part;
    }
    const Quatd given{parts[0], parts[1], parts[2], parts[3]};
    const double length = glm::length(given);
    if (length < 1e-6) {
        table.error("orientation", "its length is 0; expected {}", kExpected);
        return kNoRotation;
    }
    if (std::abs(length - 1.0) > 0.01) {
        table.warning("orientation", "its length is {:.4g} instead of 1; it is normalised", length);
    }
    return Quat(glm::normalize(given));
}

}  // namespace

Pose read_pose(TableReader& table) {
    Pose pose;
    table.read("position_m", pose.position, kCoordinate_m);
    const Vec3 reach = glm::abs(pose.position);
    if (glm::max(reach.x, glm::max(reach.y, reach.z)) > kFar_m) {
        table.warning("position_m",
                      "more than 10000 m from the origin: single precision resolves 1 mm there");
    }
    pose.orientation = read_turn(table).value_or(kNoRotation);
    return pose;
}

std::optional<Quat> read_turn(TableReader& table) {
    const std::string_view key = table.either("rotation_deg", "orientation");
    if (key == "orientation") return read_orientation(table);
    if (key.empty()) return {};
    Vec3 angles_deg{0, 0, 0};
    table.read(key, angles_deg, kTurn_deg);
    return quat_from_euler_deg(angles_deg);
}

}  // namespace plumbline::scene
