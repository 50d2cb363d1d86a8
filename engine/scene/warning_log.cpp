#include "engine/scene/warning_log.h"

#include "engine/core/log.h"
#include "engine/scene/simulation.h"

namespace plumbline::scene {

void WarningLog::log_new(const Simulation& simulation) {
    for (; logged_ < simulation.warnings.size(); ++logged_)
        log_line(LogLevel::Warning, simulation.warnings[logged_]);
}

}  // namespace plumbline::scene
