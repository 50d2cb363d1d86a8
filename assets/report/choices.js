"use strict";
// What findings come to: the cheapest setting for an error, the settings that no other beats, and advice.

const FRAMES_PER_S = 60;
const FRAME_MS = 1000 / FRAMES_PER_S;
const TOLERANCES = [0.05, 0.01, 0.001];
const BUDGETS_MS = [0.1, 0.5, 2, 8];
const USUAL_TOLERANCE = 0.01;
/** Instead of the index of a metric: the one that is furthest off. */
const WORST = -1;

/** Magnitude; Infinity where the run gave none. */
function errorOf(point, metric) {
  if (point.status !== "done") return Infinity;
  const errors = metric === WORST ? point.errors : point.errors.slice(metric, metric + 1);
  if (errors.length === 0 || errors.some(error => typeof error !== "number")) return Infinity;
  return Math.max(...errors.map(Math.abs));
}

/** CPU ms for 1/60 s of simulated time; Infinity where nothing was measured. */
const costOf = point => point.status === "done" && point.cost.repeats > 0 ? point.cost.ms_per_s_min / FRAMES_PER_S : Infinity;

/** The first of `points` that fits, by `less`. */
function least(points, metric, fits, less) {
  let best;
  for (const point of points) {
    const rated = { point, cost: costOf(point), error: errorOf(point, metric) };
    if (rated.cost === Infinity || rated.error === Infinity || !fits(rated)) continue;
    if (!best || less(rated, best)) best = rated;
  }
  return best?.point;
}

const isCheaper = (a, b) => a.cost !== b.cost ? a.cost < b.cost : a.error < b.error;
const isNearer = (a, b) => a.error !== b.error ? a.error < b.error : a.cost < b.cost;
const cheapestWithin = (points, tolerance, metric) => least(points, metric, rated => rated.error <= tolerance, isCheaper);
const nearestWithin = (points, budget_ms, metric) => least(points, metric, rated => rated.cost <= budget_ms, isNearer);

/** Points that no other beats in both cost and error, by rising cost. */
function paretoFront(points, metric) {
  const rated = points.map(point => ({ point, cost: costOf(point), error: errorOf(point, metric) }))
    .filter(each => each.cost < Infinity && each.error < Infinity)
    .sort((a, b) => a.cost - b.cost || a.error - b.error);
  let smallest = Infinity;
  return rated.filter(each => each.error < smallest && ((smallest = each.error), true)).map(each => each.point);
}

/** Points by solver and precision, in the order of their first points. */
function bySolver(points) {
  const groups = new Map();
  for (const point of points) {
    const name = solverText(point.setting);
    if (!groups.has(name)) groups.set(name, []);
    groups.get(name).push(point);
  }
  return groups;
}

/** A scene has no formula, so that all its metrics count; a scenario's first one is what it is about. */
const mainMetric = subject => /^T[45]/.test(subject.tier) && subject.metrics.length > 1 ? WORST : 0;
const metricName = (subject, metric) =>
  metric === WORST ? "worst metric" : subject.metrics[metric]?.name ?? "no metric";

/** A scene by its file's name, wherever it lay. */
const nameOf = id => id.includes("/") ? id.slice(id.lastIndexOf("/") + 1).replace(/\.\w+$/, "") : id;
function titleOf(subject) {
  const name = nameOf(subject.id);
  const isSaid = subject.title.toLowerCase() === name.toLowerCase();
  return name && subject.title && !isSaid ? `${subject.title} (${name})` : subject.title || name || "(no name)";
}

/** The setting to use: the cheapest within 1 %, else the nearest. Files cannot choose the precision. */
function recommended(subject) {
  const metric = mainMetric(subject);
  const single = subject.points.filter(point => point.setting.precision === "float32");
  const within = Math.max(USUAL_TOLERANCE / 2, USUAL_TOLERANCE - (subject.uncertainty ?? 0));
  const met = cheapestWithin(single, within, metric) ?? cheapestWithin(single, USUAL_TOLERANCE, metric);
  return { met: Boolean(met), point: met ?? nearestWithin(single, Infinity, metric) };
}

/** What a point costs a game. */
function costWords(point) {
  const { frame_ms_max: worst, bodies } = point.cost;
  const more = worst > 0 ? [`worst frame ${numberText(worst)} ms`] : [];
  if (bodies > 1) more.push(`${bodies} moving bodies, ${numberText(costOf(point) * 1e3 / bodies)} µs each`);
  return `${numberText(costOf(point))} ms of a ${numberText(FRAME_MS)} ms frame on one core` + (more.length ? ` (${more.join("; ")})` : "");
}

/** How the other solvers do, and what ten times the accuracy costs. */
function comparisons(subject, point) {
  const metric = mainMetric(subject);
  const sentences = [];
  const missing = [];
  const others = [...bySolver(subject.points)].filter(([name]) => name !== solverText(point.setting));
  const ratio = other => `${numberText(costOf(other) / costOf(point))} times as long (${shortSetting(other.setting)})`;
  const taking = [];
  for (const [name, points] of others) {
    const reached = cheapestWithin(points, USUAL_TOLERANCE, metric);
    if (reached) taking.push(`${name} takes ${ratio(reached)}`);
    else missing.push(name);
  }
  if (taking.length) sentences.push(`For 1 % ${taking.join(", ")}.`);
  if (missing.length) sentences.push(`Not within 1 % at any setting: ${missing.join(", ")}.`);
  const finer = cheapestWithin(subject.points, USUAL_TOLERANCE / 10, metric);
  sentences.push(finer === point ? "It is the cheapest within 0.1 %, too." : finer ? `0.1 % costs ${numberText(costOf(finer) / costOf(point))} times as much: ${settingText(finer.setting)}.`
    : "No setting comes within 0.1 %.");
  return sentences.join(" ");
}

/** One sentence to act on, and what it is based on. */
function adviceOf(subject) {
  if (subject.points.length === 0) return "No run was made.";
  const { met, point } = recommended(subject);
  if (!point) return "No setting can be recommended: no run gave an error and a cost.";
  const error = errorText(errorOf(point, mainMetric(subject)));
  if (!met) return `No setting comes within 1 %. The nearest is ${settingText(point.setting)}: it is ${error} off and takes ${costWords(point)}.`;
  return `Use ${settingText(point.setting)}: it is ${error} off and takes ${costWords(point)}. ${comparisons(subject, point)}`;
}

/** One row of the table of solvers over all subjects. */
function scoresOf(subjects) {
  const scores = new Map();
  for (const subject of subjects) {
    const cheapest = cheapestWithin(subject.points, USUAL_TOLERANCE, 0);
    for (const [name, points] of bySolver(subject.points)) {
      if (!scores.has(name)) scores.set(name, { name, subjects: 0, reached: TOLERANCES.map(() => 0), cheapest: 0, prices: [], runs: 0, failed: 0 });
      const score = scores.get(name);
      score.subjects += 1;
      score.runs += points.length;
      score.failed += points.filter(point => point.status !== "done").length;
      TOLERANCES.forEach((tolerance, i) => { score.reached[i] += cheapestWithin(points, tolerance, 0) ? 1 : 0; });
      const own = cheapestWithin(points, USUAL_TOLERANCE, 0);
      if (!own) continue;
      score.cheapest += own === cheapest ? 1 : 0;
      if (costOf(cheapest) > 0) score.prices.push(costOf(own) / costOf(cheapest));
    }
  }
  return [...scores.values()].map(score => ({ ...score, price: median(score.prices) }))
    .sort((a, b) => b.reached[1] - a.reached[1] || a.price - b.price);
}

/** The advice over many subjects. */
function adviceOverAll(subjects) {
  const [best, ...others] = scoresOf(subjects).filter(score => !score.name.endsWith("float64"));
  if (!best || best.reached[1] === 0) return "No solver comes within 1 % in any subject.";
  const rest = others.map(score => `${score.name} in ${score.reached[1]} of ${score.subjects}`).join(", ");
  return `Use ${best.name}: some setting of it comes within 1 % in ${best.reached[1]} of ${best.subjects} subjects, ` +
    `and is the cheapest there in ${best.cheapest}` + (rest ? `; ${rest}.` : ".");
}

/** One point a setting that nearly all subjects were run at: medians over the subjects that have all of these. */
function overall(subjects) {
  const runs = new Map();
  for (const subject of subjects) {
    for (const point of subject.points) {
      const name = settingText(point.setting);
      if (!runs.has(name)) runs.set(name, new Map());
      runs.get(name).set(subject, point);
    }
  }
  const usual = [...runs].filter(([, points]) => points.size >= 0.7 * subjects.length);
  const common = subjects.filter(subject => usual.every(([, points]) => points.has(subject)));
  if (common.length < 2 || usual.length < 2) return null;
  const points = usual.map(([, byWhom]) => {
    const own = common.map(subject => byWhom.get(subject));
    const error = median(own.map(point => Math.min(1e9, errorOf(point, 0))));
    const costs = own.filter(point => costOf(point) < Infinity).map(point => point.cost.ms_per_s_min);
    return { setting: own[0].setting, status: "done", errors: [error], cost: { ms_per_s_min: median(costs), repeats: costs.length } };
  });
  return { id: "", title: `${common.length} subjects`, tier: "", metrics: [{ name: `median over ${common.length} subjects`, scale: "" }],
    euler_floor: [], points, verdicts: [], notes: [] };
}

/** Fields of lines without quotes, as objects by the heading. */
function parseCsv(text) {
  const [heading, ...lines] = (text ?? "").split(/\r?\n/).filter(line => line && !line.startsWith("#")).map(line => line.split(","));
  return lines.map(fields => Object.fromEntries(heading.map((name, i) => [name, fields[i]])));
}

/** Figures of other engines that mean what the subject's first metric means, as relative errors; 1 at least where
 *  what should stand fell. */
function peersOf(subject, data) {
  const same = data.peer_metrics.find(each => each.scene === subject.peer_scene && each.metric === subject.metrics[0]?.name);
  if (!same) return [];
  const own = data.peers.filter(each => each.scene === subject.peer_scene);
  const key = each => `${each.engine} ${each.substeps}`;
  const fallen = new Set(own.filter(each => each.metric === "stands" && Number(each.value) === 0).map(key));
  return own.filter(each => each.metric === same.figure).map(each => ({
    engine: each.engine, text: `${60 * Number(each.substeps)} Hz`, cost: Number(each.cpu_ms_per_frame),
    error: Math.max(Math.abs(Number(each.value)) * Number(same.factor), fallen.has(key(each)) ? 1 : 0) }));
}

/** Settings of other engines that were measured with the subject. */
function enginesOf(subject, metric) {
  return (subject.engines ?? []).filter(point => point.status === "done").map(point => ({
    engine: engineName(point), text: point.settings_text, cost: point.cost.ms_per_s_min / FRAMES_PER_S, error: errorOf(point, metric) }));
}

const engineName = point => `${point.title} ${point.version}${point.webassembly ? " (wasm)" : ""}`;
