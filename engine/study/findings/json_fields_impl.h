// Structs as JSON objects: a function fields() lists the members of a struct under their keys, in the
// order of the text, and serves both ways. `Json(point)` writes one; `json.get<Point>()` reads it, and
// throws std::exception where it cannot.
//
// A number that is not finite is written as null and read as NaN.
#pragma once

#include "engine/core/math.h"
#include "engine/core/result.h"
#include "engine/physics/physics_world.h"
#include "engine/scene/environment/field_description.h"
#include "engine/scene/formats/json_read.h"
#include "engine/study/setting.h"
#include "engine/study/words.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <concepts>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

/// It lies in another namespace, where the functions of this one are not looked for.
template <>
struct nlohmann::adl_serializer<plumbline::scene::EffectFidelity> {
    static void to_json(auto& json, const plumbline::scene::EffectFidelity& each) {
        json["effect"] = each.effect;
        json["fidelity"] = plumbline::study::word_of(each.fidelity);
    }
    static void from_json(const auto& json, plumbline::scene::EffectFidelity& each) {
        json.at("effect").get_to(each.effect);
        const auto& words = plumbline::study::kWords<plumbline::scene::Fidelity>;
        const auto found =
            std::ranges::find(words, json.at("fidelity").template get<std::string>());
        if (found == words.end()) throw std::runtime_error("expected a fidelity");
        each.fidelity = static_cast<plumbline::scene::Fidelity>(found - words.begin());
    }
};

namespace plumbline::study {

/// Keeps the order in which keys were written.
using Json = nlohmann::ordered_json;

/// Plain or const Plain: what fields() takes.
template <class T, class Plain>
concept Like = std::same_as<std::remove_const_t<T>, Plain>;

inline double number_from(const Json& json) {
    return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

/// Puts each member that fields() names into an object.
struct FieldWriter {
    Json& json;

    template <class T>
    void operator()(const char* key, const T& value) const;
    void operator()(const char* key, physics::Solver solver) const {
        json[key] = physics::solver_name(solver);
    }
    void operator()(const char* key, const Vec3d& v) const { json[key] = {v.x, v.y, v.z}; }
    void operator()(const char* key, const Quatd& q) const { json[key] = {q.w, q.x, q.y, q.z}; }
    void operator()(const char* key, const std::optional<double>& number) const {
        json[key] = number ? Json(*number) : Json(nullptr);
    }
    /// No key where there is none.
    template <class T>
    void operator()(const char* key, const std::optional<T>& part) const {
        if (part) (*this)(key, *part);
    }
    /// Likewise.
    void operator()(const char* key, const std::vector<scene::EffectFidelity>& fidelity) const {
        if (!fidelity.empty()) json[key] = fidelity;
    }
};

/// Takes each member that fields() names from an object.
struct FieldReader {
    const Json& json;

    template <class T>
    void operator()(const char* key, T& value) const;
    /// Counts: what is none must not become one by conversion.
    void operator()(const char* key, int& count) const {
        const Json& number = json.at(key);
        if (!number.is_number_integer() || number < 0 || number > 1'000'000)
            throw std::runtime_error(
                fmt::format("{} is {}; expected a whole number", key, number.dump()));
        count = number.get<int>();
    }
    void operator()(const char* key, double& number) const { number = number_from(json.at(key)); }
    void operator()(const char* key, std::vector<double>& numbers) const {
        numbers.clear();
        for (const Json& number : json.at(key)) numbers.push_back(number_from(number));
    }
    void operator()(const char* key, std::optional<double>& number) const {
        if (!json.at(key).is_null()) number = json.at(key).get<double>();
    }
    template <class T>
    void operator()(const char* key, std::optional<T>& part) const {
        if (json.contains(key)) (*this)(key, part.emplace());
    }
    void operator()(const char* key, std::vector<scene::EffectFidelity>& fidelity) const {
        if (json.contains(key)) json.at(key).get_to(fidelity);
    }
    void operator()(const char* key, physics::Solver& solver) const {
        const std::string name = json.at(key);
        const std::optional<physics::Solver> known = physics::solver_from_name(name);
        if (!known) throw std::runtime_error(fmt::format("unknown solver \"{}\"", name));
        solver = *known;
    }
    void operator()(const char* key, Vec3d& v) const {
        const Json& parts = json.at(key);
        v = {number_from(parts.at(0)), number_from(parts.at(1)), number_from(parts.at(2))};
    }
    void operator()(const char* key, Quatd& q) const {
        const Json& parts = json.at(key);
        q = {number_from(parts.at(0)),
             number_from(parts.at(1)),
             number_from(parts.at(2)),
             number_from(parts.at(3))};
    }
};

template <class T>
concept HasFields = requires(const FieldWriter& field, const T& value) {
    fields(field, value);
};

template <HasFields T>
void to_json(Json& json, const T& value) {
    json = Json::object();
    fields(FieldWriter{json}, value);
}

template <HasFields T>
void from_json(const Json& json, T& value) {
    fields(FieldReader{json}, value);
}

template <class T>
void FieldWriter::operator()(const char* key, const T& value) const {
    if constexpr (HasFields<T>)
        to_json(json[key], value);
    else if constexpr (std::is_enum_v<T>)
        json[key] = word_of(value);
    else
        json[key] = value;
}

template <class T>
void FieldReader::operator()(const char* key, T& value) const {
    if constexpr (HasFields<T>) {
        from_json(json.at(key), value);
    } else if constexpr (std::is_enum_v<T>) {
        const std::string word = json.at(key);
        const auto found = std::ranges::find(kWords<T>, word);
        if (found == kWords<T>.end())
            throw std::runtime_error(fmt::format("unknown word \"{}\"", word));
        value = static_cast<T>(found - kWords<T>.begin());
    } else {
        json.at(key).get_to(value);
    }
}

/// Bytes that are no UTF-8, as file names may have, are replaced.
inline std::string text_of(const Json& json, int indent = -1) {
    return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

/// What text_of() has made a text of. The error begins with `what` the text is not.
template <class T>
Result<T> read_text(const std::string& text, std::string_view what) {
    try {
        return scene::read_json<Json>(text).get<T>();
    } catch (const std::exception& fault) {
        return Error{.message = fmt::format("{}: {}", what, fault.what())};
    }
}

}  // namespace plumbline::study
