#include "engine/app/live_bindings.h"

#include <utility>

namespace plumbline::app {

LiveBindings::LiveBindings(BindingsDef def) : def_(std::move(def)) {
    load();
}

void LiveBindings::load() {
    faults_ = {};
    if (def_.safe) {
        current_ = input::load_bindings({}, def_.command_line, faults_);
        return;
    }
    input::BindingSources sources =
        input::find_binding_sources(def_.shipped_folder, def_.user_folder, def_.profile, faults_);
    input::Bindings read = input::load_bindings(sources.layers, def_.command_line, faults_);
    // A file that is half written, broken or gone for a moment must not throw the person back to
    // the defaults: what was in force stays until a whole file is there again.
    const bool whole =
        sources.left_out.empty() && read.left_out.empty() && sources.layers.size() >= layer_count_;
    if (!watch_ || whole) {
        current_ = std::move(read);
        layer_count_ = sources.layers.size();
    }
    if (!watch_) watch_ = std::make_unique<platform::FileWatch>(std::move(sources.watched));
}

bool LiveBindings::reload_if_changed(double now_s) {
    if (!watch_ || watch_->take_changed(now_s).empty()) return false;
    load();
    return true;
}

}  // namespace plumbline::app
