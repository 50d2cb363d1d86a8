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
    current_ = input::load_bindings(sources.layers, def_.command_line, faults_);
    if (!watch_) watch_ = std::make_unique<platform::FileWatch>(std::move(sources.watched));
}

bool LiveBindings::reload_if_changed(double now_s) {
    if (!watch_ || watch_->take_changed(now_s).empty()) return false;
    load();
    return true;
}

}  // namespace plumbline::app
