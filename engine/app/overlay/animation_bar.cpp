#include "engine/app/overlay/overlay_panels_impl.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string>

namespace plumbline::app::panels {

float draw_animation_bar(AnimationBar& bar, float width_px, float height_px, float font_px) {
    const float wide_px = std::min(width_px * 0.7F, font_px * 44.0F);
    ImGui::SetNextWindowPos(
        {width_px * 0.5F, height_px - font_px * 0.8F}, ImGuiCond_Always, {0.5F, 1.0F});
    ImGui::SetNextWindowSize({wide_px, 0.0F});
    ImGui::SetNextWindowBgAlpha(0.6F);
    ImGui::Begin(
        "animation",
        nullptr,
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    if (ImGui::Button(bar.paused ? "play" : "stop")) bar.paused = !bar.paused;
    ImGui::SameLine();
    if (ImGui::Button("next")) bar.next = true;
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0F);
    auto time_s = static_cast<float>(bar.time_s);
    const std::string text =
        fmt::format("{}   {:.2f} of {:.2f} s", bar.name, bar.time_s, bar.length_s);
    // The text is no pattern: a name may hold any sign.
    ImGui::PushID("time");
    if (ImGui::SliderFloat("", &time_s, 0.0F, static_cast<float>(bar.length_s), "")) {
        bar.time_s = static_cast<double>(time_s);
    }
    ImGui::PopID();
    const ImVec2 from = ImGui::GetItemRectMin();
    ImGui::GetWindowDrawList()->AddText({from.x + font_px * 0.5F, from.y + font_px * 0.15F},
                                        ImGui::GetColorU32(ImGuiCol_Text),
                                        text.c_str());
    const float taken_px = ImGui::GetWindowHeight() + font_px * 0.8F;
    ImGui::End();
    return taken_px;
}

}  // namespace plumbline::app::panels
