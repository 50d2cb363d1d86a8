// Settings and findings as JSON values, for job bodies that hold them among other things.
// The from_… functions throw nlohmann::json::exception or std::runtime_error.
#pragma once

#include "engine/study/findings/findings.h"

#include <nlohmann/json.hpp>

namespace plumbline::study {

/// Keeps the order in which keys were written.
using Json = nlohmann::ordered_json;

Json json_of(const Setting& setting);
Json json_of(const Point& point);
Json json_of(const Subject& subject);
/// Where not finite: null.
Json json_of(double number);
/// null: NaN.
double number_from(const Json& json);
Setting setting_from(const Json& json);
Point point_from(const Json& json);
Subject subject_from(const Json& json);

}  // namespace plumbline::study
