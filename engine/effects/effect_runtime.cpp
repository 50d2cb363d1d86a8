#include "engine/effects/effect_runtime.h"

#include "engine/core/io/archive.h"
#include "engine/core/time/stopwatch.h"

#include <map>

namespace plumbline::effects {

namespace {

/// What an effect's callers depend on: while it stays the same, so do they.
struct CallersKey {
    std::uint64_t revision{0};
    std::optional<bool> switched{};
    std::uint64_t own{0};

    friend bool operator==(const CallersKey&, const CallersKey&) = default;
};

CallersKey key_of(const EffectRow& row, const scene::Simulation& simulation) {
    CallersKey key{.revision = simulation.revision()};
    const auto switched = simulation.switches.effects.find(row.name);
    if (switched != simulation.switches.effects.end()) key.switched = switched->second;
    if (row.key != nullptr) key.own = row.key(simulation);
    return key;
}

struct Slot {
    std::unique_ptr<Effect> effect;
    Callers callers;
    std::optional<CallersKey> key;  ///< that `callers` are of
    std::uint32_t constructions{0};
    EffectWork earlier;  ///< of effects that are gone, and of the hooks
    double gpu_ms{0};
    bool gpu_unknown{false};
    std::uint64_t bytes_gpu{0};
};

}  // namespace

struct EffectRuntime::Impl {
    ServedDomains served;
    std::span<const EffectRow> table;
    std::vector<Slot> slots;

    bool serves(Domain domain) const {
        switch (domain) {
            case Domain::Step:
                return true;
            case Domain::Frame:
                return served.frame;
            case Domain::Sound:
                return served.sound;
        }
        return false;
    }

    void refresh_row(std::size_t row, scene::Simulation& simulation) {
        const EffectRow& definition = table[row];
        if (!serves(definition.domain) || definition.name == served.without) return;
        Slot& slot = slots[row];
        CallersKey key = key_of(definition, simulation);
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

    /// Runs one hook of every effect there is and books its time.
    template <class Hook>
    void each(Hook hook) {
        for (Slot& slot : slots) {
            if (!slot.effect) continue;
            const CpuTimer timer;
            hook(*slot.effect);
            slot.earlier.cpu_ms += timer.ms();
        }
    }
};

EffectRuntime::EffectRuntime(scene::Simulation& simulation,
                             const ServedDomains& served,
                             std::span<const EffectRow> table)
    : impl_(std::make_unique<Impl>()) {
    impl_->served = served;
    impl_->table = table;
    impl_->slots.resize(table.size());
    simulation.set_features({.continuous_collision = served.without != "continuous_collision",
                             .gyroscopic_torque = served.without != "gyroscopic_torque",
                             .gyro_waits_for_spin = true,
                             .contact_events = false});
    refresh(simulation);
}

EffectRuntime::~EffectRuntime() = default;

void EffectRuntime::refresh(scene::Simulation& simulation) {
    for (std::size_t row = 0; row < impl_->slots.size(); ++row) {
        impl_->refresh_row(row, simulation);
    }
}

void EffectRuntime::before_step(scene::Simulation& simulation) {
    impl_->each([&](Effect& effect) { effect.before_step(simulation); });
}

void EffectRuntime::after_step(scene::Simulation& simulation, const scene::Game& game) {
    for (std::size_t row = 0; row < impl_->slots.size(); ++row) {
        if (impl_->table[row].domain == Domain::Step) impl_->refresh_row(row, simulation);
    }
    impl_->each([&](Effect& effect) { effect.after_step(simulation, game); });
}

void EffectRuntime::extract(const scene::Simulation& simulation,
                            const scene::ViewPoint& view,
                            render::RenderFrame& frame) {
    impl_->each([&](Effect& effect) { effect.extract(simulation, view, frame); });
}

SoundFrame EffectRuntime::sound(const scene::Simulation& simulation, const scene::ViewPoint& view) {
    SoundFrame frame;
    impl_->each([&](Effect& effect) { effect.sound(simulation, view, frame); });
    return frame;
}

void EffectRuntime::serialize(Archive& archive) {
    std::map<std::string, std::string> kept;
    if (!archive.reads()) {
        for (std::size_t row = 0; row < impl_->slots.size(); ++row) {
            if (!impl_->slots[row].effect) continue;
            Archive own;
            impl_->slots[row].effect->serialize(own);
            if (!own.written().empty()) kept[std::string(impl_->table[row].name)] = own.take();
        }
    }
    archive(kept);
    if (!archive.reads()) return;
    for (std::size_t row = 0; row < impl_->slots.size(); ++row) {
        const auto found = kept.find(std::string(impl_->table[row].name));
        if (found == kept.end() || !impl_->slots[row].effect) continue;
        Archive own(found->second);
        impl_->slots[row].effect->serialize(own);
        archive.expect(!own.failed() && own.left() == 0, "an effect's state is another's");
    }
}

void EffectRuntime::add_render_stats(const render::FrameStats& stats,
                                     std::span<const render::GpuBytes> bytes) {
    const std::span<const EffectRow> table = impl_->table;
    for (std::size_t row = 0; row < table.size(); ++row) {
        Slot& slot = impl_->slots[row];
        for (const render::PassTiming& pass : stats.passes) {
            if (table[row].passes.empty() || !pass.name.starts_with(table[row].passes)) continue;
            slot.earlier.cpu_ms += pass.cpu_ms;
            if (pass.gpu_ms >= 0.0) {
                slot.gpu_ms += pass.gpu_ms;
            } else {
                slot.gpu_unknown = true;
            }
        }
        if (table[row].gpu_owner.empty()) continue;
        slot.bytes_gpu = 0;
        for (const render::GpuBytes& owned : bytes) {
            if (owned.owner == table[row].gpu_owner) slot.bytes_gpu += owned.bytes;
        }
    }
}

std::vector<LedgerLine> EffectRuntime::ledger() const {
    const std::span<const EffectRow> table = impl_->table;
    std::vector<LedgerLine> lines;
    lines.reserve(table.size());
    for (std::size_t row = 0; row < table.size(); ++row) {
        const Slot& slot = impl_->slots[row];
        LedgerLine line{.name = table[row].name,
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
            line.bytes_cpu = slot.effect->bytes_cpu();
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

}  // namespace plumbline::effects
