#include "engine/app/ui/pages.h"

#include "engine/app/controls/action_words.h"
#include "engine/app/controls/key_labels.h"
#include "engine/app/ui/setting_cells.h"
#include "engine/core/text/text_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

namespace plumbline::app::ui {
namespace {

constexpr std::string_view kHardFolder = "hard";
constexpr std::string_view kHardImage = "hard/H15";
constexpr std::string_view kBenchFolder = "bench";
constexpr std::string_view kGamesImage = "cans";

// What a newcomer needs, in the order of need; with walking they are ten.
constexpr std::array kEssentialInPlay{Action::Look,
                                      Action::Jump,
                                      Action::Drop,
                                      Action::Throw,
                                      Action::Grab,
                                      Action::UndoDrop,
                                      Action::Flashlight,
                                      Action::Reset,
                                      Action::Menu};
constexpr std::array kEssentialAtModel{Action::TurnModel,
                                       Action::ShiftModel,
                                       Action::ZoomIn,
                                       Action::ZoomOut,
                                       Action::Turntable,
                                       Action::Wireframe,
                                       Action::Grid,
                                       Action::MoveMode,
                                       Action::Screenshot,
                                       Action::Menu};

/// "hard/H05" is in "hard", "bench/peers/x" in "bench/peers"; a scene at the top in "".
std::string folder_of(const scene::ListedScene& scene) {
    const std::size_t slash = scene.name.rfind('/');
    return slash == std::string::npos ? std::string{} : scene.name.substr(0, slash);
}

std::string last_part(const std::string& name) {
    return name.substr(name.rfind('/') + 1);
}

std::string title_of(const scene::ListedScene& scene) {
    return scene.title.empty() ? last_part(scene.name) : scene.title;
}

/// Of "4. Depth test"; 0 where the title has none.
int number_of(const std::string& title) {
    int number = 0;
    const char* end = title.data() + title.size();
    const auto read = std::from_chars(title.data(), end, number);
    return read.ec == std::errc{} && std::string_view(read.ptr, end).starts_with(". ") ? number : 0;
}

/// "book" reads "Book"; "book/nature" "Book: nature".
std::string folder_words(std::string name) {
    std::ranges::replace(name, '_', ' ');
    const std::size_t slash = name.find('/');
    if (slash != std::string::npos) name.replace(slash, 1, ": ");
    if (!name.empty()) name[0] = to_upper(name[0]);
    return name;
}

}  // namespace

Cell MenuPages::to_page(std::string text, Icon icon, Page (MenuPages::*page)()) {
    return {.text = std::move(text), .icon = icon, .activate = [this, page] {
                menu_.push([this, page] { return (this->*page)(); });
            }};
}

Cell MenuPages::back_cell() {
    return {.text = "Back", .icon = Icon::Back, .activate = [this] { menu_.back(); }};
}

std::vector<Cell> MenuPages::cards(const std::string& folder, bool are_users_own) {
    std::vector<Cell> cells;
    for (const scene::ListedScene& scene : *world_.scenes) {
        if (folder_of(scene) != folder || scene.is_users_own != are_users_own) continue;
        // Copies have the titles of what they were made of.
        cells.push_back({.text = are_users_own ? scene.name : title_of(scene),
                         .note = are_users_own ? title_of(scene) : scene.description,
                         .thumbnail = scene.name,
                         .activate = [this, file = scene.file] { ask(OpenScene{file}); }});
    }
    // Lessons stand in their own order, all else by name.
    std::ranges::stable_sort(
        cells, std::ranges::less{}, [](const Cell& cell) { return number_of(cell.text); });
    return cells;
}

void MenuPages::add_scenes(Page& page) {
    page.add_heading("Scenes");
    std::vector<Cell> shipped = cards({}, false);
    if (std::ranges::any_of(*world_.scenes, &scene::ListedScene::is_game)) {
        Cell all = to_page("Games", Icon::None, &MenuPages::games);
        all.note = "Small games against the clock: aim, build, ferry. Best times are kept";
        all.thumbnail = kGamesImage;
        shipped.insert(std::next(shipped.begin(), std::min<std::ptrdiff_t>(1, std::ssize(shipped))),
                       std::move(all));
    }
    std::map<std::string, std::vector<const scene::ListedScene*>> folders;
    for (const scene::ListedScene& scene : *world_.scenes)
        folders[folder_of(scene)].push_back(&scene);
    for (const auto& [name, scenes] : folders) {
        if (name.empty() || name.starts_with(kBenchFolder)) continue;
        if (std::ranges::all_of(scenes, &scene::ListedScene::is_game)) continue;  // a page has them
        const bool hard = name == kHardFolder;
        shipped.push_back(
            {.text = hard ? "Hard cases" : folder_words(name),
             .note = hard ? fmt::format("{} stress tests of the solver, each with pass rules that "
                                        "are checked live",
                                        scenes.size())
                          : fmt::format("{} scenes", scenes.size()),
             .thumbnail = hard ? std::string(kHardImage) : scenes.front()->name,
             .activate = [this, folder = name] {
                 menu_.push([this, folder] { return this->folder(folder); });
             }});
    }
    page.add_cards(std::move(shipped));
    if (std::vector<Cell> own = cards({}, true); !own.empty()) {
        page.add_heading("Your scenes");
        page.add_cards(std::move(own));
    }
}

Page MenuPages::games() {
    Page page{.title = "Games"};
    page.add_cells({back_cell()});
    std::vector<Cell> cells;
    for (const scene::ListedScene& scene : *world_.scenes) {
        if (!scene.is_game) continue;
        const auto best_s =
            world_.results != nullptr ? world_.results->of(last_part(scene.name)) : std::nullopt;
        cells.push_back({.text = title_of(scene),
                         .note = fmt::format("{}\n{}",
                                             best_s ? fmt::format("Best: {:.1f} s", *best_s)
                                                    : std::string("Not won yet"),
                                             scene.description),
                         .thumbnail = scene.name,
                         .activate = [this, file = scene.file] { ask(OpenScene{file}); },
                         .marked = best_s.has_value()});
    }
    page.add_cards(std::move(cells));
    return page;
}

Page MenuPages::folder(const std::string& name) {
    const bool hard = name == kHardFolder;
    Page page{.title = hard ? "Hard cases" : folder_words(name)};
    page.add_cells({back_cell()});
    for (const bool own : {false, true}) {
        if (std::vector<Cell> cells = cards(name, own); !cells.empty())
            page.add_cards(std::move(cells));
    }
    return page;
}

Page MenuPages::start() {
    Page page{.title = "Plumbline"};
    page.add_cells({{.text = fmt::format("Continue: {}", world_.scene_title),
                     .icon = Icon::Play,
                     .activate = [this] { menu_.close(); },
                     .marked = true},
                    to_page("Settings", Icon::Settings, &MenuPages::settings),
                    to_page("Controls", Icon::Keys, &MenuPages::controls),
                    to_page("Help", Icon::Help, &MenuPages::help),
                    {.text = "Quit", .icon = Icon::Quit, .activate = [this] { ask(Quit{}); }}});
    add_scenes(page);
    return page;
}

Page MenuPages::in_play() {
    Page page{.title = world_.scene_title, .most_width = 26.0F};
    page.lines.push_back(
        {.kind = LineKind::List,
         .cells = {{.text = "Resume", .icon = Icon::Play, .activate = [this] { menu_.close(); }},
                   {.text = "Reset scene",
                    .icon = Icon::Again,
                    .activate =
                        [this] {
                            ask(WorldRequest{StartAgain{}});
                            menu_.close();
                        }},
                   to_page("Scenes", Icon::Scenes, &MenuPages::all_scenes),
                   to_page("Settings", Icon::Settings, &MenuPages::settings),
                   to_page("Controls", Icon::Keys, &MenuPages::controls),
                   to_page("Help", Icon::Help, &MenuPages::help),
                   to_page("Saved games", Icon::Save, &MenuPages::saved_games),
                   {.text = "Quit", .icon = Icon::Quit, .activate = [this] { ask(Quit{}); }}}});
    return page;
}

Page MenuPages::saved_games() {
    Page page{.title = fmt::format("Saved games: {}", world_.scene_title), .most_width = 32.0F};
    page.add_cells({back_cell(), {.text = "Save as level", .icon = Icon::Save, .activate = [this] {
                                      ask(SaveLevel{});
                                      menu_.close();
                                  }}});
    for (const SaveSlot& slot : world_.saves) {
        Line line{
            .kind = LineKind::Cells,
            .label = fmt::format("{}  {}", slot.number, slot.saved.empty() ? "empty" : slot.saved)};
        line.cells.push_back({.text = "Save",
                              .activate =
                                  [this, number = slot.number] {
                                      ask(SaveGame{number});
                                      menu_.close();
                                  },
                              .marked = slot.is_latest});
        if (!slot.saved.empty()) {
            line.cells.push_back({.text = "Load", .activate = [this, number = slot.number] {
                                      ask(LoadGame{number});
                                      menu_.close();
                                  }});
        }
        page.lines.push_back(std::move(line));
    }
    return page;
}

Page MenuPages::all_scenes() {
    Page page{.title = "Scenes"};
    page.add_cells({back_cell()});
    add_scenes(page);
    return page;
}

Page MenuPages::help() {
    Page page{.title = "Help"};
    page.add_cells({back_cell(),
                    to_page("Controls", Icon::Keys, &MenuPages::controls),
                    reset("Reset hints", [this] { ask(ShowHintsAgain{}); })});
    const input::Bindings& bindings = this->bindings().current();
    const bool at_model = world_.looks_at_model;
    const std::span<const Action> essential = at_model ? std::span<const Action>(kEssentialAtModel)
                                                       : std::span<const Action>(kEssentialInPlay);
    page.add_heading("Essentials");
    if (!at_model) page.add_keys(walk_labels(bindings, input::LastDevice::KeyboardMouse), "Move");
    for (const Action action : essential)
        page.add_keys(all_labels(bindings, action, has_pad_), action_words(action));
    constexpr std::array kGroups{ActionGroup::Walk,
                                 ActionGroup::Things,
                                 ActionGroup::View,
                                 ActionGroup::Light,
                                 ActionGroup::CameraPath,
                                 ActionGroup::Time,
                                 ActionGroup::Menu};
    for (const ActionGroup group : kGroups) add_help_group(page, group, essential);
    return page;
}

void MenuPages::add_help_group(Page& page, ActionGroup group, std::span<const Action> shown_above) {
    const input::Bindings& bindings = this->bindings().current();
    const bool at_model = world_.looks_at_model;
    bool has_heading = false;
    for (std::size_t i = 0; i < kActionCount; ++i) {
        const auto action = static_cast<Action>(i);
        if (group_of(action) != group || !is_offered(action)) continue;
        if (at_model ? !is_for_models(action) : !is_for_play(action)) continue;
        if (std::ranges::find(shown_above, action) != shown_above.end()) continue;
        std::string keys = all_labels(bindings, action, has_pad_);
        if (keys == kUnbound) continue;
        if (!std::exchange(has_heading, true)) page.add_heading(group_words(group));
        page.add_keys(std::move(keys), action_words(action));
    }
}

}  // namespace plumbline::app::ui
