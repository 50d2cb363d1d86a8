#include "engine/app/controls/action_words.h"

namespace plumbline::app {

bool is_offered(Action action) {
    switch (action) {
        case Action::Select8:
        case Action::Select9:
            return false;
        default:
            return true;
    }
}

bool is_for_models(Action action) {
    switch (action) {
        case Action::Look:
        case Action::Jump:
        case Action::Crouch:
        case Action::Sprint:
            return false;
        default:
            return group_of(action) != ActionGroup::Things;
    }
}

bool is_for_play(Action action) {
    switch (action) {
        case Action::Grid:
        case Action::Axes:
        case Action::Normals:
        case Action::Turntable:
        case Action::Ground:
        case Action::Background:
        case Action::TurnModel:
        case Action::ShiftModel:
            return false;
        default:
            return true;
    }
}

}  // namespace plumbline::app
