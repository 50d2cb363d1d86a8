#include "engine/effects/effect_runtime.h"

#include "engine/core/io/archive.h"
#include "engine/core/time/stopwatch.h"
#include "engine/core/time/trace_events.h"

#include <map>

namespace plumbline::effects {

EffectRuntime::CallersKey EffectRuntime::key_of(const EffectRow& row,
                                                const scene::Simulation& simulation) {
    CallersKey key{.revision = simulation.revision()};
    const auto switched = simulation.switches.effects.find(row.name);
    if (switched != simulation.switches.effects.end()) key.switched = switched->second;
    if (row.key != nullptr) key.own = row.key(simulation);
    return key;
}

bool EffectRuntime::serves(Domain domain) const {
    return domain == Domain::Step || (domain == Domain::Frame ? served_.frame : served_.sound);
}

void EffectRuntime::refresh_row(std::size_t row, scene::Simulation& simulation) {
    const EffectRow& definition = table_[row];
    if (!serves(definition.domain) || definition.name == served_.without) return;
    Slot& slot = slots_[row];
    const CallersKey key = key_of(definition, simulation);
    if (slot.key == key) return;
    slot.key = key;
    slot.callers = definition.called_for_by(simulation);
    if (!slot.callers.empty() && !slot.effect) {
        const CpuTimer timer;
        slot.effect = definition.make(simulation);
        slot.earlier.cpu_ms += timer.ms();
        ++slot.constructions;
    } else if (slot.callers.empty() && slot.effect) {
        slot.earlier.calls += slot.effect->work().calls;
        slot.earlier.cpu_ms += slot.effect->work().cpu_ms;
        slot.effect.reset();
    }
}

template <class Hook>
void EffectRuntime::each(Hook hook) {
    for (std::size_t row = 0; row < slots_.size(); ++row) {
        Slot& slot = slots_[row];
        if (!slot.effect) continue;
        const TraceSpan span(table_[row].name);
        const CpuTimer timer;
        hook(*slot.effect);
        slot.earlier.cpu_ms += timer.ms();
    }
}

EffectRuntime::EffectRuntime(scene::Simulation& simulation,
                             const ServedDomains& served,
                             std::span<const EffectRow> table)
    : served_(served), table_(table), slots_(table.size()) {
    simulation.set_features({.continuous_collision = served.without != "continuous_collision",
                             .gyroscopic_torque = served.without != "gyroscopic_torque",
                             .gyro_waits_for_spin = true,
                             .contact_events = false,
                             .belts = false});
    refresh(simulation);
}

void EffectRuntime::refresh(scene::Simulation& simulation) {
    for (std::size_t row = 0; row < slots_.size(); ++row) {
        refresh_row(row, simulation);
    }
}

void EffectRuntime::before_step(scene::Simulation& simulation) {
    each([&](Effect& effect) { effect.before_step(simulation); });
}

void EffectRuntime::after_step(scene::Simulation& simulation, const scene::Game& game) {
    for (std::size_t row = 0; row < slots_.size(); ++row) {
        if (table_[row].domain == Domain::Step) refresh_row(row, simulation);
    }
    each([&](Effect& effect) { effect.after_step(simulation, game); });
}

void EffectRuntime::extract(const scene::Simulation& simulation,
                            const scene::ViewPoint& view,
                            render::RenderFrame& frame) {
    each([&](Effect& effect) { effect.extract(simulation, view, frame); });
}

SoundFrame EffectRuntime::sound(const scene::Simulation& simulation, const scene::ViewPoint& view) {
    SoundFrame frame;
    each([&](Effect& effect) { effect.sound(simulation, view, frame); });
    return frame;
}

void EffectRuntime::serialize(Archive& archive) {
    std::map<std::string, std::string> kept;
    if (!archive.reads()) {
        for (std::size_t row = 0; row < slots_.size(); ++row) {
            if (!slots_[row].effect) continue;
            Archive own;
            slots_[row].effect->serialize(own);
            if (!own.written().empty()) kept[std::string(table_[row].name)] = own.take();
        }
    }
    archive(kept);
    if (!archive.reads()) return;
    for (std::size_t row = 0; row < slots_.size(); ++row) {
        const auto found = kept.find(std::string(table_[row].name));
        if (found == kept.end() || !slots_[row].effect) continue;
        Archive own(found->second);
        slots_[row].effect->serialize(own);
        archive.expect(!own.failed() && own.left() == 0, "an effect's state is another's");
    }
}

void EffectRuntime::add_render_stats(const render::FrameStats& stats,
                                     std::span<const render::GpuBytes> bytes) {
    for (std::size_t row = 0; row < table_.size(); ++row) {
        Slot& slot = slots_[row];
        for (const render::PassTiming& pass : stats.passes) {
            if (table_[row].passes.empty() || !pass.name.starts_with(table_[row].passes)) continue;
            slot.earlier.cpu_ms += pass.cpu_ms;
            if (pass.gpu_ms >= 0.0) {
                slot.gpu_ms += pass.gpu_ms;
            } else {
                slot.gpu_unknown = true;
            }
        }
        if (table_[row].gpu_owner.empty()) continue;
        slot.bytes_gpu = 0;
        for (const render::GpuBytes& owned : bytes) {
            if (owned.owner == table_[row].gpu_owner) slot.bytes_gpu += owned.bytes;
        }
    }
}

std::vector<LedgerLine> EffectRuntime::ledger() const {
    std::vector<LedgerLine> lines;
    lines.reserve(table_.size());
    for (std::size_t row = 0; row < table_.size(); ++row) {
        const Slot& slot = slots_[row];
        LedgerLine line{.name = table_[row].name,
                        .called_for_by = slot.callers,
                        .constructions = slot.constructions,
                        .calls = slot.earlier.calls,
                        .cpu_ms = slot.earlier.cpu_ms,
                        .gpu_ms = slot.gpu_ms > 0.0 || !slot.gpu_unknown ? slot.gpu_ms : -1.0,
                        .bytes_gpu = slot.bytes_gpu,
                        .exists = slot.effect != nullptr};
        if (slot.effect) {
            line.calls += slot.effect->work().calls;
            line.cpu_ms += slot.effect->work().cpu_ms;
            line.bytes_cpu = table_[row].bytes + slot.effect->bytes_held();
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

}  // namespace plumbline::effects
