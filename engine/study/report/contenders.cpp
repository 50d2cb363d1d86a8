#include "engine/study/report/contenders.h"

#include "engine/study/report/setting_names.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::study {

std::vector<Contender> contenders_of(const Subject& subject) {
    std::vector<Contender> contenders;
    for (const Point& point : subject.points) {
        const std::string name = contender_name(point.setting);
        auto found = std::ranges::find(contenders, name, &Contender::name);
        if (found == contenders.end()) {
            contenders.push_back({name, {}});
            found = contenders.end() - 1;
        }
        found->points.push_back(point);
    }
    return contenders;
}

const Point* cheapest_at(const Contender& contender, double tolerance, std::size_t metric) {
    const std::array<double, 1> asked{tolerance};
    const auto found = cost_to_reach(contender.points, asked, metric).front().point;
    return found ? &contender.points[*found] : nullptr;
}

const Point* best_for(const Contender& contender, double budget_ms, std::size_t metric) {
    const std::array<double, 1> asked{budget_ms};
    const auto found = error_at_budget(contender.points, asked, metric).front().point;
    return found ? &contender.points[*found] : nullptr;
}

std::size_t winner_at(const std::vector<Contender>& contenders,
                      double tolerance,
                      std::size_t metric) {
    std::size_t best = contenders.size();
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < contenders.size(); ++i) {
        const Point* reached = cheapest_at(contenders[i], tolerance, metric);
        if (reached == nullptr || reached->cost.ms_per_s_min >= least) continue;
        least = reached->cost.ms_per_s_min;
        best = i;
    }
    return best;
}

}  // namespace plumbline::study
