"use strict";
// Numbers, settings and markup as the page shows them. Every function returns text that is safe to put into HTML.

/** For text and for attributes in quotes; control characters become U+FFFD. */
function esc(text) {
  return String(text).replace(/[\u0000-\u0008\u000b-\u001f\u007f]/g, "\ufffd").replace(/&/g, "&amp;")
    .replace(/</g, "&lt;").replace(/>/g, "&gt;").replace(/"/g, "&quot;").replace(/'/g, "&#39;");
}

/** Three digits: "0.351", "12.4", "1.2e-7", "0". JSON has null where a number was not finite. */
function numberText(value) {
  if (typeof value !== "number" || Number.isNaN(value)) return "not a number";
  const size = Math.abs(value);
  if (size === Infinity) return "infinite";
  if (size === 0) return "0";
  if (size >= 999.5 && size < 1e7) return value.toFixed(0);
  return size < 1e-4 || size >= 1e7 ? value.toExponential(1) : String(Number(value.toPrecision(3)));
}

/** A relative error: 0.0123 is "1.23 %"; below 1e-5 "3.1e-7". */
function errorText(error) {
  if (!Number.isFinite(error) || Math.abs(error) < 1e-5) return numberText(error);
  return `${numberText(error * 100)} %`;
}

function bytesText(bytes) {
  return bytes >= 1 << 20 ? `${numberText(bytes / (1 << 20))} MiB` : `${numberText(bytes / 1024)} KiB`;
}

/** Least number of sub-steps where islands choose it themselves (preset "balanced"). */
const LEAST_SUBSTEPS = 2;

const isSmallStep = setting => setting.solver === "small_step";
const choosesSubsteps = setting => isSmallStep(setting) && setting.substeps <= 0;
const substepsOf = setting =>
  choosesSubsteps(setting) ? Math.min(LEAST_SUBSTEPS, setting.substeps_max) : Math.max(1, setting.substeps);

/** " x 4", " x 2-16", ", 10 it". */
function effortText(setting) {
  const most = choosesSubsteps(setting) ? setting.substeps_max : substepsOf(setting);
  const steps = most > substepsOf(setting) ? ` x ${substepsOf(setting)}-${most}`
    : isSmallStep(setting) || most > 1 ? ` x ${most}` : "";
  return steps + (isSmallStep(setting) && setting.iterations === 1 ? "" : `, ${setting.iterations} it`);
}

/** ", float64", and effects that do not run at the scene's own fidelity. */
const precisionText = setting => (setting.precision === "float64" ? ", float64" : "") +
  (setting.effects ?? []).map(each => `, ${each.effect} ${each.fidelity}`).join("");
/** Solver and precision. */
const solverText = setting => setting.solver + precisionText(setting);
/** Without the solver: "60 Hz x 4". */
const shortSetting = setting => `${setting.step_hz} Hz${effortText(setting)}`;
/** Without the step rate: "small_step x 4". */
const familyText = setting => setting.solver + effortText(setting) + precisionText(setting);
const settingText = setting => `${setting.solver} ${shortSetting(setting)}${precisionText(setting)}`;

/** The keys to paste under [accuracy]. */
function accuracyLines(setting) {
  const most = choosesSubsteps(setting) ? `substeps_max = ${setting.substeps_max}\n` : "";
  return `solver = "${setting.solver}"\nstep_hz = ${setting.step_hz}\nsubsteps = ${substepsOf(setting)}\n${most}` +
    `iterations = ${setting.iterations}\n` +
    (setting.effects ?? []).map(each => `[effects.${each.effect}]\nfidelity = "${each.fidelity}"\n`).join("");
}

const words = html => `<td>${html}</td>`;
const number = html => `<td class="n">${html}</td>`;
const row = (cells, kind) => `<tr${kind ? ` class="${kind}"` : ""}>${cells.join("")}</tr>\n`;

/** A table that scrolls in its own box. A heading that begins with "#" is of numbers. */
function table(headings, rows, kind = "wide") {
  if (rows.length === 0) return "";
  const heads = headings.map(name => name.startsWith("#") ? `<th class="n">${esc(name.slice(1))}</th>` : `<th>${esc(name)}</th>`);
  return `<div class="${kind}" tabindex="0"><table><thead><tr>${heads.join("")}</tr></thead>\n<tbody>${rows.join("")}</tbody></table></div>\n`;
}

const details = (summary, html) => html ? `<details><summary>${esc(summary)}</summary>\n${html}</details>\n` : "";
const definitions = pairs => `<dl>${pairs.map(([name, html]) => `<dt>${esc(name)}</dt><dd>${html}</dd>`).join("\n")}</dl>\n`;
const unique = values => [...new Set(values)];

function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const half = sorted.length >> 1;
  return sorted.length === 0 ? NaN : sorted.length % 2 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
}
