"use strict";
// The page of a study: advice, the diagram, tables; what was measured and how at the end of each section.

const HOW_TO_READ = `<p>A simulation is never exact, and less error costs more time. A <em>work-precision diagram</em> shows both. Each point is one
run of the same scene at one setting. Its place from left to right is its <b>cost</b>: milliseconds of one processor core for each frame of 1/60 s.
Its height is its <b>error</b>: 1 % means that the measured number was off by a hundredth of its natural size. The lower left corner is best. Both
scales go in factors of ten.</p>
<p>A line joins runs that differ in their step rate alone (Hz), from few steps a second on the left to many on the right. A line that falls says
that smaller steps pay. A flat line costs time and gains nothing. A line that rises is a fault. A solver whose line lies below and left of another's
is the better one for this scene.</p>
<p>Rings mark the runs that no other run beats: a cheaper one has a larger error. The bar of a ring ends at its worst frame. Dotted lines across are errors of
5 %, 1 % and 0.1 %; dotted lines upwards are 0.1, 0.5 and 2 ms of a frame, and 16.7 ms, all of a frame at 60 frames a second. Grey points are
other engines on the same scene, measured elsewhere (assets/data/README.md). A red cross at the top is a run that failed.</p>
<p>The second diagram has the step on its axis: the time that the solver moves the world forward at once. Grey lines show how steep methods of first
order (half the step, half the error) and of second order (half the step, a quarter) are. The <em>Euler floor</em> is the error of the simplest way to move
a falling body. Errors of zero are drawn where the arithmetic ends, at 1.2e-7 for float32.</p>
`;

function figureHtml(plot, kind, caption, isNarrow) {
  return plot ? `<figure class="${kind}">\n${diagram(plot, isNarrow)}<figcaption>${esc(caption)}</figcaption>\n</figure>\n` : "";
}

/** What was measured and against what. */
function measuredHtml(subject) {
  const metrics = subject.metrics.map(metric => `<li>${esc(metric.name)}${metric.scale ? `, relative to ${esc(metric.scale)}` : ""}</li>`);
  return definitions([["subject", esc(subject.id)], ["set-up", esc(subject.set_up)], ["reference", esc(subject.reference)],
    ["tier", esc(`${subject.tier}: ${tierWords(subject.tier)}`)],
    ["measured", metrics.length ? `<ul>${metrics.join("")}</ul>` : "no metric"],
    ...subject.notes.map(note => ["note", esc(note)])]);
}

function subjectHtml(subject, data, isNarrow) {
  const metric = mainMetric(subject);
  const engines = enginesOf(subject, metric);
  const peers = [...peersOf(subject, data), ...engines];
  const { point } = recommended(subject);
  const caption = `Error of the ${metricName(subject, metric)} against cost.` +
    (peers.length > engines.length ? ` Grey: other engines on the scene ${subject.peer_scene}, measured elsewhere.` : "") +
    (engines.length ? ` Grey: other engines with their own settings, measured on this machine; ${WASM}` : "");
  const other = metric === WORST ? 0 : WORST;
  return `<p class="advice">${esc(adviceOf(subject))}</p>\n` +
    figureHtml(workPrecision(subject, peers), "cost", caption, isNarrow) + failureLine(subject) +
    (point ? details("Lines to paste under [accuracy]", `<pre>${esc(accuracyLines(point.setting))}</pre>\n`) : "") +
    frameTable(subject) + costTables(subject, metric) +
    (subject.metrics.length > 1 ? details(`The same for the ${metricName(subject, other)}`, costTables(subject, other)) : "") +
    figureHtml(stepPlot(subject), "step", `Error of the ${metricName(subject, metric)} against the step.`, isNarrow) +
    verdictTable(subject) + threadsTable(subject) + peerTable(peers) + engineFailures(subject) + pointsTable(subject) + details("What was measured, and against what", measuredHtml(subject));
}

function imageHtml(image, isNarrow) {
  const best = [...image.rows].filter(each => each.unbeaten).sort((a, b) => a.rms_error - b.rms_error)[0];
  const advice = best ? `The most accurate way to draw is ${best.name}: ${errorText(best.rms_error)} off for ${numberText(best.cpu_ms)} ms of CPU a frame.`
    : "No way to draw was measured.";
  return `<p class="advice">${esc(advice)}</p>\n` + figureHtml(imagePlot(image), "cost", "Error of the image against its cost.", isNarrow) + imageTable(image) +
    `<p class="soft">${image.width_px} by ${image.height_px} pixels of level high, and what differs from it in one thing, against the mean of
${image.samples_per_pixel} samples a pixel, of which an exact ray says whether each is in the sun. Errors are of linear light, relative to the mean luminance of
the reference (${numberText(image.mean_luminance)} of the screen's white). No other row is both cheaper and nearer than a row in bold.</p>\n`;
}

function effectsHtml(effects) {
  const told = effects.rows.map(each => ({ each, ms: Math.max(...[each.step_ms, each.frame_ms].map(cost =>
    cost && cost.pairs > 1 && cost.mean > 2 * cost.standard_error ? cost.mean : 0)) })).filter(({ ms }) => ms > 0).sort((a, b) => b.ms - a.ms);
  const advice = effects.rows.length === 0 ? "This scene calls for no effect, or none was measured." : told.length === 0
    ? "No effect of this scene costs more than the noise of the measurement."
    : `The most expensive effect is ${told[0].each.name}: switching it off saves ${numberText(told[0].ms)} ms.`;
  return `<p class="advice">${esc(advice)}</p>\n` + effectTable(effects) + fidelityTable(effects) +
    `<p class="soft">What switching an effect off saves: ${numberText(effects.seconds)} s of the scene with and without it, ${effects.pairs} times in
turns; mean and standard error. A cost within two standard errors of nothing is "below the noise". A scene without an effect may move otherwise. Images are
${effects.width_px} x ${effects.height_px}; what a GPU does beside the CPU is not in their ms.</p>\n`;
}

/** Warnings before everything else. */
function warningsHtml(findings) {
  let html = findings.complete ? "" : `<p class="red">Interrupted: this page has what was done by then.</p>\n`;
  if (findings.clock_spread > 0.15) {
    html += `<p class="red">The clock of this machine was noisy: read the costs as rough, the errors and the work counts as exact.</p>\n`;
  }
  return html;
}

function originHtml(findings, files) {
  const pairs = [["machine", esc(findings.machine)], ["build", esc(findings.build)], ["date", esc(findings.made_on)]];
  if (findings.clock_spread !== undefined) {
    pairs.push(["clock", `the median of a run's repeats lies ${errorText(findings.clock_spread)} above the least (median over all runs)`]);
  }
  return definitions([...pairs, ["same numbers", files.map(file => `<a href="${file}">${file}</a>`).join(", ")]]) +
    `<p>To repeat it:</p>\n<pre>${esc(findings.command)}</pre>\n`;
}

function overviewHtml(subjects, isNarrow) {
  const all = overall(subjects);
  const contents = subjects.map((subject, i) => row([words(`<a href="#s${i + 1}">${esc(titleOf(subject))}</a>`), words(esc(subject.tier.slice(0, 2))),
    `<td class="words">${esc(adviceOf(subject).split(". ")[0].replace(/\.?$/, "."))}${failureLine(subject)}</td>`]));
  return `<p class="advice">${esc(adviceOverAll(subjects))}</p>\n` +
    (all ? figureHtml(workPrecision(all, []), "cost", `Median error against median cost of ${all.title}; failed runs count as an endless error.`, isNarrow) : "") +
    scoreTable(subjects) +
    figureHtml(bodiesPlot(subjects), "bodies", "Worst frame against the number of moving bodies, a point a subject.", isNarrow) +
    `<h2 id="contents">Subjects</h2>\n` + table(["subject", "tier", "in one line"], contents, "wide tall");
}

function referencesHtml(references) {
  const above = references.filter(each => !(each.error <= each.tolerance)).length;
  const advice = above === 0 ? `All ${references.length} measurements are within what is allowed.` : `${above} of ${references.length} measurements are above what is allowed.`;
  return `<p class="advice">${esc(advice)}</p>\n` + referenceTable(references) +
    `<p class="soft">Errors are relative to the closed form; the cost is CPU time of all steps for a simulated second of the reference's own scene.</p>\n`;
}

/** Everything below <body>. */
function studyHtml(data, isNarrow) {
  const findings = data.findings;
  const parts = [
    ...findings.images.map((image, i) => ({ id: `image${i + 1}`, title: `The image of ${nameOf(image.scene)}`, html: imageHtml(image, isNarrow) })),
    ...(findings.effects ?? []).map((effects, i) => ({ id: `effects${i + 1}`, title: `What the effects of ${nameOf(effects.scene)} cost`, html: effectsHtml(effects) })),
    ...findings.subjects.map((subject, i) => ({ id: `s${i + 1}`, title: titleOf(subject), html: subjectHtml(subject, data, isNarrow) })),
  ];
  if ((findings.references ?? []).length > 0)
    parts.unshift({ id: "references", title: "Effects that bodies feel, against their references", html: referencesHtml(findings.references) });
  const isSingle = parts.length === 1;
  const title = isSingle ? parts[0].title : "What accuracy costs in time";
  let html = `<h1>${esc(title)}</h1>\n` + warningsHtml(findings);
  if (parts.length === 0) html += `<p class="red">No subject was studied.</p>\n`;
  if (findings.subjects.length > 1) html += overviewHtml(findings.subjects, isNarrow);
  for (const part of parts) {
    html += `<section id="${part.id}">\n${isSingle ? "" : `<h2>${esc(part.title)}</h2>\n`}${part.html}</section>\n`;
  }
  const tiers = table(["tier", "reference"], TIERS.map(([name, meaning]) => row([words(esc(name)), words(esc(meaning))])));
  return html + `<section>\n<h2>About this page</h2>\n` +
    (findings.subjects.length ? details("How to read the diagrams", HOW_TO_READ) + details("What the tiers of references mean", tiers) : "") +
    originHtml(findings, ["findings.json", "findings.csv"]) + "</section>\n";
}
