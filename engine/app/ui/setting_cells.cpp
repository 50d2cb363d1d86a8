#include "engine/app/ui/setting_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace plumbline::app::ui {

Cell toggle(bool on, const std::function<void(bool)>& set) {
    return {.text = on ? "on" : "off",
            .icon = on ? Icon::On : Icon::Off,
            .activate = [on, set] { set(!on); },
            .adjust = [set](int direction) { set(direction > 0); }};
}

Cell reset(std::string text, std::function<void()> activate) {
    return {.text = std::move(text), .icon = Icon::Again, .activate = std::move(activate)};
}

Cell slider(std::string text,
            double value,
            double min,
            double max,
            double step,
            const std::function<void(double)>& set) {
    const auto on_step = [=](double wanted) {
        return std::clamp(min + std::round((wanted - min) / step) * step, min, max);
    };
    return {.text = std::move(text),
            .fraction = static_cast<float>((value - min) / (max - min)),
            .adjust =
                [=](int direction) {
                    // Values between two steps go to the next one in the direction.
                    const double at = on_step(value);
                    const bool lies_ahead = direction > 0 ? at > value : at < value;
                    const bool between = std::abs(at - value) > step * 1e-3;
                    set(between && lies_ahead ? at : on_step(at + direction * step));
                },
            .set_fraction =
                [=](float fraction) {
                    const double wanted =
                        on_step(min + static_cast<double>(fraction) * (max - min));
                    if (std::abs(wanted - value) > step * 1e-3) set(wanted);
                }};
}

std::string percent(float share) {
    return fmt::format("{:.0f} %", static_cast<double>(share) * 100.0);
}

}  // namespace plumbline::app::ui
