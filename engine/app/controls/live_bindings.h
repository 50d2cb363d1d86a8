// The bindings in force: read from their layers at the start and again whenever a file is saved.
#pragma once

#include "engine/core/result.h"
#include "engine/core/text/diagnostics.h"
#include "engine/input/bindings.h"
#include "engine/platform/file_watch.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
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

    /// The profile that suits what is open, where neither the command line nor the user's file names
    /// one; empty: none.
    void use_usual_profile(std::string_view profile);

    /// True when files changed and say something else now; a file that cannot be parsed leaves its
    /// layer out and says so in faults().
    bool reload_if_changed(double now_s);

    /// What the controls pages edit: as current(), but without --bind.
    const input::Bindings& stored() const { return stored_; }
    /// What holds without the controls pages: where "reset" leads back to.
    const input::Bindings& below() const { return below_; }
    /// Puts `wanted` in force and writes bindings.ui.toml at once. The error says why it is not
    /// stored; it holds for this session all the same.
    Result<Done> change(const input::Bindings& wanted);

private:
    void load();

    BindingsDef def_;
    std::string usual_profile_;
    input::Bindings current_;
    input::Bindings stored_;
    input::Bindings below_;
    std::optional<std::string> unsaved_;       ///< in place of bindings.ui.toml
    std::vector<input::BindingLayer> layers_;  ///< as read last
    Diagnostics faults_;
    std::size_t layer_count_{0};
    bool read_once_{false};
    std::unique_ptr<platform::FileWatch> watch_;
};

}  // namespace plumbline::app
