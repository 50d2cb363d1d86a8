// How large the text is: everything else of the overlay is measured in it.
#pragma once

namespace plumbline::app::ui {

inline constexpr float kUsualFont_px = 17.0F;  ///< at 1280x720 and a setting of 1

/// Whole pixels. `setting` 0: grows with the window, slower than it, and is at least what the
/// monitor's scale asks for; else 0.75 to 3. However large the setting, 58 letters' heights fit
/// beside and 32 above each other, so that no page is wider than the window.
float font_size_px(float width_px, float height_px, float content_scale, float setting);

}  // namespace plumbline::app::ui
