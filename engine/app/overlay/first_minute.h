// What a person can do, said one thing at a time until it has been done; remembered, so that it
// does not come again.
#pragma once

#include "engine/core/actions.h"

#include <array>
#include <bitset>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace plumbline::app {

/// In the order in which they are said.
enum class FirstStep : std::uint8_t {
    Look,
    Walk,
    Drop,
    Throw,
    Grab,
    Flashlight,
    TurnModel,
    ShiftModel,
    ComeNear,
    TurnAbout,
    Drag,
    Shoot,
    Menu,
    Count
};

/// What decides which steps there are.
struct HintScene {
    bool has_flashlight{false};
    bool looks_at_model{false};  ///< a model by itself is turned: nobody walks among things
    bool by_pointer{false};  ///< the pointer is free: hands go where it is, no mouse looks around
};

class FirstMinute {
public:
    /// What was done before stands in `file`; empty: nothing is remembered. Damaged files count as
    /// empty ones.
    explicit FirstMinute(std::filesystem::path file);

    /// Presses since the start of the session, as the latch counts them. Stores what is new.
    void see(const std::array<std::uint64_t, kActionCount>& presses);
    /// The step to say; nothing when all has been done.
    std::optional<FirstStep> now(const HintScene& scene) const;
    void forget();  ///< says all of it again

private:
    void store() const;

    std::filesystem::path file_;
    std::bitset<static_cast<std::size_t>(FirstStep::Count)> done_;
    std::array<std::uint64_t, kActionCount> seen_{};  ///< presses that do not count
    bool counts_from_here_{false};
};

std::string_view step_words(FirstStep step);  ///< "look around"
Action action_of(FirstStep step);

}  // namespace plumbline::app
