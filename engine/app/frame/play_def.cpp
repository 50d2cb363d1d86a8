#include "engine/app/frame/play_def.h"

#include "engine/core/log.h"

#include <fmt/format.h>

namespace plumbline::app {

void continue_with_next(PlayDef& def, const PlayEnd& end) {
    def.start_page = false;
    def.first_message.clear();
    if (end.steps > 0 && !def.record.empty()) {
        def.first_message = fmt::format("a recording is of one scene: {} ends with the one before",
                                        def.record.string());
        log_warning("{}", def.first_message);
        def.record.clear();
    }
    if (def.seconds) *def.seconds -= end.seconds;
    def.steps.replay.clear();
    def.steps.first_step = 0;
    def.camera_path.clear();
    def.chosen_s = end.chosen_s;
    def.report_before = end.report;
}

}  // namespace plumbline::app
