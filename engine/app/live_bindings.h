// The bindings in force: read from their layers at the start and again whenever a file is saved.
#pragma once

#include "engine/core/diagnostics.h"
#include "engine/input/bindings.h"
#include "engine/platform/file_watch.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::app {

struct BindingsDef {
    std::filesystem::path shipped_folder;
    std::filesystem::path user_folder;  ///< empty: none
    std::string profile;
    std::vector<std::string> command_line;  ///< --bind action=key[,key]
    bool safe{false};                       ///< built-in settings only
};

class LiveBindings {
public:
    explicit LiveBindings(BindingsDef def);

    const input::Bindings& current() const { return current_; }
    const Diagnostics& faults() const { return faults_; }  ///< of the last reading

    /// True when files changed and were read again; a file that cannot be parsed leaves its layer
    /// out and says so in faults().
    bool reload_if_changed(double now_s);

private:
    void load();

    BindingsDef def_;
    input::Bindings current_;
    Diagnostics faults_;
    std::size_t layer_count_{0};
    std::unique_ptr<platform::FileWatch> watch_;
};

}  // namespace plumbline::app
