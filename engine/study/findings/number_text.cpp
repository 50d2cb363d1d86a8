#include "engine/study/findings/number_text.h"

#include <fmt/format.h>

#include <cmath>

namespace plumbline::study {

std::string number_text(double value) {
    if (std::isnan(value)) return "not a number";
    if (std::isinf(value)) return "infinite";
    const double size = std::abs(value);
    if (size == 0) return "0";
    if (size >= 999.5 && size < 1e7) return fmt::format("{:.0f}", value);
    if (size < 1e-4 || size >= 1e7) return fmt::format("{:.1e}", value);
    return fmt::format("{:.3g}", value);
}

std::string error_text(double error) {
    if (!std::isfinite(error) || error == 0 || std::abs(error) < 1e-5) return number_text(error);
    return fmt::format("{} %", number_text(error * 100));
}

}  // namespace plumbline::study
