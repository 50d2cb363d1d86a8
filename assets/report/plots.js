"use strict";
// What the diagrams of a page show, as data for diagram().

const COLORS = { small_step: "#2f7fd6", bullet_si: "#d9762b", bullet_nncg: "#2f9e6e", bullet_dantzig: "#a364cf",
  bullet_pgs: "#b08a2a" };
const GREY = "#9a9a9a";
const INK = "currentColor";
const RED = "#d03030";
const SYMBOLS = ["disc", "square", "up", "diamond", "down"];
const MOST_ERROR = 100;  // what is ten thousand per cent off is drawn at the top

/** An error as it is drawn: at least the rounding level of the precision. */
const drawnError = (error, precision) =>
  Math.min(MOST_ERROR, Math.max(error, precision === "float64" ? 2.2e-16 : 1.2e-7));
const errorTick = value => value < 0.9e-5 ? value.toExponential(0) : errorText(value);

function errorAxis(name, errors) {
  const axis = logAxis(name, [...errors, 0.001, 0.1], 100, errorTick);
  axis.guides = TOLERANCES.map(at => ({ at, name: errorText(at) }));
  return axis;
}

/** Settings that differ in one knob alone: {name, isOfRate, points}. Every point is on a line: on that of its step
 *  rate where there is one, else on one of its sub-steps, else of its iterations, else alone. */
function knobLines(points) {
  const lines = [];
  const placed = new Set();
  const without = (setting, knob) => JSON.stringify({ ...setting, [knob]: 0,
    substeps_max: setting.substeps > 0 ? 0 : setting.substeps_max });
  const named = (line, knob) => {
    const [first, last] = [line[0].setting, line[line.length - 1].setting];
    if (knob === "step_hz") return familyText(first);
    const who = `${solverText(first)} ${first.step_hz} Hz`;
    return knob === "substeps" ? `${who} x ${first.substeps} to ${last.substeps}` : `${who}, ${first.iterations} to ${last.iterations} it`;
  };
  for (const knob of ["step_hz", "substeps", "iterations"]) {
    for (const point of points) {
      if (placed.has(point) || (knob === "substeps" && point.setting.substeps === 0)) continue;
      const like = without(point.setting, knob);
      const line = points.filter(other => without(other.setting, knob) === like && (knob !== "substeps" || other.setting.substeps > 0))
        .sort((a, b) => a.setting[knob] - b.setting[knob]);
      if (line.length < 2) continue;
      line.forEach(each => placed.add(each));
      lines.push({ name: named(line, knob), isOfRate: knob === "step_hz", points: line });
    }
  }
  for (const point of points) {
    if (!placed.has(point)) lines.push({ name: settingText(point.setting), isOfRate: false, points: [point] });
  }
  return lines;
}

/** The curves of all settings; `xOf` gives a point's place, or NaN. */
function settingCurves(subject, metric, xOf) {
  const ranks = {};
  return knobLines(subject.points).map(line => {
    const { solver, precision } = line.points[0].setting;
    ranks[solver] = (ranks[solver] ?? -1) + 1;
    const isDouble = precision === "float64";
    return { name: line.name, color: COLORS[solver] ?? INK, dash: !line.isOfRate ? "dotted" : isDouble ? "dashed" : "solid",
      symbol: (isDouble ? "open " : "") + SYMBOLS[ranks[solver] % SYMBOLS.length],
      points: line.points.filter(point => errorOf(point, metric) < Infinity && xOf(point) > 0).map(point => ({
        x: xOf(point), y: drawnError(errorOf(point, metric), precision),
        tip: `${settingText(point.setting)}: ${errorText(errorOf(point, metric))}, ${numberText(costOf(point))} ms a frame` })) };
  }).filter(curve => curve.points.length > 0);
}

const costSpent = point => point.cost.ms_per_s_min / FRAMES_PER_S;

function peerCurves(peers) {
  return unique(peers.map(peer => peer.engine)).map((engine, i) => ({
    name: i === 0 ? "other engines" : "", color: GREY, dash: "solid", width: 0.7, symbol: "disc", size: 2.4,
    points: peers.filter(peer => peer.engine === engine && peer.cost > 0).map((peer, k) => ({
      x: peer.cost, y: drawnError(peer.error, "float32"), label: k === 0 ? engine : "",
      tip: `${engine} ${peer.text}: ${errorText(peer.error)}, ${numberText(peer.cost)} ms a frame` })) }));
}

/** The runs that no other beats, with a bar to their worst frame. */
function frontCurve(subject, metric) {
  return { name: "cheapest for its error; bar: worst frame", color: INK, dash: "none", symbol: "open disc", size: 6,
    points: paretoFront(subject.points, metric).map(point => ({ x: costOf(point),
      y: drawnError(errorOf(point, metric), point.setting.precision), label: shortSetting(point.setting), to: point.cost.frame_ms_max })) };
}

/** Error against cost. Null: no run gave an error at a cost. */
function workPrecision(subject, peers) {
  const metric = mainMetric(subject);
  const measured = subject.points.filter(point => costOf(point) > 0 && costOf(point) < Infinity && errorOf(point, metric) < Infinity);
  if (measured.length === 0) return null;
  const front = frontCurve(subject, metric);
  const costs = subject.points.map(costSpent).concat(peers.map(peer => peer.cost), front.points.map(point => point.to));
  const spent = costs.filter(cost => cost > 0);
  // One frame is shown wherever it does not squeeze the rest into a corner.
  if (FRAME_MS < 30 * Math.max(...spent)) spent.push(FRAME_MS);
  const x = logAxis("CPU ms a frame (1/60 s simulated)", spent, 10, numberText);
  x.guides = [...BUDGETS_MS.map(at => ({ at, name: `${at} ms` })), { at: FRAME_MS, name: "16.7 ms: all of a frame" }];
  const errors = measured.map(point => drawnError(errorOf(point, metric), point.setting.precision))
    .concat(peers.map(peer => drawnError(peer.error, "float32")));
  const y = errorAxis(`error: ${metricName(subject, metric)}`, errors);
  const failed = subject.points.filter(point => errorOf(point, metric) === Infinity && costSpent(point) > 0);
  const crosses = { name: failed.length ? "failed" : "", color: RED, dash: "none", symbol: "cross", points: failed.map(point => ({
    x: costSpent(point), y: 10 ** (y.high - 1e-9), tip: `${settingText(point.setting)}: ${point.status}: ${point.why}` })) };
  return { name: `Error against cost: ${titleOf(subject)}`, x, y,
    curves: [...peerCurves(peers), ...settingCurves(subject, metric, costOf), front, crosses] };
}

/** Error against the step that the solver takes, with slopes of order 1 and 2 and the Euler floor. Null: one step only. */
function stepPlot(subject) {
  const metric = mainMetric(subject);
  const stepOf = point => 1000 / point.setting.step_hz / substepsOf(point.setting);
  const measured = subject.points.filter(point => errorOf(point, metric) < Infinity && point.setting.step_hz > 0);
  const steps = measured.map(stepOf);
  if (unique(steps).length < 2) return null;
  const drawn = point => drawnError(errorOf(point, metric), point.setting.precision);
  const floor = metric === 0 ? subject.euler_floor : [];
  const x = logAxis("step of the solver, ms", steps, 10, numberText);
  const y = errorAxis(`error: ${metricName(subject, metric)}`, [...measured.map(drawn), ...floor.map(each => drawnError(each.error, "float32"))]);
  const largest = Math.max(...steps);
  const from = Math.max(...measured.filter(point => stepOf(point) === largest).map(drawn));
  const slopes = [1, 2].map(order => ({ name: `slope of order ${order}`, color: GREY, dash: order === 1 ? "dashed" : "dotted",
    points: Array.from({ length: 61 }, (_, i) => {
      const at = 10 ** (x.low + (x.high - x.low) * i / 60);
      return { x: at, y: from * (at / largest) ** order };
    }) }));
  const euler = { name: floor.length ? "Euler floor" : "", color: INK, dash: "dashed", width: 3,
    points: floor.map(each => ({ x: each.step_s * 1000, y: each.error })) };
  return { name: `Error against step: ${titleOf(subject)}`, x, y, curves: [...slopes, euler, ...settingCurves(subject, metric, stepOf)] };
}

/** The settings that a game would start from. */
const isUsual = setting => setting.step_hz === 60 && setting.precision === "float32" &&
  (isSmallStep(setting) ? setting.substeps === 0 : setting.iterations === 10);

/** Worst frame against the number of moving bodies, a point a subject. Null: all have as many. */
function bodiesPlot(subjects) {
  const points = new Map();
  for (const subject of subjects) {
    for (const point of subject.points.filter(each => isUsual(each.setting) && each.cost.frame_ms_max > 0 && each.cost.bodies > 0)) {
      const name = familyText(point.setting);
      if (!points.has(name)) points.set(name, []);
      points.get(name).push({ x: point.cost.bodies, y: point.cost.frame_ms_max,
        tip: `${titleOf(subject)}: ${point.cost.bodies} bodies, worst frame ${numberText(point.cost.frame_ms_max)} ms with ${name}` });
    }
  }
  const all = [...points.values()].flat();
  if (unique(all.map(point => point.x)).length < 2) return null;
  const y = logAxis("worst frame, ms", [...all.map(point => point.y), FRAME_MS], 10, numberText);
  y.guides = [{ at: FRAME_MS, name: "16.7 ms: all of a frame" }];
  return { name: "Worst frame against number of bodies", x: logAxis("moving bodies", all.map(point => point.x), 10, numberText), y,
    curves: [...points].map(([name, own], i) => ({ name: `${name} at 60 Hz`, color: COLORS[name.split(/[ ,]/)[0]] ?? INK, dash: "none",
      symbol: SYMBOLS[i % SYMBOLS.length], points: own })) };
}

/** The image's error against its cost. Null: fewer than two rows can be drawn. */
function imagePlot(image) {
  const rows = image.rows.filter(each => each.rms_error > 0 && each.cpu_ms > 0);
  if (rows.length < 2) return null;
  const curve = isUnbeaten => ({ name: isUnbeaten ? "no other is cheaper and nearer" : "another is cheaper and nearer",
    color: isUnbeaten ? COLORS.small_step : GREY, dash: isUnbeaten ? "dotted" : "none", symbol: isUnbeaten ? "disc" : "open disc",
    points: rows.filter(each => each.unbeaten === isUnbeaten).sort((a, b) => a.cpu_ms - b.cpu_ms)
      .map(each => ({ x: each.cpu_ms, y: each.rms_error, label: each.name, tip: each.verdict })) });
  const x = logAxis("CPU ms a frame", rows.map(each => each.cpu_ms), 4, numberText);
  x.guides = [{ at: FRAME_MS, name: "16.7 ms: all of a frame" }];
  return { name: `Error of the image of ${image.scene} against its cost`, x,
    y: logAxis("rms error of light", rows.map(each => each.rms_error), 4, errorText), curves: [curve(false), curve(true)] };
}
