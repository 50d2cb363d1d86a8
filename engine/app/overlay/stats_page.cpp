// The statistics over the image: a summary that is read at a glance, or the full table.
#include "engine/app/controls/key_labels.h"
#include "engine/app/overlay/overlay_panels_impl.h"
#include "engine/core/process/process_memory.h"
#include "engine/physics/totals.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <span>

namespace plumbline::app::panels {
namespace {

using ui::HudLine;
using ui::Tone;

constexpr std::size_t kMostExpensive = 3;
constexpr float kFrameBudget_ms = 1000.0F / 60.0F;

struct NamedCost {
    std::string name;
    double ms{0};
};

HudLine head(std::string text) {
    return {.text = std::move(text), .tone = Tone::Head};
}

template <class... Parts>
HudLine row(const std::string& text, fmt::format_string<Parts...> value, Parts&&... parts) {
    return {.text = text, .value = fmt::format(value, std::forward<Parts>(parts)...)};
}

HudLine graph(std::span<const float> values, float budget, float least_top) {
    HudLine line{.text = {}, .graph = {values.begin(), values.end()}, .graph_budget = budget};
    const auto most = std::ranges::max_element(line.graph);
    line.graph_top = std::max(least_top, most == line.graph.end() ? 0.0F : *most * 1.1F);
    return line;
}

/// Works on the GPU and on the CPU at the same time: the longer of the two counts.
double cost_of(const render::PassTiming& pass) {
    return std::max(pass.cpu_ms, pass.gpu_ms);
}

std::vector<NamedCost> pass_costs(const FrameReport& report) {
    std::vector<NamedCost> costs;
    for (const render::PassTiming& pass : report.recent_passes())
        costs.push_back({std::string(pass.name), cost_of(pass)});
    return costs;
}

/// Mean over all frames: what an effect does in one frame is too little to be timed.
std::vector<NamedCost> effect_costs(const OverlayInput& input) {
    const auto frames = static_cast<double>(std::max<std::uint64_t>(1, input.report.frames()));
    std::vector<NamedCost> costs;
    for (const effects::LedgerLine& line : input.ledger)
        if (line.exists) costs.push_back({std::string(line.name), line.cpu_ms / frames});
    return costs;
}

void add_most_expensive(std::vector<NamedCost> costs, std::vector<HudLine>& lines) {
    std::ranges::sort(costs, std::ranges::greater{}, &NamedCost::ms);
    if (costs.size() > kMostExpensive) costs.resize(kMostExpensive);
    for (const NamedCost& cost : costs) {
        lines.push_back(row(cost.name, "{:.2f} ms", cost.ms));
        const double most = costs.front().ms;
        lines.back().share = most > 0.0 ? static_cast<float>(cost.ms / most) : 0.0F;
    }
}

HudLine frame_line(const FrameReport& report) {
    const scene::Percentiles frame = report.recent_frame_ms();
    HudLine line = row(fmt::format("{:.0f} fps   {:.1f} ms",
                                   frame.median > 0.0 ? 1000.0 / frame.median : 0.0,
                                   frame.median),
                       "p99 {:.1f} ms",
                       frame.p99);
    line.tone = Tone::Head;
    return line;
}

HudLine step_line(const scene::Simulation& simulation) {
    const physics::StepCost& cost = simulation.physics.report().cost;
    const std::string shared =
        cost.helpers_ms > 0 ? fmt::format(", {:.2f} on the clock", cost.wall_ms) : "";
    HudLine line = row(fmt::format("Physics   {:.2f} ms per step{}", cost.total_ms, shared),
                       "{:.0f} Hz x {}",
                       1.0 / simulation.step_s(),
                       most_substeps(simulation.physics));
    line.tone = Tone::Head;
    return line;
}

HudLine image_line(const FrameReport& report) {
    const QualityInForce& image = report.image();
    const render::FrameStats& stats = report.last_stats();
    return row(fmt::format("Image quality {}{}", image.level, image.is_automatic ? " (auto)" : ""),
               "{} x {}",
               stats.scene_width_px,
               stats.scene_height_px);
}

HudLine memory_line() {
    return row("Peak memory", "{:.0f} MiB", static_cast<double>(peak_resident_bytes()) / 1048576.0);
}

void add_world(const OverlayInput& input, std::vector<HudLine>& lines) {
    const physics::PhysicsWorld& world = input.simulation.physics;
    lines.push_back(row(fmt::format("{} bodies, {} awake", body_count(world), awake_count(world)),
                        "{} contacts",
                        world.report().cost.contacts));
    if (input.clock.lost_s() >= 0.1)
        lines.push_back(row("Dropped time (too slow)", "{:.1f} s", input.clock.lost_s()));
}

std::vector<HudLine> summary(const OverlayInput& input) {
    const auto step_ms = static_cast<float>(input.simulation.step_s() * 1000.0);
    std::vector<HudLine> lines{frame_line(input.report),
                               graph(input.report.recent_frames(), kFrameBudget_ms, 20.0F),
                               step_line(input.simulation),
                               graph(input.report.recent_steps(), step_ms, 0.5F)};
    add_world(input, lines);
    lines.push_back(head("Most expensive passes"));
    add_most_expensive(pass_costs(input.report), lines);
    if (std::vector<NamedCost> effects = effect_costs(input); !effects.empty()) {
        lines.push_back(head("Most expensive effects"));
        add_most_expensive(std::move(effects), lines);
    }
    lines.push_back(image_line(input.report));
    lines.push_back(memory_line());
    lines.push_back({.text = fmt::format("{}: full table",
                                         hint_for(input.bindings, Action::Stats, input.device)),
                     .tone = Tone::Faint});
    return lines;
}

/// A bar for each phase and, where there are helpers, for the threads: shares of the whole step. Phases are timed on the
/// clock of the thread that calls them.
void add_step_phases(const physics::StepCost& step, std::vector<HudLine>& lines) {
    const double own_ms = step.total_ms - step.helpers_ms;
    const auto add = [&](const char* name, double ms, double of_ms) {
        lines.push_back(row(name, "{:.2f} ms", ms));
        lines.back().share =
            of_ms > 0.0 ? static_cast<float>(std::clamp(ms / of_ms, 0.0, 1.0)) : 0.0F;
    };
    add("  broad phase", step.broad_ms, own_ms);
    add("  narrow phase", step.narrow_ms, own_ms);
    add("  solver", step.solve_ms, own_ms);
    add("  integration", step.integrate_ms, own_ms);
    if (step.helpers_ms <= 0.0) return;
    add("  calling thread", own_ms, step.total_ms);
    add("  helper threads", step.helpers_ms, step.total_ms);
}

void add_drawn(const FrameReport& report, std::vector<HudLine>& lines) {
    const render::FrameStats& stats = report.last_stats();
    lines.push_back(image_line(report));
    if (const std::string without = render::what_gave_way(report.image().quality); !without.empty())
        lines.push_back({.text = "Reduced: " + without});
    lines.push_back(row("Draw calls", "{}", stats.draw_calls));
    lines.push_back(row("Triangles", "{}", stats.triangles));
    lines.push_back(row("Instances", "{}", stats.instances));
    lines.push_back(row("Shadow maps",
                        "{} drawn, {} cached",
                        stats.shadow_passes_rendered,
                        stats.shadow_passes_cached));
    if (stats.shadowed_lights + stats.unshadowed_lights > 0)
        lines.push_back(row("Lamps",
                            "{} with shadows, {} without",
                            stats.shadowed_lights,
                            stats.unshadowed_lights));
}

std::vector<HudLine> full_table(const OverlayInput& input) {
    const scene::Percentiles frame = input.report.recent_frame_ms();
    const physics::PhysicsWorld& world = input.simulation.physics;
    std::vector<HudLine> lines{frame_line(input.report),
                               row("Frame p95", "{:.1f} ms", frame.p95),
                               step_line(input.simulation)};
    add_step_phases(input.report.recent_step(), lines);
    add_world(input, lines);
    lines.push_back(row("Max penetration", "{:.2f} mm", max_penetration_m(world) * 1e3));
    if (const std::string done = scene::interventions_text(input.report.interventions());
        !done.empty())
        lines.push_back({.text = "Solver interventions: " + done});
    add_drawn(input.report, lines);
    lines.push_back(memory_line());
    lines.push_back(head("Passes: CPU and GPU ms"));
    for (const render::PassTiming& pass : input.report.recent_passes()) {
        const std::string gpu = pass.gpu_ms >= 0.0 ? fmt::format("{:.2f}", pass.gpu_ms) : "-";
        lines.push_back(row(std::string(pass.name), "{:.2f}  {}", pass.cpu_ms, gpu));
    }
    lines.push_back(head("Effects: CPU ms per frame"));
    for (const NamedCost& effect : effect_costs(input))
        lines.push_back(row(effect.name, "{:.3f}", effect.ms));
    lines.push_back(
        {.text = fmt::format("{}: close", hint_for(input.bindings, Action::Stats, input.device)),
         .tone = Tone::Faint});
    return lines;
}

/// A model by itself: its file and what it is made of.
std::vector<HudLine> model_lines(const scene::Simulation& simulation) {
    const assets::AssetLibrary& library = simulation.library();
    std::vector<HudLine> lines;
    for (auto [entity, name, visual] :
         simulation.registry.view<const scene::Name, const scene::Visual>()) {
        if (name.text != "model") continue;
        const assets::MeshData& mesh = library.mesh(visual.mesh);
        const Vec3f size = mesh.bounds.size();
        lines.push_back(head(simulation.description().file.filename().string()));
        lines.push_back(row("Triangles", "{}", mesh.indices.size() / 3));
        lines.push_back(row("Vertices", "{}", mesh.vertices.size()));
        lines.push_back(row("Materials", "{}", visual.materials.size()));
        lines.push_back(row("Size", "{:.4g} x {:.4g} x {:.4g} m", size.x, size.y, size.z));
    }
    return lines;
}

}  // namespace

std::vector<HudLine> stats_lines(const OverlayInput& input) {
    std::vector<HudLine> lines;
    if (input.parts.stats == StatsPage::Off) return lines;
    if (input.simulation.description().shows_model) lines = model_lines(input.simulation);
    std::vector<HudLine> costs =
        input.parts.stats == StatsPage::Summary ? summary(input) : full_table(input);
    std::ranges::move(costs, std::back_inserter(lines));
    return lines;
}

}  // namespace plumbline::app::panels
