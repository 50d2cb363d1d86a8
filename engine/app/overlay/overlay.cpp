#include "engine/app/overlay/overlay.h"

#include "engine/app/overlay/overlay_panels_impl.h"
#include "engine/app/ui/canvas.h"
#include "engine/app/ui/menu_control.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <deque>
#include <map>
#include <utility>

namespace plumbline::app {
namespace {

constexpr double kMessage_s = 4.0;
constexpr double kReading_s = 0.04;  // for each letter
constexpr std::size_t kMessages = 6;

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

struct Overlay::Impl {
    explicit Impl(platform::Window& window_drawn_into) : window(window_drawn_into) {}

    void make_texture() const {
        ImGui_ImplOpenGL3_DestroyFontsTexture();
        ImGui_ImplOpenGL3_CreateFontsTexture();
    }

    platform::Window& window;
    ui::Canvas canvas;
    std::deque<panels::Message> messages;
    bool sound_was_silent{false};
};

Overlay::Overlay(platform::Window& window, const std::filesystem::path& thumbnails)
    : impl_(std::make_unique<Impl>(window)) {
    impl_->canvas.set_thumbnails(thumbnails_in(thumbnails));
    const platform::PixelSize size = window.framebuffer_size();
    impl_->canvas.resize(size.width, size.height, window.content_scale(), 0.0F);
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

Overlay::~Overlay() {
    ImGui_ImplOpenGL3_Shutdown();
}

void Overlay::follow_window(float ui_scale, ui::MenuControl& menu) {
    const platform::PixelSize size = impl_->window.framebuffer_size();
    if (size.width == 0) return;
    ui::Canvas& canvas = impl_->canvas;
    bool remade = canvas.resize(size.width, size.height, impl_->window.content_scale(), ui_scale);
    remade |= canvas.load_thumbnails(menu.menu());
    if (remade) impl_->make_texture();
    menu.lay_out(canvas.width_px(), canvas.height_px(), canvas.font_px(), canvas.text_size());
}

void Overlay::say(std::string message, double now_s) {
    const double until_s = now_s + kMessage_s + kReading_s * static_cast<double>(message.size());
    // A message that is still up is renewed, not stacked.
    for (panels::Message& shown : impl_->messages) {
        if (shown.text == message) {
            shown.until_s = until_s;
            return;
        }
    }
    impl_->messages.push_back({std::move(message), until_s});
    if (impl_->messages.size() > kMessages) impl_->messages.pop_front();
}

void Overlay::say_latest(std::string message, double now_s) {
    const std::string_view stem = panels::stem_of(message);
    std::erase_if(impl_->messages, [&](const panels::Message& shown) {
        return panels::stem_of(shown.text) == stem;
    });
    say(std::move(message), now_s);
}

AccuracyRequest Overlay::draw(const OverlayInput& input,
                              const InputSnapshot& devices,
                              const ui::MenuControl& menu) {
    std::erase_if(impl_->messages,
                  [&](const panels::Message& m) { return m.until_s < input.now_s; });
    // The start page is not written over.
    if (!menu.open() &&
        std::exchange(impl_->sound_was_silent, input.sound_silent) != input.sound_silent)
        say(input.sound_silent ? "no sound device: sound is off" : "sound is back", input.now_s);
    ui::Canvas& canvas = impl_->canvas;
    ImGui_ImplOpenGL3_NewFrame();
    canvas.begin(devices);
    AccuracyRequest answer;
    float side_px = 0.0F;
    if (input.parts.accuracy && !menu.open())
        answer = panels::draw_accuracy(input.accuracy, input.clock, canvas.font_px(), side_px);
    float bar_px = 0.0F;
    if (input.animation != nullptr && input.parts.hud && !menu.open()) {
        bar_px = panels::draw_animation_bar(
            *input.animation, canvas.width_px(), canvas.height_px(), canvas.font_px());
    }
    ui::HudTexts texts;
    if (!menu.open()) {
        texts = panels::hud_texts(input);
        // Two panels of that size stand beside each other in wide windows only.
        if (side_px > canvas.width_px() * 0.4F) texts.side.clear();
    }
    texts.messages = panels::message_lines(impl_->messages, input.now_s, input.reduce_motion);
    for (const std::string& fault : input.faults)
        texts.messages.push_back({.text = fault, .tone = ui::Tone::Bad});
    const ui::HudLayout layout = ui::layout_of(texts,
                                               canvas.width_px(),
                                               canvas.height_px() - bar_px,
                                               canvas.font_px(),
                                               side_px,
                                               canvas.text_size());
    if (input.parts.hud && !menu.open()) panels::draw_crosshair(input, canvas.font_px());
    constexpr float kFaint = 0.5F;
    constexpr float kSolid = 0.72F;
    canvas.draw(layout.status, kFaint);
    canvas.draw(layout.verdict, kSolid);
    canvas.draw(layout.side, kSolid);
    canvas.draw(layout.target, 0.25F);
    canvas.draw(layout.hint, kSolid);
    canvas.draw(layout.captions, kSolid);
    canvas.draw(menu.menu());
    canvas.draw(layout.messages, kSolid, ui::Layer::Above);
    canvas.end();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    return answer;
}

bool Overlay::wants_mouse() const {
    return ImGui::GetIO().WantCaptureMouse;
}

}  // namespace plumbline::app
