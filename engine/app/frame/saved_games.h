// The numbered slots of a scene's saved games.
#pragma once

#include "engine/app/session.h"
#include "engine/app/ui/pages.h"

#include <filesystem>
#include <string>
#include <vector>

namespace plumbline::app {

class SavedGames {
public:
    /// `user_data_folder` empty: there is no place for any. The session must outlive it.
    SavedGames(const Session& session, std::filesystem::path user_data_folder);

    /// Makes the slot the one used last; 0 leaves that. Its file.
    std::filesystem::path choose(int slot);
    int chosen() const { return chosen_; }
    bool has_folder() const { return !user_data_folder_.empty(); }

    /// Looks which slots hold games.
    void refresh();
    /// As they were at the last refresh().
    const std::vector<ui::SaveSlot>& slots() const { return slots_; }
    /// "; slots with saved games: 2, 5", without the chosen one; empty where there is none.
    std::string others() const;

private:
    const Session& session_;
    std::filesystem::path user_data_folder_;
    int chosen_{1};
    std::vector<ui::SaveSlot> slots_;
};

}  // namespace plumbline::app
