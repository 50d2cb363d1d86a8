#include "engine/core/limits.h"
#include "engine/scene/sections/scene_parts.h"

#include <fmt/format.h>

namespace plumbline::scene {
namespace {

constexpr Range kAngle_deg{-36'000, 36'000, "degrees from -36000 to 36000"};
/// Beyond this a float's step is about a millimetre.
constexpr Real kFar_m{1e4};

Quat read_orientation(TableReader& table) {
    constexpr std::string_view kExpected = "[w, x, y, z], a quaternion of length 1";
    const TomlNode* node = table.find("orientation");
    const TomlArray* array = node->array();
    if (array == nullptr || array->size() != 4) {
        table.error("orientation", fmt::format("{}; expected {}", found(*node), kExpected));
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
        table.error("orientation", fmt::format("its length is 0; expected {}", kExpected));
        return kNoRotation;
    }
    if (std::abs(length - 1.0) > 0.01) {
        table.warning("orientation",
                      fmt::format("its length is {:.4g} instead of 1; it is normalised", length));
    }
    return Quat(glm::normalize(given));
}

}  // namespace

Pose read_pose(TableReader& table) {
    Pose pose;
    pose.position = table.vector("position_m", Vec3{0, 0, 0}, kCoordinate_m);
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
    if (key == "rotation_deg")
        return quat_from_euler_deg(table.vector("rotation_deg", Vec3{0, 0, 0}, kAngle_deg));
    if (key == "orientation") return read_orientation(table);
    return {};
}

Vec3 read_turn_of_copies(TableReader& table) {
    const Vec3 turn_deg = table.vector("turn_deg", Vec3{0, 0, 0}, kAngle_deg);
    return {radians_from_degrees(turn_deg.x),
            radians_from_degrees(turn_deg.y),
            radians_from_degrees(turn_deg.z)};
}

}  // namespace plumbline::scene
