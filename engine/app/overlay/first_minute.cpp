#include "engine/app/overlay/first_minute.h"

#include "engine/core/io/files.h"
#include "engine/core/log.h"

#include <sstream>
#include <utility>

namespace plumbline::app {
namespace {

enum class Where : std::uint8_t { Playing, AtModel, ByPointer, Anywhere };

struct Row {
    FirstStep step;
    Where where;
    Action action;
    std::string_view name;  ///< in the file
    std::string_view words;
    std::uint64_t presses;  ///< that count as done
};
using enum Where;
// A look is counted once a frame that turned the view: a nudge of the mouse is not yet looking.
constexpr std::array<Row, static_cast<std::size_t>(FirstStep::Count)> kRows{
    {{FirstStep::Look, Playing, Action::Look, "look", "look around", 10},
     {FirstStep::Walk, Playing, Action::Forward, "walk", "walk", 1},
     {FirstStep::Drop, Playing, Action::Drop, "drop", "drop an object", 1},
     {FirstStep::Throw, Playing, Action::Throw, "throw", "throw one (hold to throw harder)", 1},
     {FirstStep::Grab, Playing, Action::Grab, "grab", "grab what you look at, and release it", 1},
     {FirstStep::Flashlight,
      Playing,
      Action::Flashlight,
      "flashlight",
      "turn the flashlight on",
      1},
     {FirstStep::TurnModel, AtModel, Action::TurnModel, "turn", "rotate the model (hold)", 1},
     {FirstStep::ShiftModel, AtModel, Action::ShiftModel, "shift", "pan the model (hold)", 1},
     {FirstStep::ComeNear, AtModel, Action::ZoomIn, "near", "zoom in", 1},
     {FirstStep::TurnAbout, ByPointer, Action::RotateLeft, "turn_about", "rotate the view", 1},
     {FirstStep::Drag,
      ByPointer,
      Action::Grab,
      "drag",
      "drag the object under the pointer (hold)",
      1},
     {FirstStep::Shoot, ByPointer, Action::Shoot, "shoot", "shoot at the pointer", 1},
     {FirstStep::Menu,
      Anywhere,
      Action::Menu,
      "menu",
      "open the menu (scenes, settings, controls)",
      1}}};

const Row& row_of(FirstStep step) {
    return kRows[static_cast<std::size_t>(step)];
}

}  // namespace

FirstMinute::FirstMinute(std::filesystem::path file) : file_(std::move(file)) {
    constexpr std::size_t kMostBytes = 4096;
    if (file_.empty()) return;
    const Result<std::string> text = read_file(file_, kMostBytes);
    if (!text) return;  // never played before, or not readable: all is said
    std::istringstream words(*text);
    for (std::string word; words >> word;) {
        for (const Row& row : kRows)
            if (row.name == word) done_.set(static_cast<std::size_t>(row.step));
    }
}

void FirstMinute::see(const std::array<std::uint64_t, kActionCount>& presses) {
    // After forget() only what is done from then on counts.
    if (std::exchange(counts_from_here_, false)) seen_ = presses;
    const auto before = done_;
    for (const Row& row : kRows) {
        const auto i = index_of(row.action);
        std::uint64_t made = presses[i] - seen_[i];
        if (row.step == FirstStep::Walk) {
            for (const Action other : {Action::Back, Action::Left, Action::Right}) {
                const auto j = index_of(other);
                made += presses[j] - seen_[j];
            }
        }
        if (made >= row.presses) done_.set(static_cast<std::size_t>(row.step));
    }
    if (done_ != before) store();
}

std::optional<FirstStep> FirstMinute::now(const HintScene& scene) const {
    const Where here = scene.looks_at_model ? AtModel : scene.by_pointer ? ByPointer : Playing;
    for (const Row& row : kRows) {
        if (done_[static_cast<std::size_t>(row.step)]) continue;
        if (row.step == FirstStep::Flashlight && !scene.has_flashlight) continue;
        if (row.where == here || row.where == Anywhere) return row.step;
    }
    return std::nullopt;
}

void FirstMinute::forget() {
    done_.reset();
    counts_from_here_ = true;
    store();
}

void FirstMinute::store() const {
    if (file_.empty()) return;
    std::string text;
    for (const Row& row : kRows) {
        if (done_[static_cast<std::size_t>(row.step)]) text += std::string(row.name) + '\n';
    }
    const Result<Done> written = write_file_and_folder(file_, text);
    // The hints come again next time: not worth a message to somebody who is about to play.
    if (!written) log_note("{}", written.error().message);
}

std::string_view step_words(FirstStep step) {
    return row_of(step).words;
}

Action action_of(FirstStep step) {
    return row_of(step).action;
}

}  // namespace plumbline::app
