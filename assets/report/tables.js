"use strict";
// The tables of a study. Every run has its row; a run without an answer is red.

const TIERS = [
  ["T1 closed form", "the exact answer is a formula"],
  ["T2 two integrators", "two independent integrators of high order agree on it to ten digits"],
  ["T3 conserved", "something that must stay the same: energy, momentum, a symmetry"],
  ["T4 self-converged", "this engine itself, in float64 at a far smaller step, shown to converge: consistent, not proven right"],
  ["T5 spread", "no truth at all: how far apart copies end that began a hair apart"],
];
const tierWords = tier => TIERS.find(([name]) => name === tier)?.[1] ?? "";

/** Cost to reach an error, and error at a cost, by solver. */
function costTables(subject, metric) {
  const groups = [...bySolver(subject.points)];
  if (groups.length === 0 || subject.metrics.length === 0) return "";
  const soft = setting => `<span class="soft">${esc(shortSetting(setting))}</span>`;
  const cheapest = TOLERANCES.map(tolerance => cheapestWithin(subject.points, tolerance, metric));
  const reach = groups.map(([name, points]) => row([words(esc(name)), ...TOLERANCES.map((tolerance, i) => {
    const point = cheapestWithin(points, tolerance, metric);
    if (!point) return `<td class="red">not reached</td>`;
    const cost = numberText(costOf(point));
    return words(`${point === cheapest[i] ? `<b>${cost}</b>` : cost} ms ${soft(point.setting)}`);
  })]));
  const budget = groups.map(([name, points]) => row([words(esc(name)), ...BUDGETS_MS.map(budget_ms => {
    const point = nearestWithin(points, budget_ms, metric);
    return point ? words(`${errorText(errorOf(point, metric))} ${soft(point.setting)}`) : `<td class="red">none</td>`;
  })]));
  const of = esc(metricName(subject, metric));
  return `<h3>CPU ms a frame to reach an error of the ${of}</h3>\n${table(["solver", "5 %", "1 %", "0.1 %"], reach)}` +
    `<h3>Error of the ${of} for a cost</h3>\n${table(["solver", ...BUDGETS_MS.map(each => `${each} ms a frame`)], budget)}`;
}

/** What the settings that no other beats take of a game's frame and memory. */
function frameTable(subject) {
  const metric = mainMetric(subject);
  const rows = paretoFront(subject.points, metric).map(point => row([words(esc(settingText(point.setting))), number(errorText(errorOf(point, metric))),
    number(numberText(costOf(point))), number(numberText(point.cost.frame_ms_p99)), number(numberText(point.cost.frame_ms_max)),
    number(point.cost.frame_ms_max > 0 ? `${numberText(100 * point.cost.frame_ms_max / FRAME_MS)} %` : "&#8211;"),
    number(point.cost.peak_bytes > 0 ? bytesText(point.cost.peak_bytes) : "&#8211;")]));
  return rows.length ? `<h3>Settings that no other beats</h3>\n` +
    table(["setting", "#error", "#mean frame, ms", "#99 % of frames below", "#worst frame", "#of 16.7 ms", "#memory"], rows) : "";
}

const DASH = "&#8211;";
function pointRow(subject, point) {
  const cost = point.cost;
  const isDone = point.status === "done";
  const measured = (value, text = numberText) => number(cost.repeats > 0 && value !== undefined ? text(value) : DASH);
  const errors = subject.metrics.map((_, i) => {
    if (!isDone || i >= point.errors.length) return number(DASH);
    const error = point.errors[i];
    return typeof error === "number" ? number(errorText(error)) : `<td class="n red">${numberText(error)}</td>`;
  });
  const frames = [cost.ms_per_s_min, cost.ms_per_s_median, cost.ms_per_s_max].map(value => measured(value / FRAMES_PER_S));
  return row([words(esc(settingText(point.setting))), words(esc(point.why ? `${point.status}: ${point.why}` : point.status)), ...errors, ...frames,
    number(cost.repeats), measured(cost.frame_ms_p99), measured(cost.frame_ms_max), measured(cost.step_ms_median), measured(cost.step_ms_p99),
    measured(cost.step_ms_max), measured(cost.work_per_s), measured(cost.peak_bytes, bytesText)], isDone ? "" : "red");
}

function pointsTable(subject) {
  const heads = ["setting", "status", ...subject.metrics.map(metric => `#${metric.name}`), "#ms a frame, least", "#median", "#most", "#repeats",
    "#frame p99", "#frame worst", "#step median", "#step p99", "#step worst", "#work a second", "#memory"];
  return details(`All ${subject.points.length} runs`, table(heads, subject.points.map(point => pointRow(subject, point)), "wide tall"));
}

function verdictWords(verdict) {
  const factor = numberText(2 ** (verdict.order ?? 0));
  switch (verdict.trend) {
    case "converges": {
      const text = `Pays: each doubling divides the error by about ${factor}.`;
      if (verdict.theory === null) return text;
      return text + (Math.abs(verdict.order - verdict.theory) <= 0.15 ? " As theory says." : ` Theory says ${numberText(2 ** verdict.theory)}.`);
    }
    case "stalls": return "Does not pay: the error stays where it is.";
    case "diverges": return "Harms: the error grows.";
    case "exact": return "Nothing to gain: the error is rounding already.";
    default: return "Too few runs gave an answer to tell.";
  }
}

/** What each knob does to the error. */
function verdictTable(subject) {
  const rows = subject.verdicts.map(verdict => row([words(esc(verdict.solver)), words(esc(verdict.knob)), words(esc(verdict.held)),
    number(verdict.order === null ? DASH : verdict.order.toFixed(2)), number(verdict.theory === null ? DASH : numberText(verdict.theory)),
    number(verdict.halvings), `<td${/diverges|stalls/.test(verdict.trend) ? ` class="red"` : ""}>${esc(verdict.trend)}</td>`,
    `<td class="words">${esc(verdictWords(verdict))}</td>`]));
  return rows.length ? `<h3>Does a finer setting pay?</h3>\n` +
    table(["solver", "knob", "held fixed", "#order", "#theory", "#doublings", "verdict", "in words"], rows) : "";
}

function peerTable(peers) {
  const rows = [...peers].sort((a, b) => a.cost - b.cost)
    .map(peer => row([words(esc(peer.engine)), words(esc(peer.text)), number(numberText(peer.cost)), number(errorText(peer.error))]));
  return details(`All ${peers.length} figures of other engines`, table(["engine", "setting", "#ms a frame", "#error"], rows));
}

const WASM = "wasm costs 1.3 to 2 times a native build, Jolt's package, which is built without SIMD, 5 to 6 times.";

/** What other engines could not do, a line each. */
function engineFailures(subject) {
  const failed = (subject.engines ?? []).filter(point => point.status !== "done");
  return failed.length ? `<ul class="red">${failed.map(point =>
    `<li>${esc(`${engineName(point)}, ${point.settings_text}: ${point.status}: ${point.why}`)}</li>`).join("")}</ul>\n` : "";
}

/** What each number of threads takes of the cores and of the clock. */
function threadsTable(subject) {
  const points = subject.threads ?? [];
  const first = points[0]?.cost.clock_ms_per_s;
  const perFrame = ms_per_s => number(numberText(ms_per_s / FRAMES_PER_S));
  const rows = points.map(({ threads, status, why, same, cost }) => row(status === "done"
    ? [number(threads), perFrame(cost.ms_per_s_min), perFrame(cost.clock_ms_per_s), number((first / cost.clock_ms_per_s).toFixed(2)),
       words(same ? "same" : "another")]
    : [number(threads), number(DASH), number(DASH), number(DASH), `<td class="words red">${esc(`${status}: ${why}`)}</td>`]));
  return rows.length ? `<h3>Threads</h3>\n` +
    table(["#threads", "#CPU ms a frame", "#clock ms a frame", "#speed-up", "result"], rows) : "";
}

/** "3 of 40 runs failed: 2 exploded, 1 timed out." */
function failureLine(subject) {
  const failed = subject.points.filter(point => point.status !== "done").map(point => point.status);
  if (failed.length === 0) return "";
  const kinds = unique(failed).sort().map(kind => `${failed.filter(each => each === kind).length} ${kind}`);
  return `<p class="red">${failed.length} of ${subject.points.length} runs failed: ${esc(kinds.join(", "))}.</p>\n`;
}

function scoreTable(subjects) {
  const rows = scoresOf(subjects).map(score => row([words(esc(score.name)), ...score.reached.map(count => number(`${count} of ${score.subjects}`)),
    number(score.cheapest), number(score.price > 0 ? numberText(score.price) : DASH),
    `<td class="n${score.failed ? " red" : ""}">${score.failed} of ${score.runs}</td>`]));
  return table(["solver", "#within 5 %", "#1 %", "#0.1 %", "#cheapest at 1 %", "#price of 1 %", "#runs that failed"], rows) +
    `<p class="soft">Each cell counts the subjects in which some setting of the solver comes within the error. "Cheapest at 1 %" counts those in which
no other solver is cheaper. "Price of 1 %" is the solver's cost over the cheapest solver's, median over the subjects that it solves.</p>\n`;
}

function imageTable(image) {
  const rows = image.rows.map(each => row([words(each.unbeaten ? `<b>${esc(each.name)}</b>` : esc(each.name)), number(errorText(each.rms_error)),
    number(errorText(each.mean_error)), number(numberText(each.cpu_ms)), `<td class="words">${esc(each.verdict)}</td>`]));
  return table(["way to draw", "#rms error", "#mean error", "#CPU ms a frame", "against level high"], rows);
}

/** A cost with its standard error, or that it cannot be told from none. */
function differenceText(difference) {
  if (!difference || difference.pairs === 0) return DASH;
  const error = numberText(difference.standard_error);
  const isTold = difference.pairs > 1 && Math.abs(difference.mean) > 2 * difference.standard_error;
  return isTold ? `${numberText(difference.mean)} &#177; ${error}` : `below the noise (&#177; ${error})`;
}

/** References of effects: an error above what is allowed is red. */
function referenceTable(references) {
  const rows = references.map(each => row([words(esc(each.effect)), words(esc(each.reference)), words(esc(each.formula)), words(esc(each.fidelity)),
    each.error <= each.tolerance ? number(errorText(each.error)) : `<td class="red">${errorText(each.error)}</td>`, number(errorText(each.tolerance)),
    number(numberText(each.cpu_ms_per_s))]));
  return table(["effect", "reference", "held to", "fidelity", "#error", "#allowed", "#CPU ms for 1 s"], rows);
}

function effectTable(effects) {
  const rows = effects.rows.map(each => row([words(esc(each.name)), words(esc(each.domain)), number(differenceText(each.step_ms)),
    number(differenceText(each.frame_ms)), number(each.calls), number(bytesText(each.bytes_cpu)), number(bytesText(each.bytes_gpu)), words(esc(each.caller))]));
  return table(["effect", "part of", "#ms a step", "#ms a frame", "#calls", "#CPU memory", "#GPU memory", "called for by"], rows);
}

/** Effects that come in three fidelities; empty where there is none. */
function fidelityTable(effects) {
  const rows = effects.rows.flatMap(each => (each.fidelities ?? []).map(at => row([words(esc(each.name)), words(esc(at.fidelity)),
    number(numberText(at.step_ms)), number(numberText(at.largest_m)), number(numberText(at.mean_m))])));
  return rows.length === 0 ? "" : table(["effect", "fidelity", "#ms of a step", "#farthest from precise, m", "#mean, m"], rows);
}
