#include "engine/app/overlay/overlay.h"

#include "engine/app/overlay/overlay_panels_impl.h"
#include "engine/app/ui/menu_control.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <map>

namespace plumbline::app {
namespace {

std::map<std::string, std::filesystem::path> thumbnails_in(const std::filesystem::path& folder) {
    std::map<std::string, std::filesystem::path> files;
    std::error_code failed;
    for (std::filesystem::recursive_directory_iterator entry(folder, failed), end;
         !failed && entry != end;
         entry.increment(failed)) {
        if (entry->path().extension() != ".jpg") continue;
        files.emplace(entry->path().lexically_relative(folder).replace_extension().generic_string(),
                      entry->path());
    }
    return files;
}

}  // namespace

Overlay::Overlay(platform::Window& window, const std::filesystem::path& thumbnails)
    : window_(window) {
    canvas_.set_thumbnails(thumbnails_in(thumbnails));
    const platform::PixelSize size = window.framebuffer_size();
    canvas_.resize(size.width, size.height, window.content_scale(), 0.0F);
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

Overlay::~Overlay() {
    ImGui_ImplOpenGL3_Shutdown();
}

void Overlay::follow_window(float ui_scale, ui::MenuControl& menu) {
    const platform::PixelSize size = window_.framebuffer_size();
    if (size.width == 0) return;
    bool remade = canvas_.resize(size.width, size.height, window_.content_scale(), ui_scale);
    remade |= canvas_.load_thumbnails(menu.menu());
    if (remade) {
        ImGui_ImplOpenGL3_DestroyFontsTexture();
        ImGui_ImplOpenGL3_CreateFontsTexture();
    }
    menu.lay_out(canvas_.width_px(), canvas_.height_px(), canvas_.font_px(), canvas_.text_size());
}

void Overlay::draw(const OverlayInput& input,
                   const InputSnapshot& devices,
                   const ui::MenuControl& menu,
                   Requests& requests) {
    ImGui_ImplOpenGL3_NewFrame();
    canvas_.begin(devices);
    float side_px = 0.0F;
    if (input.parts.accuracy && !menu.open())
        side_px = panels::draw_accuracy(
            {.control = input.accuracy,
             .clock = input.clock,
             .replaying = input.replaying,
             .is_hard_case = input.judge != nullptr,
             .tolerance = input.simulation.description().accuracy.tolerance.value_or(
                 study::kUsualTolerance)},
            canvas_.font_px(),
            requests);
    float bar_px = 0.0F;
    if (input.animation && input.parts.hud && !menu.open()) {
        bar_px = panels::draw_animation_bar(*input.animation, canvas_.font_px(), requests);
    }
    ui::HudTexts texts;
    if (!menu.open()) {
        texts = panels::hud_texts(input);
        // Two panels of that size stand beside each other in wide windows only.
        if (side_px > canvas_.width_px() * 0.4F) texts.side.clear();
    }
    texts.messages = input.messages;
    for (const std::string& fault : input.faults)
        texts.messages.push_back({.text = fault, .tone = ui::Tone::Bad});
    const ui::HudLayout layout = ui::layout_of(texts,
                                               canvas_.width_px(),
                                               canvas_.height_px() - bar_px,
                                               canvas_.font_px(),
                                               side_px,
                                               canvas_.text_size());
    if (input.parts.hud && !menu.open()) panels::draw_crosshair(input, canvas_.font_px());
    constexpr float kFaint = 0.5F;
    constexpr float kSolid = 0.72F;
    canvas_.draw(layout.status, kFaint);
    canvas_.draw(layout.verdict, kSolid);
    canvas_.draw(layout.side, kSolid);
    canvas_.draw(layout.target, 0.25F);
    canvas_.draw(layout.hint, kSolid);
    canvas_.draw(layout.captions, kSolid);
    canvas_.draw(menu.menu());
    canvas_.draw(layout.messages, kSolid, ui::Layer::Above);
    canvas_.end();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

bool Overlay::takes_pointer(double x_px, double y_px) const {
    return ImGui::GetIO().WantCaptureMouse ||
           canvas_.covers(static_cast<float>(x_px), static_cast<float>(y_px));
}

bool Overlay::takes_keys() const {
    return canvas_.takes_keys();
}

}  // namespace plumbline::app
