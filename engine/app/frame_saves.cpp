// Saved games, in numbered slots of each scene.
#include "engine/app/frame_parts_impl.h"
#include "engine/core/log.h"
#include "engine/effects/saved_game.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

namespace plumbline::app {
namespace fs = std::filesystem;
namespace {

/// "; slots 2, 5 hold games"; where the one that was wanted is refused.
std::string other_slots(const std::vector<ui::SaveSlot>& slots, int refused) {
    std::string numbers;
    for (const ui::SaveSlot& slot : slots) {
        if (slot.number == refused || slot.saved.empty()) continue;
        numbers += fmt::format("{}{}", numbers.empty() ? "" : ", ", slot.number);
    }
    return numbers.empty() ? "" : fmt::format("; slots with saved games: {}", numbers);
}

}  // namespace

fs::path FrameParts::file_of_slot(int slot) const {
    return effects::save_slot(
        def_.user_data_folder, session_.folders().assets, session_.description().file, slot);
}

void FrameParts::save_game(int slot) {
    if (slot > 0) save_slot_ = slot;
    if (def_.user_data_folder.empty())
        return say("cannot save: no user data folder (XDG_DATA_HOME and HOME are not set)");
    const fs::path file = file_of_slot(save_slot_);
    const Result<Done> saved = session_.save(file, stepper.steps());
    if (!saved) log_error("{}", saved.error().message);
    say(saved ? fmt::format("saved to slot {}: {}", save_slot_, file.string())
              : saved.error().message);
}

void FrameParts::load_game(int slot) {
    if (stepper.replaying()) return say("not available during a replay");
    if (slot > 0) save_slot_ = slot;
    const fs::path file = file_of_slot(save_slot_);
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return say(fmt::format("slot {} is empty", save_slot_));
    const study::Setting before = accuracy_.setting();
    std::uint64_t steps = 0;
    const Result<Done> loaded = within_memory([&]() -> Result<Done> {
        const Result<std::uint64_t> done = session_.load(file);
        if (!done) return done.error();
        steps = *done;
        return Done{};
    });
    if (!loaded) {
        log_error("{}", loaded.error().message);
        return say(loaded.error().message + other_slots(save_slots(), save_slot_));
    }
    stepper.begin_anew(steps);
    accuracy_.after_load(before, clock);
    resumes_toggles_ = true;
    say(fmt::format(
        "slot {} loaded ({:.1f} s into the scene)", save_slot_, session_.simulation->time_s()));
}

std::vector<ui::SaveSlot> FrameParts::save_slots() const {
    std::vector<ui::SaveSlot> slots;
    for (int number = 1; number <= effects::kSaveSlots; ++number) {
        ui::SaveSlot slot{.number = number, .is_latest = number == save_slot_};
        const fs::path file = file_of_slot(number);
        std::error_code failed;
        const auto written = fs::last_write_time(file, failed);
        if (!failed) {
            const auto at = std::chrono::time_point_cast<std::chrono::seconds>(
                std::chrono::file_clock::to_sys(written));
            slot.saved = fmt::format("{:%Y-%m-%d %H:%M}",
                                     fmt::localtime(std::chrono::system_clock::to_time_t(at)));
        }
        slots.push_back(std::move(slot));
    }
    return slots;
}

}  // namespace plumbline::app
