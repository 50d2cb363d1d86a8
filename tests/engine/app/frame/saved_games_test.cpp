#include "engine/app/frame/saved_games.h"

#include "engine/effects/saved_game.h"
#include "tests/engine/app/session_fixture.h"

namespace plumbline::app {
namespace {

TEST_F(SessionTest, SavedGamesKnowsWhichSlotsHoldGames) {
    const auto session = open();
    ASSERT_TRUE(session);
    EXPECT_FALSE(SavedGames(*session, {}).has_folder());
    SavedGames games(*session, folder_.path() / "data");
    EXPECT_TRUE(games.has_folder());
    ASSERT_EQ(games.slots().size(), static_cast<std::size_t>(effects::kSaveSlots));
    for (const ui::SaveSlot& slot : games.slots()) EXPECT_EQ(slot.saved, "");
    EXPECT_EQ(games.others(), "");
    for (const int slot : {2, 5}) ASSERT_TRUE(session->save(games.choose(slot), 0).ok());
    EXPECT_EQ(games.choose(0), games.choose(5)) << "the one used last";
    games.refresh();
    EXPECT_EQ(games.others(), "; slots with saved games: 2");
    for (const ui::SaveSlot& slot : games.slots()) {
        EXPECT_EQ(slot.saved.empty(), slot.number != 2 && slot.number != 5);
        EXPECT_EQ(slot.is_latest, slot.number == 5);
    }
    games.choose(1);
    games.refresh();
    EXPECT_EQ(games.others(), "; slots with saved games: 2, 5");
}

}  // namespace
}  // namespace plumbline::app
