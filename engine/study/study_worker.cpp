#include "engine/study/study_worker.h"

#include "engine/study/gallery/gallery.h"
#include "engine/study/ghost/ghost_state.h"
#include "engine/study/scenarios/scenario_study.h"
#include "engine/study/scenes/effects_cost.h"
#include "engine/study/scenes/scene_run.h"
#include "engine/study/workers/worker.h"

#include <array>

namespace plumbline::study {

void run_study_worker() {
    static constexpr std::array<JobKind, 5> kJobKinds{
        {{"scenario", each_by_itself<run_scenario_job>},
         {"hard_case", each_by_itself<run_hard_case_job>},
         {"scene", scene_jobs},
         {"effect", each_by_itself<run_effect_job>},
         {"ghost", ghost_jobs}}};
    run_worker(kJobKinds);
}

}  // namespace plumbline::study
