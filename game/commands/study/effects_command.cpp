#include "game/commands/study/effects_command.h"

#include "engine/core/log.h"
#include "engine/core/process/interrupt.h"
#include "engine/core/time/stopwatch.h"
#include "engine/study/scenes/effects_cost.h"
#include "game/offscreen/offscreen_studio.h"

#include <array>
#include <utility>

namespace plumbline::game {
namespace {

constexpr int kFramesOfAPass = 6;
constexpr int kFramesToWarmUp = 2;

/// Draws the scene with and without an effect of the image, in turns.
class EffectImages {
public:
    explicit EffectImages(OffscreenStudio studio) : studio_(std::move(studio)) {}

    /// One line for each effect of the image that something calls for.
    std::vector<study::EffectCost> measure(int pairs) {
        frames({});
        const std::vector<effects::LedgerLine> ledger = session().effects->ledger();
        std::vector<study::EffectCost> costs;
        for (std::size_t row = 0; row < ledger.size(); ++row) {
            const effects::EffectRow& definition = effects::effect_table()[row];
            if (definition.domain != effects::Domain::Frame || ledger[row].constructions == 0)
                continue;
            if (interrupted()) break;
            costs.push_back({.name = std::string(definition.name),
                             .caller = ledger[row].called_for_by.empty()
                                           ? std::string()
                                           : ledger[row].called_for_by.front(),
                             .domain = std::string(study::word_of(definition.domain)),
                             .frame_ms = difference(definition.name, pairs),
                             .calls = ledger[row].calls,
                             .bytes_cpu = ledger[row].bytes_cpu,
                             .bytes_gpu = ledger[row].bytes_gpu});
        }
        return costs;
    }

private:
    study::Difference difference(std::string_view name, int pairs) {
        std::array<std::vector<double>, 2> ms;
        for (int i = 0; i < 2 * pairs && !interrupted(); ++i) {
            const auto without = static_cast<std::size_t>((i + i / 2) % 2);
            ms[without].push_back(frames(without == 1 ? name : std::string_view()));
        }
        return study::paired_difference(ms[0], ms[1]);
    }

    /// CPU ms of a frame, of all threads: software GL draws in several. The image is read back at
    /// the end so that it is really there.
    double frames(std::string_view without) {
        session().effects = std::make_unique<effects::EffectRuntime>(
            *session().simulation, effects::ServedDomains{.frame = true, .without = without});
        for (int i = 0; i < kFramesToWarmUp; ++i) draw();
        studio_.run->pixels();
        double drawing_s = 0;
        for (int i = 0; i < kFramesOfAPass; ++i) {
            studio_.run->simulate(1);
            const double start_s = process_cpu_s();
            draw();
            if (i + 1 == kFramesOfAPass) studio_.run->pixels();
            drawing_s += process_cpu_s() - start_s;
        }
        return drawing_s * 1e3 / kFramesOfAPass;
    }
    /// Cannot fail any more: the studio has drawn already.
    void draw() { static_cast<void>(studio_.run->draw()); }
    app::Session& session() { return *studio_.session; }

    OffscreenStudio studio_;
};

}  // namespace

Result<study::EffectFindings> study_effects(const std::filesystem::path& scene,
                                            std::optional<double> seconds) {
    study::EffectsRun run{.scene = scene};
    run.seconds = seconds.value_or(run.seconds);
    Result<std::vector<study::EffectCost>> costs = study::measure_effects(run, 1);
    if (!costs) return costs.error();
    study::EffectFindings findings{.scene = scene.filename().string(),
                                   .seconds = run.seconds,
                                   .pairs = run.pairs,
                                   .rows = std::move(*costs)};
    if (interrupted()) return findings;
    Result<OffscreenStudio> studio = OffscreenStudio::open(scene);
    if (!studio) {
        log_warning("effects of the image are left out: {}", studio.error().message);
        return findings;
    }
    findings.width_px = kStudioWidth_px;
    findings.height_px = kStudioHeight_px;
    const std::vector<study::EffectCost> image =
        EffectImages(std::move(*studio)).measure(run.pairs);
    findings.rows.insert(findings.rows.begin(), image.begin(), image.end());
    return findings;
}

}  // namespace plumbline::game
