#include "engine/app/key_labels.h"
#include "engine/app/overlay_panels_impl.h"
#include "engine/core/process_memory.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

namespace plumbline::app::panels {
namespace {

constexpr ImGuiWindowFlags kBare = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_AlwaysAutoResize |
                                   ImGuiWindowFlags_NoSavedSettings |
                                   ImGuiWindowFlags_NoFocusOnAppearing;
constexpr double kHints_s = 12.0;
constexpr float kPanelOpacity = 0.72F;

ImVec2 screen() {
    return ImGui::GetIO().DisplaySize;
}

struct Hint {
    Action action;
    const char* words;
};

}  // namespace

void text(const std::string& line) {
    ImGui::TextUnformatted(line.data(), line.data() + line.size());
}

void apply_style(float scale) {
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 6.0F;
    style.FrameRounding = 4.0F;
    style.WindowBorderSize = 0.0F;
    style.WindowPadding = {12.0F, 10.0F};
    style.ScaleAllSizes(scale);
}

void draw_crosshair(const scene::HudContent& hud) {
    if (!hud.crosshair) return;
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    const ImVec2 middle{screen().x * 0.5F, screen().y * 0.5F};
    // A dark rim keeps the mark visible on any ground.
    list->AddCircleFilled(middle, 3.5F, IM_COL32(0, 0, 0, 140));
    list->AddCircleFilled(middle, 2.2F, IM_COL32(255, 255, 255, 230));
    if (hud.charge > 0.0F) {
        const float full_turn = 6.2831853F;
        list->PathArcTo(middle, 14.0F, -full_turn * 0.25F, full_turn * (hud.charge - 0.25F), 40);
        list->PathStroke(IM_COL32(255, 210, 90, 235), 0, 3.0F);
    }
    if (!hud.looking_at.empty()) {
        const ImVec2 size = ImGui::CalcTextSize(hud.looking_at.c_str());
        const ImVec2 at{middle.x - size.x * 0.5F, middle.y + 22.0F};
        list->AddText({at.x + 1.0F, at.y + 1.0F}, IM_COL32(0, 0, 0, 190), hud.looking_at.c_str());
        list->AddText(at, IM_COL32(255, 255, 255, 220), hud.looking_at.c_str());
    }
}

void draw_hints(const OverlayInput& input, double shown_s) {
    constexpr std::array<Hint, 7> kFirst{{{Action::Forward, "walk"},
                                          {Action::Drop, "drop"},
                                          {Action::Throw, "throw"},
                                          {Action::Grab, "grab"},
                                          {Action::Flashlight, "light"},
                                          {Action::Help, "all keys"},
                                          {Action::Menu, "menu"}}};
    if (shown_s > kHints_s) return;
    std::string line;
    for (const Hint& hint : kFirst) {
        if (!line.empty()) line += "     ";
        line += hint_for(input.bindings, hint.action, input.device);
        if (hint.action == Action::Forward) {
            for (const Action other : {Action::Left, Action::Back, Action::Right}) {
                line += " " + hint_for(input.bindings, other, input.device);
            }
        }
        line += std::string("  ") + hint.words;
    }
    ImGui::SetNextWindowPos(
        {screen().x * 0.5F, screen().y - 14.0F}, ImGuiCond_Always, {0.5F, 1.0F});
    ImGui::SetNextWindowBgAlpha(0.55F);
    ImGui::Begin("hints", nullptr, kBare);
    text(line);
    ImGui::End();
}

void draw_status(const OverlayInput& input) {
    std::string line;
    const auto add = [&](const std::string& part) { line += (line.empty() ? "" : "   ") + part; };
    if (!input.hud.chosen_thing.empty()) {
        add(fmt::format("{}: {}",
                        hint_for(input.bindings, Action::Drop, input.device),
                        input.hud.chosen_thing));
    }
    if (input.clock.paused()) add("paused");
    if (input.clock.speed() != 1.0) add(fmt::format("speed x{:g}", input.clock.speed()));
    if (input.clock.lost_s() >= 0.1)
        add(fmt::format("{:.1f} s lost: too slow here for real time", input.clock.lost_s()));
    if (input.sound_silent) add("no sound device");
    if (!input.simulation.physics.quarantined().empty()) {
        add(fmt::format("{} bodies taken out (not finite)",
                        input.simulation.physics.quarantined().size()));
    }
    if (input.lines_not_shown > 0) add(fmt::format("{} lines not shown", input.lines_not_shown));
    if (line.empty()) return;
    ImGui::SetNextWindowPos({14.0F, 14.0F});
    ImGui::SetNextWindowBgAlpha(0.5F);
    ImGui::Begin("status", nullptr, kBare);
    text(line);
    ImGui::End();
}

void draw_verdict(const OverlayInput& input) {
    const ImVec4 good{0.55F, 0.9F, 0.55F, 1.0F};
    const ImVec4 bad{1.0F, 0.45F, 0.4F, 1.0F};
    const ImVec4 open_yet{0.8F, 0.8F, 0.8F, 1.0F};
    const auto color = [&](study::Verdict verdict) {
        return verdict == study::Verdict::Pass   ? good
               : verdict == study::Verdict::Fail ? bad
                                                 : open_yet;
    };
    const study::HardCaseJudge& judge = *input.judge;
    const scene::HardCase& hard = *input.simulation.description().hard_case;
    ImGui::SetNextWindowPos({14.0F, 54.0F});
    ImGui::SetNextWindowBgAlpha(kPanelOpacity);
    ImGui::Begin("verdict", nullptr, kBare);
    const bool open = judge.verdict() == study::Verdict::Undecided;
    const std::string head =
        fmt::format("{}  {}  {:.1f} of {:g} s",
                    hard.id,
                    open ? "holds so far" : study::verdict_name(judge.verdict()),
                    std::min(input.simulation.time_s(), hard.seconds),
                    hard.seconds);
    ImGui::TextColored(color(judge.verdict()), "%s", head.c_str());
    for (const study::RuleState& rule : judge.rules()) {
        const std::string line =
            rule.seen
                ? fmt::format(
                      "{}: {:.3g}  {}", rule.text, rule.value, study::margin_text(rule.margin()))
                : rule.text;
        ImGui::TextColored(color(rule.verdict), "%s", line.c_str());
    }
    ImGui::End();
}

void draw_messages(const std::deque<Message>& messages, double now_s) {
    if (messages.empty()) return;
    ImGui::SetNextWindowPos(
        {screen().x * 0.5F, screen().y * 0.78F}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowBgAlpha(0.6F);
    ImGui::Begin("messages", nullptr, kBare);
    for (const Message& message : messages) {
        const auto fade = static_cast<float>(std::clamp(message.until_s - now_s, 0.0, 1.0));
        ImGui::PushStyleVar(ImGuiStyleVar_Alpha, std::max(0.05F, fade));
        text(message.text);
        ImGui::PopStyleVar();
    }
    ImGui::End();
}

void draw_help(const OverlayInput& input) {
    ImGui::SetNextWindowPos({screen().x * 0.5F, screen().y * 0.5F}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowBgAlpha(0.85F);
    ImGui::Begin("help", nullptr, kBare);
    text(
        "What every key does (config/bindings.toml; copy it to ~/.config/plumbline and change it)");
    constexpr std::array kGroups{ActionGroup::Walk,
                                 ActionGroup::Things,
                                 ActionGroup::View,
                                 ActionGroup::Light,
                                 ActionGroup::Time,
                                 ActionGroup::Menu};
    if (ImGui::BeginTable("keys", 3)) {
        for (const ActionGroup group : kGroups) {
            ImGui::TableNextColumn();
            ImGui::Spacing();
            ImGui::TextColored(
                {1.0F, 0.82F, 0.45F, 1.0F}, "%s", std::string(group_name(group)).c_str());
            for (std::size_t i = 0; i < kActionCount; ++i) {
                const auto action = static_cast<Action>(i);
                if (group_of(action) != group || input.bindings.of(action).empty()) continue;
                text(fmt::format(
                    "{:<16} {}", action_name(action), all_labels(input.bindings, action)));
            }
        }
        ImGui::EndTable();
    }
    ImGui::End();
}

void draw_stats(const OverlayInput& input) {
    const scene::Percentiles frame = input.report.recent_frame_ms();
    const physics::StepCost& cost = input.simulation.physics.cost();
    const render::FrameStats& stats = input.report.last_stats();
    ImGui::SetNextWindowPos({screen().x - 14.0F, 14.0F}, ImGuiCond_Always, {1.0F, 0.0F});
    ImGui::SetNextWindowBgAlpha(kPanelOpacity);
    ImGui::Begin("stats", nullptr, kBare);
    text(fmt::format("{:.1f} frames/s   frame {:.1f} ms   p95 {:.1f}   p99 {:.1f}",
                     frame.median > 0.0 ? 1000.0 / frame.median : 0.0,
                     frame.median,
                     frame.p95,
                     frame.p99));
    text(fmt::format(
        "physics {:.2f} ms a step: broad {:.2f}  narrow {:.2f}  solve {:.2f}  integrate {:.2f}",
        cost.total_ms,
        cost.broad_ms,
        cost.narrow_ms,
        cost.solve_ms,
        cost.integrate_ms));
    text(fmt::format("{:.0f} Hz x {}   {} bodies, {} awake   {} contacts   {:.2f} s lost",
                     1.0 / input.simulation.step_s(),
                     most_substeps(input.simulation.physics),
                     input.simulation.physics.body_count(),
                     input.simulation.physics.awake_count(),
                     cost.contacts,
                     input.clock.lost_s()));
    text(fmt::format("deepest contact {:.2f} mm",
                     input.simulation.physics.max_penetration_m() * 1e3));
    text(fmt::format("{} draws  {} triangles  {} instances  shadow maps {} drawn {} kept",
                     stats.draw_calls,
                     stats.triangles,
                     stats.instances,
                     stats.shadow_passes_rendered,
                     stats.shadow_passes_cached));
    for (const render::PassTiming& pass : stats.passes) {
        const std::string gpu = pass.gpu_ms >= 0.0 ? fmt::format("{:6.2f}", pass.gpu_ms) : "     -";
        text(fmt::format("  {:<20} cpu {:6.2f}  gpu {} ms", pass.name, pass.cpu_ms, gpu));
    }
    ImGui::Separator();
    for (const effects::LedgerLine& line : input.ledger) {
        if (line.exists)
            text(fmt::format("  {:<20} {} calls  {:.2f} ms", line.name, line.calls, line.cpu_ms));
    }
    text(fmt::format("memory {:.0f} MiB at most",
                     static_cast<double>(peak_resident_bytes()) / 1048576.0));
    ImGui::End();
}

MenuChoice draw_menu(const OverlayInput& input) {
    MenuChoice choice = MenuChoice::None;
    ImGui::SetNextWindowPos(
        {screen().x * 0.5F, screen().y * 0.45F}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowBgAlpha(0.9F);
    constexpr ImGuiWindowFlags kMenu = ImGuiWindowFlags_NoDecoration |
                                       ImGuiWindowFlags_AlwaysAutoResize |
                                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove;
    ImGui::Begin("menu", nullptr, kMenu);
    const std::string& title = input.simulation.description().title;
    text(title.empty() ? "Plumbline" : title);
    ImGui::Separator();
    const ImVec2 wide{ImGui::GetFontSize() * 14.0F, 0.0F};
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    if (ImGui::Button("Go on", wide)) choice = MenuChoice::Resume;
    if (ImGui::Button("Start the scene again", wide)) choice = MenuChoice::Reset;
    if (ImGui::Button("Controls", wide)) choice = MenuChoice::Controls;
    if (ImGui::Button("Quit", wide)) choice = MenuChoice::Quit;
    ImGui::End();
    return choice;
}

}  // namespace plumbline::app::panels
