// Letters whose size is known without a font.
#pragma once

#include "engine/app/ui/menu_layout.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace plumbline::app::ui {

/// Letters of half their size's width, and lines of its height.
inline TextSize square_text(float font_px) {
    return {.width_px =
                [=](const std::string& words) {
                    return 0.5F * font_px * static_cast<float>(words.size());
                },
            .height_px =
                [=](const std::string& words, float wrap_px) {
                    const float width = 0.5F * font_px * static_cast<float>(words.size());
                    return words.empty() ? 0.0F
                                         : font_px * std::ceil(width / std::max(1.0F, wrap_px));
                }};
}

}  // namespace plumbline::app::ui
