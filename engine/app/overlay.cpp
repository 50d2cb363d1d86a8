#include "engine/app/overlay.h"

#include "engine/app/overlay_panels_impl.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <vector>

namespace plumbline::app {
namespace {

constexpr double kMessage_s = 5.0;
constexpr std::size_t kMessages = 6;
constexpr float kFontSize_px = 17.0F;

void load_font(float scale) {
    ImGuiIO& io = ImGui::GetIO();
    constexpr const char* kFont = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
    // Latin and Cyrillic: key labels of other layouts.
    const ImWchar* ranges = io.Fonts->GetGlyphRangesCyrillic();
    if (std::filesystem::exists(kFont)) {
        io.Fonts->AddFontFromFileTTF(kFont, kFontSize_px * scale, nullptr, ranges);
    } else {
        ImFontConfig config;
        config.SizePixels = kFontSize_px * scale;
        io.Fonts->AddFontDefault(&config);
    }
}

}  // namespace

struct Overlay::Impl {
    std::vector<int> tapped_keys;  // shown as down although they are up again
    std::deque<panels::Message> messages;
    double started_s{-1.0};
};

Overlay::Overlay(platform::Window& window, float ui_scale) : impl_(std::make_unique<Impl>()) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard | ImGuiConfigFlags_NavEnableGamepad |
                      ImGuiConfigFlags_NoMouseCursorChange;
    const float scale = ui_scale > 0.0F ? ui_scale : std::max(1.0F, window.content_scale());
    load_font(scale);
    panels::apply_style(scale);
    ImGui_ImplGlfw_InitForOpenGL(window.handle(), true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

Overlay::~Overlay() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Overlay::take_input(const InputSnapshot& input) {
    ImGuiIO& io = ImGui::GetIO();
    const auto is_down = [&](int key) { return input.keys[static_cast<std::size_t>(key)]; };
    for (const int key : impl_->tapped_keys) io.KeysDown[key] = is_down(key);
    impl_->tapped_keys.clear();
    for (const DeviceEvent& event : input.events) {
        if (event.kind != DeviceEventKind::Key || !event.pressed) continue;
        if (event.code < 0 || event.code >= kKeyCount || is_down(event.code)) continue;
        io.KeysDown[event.code] = true;
        impl_->tapped_keys.push_back(event.code);
    }
}

void Overlay::say(std::string message, double now_s) {
    // A message that is still up is renewed, not stacked.
    for (panels::Message& shown : impl_->messages) {
        if (shown.text == message) {
            shown.until_s = now_s + kMessage_s;
            return;
        }
    }
    impl_->messages.push_back({std::move(message), now_s + kMessage_s});
    if (impl_->messages.size() > kMessages) impl_->messages.pop_front();
}

OverlayAnswer Overlay::draw(const OverlayInput& input) {
    if (impl_->started_s < 0.0) impl_->started_s = input.now_s;
    std::erase_if(impl_->messages,
                  [&](const panels::Message& m) { return m.until_s < input.now_s; });

    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    OverlayAnswer answer;
    if (input.parts.hud && !input.parts.menu) {
        panels::draw_crosshair(input.hud);
        if (input.show_hints) panels::draw_hints(input, input.now_s - impl_->started_s);
        panels::draw_status(input);
        if (input.judge != nullptr) panels::draw_verdict(input);
    }
    panels::draw_messages(impl_->messages, input.now_s);
    if (input.parts.help) panels::draw_help(input);
    if (input.parts.stats) panels::draw_stats(input);
    if (input.parts.accuracy && !input.parts.menu)
        answer.accuracy = panels::draw_accuracy(input.accuracy, input.clock);
    if (input.parts.menu) answer.menu = panels::draw_menu(input);
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    return answer;
}

bool Overlay::wants_keyboard() const {
    return ImGui::GetIO().WantTextInput;
}

bool Overlay::wants_mouse() const {
    return ImGui::GetIO().WantCaptureMouse;
}

}  // namespace plumbline::app
