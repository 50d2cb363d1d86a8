#include "engine/app/controls/action_words.h"
#include "engine/app/controls/key_labels.h"
#include "engine/app/ui/pages.h"
#include "engine/app/ui/setting_cells.h"

#include <fmt/format.h>

#include <bitset>
#include <utility>

namespace plumbline::app::ui {

using input::PressCapture;

namespace {

/// What was down before this frame's events.
std::bitset<kKeyCount> keys_before(const InputSnapshot& input) {
    std::bitset<kKeyCount> keys = input.keys;
    for (std::size_t i = input.events.size(); i-- > 0;) {
        const DeviceEvent& event = input.events[i];
        if (event.kind == DeviceEventKind::Key && event.code >= 0 && event.code < kKeyCount)
            keys[static_cast<std::size_t>(event.code)] = !event.pressed;
    }
    return keys;
}

}  // namespace

void MenuPages::change_bindings(const std::function<void(input::Bindings&)>& change) {
    input::Bindings wanted = stored();
    change(wanted);
    ask(ChangeBindings{wanted});
    changed_bindings_ = std::move(wanted);
}

Line MenuPages::binding_line(Action action) {
    const input::Bindings& stored = this->stored();
    const input::Bindings& below = world_.bindings->below();
    Line line{.kind = LineKind::Cells, .label = std::string(action_words(action))};
    const std::vector<input::Input>& inputs = stored.of(action);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        line.cells.push_back({.text = label_of(inputs[i]),
                              .activate =
                                  [this, action, i] {
                                      wait_for_press({action, i});
                                  },
                              .remove =
                                  [this, action, i] {
                                      change_bindings([&](input::Bindings& wanted) {
                                          input::remove_input(wanted, action, i);
                                      });
                                  }});
    }
    line.cells.push_back({.text = "+", .activate = [this, action, count = inputs.size()] {
                              wait_for_press({action, count});
                          }});
    const auto index = index_of(action);
    const bool holds = stored.hold_mode[index] == input::HoldMode::Hold;
    const bool can_toggle =
        action == Action::Crouch || action == Action::Sprint || action == Action::Grab;
    if (can_toggle) {
        line.cells.push_back({.text = holds ? "hold" : "toggle", .activate = [this, index, holds] {
                                  change_bindings([&](input::Bindings& wanted) {
                                      wanted.hold_mode[index] =
                                          holds ? input::HoldMode::Toggle : input::HoldMode::Hold;
                                  });
                              }});
    }
    if (!input::same_inputs(stored, below, action) ||
        stored.hold_mode[index] != below.hold_mode[index]) {
        line.cells.push_back(reset("reset", [this, action] {
            change_bindings([&](input::Bindings& wanted) {
                input::reset_action(wanted, world_.bindings->below(), action);
            });
        }));
    }
    return line;
}

Page MenuPages::controls() {
    Page page{.title = "Controls"};
    const auto reset_all = [this] {
        change_bindings([this](input::Bindings& wanted) { wanted = world_.bindings->below(); });
    };
    page.add_cells({back_cell(), reset("Reset all", reset_all)});
    page.add_text(
        "Select a binding to replace it, + to add one; Delete removes it. Changes are saved "
        "immediately.");
    std::optional<ActionGroup> group;
    for (std::size_t i = 0; i < kActionCount; ++i) {
        const auto action = static_cast<Action>(i);
        // How one looks around is a whole stick or the mouse: no press names those.
        if (!is_offered(action) || action == Action::Look) continue;
        if (group != group_of(action)) {
            group = group_of(action);
            page.add_heading(group_words(*group));
            page.add_cells({reset("Reset group", [this, of = *group] {
                change_bindings([&](input::Bindings& wanted) {
                    input::reset_group(wanted, world_.bindings->below(), of);
                });
            })});
        }
        page.lines.push_back(binding_line(action));
    }
    return page;
}

void MenuPages::wait_for_press(Slot slot) {
    slot_ = slot;
    refused_.clear();
    wanted_.reset();
    capture_begins_ = true;
    capture_.emplace(std::bitset<kKeyCount>{});
    menu_.push([this] { return press_page(); });
}

Page MenuPages::press_page() {
    Page page{.title = fmt::format("Press a key for: {}", action_words(slot_.action)),
              .most_width = 40.0F};
    if (!refused_.empty()) page.add_text(refused_);
    page.add_text(
        "Key, mouse button, wheel, gamepad button, trigger or stick; hold Ctrl, Shift, Alt or "
        "Super for a chord. Escape cancels.");
    return page;
}

void MenuPages::take_press(const InputSnapshot& input) {
    if (std::exchange(capture_begins_, false)) capture_.emplace(keys_before(input));
    const PressCapture::State state = capture_->take(input);
    if (state == PressCapture::State::Waiting) return;
    if (state == PressCapture::State::Cancelled) {
        capture_.reset();
        return menu_.back();
    }
    const input::Input taken = capture_->taken();
    const input::Bindings& stored = this->stored();
    refused_ = input::why_not(stored, taken, slot_.action);
    if (!refused_.empty()) {
        capture_.emplace(input.keys);
        return;
    }
    capture_.reset();
    menu_.back();
    if (input::also_drives(stored, taken, slot_.action).empty()) return bind(slot_, taken);
    wanted_ = taken;
    menu_.push([this] { return conflict_page(); });
}

void MenuPages::bind(Slot slot, const input::Input& input) {
    change_bindings(
        [&](input::Bindings& wanted) { input::put_input(wanted, slot.action, slot.index, input); });
}

Page MenuPages::conflict_page() {
    Page page{.title = fmt::format("{} is already in use", label_of(*wanted_)),
              .most_width = 40.0F};
    std::string others;
    std::string unbound;
    const input::Bindings& stored = this->stored();
    for (const Action other : input::also_drives(stored, *wanted_, slot_.action)) {
        others += fmt::format("{}\"{}\"", others.empty() ? "" : " and ", action_words(other));
        if (stored.of(other).size() == 1)
            unbound += fmt::format(" \"{}\" will then have no binding.", action_words(other));
    }
    page.add_text(fmt::format("{} is bound to {}. Bind it to \"{}\" instead?{}",
                              label_of(*wanted_),
                              others,
                              action_words(slot_.action),
                              unbound));
    page.lines.push_back(
        {.kind = LineKind::List,
         .cells = {{.text = "Rebind",
                    .activate =
                        [this] {
                            bind(slot_, *wanted_);
                            menu_.back();
                        }},
                   {.text = "Cancel", .icon = Icon::Back, .activate = [this] { menu_.back(); }}}});
    return page;
}

}  // namespace plumbline::app::ui
