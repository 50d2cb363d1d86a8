#include "engine/app/ui/ui_scale.h"

#include <algorithm>
#include <cmath>

namespace plumbline::app::ui {

float font_size_px(float width_px, float height_px, float content_scale, float setting) {
    constexpr float kSmallest_px = 8.0F;
    constexpr float kLowestSetting = 0.75F;
    constexpr float kHighestSetting = 3.0F;
    const float against_usual = std::max(0.0F, std::min(width_px / 1280.0F, height_px / 720.0F));
    const float scale = setting > 0.0F ? std::clamp(setting, kLowestSetting, kHighestSetting)
                                       : std::max(std::pow(against_usual, 0.75F),
                                                  content_scale > 1.0F ? content_scale : 0.0F);
    const float most_px = std::min(width_px / 58.0F, height_px / 32.0F);
    return std::max(kSmallest_px, std::floor(std::min(kUsualFont_px * scale, most_px)));
}

}  // namespace plumbline::app::ui
