#include "engine/app/controls/action_words.h"

#include <algorithm>
#include <array>

namespace plumbline::app {

bool is_offered(Action action) {
    return action != Action::Select8 && action != Action::Select9;
}

bool is_for_models(Action action) {
    constexpr std::array kWalkers{Action::Look, Action::Jump, Action::Crouch, Action::Sprint};
    return group_of(action) != ActionGroup::Things &&
           std::ranges::find(kWalkers, action) == kWalkers.end();
}

bool is_for_play(Action action) {
    constexpr std::array kViewers{Action::Grid,
                                  Action::Axes,
                                  Action::Normals,
                                  Action::Turntable,
                                  Action::Ground,
                                  Action::Background,
                                  Action::TurnModel,
                                  Action::ShiftModel};
    return std::ranges::find(kViewers, action) == kViewers.end();
}

}  // namespace plumbline::app
