#include "engine/app/frame/saved_games.h"

#include "engine/effects/saved_game.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <utility>

namespace plumbline::app {
namespace fs = std::filesystem;

SavedGames::SavedGames(const Session& session, fs::path user_data_folder)
    : session_(session), user_data_folder_(std::move(user_data_folder)) {
    refresh();
}

fs::path SavedGames::choose(int slot) {
    if (slot > 0) chosen_ = slot;
    return effects::save_slot(
        user_data_folder_, session_.folders().assets, session_.description().file, chosen_);
}

void SavedGames::refresh() {
    slots_.clear();
    for (int number = 1; number <= effects::kSaveSlots; ++number) {
        ui::SaveSlot slot{.number = number, .is_latest = number == chosen_};
        std::error_code failed;
        const auto written = fs::last_write_time(
            effects::save_slot(
                user_data_folder_, session_.folders().assets, session_.description().file, number),
            failed);
        if (!failed) {
            const auto at = std::chrono::time_point_cast<std::chrono::seconds>(
                std::chrono::file_clock::to_sys(written));
            slot.saved = fmt::format("{:%Y-%m-%d %H:%M}",
                                     fmt::localtime(std::chrono::system_clock::to_time_t(at)));
        }
        slots_.push_back(std::move(slot));
    }
}

std::string SavedGames::others() const {
    std::string numbers;
    for (const ui::SaveSlot& slot : slots_) {
        if (slot.number == chosen_ || slot.saved.empty()) continue;
        numbers += fmt::format("{}{}", numbers.empty() ? "" : ", ", slot.number);
    }
    return numbers.empty() ? "" : fmt::format("; slots with saved games: {}", numbers);
}

}  // namespace plumbline::app
