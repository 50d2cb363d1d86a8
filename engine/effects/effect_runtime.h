// The effects of one run: made when the first caller appears, destroyed when the last one goes, also
// in mid-game; and the ledger that says what each cost.
#pragma once

#include "engine/effects/effect_table.h"
#include "engine/render/renderer.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::effects {

struct LedgerLine {
    std::string_view name;
    Callers called_for_by;  ///< now; empty where its domain is not served
    std::uint32_t constructions{0};
    std::uint64_t calls{0};  ///< times it did anything: steps, extractions, sounds, swept bodies
    double cpu_ms{0};
    double gpu_ms{0};  ///< -1: passes ran and the driver does not tell
    std::uint64_t bytes_cpu{0};
    std::uint64_t bytes_gpu{0};
    bool exists{false};  ///< now
};

struct ServedDomains {
    bool frame{false};
    bool sound{false};
    /// Name of an effect that is not made, whoever calls for it: to see what it costs. Outlives us.
    std::string_view without{};
};

class EffectRuntime {
public:
    /// `simulation` must outlive it, and so must the rows. Takes over the optional parts of its
    /// physics.
    EffectRuntime(scene::Simulation& simulation,
                  const ServedDomains& served,
                  std::span<const EffectRow> table = effect_table());
    EffectRuntime(const EffectRuntime&) = delete;
    EffectRuntime& operator=(const EffectRuntime&) = delete;

    /// Makes and destroys effects as callers come and go. Called at the start of every step, and
    /// before extraction by whoever changed what callers look at since; cheap when nothing changed.
    void refresh(scene::Simulation& simulation);

    void before_step(scene::Simulation& simulation);
    void after_step(scene::Simulation& simulation, const scene::Game& game);
    void extract(const scene::Simulation& simulation,
                 const scene::ViewPoint& view,
                 render::RenderFrame& frame);
    SoundFrame sound(const scene::Simulation& simulation, const scene::ViewPoint& view);

    /// What saved games keep of the effects there are. When read: each takes up its own; those that
    /// this run does not serve are passed over.
    void serialize(Archive& archive);

    /// Adds what the renderer measured for the effects' passes and memory.
    void add_render_stats(const render::FrameStats& stats, std::span<const render::GpuBytes> bytes);

    /// One line per row of the table, in its order, whether or not it exists.
    std::vector<LedgerLine> ledger() const;

private:
    /// What an effect's callers depend on: while it stays the same, so do they.
    struct CallersKey {
        std::uint64_t revision{0};
        std::optional<bool> switched{};
        std::uint64_t own{0};

        friend bool operator==(const CallersKey&, const CallersKey&) = default;
    };
    /// One row's effect, while there is one, and what it cost.
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

    static CallersKey key_of(const EffectRow& row, const scene::Simulation& simulation);
    bool serves(Domain domain) const;
    void refresh_row(std::size_t row, scene::Simulation& simulation);
    /// Runs one hook of every effect there is and books its time.
    template <class Hook>
    void each(Hook hook);

    ServedDomains served_;
    std::span<const EffectRow> table_;
    std::vector<Slot> slots_;
};

/// The ledger as a JSON array, as reports hold it.
std::string ledger_json(const std::vector<LedgerLine>& ledger);
/// And as a table for people (`plumbline explain`).
std::string ledger_table(const std::vector<LedgerLine>& ledger);

}  // namespace plumbline::effects
