// One bindings file as it was written: read and checked line by line, not yet laid over anything.
#pragma once

#include "engine/core/text/source_location.h"
#include "engine/input/bindings.h"

#include <optional>

namespace plumbline::input {

struct LocatedInput {
    Input input;
    SourceLocation location;
};

/// Something in a list that is no input; what happens instead is for the merge to say.
struct EntryFault {
    SourceLocation location;
    std::string message;
};

/// `forward = ["w", "up"]`.
struct LayerLine {
    Action action{Action::Count};
    SourceLocation location;  ///< without a file; line 0 where there is no text (--bind)
    std::vector<LocatedInput> inputs;
    std::vector<EntryFault> faults;
};

struct LayerHold {
    Action action{Action::Count};
    HoldMode mode{HoldMode::Hold};
};

struct LayerContent {
    std::vector<LayerLine> lines;  ///< in the order of the text
    std::vector<LayerHold> holds;
    std::vector<std::string> aliases;  ///< for the log: other names for known words
    std::string profile;
};

/// Reads a layer; its tuning goes straight into `tuning`. Nothing when the text cannot be parsed:
/// then the whole layer counts for nothing, and `faults` says where it broke.
std::optional<LayerContent> read_layer(const BindingLayer& layer,
                                       Tuning& tuning,
                                       Diagnostics& faults);

/// "drop=q,mouse.4" as a line; nothing when it has no such form or names no action.
std::optional<LayerLine> read_bind_option(std::string_view option, Diagnostics& faults);

}  // namespace plumbline::input
