#include "engine/study/findings/findings.h"

#include "engine/core/assert.h"

namespace plumbline::study {

std::string_view tier_name(Tier tier) {
    switch (tier) {
        case Tier::ClosedForm:
            return "T1 closed form";
        case Tier::TwoIntegrators:
            return "T2 two integrators";
        case Tier::Conserved:
            return "T3 conserved";
        case Tier::SelfConverged:
            return "T4 self-converged";
        case Tier::Spread:
            return "T5 spread";
    }
    PL_ASSERT(false, "a known tier");
    return "";
}

std::string_view status_name(RunStatus status) {
    switch (status) {
        case RunStatus::Done:
            return "done";
        case RunStatus::NotFinite:
            return "not finite";
        case RunStatus::Exploded:
            return "exploded";
        case RunStatus::TimedOut:
            return "timed out";
        case RunStatus::Crashed:
            return "crashed";
        case RunStatus::Refused:
            return "refused";
    }
    PL_ASSERT(false, "a known status");
    return "";
}

std::string_view trend_name(Trend trend) {
    switch (trend) {
        case Trend::Converges:
            return "converges";
        case Trend::Stalls:
            return "stalls";
        case Trend::Diverges:
            return "diverges";
        case Trend::Exact:
            return "exact";
        case Trend::TooFew:
            return "too few";
    }
    PL_ASSERT(false, "a known trend");
    return "";
}

}  // namespace plumbline::study
