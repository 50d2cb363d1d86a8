#include "engine/study/report/page_parts.h"

namespace plumbline::study {

std::string_view page_style() {
    return R"css(
:root { color-scheme: light dark; --paper: #fbfbf9; --ink: #1b1d21; --soft: #62666e; --rule: #d8d9d4;
  --band: #f1f1ec; --red: #b3261e; --link: #1f5fae; }
@media (prefers-color-scheme: dark) {
  :root { --paper: #17191d; --ink: #e4e5e7; --soft: #9da2ab; --rule: #373b42; --band: #1f2227;
    --red: #ff8a80; --link: #8ab8f5; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 2rem 1.25rem 5rem; max-width: 64rem; background: var(--paper);
  color: var(--ink); font: 16px/1.55 system-ui, "DejaVu Sans", sans-serif; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 1rem; }
h2 { font-size: 1.3rem; margin: 3.5rem 0 .6rem; padding-top: 1rem; border-top: 1px solid var(--rule); }
h3 { font-size: 1rem; margin: 1.8rem 0 .4rem; }
p, dl, ul { max-width: 46rem; }
a { color: var(--link); }
code, pre { font: .9em/1.45 ui-monospace, "DejaVu Sans Mono", monospace; }
pre { padding: .7rem .9rem; background: var(--band); overflow-x: auto; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .2rem 1.2rem; }
dt { color: var(--soft); }
dd { margin: 0; overflow-wrap: anywhere; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .88rem; line-height: 1.4; margin: .4rem 0 1rem; }
th, td { padding: .28rem .7rem .28rem 0; text-align: left; vertical-align: top;
  border-bottom: 1px solid var(--rule); }
th { color: var(--soft); font-weight: 600; }
td.n, th.n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.bad, .bad td { color: var(--red); }
.soft { color: var(--soft); }
details { margin: .6rem 0; }
summary { cursor: pointer; color: var(--link); }
figure { margin: 1rem 0; overflow-x: auto; }
figcaption { color: var(--soft); font-size: .88rem; max-width: 46rem; }
figure svg { display: block; width: 100%; min-width: 40rem; height: auto; }
figure svg [fill="black"], figure svg [fill="rgb(0,0,0)"] { fill: var(--ink); }
figure svg [color="black"], figure svg [color="rgb(  0,   0,   0)"] { color: var(--ink); }
figure svg [stroke="black"], figure svg [stroke="rgb(  0,   0,   0)"] { stroke: var(--ink); }
@media print { h2 { break-before: page; } }
)css";
}

std::string_view how_to_read() {
    return R"(<h2 id="how">How to read the diagrams</h2>
<p>A simulation is never exact, and more exact costs more time. A <em>work-precision diagram</em> shows
both at once. Each point is one run of the same scene at one setting. How far right it is says what the
run <b>cost</b>: milliseconds of one processor core for each second that was simulated. How high it is
says how <b>wrong</b> the result was: 1 % means that the number named at the left was off by a hundredth
of its natural size. So <b>lower is more right, further left is cheaper, and the lower left corner is
where everybody wants to be</b>. Both scales go up by factors of ten, because costs and errors do.</p>
<p>A line joins runs that differ only in how many steps a second they take (Hz), from few (left) to many
(right). A line that falls says that smaller steps pay. A flat line says that you pay and get nothing. A
line that rises says that something is broken. Where one solver's line lies below and left of another's,
it is the better one for this scene, whatever accuracy you want.</p>
<p>A ring marks the runs that nobody beats: whoever is cheaper is further off. Choose among those. The
dotted lines across are errors of 5 %, 1 % and 0.1 %; the dotted lines upwards are 0.1, 0.5 and 2 ms of
each frame at 60 frames a second, which is what a game counts in. Small scenes cost less than the first
of them, and then it is not in sight. Grey points are other engines on the same scene, measured
elsewhere (their label says which; <code>assets/data/README.md</code> says when and on what). A red
cross at the top is a run that failed: it exploded, hung or crashed.</p>
<p>The second diagram of a subject has the step on the axis instead of the cost: the time that the solver
moves the world forward at once. Its grey lines show how steep a method of first order is (half the step,
half the error) and one of second order (half the step, a quarter). The thick dashed line, where there
is one, is the <em>Euler floor</em>: what the simplest way to move a falling body is off by whatever else
a solver does. Points above it are the solver's own errors; points below it say that the solver moves
bodies in a better way. Errors of zero are drawn where the arithmetic ends: at 1.2e-07 for float32.</p>
)";
}

}  // namespace plumbline::study
