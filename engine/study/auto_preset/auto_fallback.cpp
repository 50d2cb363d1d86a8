#include "engine/study/auto_preset/auto_fallback.h"

#include "engine/core/log.h"

namespace plumbline::study {

bool leaves_a_choice(const scene::Accuracy& asked) {
    const bool all_given =
        asked.solver_given && asked.step_hz_given && asked.substeps && asked.iterations;
    return asked.preset == "auto" && !all_given;
}

scene::Accuracy balanced(const scene::SceneDescription& description, const std::string& why) {
    log_warning("{}: preset \"auto\" falls back to \"balanced\": {}",
                description.file.filename().string(),
                why);
    scene::Accuracy accuracy = description.accuracy;
    accuracy.preset = "balanced";
    return accuracy;
}

}  // namespace plumbline::study
