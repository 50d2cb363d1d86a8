#include "engine/app/controls/live_bindings.h"

#include "engine/app/settings/live_config.h"
#include "engine/input/bindings_edit.h"

#include <algorithm>
#include <utility>

namespace plumbline::app {
namespace {

constexpr std::string_view kBindingsFile = "bindings.ui.toml";

bool same_layers(const std::vector<input::BindingLayer>& a,
                 const std::vector<input::BindingLayer>& b) {
    return std::ranges::equal(a, b, [](const input::BindingLayer& x, const input::BindingLayer& y) {
        return x.name == y.name && x.text == y.text;
    });
}

}  // namespace

LiveBindings::LiveBindings(BindingsDef def) : def_(std::move(def)) {
    load();
}

void LiveBindings::load() {
    faults_ = {};
    input::BindingSources sources;
    if (!def_.safe) {
        sources = input::find_binding_sources(
            def_.shipped_folder, def_.user_folder, {def_.profile, usual_profile_}, faults_);
    }
    if (unsaved_) {
        std::erase_if(sources.layers,
                      [](const auto& layer) { return layer.name == kBindingsFile; });
        sources.layers.push_back({std::string(kBindingsFile), *unsaved_});
    }
    input::Bindings read = input::load_bindings(sources.layers, def_.command_line, faults_);
    // A file that is half written, broken or gone for a moment must not throw the person back to
    // the defaults: what was in force stays until a whole file is there again.
    const bool whole =
        sources.left_out.empty() && read.left_out.empty() && sources.layers.size() >= layer_count_;
    if (!read_once_ || whole) {
        current_ = std::move(read);
        layer_count_ = sources.layers.size();
        Diagnostics said_already;
        stored_ = input::load_bindings(sources.layers, {}, said_already);
        std::vector<input::BindingLayer> lower = sources.layers;
        std::erase_if(lower, [](const auto& layer) { return layer.name == kBindingsFile; });
        below_ = input::load_bindings(lower, {}, said_already);
    }
    layers_ = std::move(sources.layers);
    read_once_ = true;
    if (!watch_ && !def_.safe)
        watch_ = std::make_unique<platform::FileWatch>(std::move(sources.watched));
}

void LiveBindings::use_usual_profile(std::string_view profile) {
    if (usual_profile_ == profile) return;
    usual_profile_ = profile;
    layer_count_ = 0;
    watch_.reset();
    load();
}

bool LiveBindings::reload_if_changed(double now_s) {
    if (!watch_ || watch_->take_changed(now_s).empty()) return false;
    const std::vector<input::BindingLayer> before = std::move(layers_);
    load();
    return !same_layers(before, layers_);
}

Result<Done> LiveBindings::change(const input::Bindings& wanted) {
    const std::string text = input::ui_bindings_text(below_, wanted);
    const std::filesystem::path folder = def_.safe ? std::filesystem::path() : def_.user_folder;
    const Result<Done> written = write_user_setting(folder, kBindingsFile, text);
    unsaved_ = written ? std::nullopt : std::optional(text);
    layer_count_ = 0;  // the file may be new
    load();
    return written;
}

}  // namespace plumbline::app
