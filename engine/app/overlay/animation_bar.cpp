#include "engine/app/overlay/overlay_panels_impl.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string>

namespace plumbline::app::panels {

float draw_animation_bar(const AnimationBar& bar, float font_px, Requests& requests) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float wide_px = std::min(screen.x * 0.7F, font_px * 44.0F);
    ImGui::SetNextWindowPos(
        {screen.x * 0.5F, screen.y - font_px * 0.8F}, ImGuiCond_Always, {0.5F, 1.0F});
    ImGui::SetNextWindowSize({wide_px, 0.0F});
    ImGui::SetNextWindowBgAlpha(0.6F);
    ImGui::Begin(
        "animation",
        nullptr,
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    const auto ask = [&](double time_s, bool paused, bool next) {
        requests.push_back(WorldRequest{SetAnimation{time_s, paused, next}});
    };
    if (ImGui::Button(bar.paused ? "play" : "stop")) ask(bar.time_s, !bar.paused, false);
    ImGui::SameLine();
    if (ImGui::Button("next")) ask(0.0, bar.paused, true);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0F);
    auto time_s = static_cast<float>(bar.time_s);
    const std::string text =
        fmt::format("{}   {:.2f} of {:.2f} s", bar.name, bar.time_s, bar.length_s);
    // The text is no pattern: a name may hold any sign.
    ImGui::PushID("time");
    if (ImGui::SliderFloat("", &time_s, 0.0F, static_cast<float>(bar.length_s), "")) {
        ask(static_cast<double>(time_s), bar.paused, false);
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
