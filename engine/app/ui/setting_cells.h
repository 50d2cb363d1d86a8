// Cells with which pages change a value.
#pragma once

#include "engine/app/ui/menu_page.h"

#include <functional>
#include <string>

namespace plumbline::app::ui {

Cell toggle(bool on, const std::function<void(bool)>& set);
/// Brings back what was there before.
Cell reset(std::string text, std::function<void()> activate);
/// A number between two ends that moves by equal parts of its way.
Cell slider(std::string text,
            double value,
            double min,
            double max,
            double step,
            const std::function<void(double)>& set);
/// Of a share: "85 %".
std::string percent(float share);

}  // namespace plumbline::app::ui
