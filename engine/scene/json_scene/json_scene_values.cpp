#include "engine/scene/json_scene/json_scene_impl.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <string>

namespace plumbline::scene {
namespace {

using Json = nlohmann::json;

// Shorter than this no direction is left of a vector.
constexpr double kShortest = 1e-12;

std::optional<glm::dvec3> vector_in(const Json& object,
                                    std::string_view key,
                                    const glm::dvec3& fallback,
                                    const std::string& path,
                                    const JsonFaults& faults) {
    const Json* value = member_of(object, key);
    if (value == nullptr) return fallback;
    return json_vector(*value, fmt::format("{}.{}", path, key), faults);
}

std::optional<glm::dmat4> rotation_of(const Json& value,
                                      const std::string& path,
                                      const JsonFaults& faults) {
    const auto parts = json_numbers(value, 4, path, faults);
    if (!parts) return std::nullopt;
    const glm::dvec3 axis{(*parts)[1], (*parts)[2], (*parts)[3]};
    if (glm::length(axis) < kShortest)
        return faults.error(path, "the axis is zero; expected [degrees, x, y, z]");
    return glm::mat4_cast(
        portable_angle_axis(radians_from_degrees((*parts)[0]), glm::normalize(axis)));
}

std::optional<glm::dmat4> look_at(const Json& value,
                                  const std::string& path,
                                  const JsonFaults& faults,
                                  std::optional<Vec3d>& up_seen) {
    if (!value.is_object())
        return faults.error(path, "expected an object with position, target and up");
    const auto position = vector_in(value, "position", {0, 0, 0}, path, faults);
    const auto target = vector_in(value, "target", {0, 0, -1}, path, faults);
    const auto up = vector_in(value, "up", {0, 1, 0}, path, faults);
    if (!position || !target || !up) return std::nullopt;
    if (glm::distance(*target, *position) < kShortest)
        return faults.error(path, "the target lies on the position: there is nowhere to look");
    const glm::dvec3 ahead = glm::normalize(*target - *position);
    const glm::dvec3 side = glm::cross(ahead, *up);
    if (glm::length(side) < kShortest * std::max(1.0, glm::length(*up))) {
        return faults.error(path,
                            std::string(glm::length(*up) < kShortest
                                            ? "up is zero; expected a direction"
                                            : "up runs along the view; expected a direction "
                                              "across it"));
    }
    const glm::dvec3 right = glm::normalize(side);
    up_seen = glm::normalize(*up);
    return glm::dmat4{glm::dvec4{right, 0.0},
                      glm::dvec4{glm::cross(right, ahead), 0.0},
                      glm::dvec4{-ahead, 0.0},
                      glm::dvec4{*position, 1.0}};
}

/// One element. Of several keys in it the first in the source's order counts; none does nothing.
std::optional<glm::dmat4> element_of(const Json& element,
                                     const std::string& path,
                                     const JsonFaults& faults,
                                     std::optional<Vec3d>& up) {
    if (const Json* scale = member_of(element, "scale")) {
        const auto factors = json_vector(*scale, path + ".scale", faults);
        if (!factors) return std::nullopt;
        return glm::scale(glm::dmat4{1.0}, *factors);
    }
    if (const Json* rotate = member_of(element, "rotate"))
        return rotation_of(*rotate, path + ".rotate", faults);
    if (const Json* translate = member_of(element, "translate")) {
        const auto way = json_vector(*translate, path + ".translate", faults);
        if (!way) return std::nullopt;
        return glm::translate(glm::dmat4{1.0}, *way);
    }
    if (const Json* target = member_of(element, "lookat"))
        return look_at(*target, path + ".lookat", faults, up);
    return glm::dmat4{1.0};
}

bool is_finite(const glm::dmat4& matrix) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!std::isfinite(matrix[column][row])) return false;
        }
    }
    return true;
}

}  // namespace

const Json* member_of(const Json& object, std::string_view key) {
    if (!object.is_object()) return nullptr;
    const auto found = object.find(key);
    return found == object.end() ? nullptr : &*found;
}

std::optional<std::vector<double>> json_numbers(const Json& value,
                                                std::size_t count,
                                                const std::string& path,
                                                const JsonFaults& faults) {
    if (!value.is_array())
        return faults.error(path, "expected an array of numbers, found {}", value.type_name());
    if (count > 0 && value.size() != count)
        return faults.error(path, "expected {} numbers, found {}", count, value.size());
    std::vector<double> numbers;
    numbers.reserve(value.size());
    for (const Json& item : value) {
        if (!item.is_number() || !std::isfinite(item.get<double>())) {
            return faults.error(fmt::format("{}[{}]", path, numbers.size()),
                                "expected a finite number, found {}",
                                item.is_number() ? "one that is not" : item.type_name());
        }
        numbers.push_back(item.get<double>());
    }
    return numbers;
}

std::optional<glm::dvec3> json_vector(const Json& value,
                                      const std::string& path,
                                      const JsonFaults& faults) {
    const auto parts = json_numbers(value, 3, path, faults);
    if (!parts) return std::nullopt;
    return glm::dvec3{(*parts)[0], (*parts)[1], (*parts)[2]};
}

double json_positive(const Json& object,
                     std::string_view key,
                     double fallback,
                     const std::string& path,
                     const JsonFaults& faults) {
    const Json* value = member_of(object, key);
    if (value == nullptr) return fallback;
    constexpr double kLeast = 1e-9;
    constexpr double kMost = 1e9;
    if (value->is_number()) {
        const double number = value->get<double>();
        if (number >= kLeast && number <= kMost) return number;
    }
    faults.error(fmt::format("{}.{}", path, key),
                 "expected a number above 0, up to {:g}, found {}",
                 kMost,
                 value->is_number() ? value->dump() : value->type_name());
    return fallback;
}

JsonTransform json_transform(const Json& object,
                             const std::string& path,
                             const JsonFaults& faults) {
    JsonTransform transform;
    const Json* list = member_of(object, "transform");
    if (list == nullptr) return transform;
    if (!list->is_array()) {
        faults.error(path + ".transform", "expected an array, found {}", list->type_name());
        return transform;
    }
    for (std::size_t i = 0; i < list->size(); ++i) {
        const std::string place = fmt::format("{}.transform[{}]", path, i);
        const Json& element = (*list)[i];
        if (!element.is_object()) {
            faults.error(place,
                         "expected an object with scale, rotate, translate or lookat, found {}",
                         element.type_name());
            continue;
        }
        const auto matrix = element_of(element, place, faults, transform.up);
        if (!matrix) continue;
        transform.matrix = *matrix * transform.matrix;
        if (is_finite(transform.matrix)) continue;
        faults.error(place, "the transform grows beyond all numbers");
        transform.matrix = glm::dmat4{1.0};
    }
    return transform;
}

}  // namespace plumbline::scene
