// The accuracy panel: what the setting costs and how good it is, live; the ghost beside it.
#include "engine/app/accuracy/accuracy_choice.h"
#include "engine/app/overlay/overlay_panels_impl.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <span>
#include <vector>

namespace plumbline::app::panels {
namespace {

using physics::Solver;
using study::Setting;

// Nothing is typed: no text of a keyboard reaches the panel.
constexpr ImGuiSliderFlags kSlider = ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput;
constexpr int kMostIterations = 50;

bool choose_solver(const char* label, Setting& setting) {
    const std::string now(physics::solver_name(setting.solver));
    if (!ImGui::BeginCombo(label, now.c_str())) return false;
    bool changed = false;
    for (const Solver solver : physics::kSolvers) {
        const std::string name(physics::solver_name(solver));
        if (!ImGui::Selectable(name.c_str(), solver == setting.solver)) continue;
        changed = solver != setting.solver;
        if (changed) setting = with_solver(setting, solver);
    }
    ImGui::EndCombo();
    return changed;
}

bool choose_rate(const char* label, Setting& setting) {
    const std::span<const int> rates = offered_rates_hz();
    const auto last = static_cast<int>(rates.size()) - 1;
    const auto found = std::ranges::lower_bound(rates, setting.step_hz);
    int place = std::min(static_cast<int>(found - rates.begin()), last);
    const std::string shown = fmt::format("{} Hz", setting.step_hz);
    if (!ImGui::SliderInt(label, &place, 0, last, shown.c_str(), kSlider)) return false;
    const int chosen = rates[static_cast<std::size_t>(std::clamp(place, 0, last))];
    const bool changed = chosen != setting.step_hz;
    setting.step_hz = chosen;
    return changed;
}

/// A slider that counts only once it is let go: each change rebuilds the world.
bool choose_count(const char* label, int& value, int least, int most, const char* format) {
    static ImGuiID held = 0;
    static int held_value = 0;
    const ImGuiID id = ImGui::GetID(label);
    int shown = held == id ? held_value : value;
    if (ImGui::SliderInt(label, &shown, least, most, format, kSlider)) {
        held = id;
        held_value = shown;
    }
    if (!ImGui::IsItemDeactivatedAfterEdit() || held != id) return false;
    held = 0;
    const bool changed = held_value != value;
    value = held_value;
    return changed;
}

bool choose_setting(Setting& setting) {
    bool changed = choose_rate("Step rate", setting);
    changed |= choose_count("Sub-steps",
                            setting.substeps,
                            setting.solver == Solver::SmallStep ? 0 : 1,
                            scene::kMostSubsteps,
                            setting.substeps == 0 ? "on demand" : "%d");
    changed |= choose_count("Iterations", setting.iterations, 1, kMostIterations, "%d");
    changed |= choose_solver("Solver", setting);
    return changed;
}

/// Each effect that bodies feel and something calls for, with what another fidelity costs and buys as far as a study has seen.
bool choose_fidelities(const std::vector<EffectInPlay>& effects, Setting& setting) {
    bool changed = false;
    for (const EffectInPlay& effect : effects) {
        int level = static_cast<int>(effect.fidelity);
        const std::string label = fmt::format("{}##fidelity", effect.name);
        const std::string shown(study::word_of(effect.fidelity));
        if (choose_count(label.c_str(), level, 0, 2, shown.c_str())) {
            std::erase_if(setting.fidelity,
                          [&](const auto& each) { return each.effect == effect.name; });
            setting.fidelity.push_back({effect.name, static_cast<scene::Fidelity>(level)});
            changed = true;
        }
        if (!effect.price.empty()) draw_text(effect.price);
    }
    return changed;
}

void draw_gauges(const AccuracyGauges& gauges) {
    const scene::CostHistory& cost = gauges.cost;
    const double steps = std::max(1.0, static_cast<double>(cost.step_ms.size()));
    const double other =
        cost.cpu_ms_total - cost.broad_ms - cost.narrow_ms - cost.solve_ms - cost.integrate_ms;
    draw_text(fmt::format(
        "{:.3f} ms per step, {:.1f} ms per second", cost.cpu_ms_total / steps, gauges.ms_per_s));
    draw_text(fmt::format("broad {:.2f}  narrow {:.2f}  solve {:.2f}  move {:.2f}  other {:.2f}",
                          cost.broad_ms / steps,
                          cost.narrow_ms / steps,
                          cost.solve_ms / steps,
                          cost.integrate_ms / steps,
                          std::max(0.0, other / steps)));
    draw_text(fmt::format("up to {} sub-steps, {} islands, {:.0f} s dropped",
                          gauges.most_substeps,
                          gauges.islands,
                          gauges.lost_s));
    draw_text(fmt::format(
        "energy {:.4g} J, change {:+.2g} J per second", gauges.energy_J, gauges.energy_change_J));
    draw_text(fmt::format("penetration {:.2f} mm, joint error {:.2f} mm at most",
                          gauges.max_penetration_m * 1e3,
                          gauges.max_joint_error_m * 1e3));
    const std::string done = scene::interventions_text(gauges.cost.interventions);
    draw_text(fmt::format("interventions: {}", done.empty() ? "none" : done));
}

void plot(const char* label,
          std::span<const study::GhostDistance> history,
          double study::GhostDistance::*part,
          double scale) {
    std::vector<float> values;
    for (const study::GhostDistance& each : history)
        values.push_back(static_cast<float>(each.*part * scale));
    const float last = values.empty() ? 0.0F : values.back();
    const std::string shown = fmt::format("{:.{}f}", last, last < 10.0F ? 2 : 0);
    ImGui::PlotLines(label,
                     values.data(),
                     static_cast<int>(values.size()),
                     0,
                     shown.c_str(),
                     0.0F,
                     std::max(1e-6F, values.empty() ? 0.0F : *std::ranges::max_element(values)),
                     {0.0F, ImGui::GetTextLineHeight() * 2.2F});
}

/// The buttons that make a ghost.
void offer_ghost(const Setting& setting, Requests& requests) {
    if (ImGui::Button("Ghost from the start"))
        requests.push_back(StartGhost{setting, GhostFrom::Start});
    ImGui::SameLine();
    if (ImGui::Button("Ghost from here")) requests.push_back(StartGhost{setting, GhostFrom::Here});
}

void draw_ghost(const AccuracyPanel& shown, Requests& requests) {
    const study::Ghost* ghost = shown.control.ghost();
    if (ghost == nullptr || !ghost->failure().empty()) {
        draw_text(ghost == nullptr ? "ghost: the same scene at higher accuracy"
                                   : fmt::format("ghost failed: {}", ghost->failure()));
        // A replay starts as it was recorded.
        if (!shown.replaying) offer_ghost(finer(shown.control.setting()), requests);
        return;
    }
    draw_text(fmt::format("ghost: {}", study::setting_text(ghost->setting())));
    if (ghost->behind_s() > 0.25)
        draw_text(
            fmt::format("{:.1f} s behind: too expensive to run in real time", ghost->behind_s()));
    plot("max distance, mm", ghost->history(), &study::GhostDistance::largest_m, 1e3);
    plot("mean distance, mm", ghost->history(), &study::GhostDistance::mean_m, 1e3);
    plot("this world, ms/s", ghost->history(), &study::GhostDistance::visible_ms_per_s, 1);
    plot("ghost, ms/s", ghost->history(), &study::GhostDistance::ghost_ms_per_s, 1);
    offer_ghost(ghost->setting(), requests);
    ImGui::SameLine();
    if (ImGui::Button("Stop ghost")) requests.push_back(StopGhost{});
    draw_text(
        "Outlines show bodies that are 1 mm or more apart.\nThe ghost does not feel your hands or "
        "what you drop.");
}

}  // namespace

void draw_text(const std::string& text) {
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
}

Setting finer(Setting setting) {
    setting.solver = Solver::SmallStep;
    setting.step_hz = std::min(setting.step_hz * 4, 480);
    setting.substeps = std::max(8, setting.substeps * 2);
    setting.iterations = 1;
    setting.precision = study::Precision::Float64;
    return setting;
}

float draw_accuracy(const AccuracyPanel& shown, float font_px, Requests& requests) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float margin = font_px * 0.8F;
    const float width = std::min(font_px * 24.0F, screen.x - 2 * margin);
    ImGui::SetNextWindowPos({screen.x - margin, margin}, ImGuiCond_Always, {1.0F, 0.0F});
    // As high as it needs; in a low window it scrolls.
    ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, screen.y - 2 * margin});
    ImGui::SetNextWindowBgAlpha(0.82F);
    ImGui::Begin("accuracy",
                 nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PushItemWidth(width * 0.5F);
    draw_text("Accuracy and cost (last second)");
    ImGui::Separator();
    Setting setting = shown.control.setting();
    if (shown.replaying)
        draw_text(
            fmt::format("{}\nAccuracy is locked while replaying.", study::setting_text(setting)));
    else if (choose_setting(setting))
        requests.push_back(WorldRequest{SetAccuracy{setting}});
    const std::vector<EffectInPlay> effects = shown.control.effects();
    if (!shown.replaying && !effects.empty()) {
        ImGui::Separator();
        draw_text("Effects; another fidelity starts the scene again");
        if (choose_fidelities(effects, setting))
            requests.push_back(WorldRequest{SetAccuracy{setting}});
        ImGui::Separator();
    }
    // Above all that grows and shrinks, so that it stays where it is.
    if (ImGui::Button("Save copy")) requests.push_back(AdoptAccuracy{});
    ImGui::SameLine();
    draw_text("Writes this setting into a copy of the scene.");
    draw_text(fmt::format("{}; plumbline-f64 runs in double precision",
                          study::word_of(setting.precision)));
    if (shown.is_hard_case) draw_text("What you throw, push or drop counts in the verdict.");
    ImGui::Separator();
    draw_study(shown, requests);
    ImGui::Separator();
    draw_gauges(shown.control.gauges(shown.clock));
    ImGui::Separator();
    draw_ghost(shown, requests);
    ImGui::PopItemWidth();
    ImGui::End();
    return width + margin;
}

}  // namespace plumbline::app::panels
