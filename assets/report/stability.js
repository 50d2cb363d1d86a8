"use strict";
// The page of the hard cases: how many each solver passes, and a row a case with every rule.

const STABILITY_WORDS = `<p class="soft">Each row is a scene in which physics engines are known to fall over, fly apart, tunnel or creep. Each scene states its
rules as numbers. A cell is one solver: <b>pass</b> when every rule held to the end, <b>FAIL</b> when one did not. Below the verdict: how far the worst rule
stayed inside its limit or went outside, as a share of that limit; the CPU time for a simulated second; and what the solver did beside solving: energy that its
guard took out, bodies that it slowed. A case from which the guard took more than 1 % of its energy fails. The images show where small_step ends.
Other engines run with their own defaults; what they lack, and rules that watch forces, are not run.</p>\n`;

function marginText(margin) {
  if (typeof margin !== "number") return "gone";
  if (margin >= 0) return `${(Math.min(margin, 10) * 100).toFixed(0)} % inside`;
  return margin > -10 ? `${(-margin * 100).toFixed(0)} % outside` : `${numberText(-margin)} x outside`;
}

const isPass = run => run.result?.passed === true;
const verdictClass = result => !result || result.gave_up ? "none" : result.passed ? "pass" : "fail";
const verdictWord = result => result.passed ? "pass" : result.gave_up ? "slow" : "FAIL";

/** What the solver did beside solving, by the keys of `interventions`. */
const INTERVENTIONS = { clamped_bodies: "bodies clamped", limited_bodies: "at the speed limit", unresolved_islands: "islands with joints too fast",
  restored_islands: "islands rolled back", oversized_islands: "islands too large for a matrix", left_out_pairs: "pairs of crowds left out" };
function interventionsText(done) {
  const parts = done.braked_islands > 0 ? [`${numberText(done.braked_J)} J braked in ${done.braked_islands} islands`] : [];
  for (const [key, what] of Object.entries(INTERVENTIONS)) {
    if (done[key] > 0) parts.push(`${done[key]} ${what}`);
  }
  return parts.join(", ");
}

/** The rule with the smallest margin; a margin that was not finite is the smallest of all. */
const sizeOf = rule => typeof rule.margin === "number" ? rule.margin : -Infinity;
const worstRule = result => result.rules.reduce((worst, rule) => !worst || sizeOf(rule) < sizeOf(worst) ? rule : worst, null);

function caseCell(run) {
  const result = run?.result;
  if (!result) return `<td class="none">not run</td>`;
  const lines = [];
  if (run.lacks) return `<td class="none">not run<br/>${esc(result.why)}</td>`;
  if (!result.ran) {
    lines.push(`<b>${verdictWord(result)}</b>`, esc(result.why));
  } else {
    const worst = worstRule(result);
    lines.push(`<b>${verdictWord(result)}</b> ${worst ? marginText(worst.margin) : ""}`, esc(result.why || (worst?.text ?? "")),
      `${numberText(result.cpu_ms_per_s)} ms/s`, esc(interventionsText(result.interventions)));
  }
  return `<td class="${verdictClass(result)}">${lines.filter(line => line).join("<br/>")}</td>`;
}

function rulesHtml(runs) {
  const rows = runs.filter(run => run.result).flatMap(run => run.result.rules.map(rule => row([words(`${esc(run.solver)} ${run.step_hz} Hz`),
    words(esc(rule.text)), number(numberText(rule.value)), `<td class="${rule.passed ? "pass" : "fail"}">${marginText(rule.margin)}</td>`,
    words(`${esc(rule.worst_of)} ${numberText(rule.worst_at_s)} s`)])));
  return details("every rule, every solver", table(["solver", "rule", "#worst value", "margin", "of, at"], rows));
}

function caseRow(shown, runs, columns, image) {
  const known = (runs.find(run => run.known_red)?.known_red ?? []).map(red => `<p class="soft">small_step fails "${esc(red.rule)}", it reaches ` +
    `${typeof red.reached === "number" ? numberText(red.reached) : "nothing: a body is gone"}: ${esc(red.why)}</p>`);
  return `<tr id="${esc(shown.id)}"><td class="case">` + (image ? `<img loading="lazy" alt="${esc(shown.title)} at the end" src="data:image/png;base64,${image}"/>` : "") +
    `<b>${esc(shown.id)}</b> ${esc(shown.title)}<br/>${esc(shown.shows)} <span class="soft">${numberText(shown.seconds)} s${shown.nightly ? ", nightly" : ""}.</span>` +
    (shown.known_to_fail ? `<p class="soft">Known to fail: ${esc(shown.known_to_fail)}.</p>` : "") + known.join("") + rulesHtml(runs) + "</td>" +
    columns.map(column => caseCell(runs.find(run => run.solver === column.solver && run.step_hz === column.step_hz))).join("") + "</tr>\n";
}

/** Solver and rate of every column, in the order of the runs. */
function columnsOf(runs) {
  return unique(runs.map(run => `${run.solver} ${run.step_hz}`)).map(name => ({ solver: name.split(" ")[0], step_hz: Number(name.split(" ")[1]) }));
}

function stabilityHtml(data) {
  const page = data.findings;
  const columns = columnsOf(page.runs).map(column => {
    const ran = page.runs.filter(run => run.solver === column.solver && run.step_hz === column.step_hz && run.result && !run.lacks);
    const ms = ran.map(run => run.result.cpu_ms_per_s).filter(value => value > 0);
    return { ...column, ran: ran.length, passed: ran.filter(isPass).length, slow: ran.filter(run => run.result.gave_up).length, ms: median(ms),
      worst: Math.max(0, ...ran.map(run => run.result.step_ms_max)) };
  });
  const [best] = [...columns].sort((a, b) => b.passed - a.passed || a.ms - b.ms);
  const advice = !best || best.ran === 0 ? "No case was run."
    : `Use ${best.solver} at ${best.step_hz} Hz: it passes ${best.passed} of ${best.ran} hard cases, for ${numberText(best.ms)} ms of CPU a simulated second (median).`;
  const sums = columns.map(each => row([words(esc(each.solver)), number(`${each.step_hz} Hz`), number(`${each.passed} of ${each.ran} pass`), number(each.slow),
    number(each.ran ? numberText(each.ms) : DASH), number(numberText(each.worst))]));
  const rows = page.cases.map(shown => caseRow(shown, page.runs.filter(run => run.case === shown.id), columns, page.images?.[shown.id]));
  return `<h1>Which hard cases hold</h1>\n` + warningsHtml(page) + `<p class="advice">${esc(advice)}</p>\n` +
    table(["solver", "#step rate", "#cases", "#given up", "#median ms/s", "#worst step, ms"], sums) + (page.no_images ? `<p><b>${esc(page.no_images)}</b></p>\n` : "") +
    STABILITY_WORDS + table(["case", ...columns.map(each => `${each.solver} ${each.step_hz} Hz`)], rows, "wide tall cases") +
    `<h2>About this page</h2>\n` + originHtml(page, ["stability.json"]);
}
