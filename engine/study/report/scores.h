// The sum of a study: who reaches what, how often, and at what price.
#pragma once

#include "engine/study/findings/findings.h"

#include <string>
#include <vector>

namespace plumbline::study {

/// One contender over all subjects it ran in; first metrics.
struct Score {
    std::string name;
    int subjects{0};
    int reached_5{0};      ///< subjects in which a setting of its is within 5 %
    int reached_1{0};      ///< within 1 %
    int reached_01{0};     ///< within 0.1 %
    int cheapest_at_1{0};  ///< subjects in which nobody reaches 1 % cheaper
    /// Its price for 1 % over the cheapest contender's, median of the subjects in which it reaches it;
    /// 0 where there is none.
    double median_price{0};
    int runs{0};
    int no_answer{0};
};

/// By falling number of subjects within 1 %, then by price.
std::vector<Score> scores_of(const Findings& findings);

std::string score_table(const Findings& findings);

}  // namespace plumbline::study
