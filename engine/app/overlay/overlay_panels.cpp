#include "engine/app/controls/key_labels.h"
#include "engine/app/overlay/overlay_panels_impl.h"
#include "engine/app/overlay/plaque_text.h"
#include "engine/app/overlay/rule_text.h"
#include "engine/app/ui/canvas_impl.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::app::panels {
namespace {

using ui::HudLine;
using ui::Tone;

/// "W A S D: walk", by what the keys print.
std::string hint_text(const OverlayInput& input, FirstStep step) {
    const std::string keys = step == FirstStep::Walk
                                 ? walk_labels(input.bindings, input.device)
                                 : hint_for(input.bindings, action_of(step), input.device);
    return fmt::format("{}: {}", keys, step_words(step));
}

std::vector<HudLine> status_lines(const OverlayInput& input) {
    std::string line;
    const auto add = [&](const std::string& part) { line += (line.empty() ? "" : "   ") + part; };
    if (!input.hud.chosen_thing.empty()) {
        add(fmt::format("{}: {}",
                        hint_for(input.bindings, Action::Drop, input.device),
                        input.hud.chosen_thing));
    }
    if (!input.camera_path.empty()) add(input.camera_path);
    if (input.clock.paused()) add("paused");
    if (input.clock.speed() != 1.0) add(fmt::format("speed {:g}x", input.clock.speed()));
    if (input.clock.lost_s() >= 0.1)
        add(fmt::format("{:.1f} s dropped: slower than real time", input.clock.lost_s()));
    if (!input.simulation.physics.report().isolated.empty()) {
        add(fmt::format("{} bodies removed (non-finite state)",
                        input.simulation.physics.report().isolated.size()));
    }
    if (input.lines_not_shown > 0)
        add(fmt::format("{} debug lines not shown", input.lines_not_shown));
    if (line.empty()) return {};
    return {{.text = line}};
}

Tone tone_of(study::Verdict verdict) {
    if (verdict == study::Verdict::Pass) return Tone::Good;
    return verdict == study::Verdict::Fail ? Tone::Bad : Tone::Faint;
}

std::vector<HudLine> verdict_lines(const OverlayInput& input) {
    const study::HardCaseJudge& judge = *input.judge;
    const scene::HardCase& hard = *input.simulation.description().hard_case;
    const bool open = judge.verdict() == study::Verdict::Undecided;
    std::vector<HudLine> lines{
        {.text = fmt::format("{}  {}  {:.1f} of {:g} s",
                             hard.id,
                             open ? "passing so far" : study::word_of(judge.verdict()),
                             std::min(input.simulation.time_s(), hard.seconds),
                             hard.seconds),
         .tone = tone_of(judge.verdict())}};
    for (const study::RuleState& rule : judge.rules()) {
        lines.push_back({.text = rule_text(rule), .tone = tone_of(rule.verdict)});
    }
    return lines;
}

/// "0:34"
std::string clock_text(double seconds) {
    const int whole = static_cast<int>(std::ceil(seconds));
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

std::vector<HudLine> goal_lines(const OverlayInput& input, const scene::GoalState& goal) {
    std::vector<HudLine> lines{{.text = goal.text, .tone = Tone::Head}};
    std::string now = fmt::format("{} of {}", std::min(goal.counted, goal.wanted), goal.wanted);
    if (goal.holds_for_s && *goal.holds_for_s > 0.5)
        now += fmt::format("   hold for {}", clock_text(*goal.holds_for_s));
    else if (goal.left_s)
        now += fmt::format("   {} left", clock_text(*goal.left_s));
    if (goal.throws_left) now += fmt::format("   {} throws left", *goal.throws_left);
    lines.push_back({.text = now});
    if (input.best_s) lines.push_back({.text = fmt::format("Best: {:.1f} s", *input.best_s)});
    if (goal.end == scene::GoalEnd::Open) return lines;
    const bool won = goal.end == scene::GoalEnd::Won;
    lines.push_back(
        {.text = fmt::format("{}   {}: play again",
                             won ? fmt::format("Won in {:.1f} s", goal.passed_s) : "Lost",
                             hint_for(input.bindings, Action::Reset, input.device)),
         .tone = won ? Tone::Good : Tone::Bad});
    return lines;
}

/// Of a step: the mean so far of the plaque's effect, or that of the latest steps of the rigid bodies.
double cost_ms_of(const OverlayInput& input, const scene::PlaqueReading& plaque) {
    for (const effects::LedgerLine& line : input.ledger) {
        if (line.name == plaque.says.effect)
            return line.cpu_ms / std::max(1.0, static_cast<double>(input.simulation.steps()));
    }
    const auto& steps = input.report.recent_steps();
    double sum_ms = 0;
    for (const float ms : steps) sum_ms += static_cast<double>(ms);
    return steps.empty() ? 0.0 : sum_ms / static_cast<double>(steps.size());
}

}  // namespace

ui::HudTexts hud_texts(const OverlayInput& input) {
    ui::HudTexts texts;
    texts.side = stats_lines(input);
    if (!input.parts.hud) return texts;
    texts.status = status_lines(input);
    if (input.judge != nullptr) texts.verdict = verdict_lines(input);
    if (input.hud.goal) texts.verdict = goal_lines(input, *input.hud.goal);
    if (input.hud.plaque)
        texts.verdict = plaque_lines(*input.hud.plaque, cost_ms_of(input, *input.hud.plaque));
    if (input.hud.crosshair && !input.hud.looking_at.empty())
        texts.target = {{.text = input.hud.looking_at}};
    if (input.hud.crosshair && !input.hud.use.empty())
        texts.target.push_back(
            {.text = fmt::format(
                 "{}: {}", hint_for(input.bindings, Action::Use, input.device), input.hud.use)});
    if (input.hint) texts.hint = {{.text = hint_text(input, *input.hint), .tone = Tone::Head}};
    for (const std::string& caption : input.captions) texts.captions.push_back({.text = caption});
    return texts;
}

void draw_crosshair(const OverlayInput& input, float font_px) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float em = font_px;
    const auto& flashlight = input.simulation.description().flashlight;
    if (flashlight && input.simulation.switches.is_on("flashlight", flashlight->on)) {
        // A sign without words, where nothing else stands.
        const ImVec2 at{screen.x - em * 1.7F, screen.y - em * 1.7F};
        list.AddCircleFilled(at, em * 0.95F, IM_COL32(12, 12, 16, 150));
        ui::draw_icon(list, ui::Icon::Light, at, em * 1.2F, IM_COL32(255, 226, 150, 255));
    }
    if (!input.hud.crosshair) return;
    const ImVec2 middle{screen.x * 0.5F, screen.y * 0.5F};
    // A dark rim keeps the mark visible on any ground.
    list.AddCircleFilled(middle, em * 0.2F, IM_COL32(0, 0, 0, 140));
    list.AddCircleFilled(middle, em * 0.13F, IM_COL32(255, 255, 255, 230));
    if (input.hud.charge > 0.0F) {
        const float full_turn = 6.2831853F;
        list.PathArcTo(
            middle, em * 0.8F, -full_turn * 0.25F, full_turn * (input.hud.charge - 0.25F), 40);
        list.PathStroke(IM_COL32(255, 210, 90, 235), 0, em * 0.18F);
    }
}

}  // namespace plumbline::app::panels
