// Writes the page of findings that hold everything awkward at once, for page.py to read.
#include "engine/study/report/report.h"
#include "tests/engine/study/report/sample_findings.h"

#include <cmath>
#include <cstdio>

namespace {

using namespace plumbline;

study::Findings awkward_findings() {
    study::Findings findings = test::sample_findings();
    findings.command = "plumbline study 'a & b' <\"c\">\x01\xFF";
    findings.complete = false;

    study::Subject chain = test::sample_subject("A15 </h2> & 'co'");
    chain.title = "a chain hangs ]]> `date` $x {y}";
    chain.peer_scene = "chainv";
    chain.metrics = {{"stretch at the end", "its length"}, {"energy <J>", "m g h"}};
    for (study::Point& point : chain.points) {
        point.cost.ms_per_s_min *= 40;
        point.errors.push_back(0);
    }
    chain.points[0].status = study::RunStatus::Exploded;
    chain.points[0].why = "faster than <1e4> m/s";
    chain.points[0].errors.clear();
    chain.points[1].errors = {std::nan(""), 0};
    chain.points[2].errors = {0, 0};
    chain.points[3].errors = {-3e5, HUGE_VAL};
    chain.points[4].cost = {};
    chain.notes = {"reference converged to 1e-6 & more"};
    findings.subjects.push_back(chain);

    findings.subjects.emplace_back();
    findings.subjects.push_back(test::sample_subject("one point"));
    findings.subjects.back().points.resize(1);
    return findings;
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) return 2;
    const auto written = study::write_report(awkward_findings(), arguments[1]);
    if (!written) std::puts(written.error().message.c_str());
    return written ? 0 : 1;
}
