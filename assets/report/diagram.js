"use strict";
// One diagram on two logarithmic axes as SVG text: `diagram(plot, isNarrow)`.
//
// plot: {name, x, y, curves}; an axis comes from logAxis() and may have guides [{at, name}]; a curve is
// {name, color, dash: "none" | "solid" | "dashed" | "dotted", symbol, size, points: [{x, y, label, tip, to}]}.
// A label is drawn where it has room; `tip` shows on hover; `to` draws a bar to the right up to that x.

const LETTER_PX = 6.3;  // mean width at the size of labels
const LINE_PX = 14;

/** The range widened to `ratio` at least, with room at both ends, and its ticks. */
function logAxis(name, values, ratio, text) {
  const logs = values.map(Math.log10);
  let low = Math.min(...logs);
  let high = Math.max(...logs);
  const missing = Math.max(0, Math.log10(ratio) - (high - low));
  const room = 0.05 * (high - low + missing);
  low -= missing / 2 + room;
  high += missing / 2 + room;
  const firsts = high - low > 2.2 ? [1] : [1, 2, 5];
  const stride = high - low > 9 ? 2 : 1;
  const ticks = [];
  for (let decade = Math.floor(low); decade <= Math.ceil(high); decade += 1) {
    if (decade % stride !== 0) continue;
    for (const first of firsts) {
      const at = Number(`${first}e${decade}`);
      if (Math.log10(at) >= low && Math.log10(at) <= high) ticks.push({ at, text: text(at) });
    }
  }
  return { name, low, high, ticks, guides: [] };
}

const isInside = (axis, value) => value > 0 && Math.log10(value) >= axis.low && Math.log10(value) <= axis.high;

const SHAPES = {
  disc: r => `M${-r} 0a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0z`,
  square: r => `M${-r} ${-r}h${2 * r}v${2 * r}h${-2 * r}z`,
  up: r => `M0 ${-1.2 * r}L${1.1 * r} ${r}H${-1.1 * r}z`,
  diamond: r => `M0 ${-1.3 * r}L${1.3 * r} 0L0 ${1.3 * r}L${-1.3 * r} 0z`,
  down: r => `M0 ${1.2 * r}L${1.1 * r} ${-r}H${-1.1 * r}z`,
  cross: r => `M${-r} ${-r}L${r} ${r}M${-r} ${r}L${r} ${-r}`,
};

const round = value => Math.round(value * 10) / 10;
const DASHES = { dashed: ` stroke-dasharray="8 5"`, dotted: ` stroke-dasharray="2 4"` };

function symbolSvg(curve, x, y, tip) {
  const isOpen = curve.symbol.startsWith("open ");
  const shape = SHAPES[curve.symbol.replace("open ", "")](curve.size ?? 3.5);
  const paint = isOpen || curve.symbol === "cross" ? `fill="none" stroke="${curve.color}" stroke-width="1.5"` : `fill="${curve.color}"`;
  return `<path d="${shape}" transform="translate(${round(x)} ${round(y)})" ${paint}>${tip ? `<title>${esc(tip)}</title>` : ""}</path>\n`;
}

function lineSvg(curve, spots) {
  if (curve.dash === "none" || spots.length < 2) return "";
  const path = spots.map(([x, y], i) => `${i ? "L" : "M"}${round(x)} ${round(y)}`).join("");
  return `<path d="${path}" fill="none" stroke="${curve.color}" stroke-width="${curve.width ?? 1.6}"${DASHES[curve.dash] ?? ""}/>\n`;
}

const textSvg = (x, y, text, more = "") => `<text x="${round(x)}" y="${round(y)}" ${more}>${esc(text)}</text>\n`;
const SOFT = `fill-opacity="0.72"`;

/** The names of the curves below the axes, in columns. */
function keySvg(curves, width, top) {
  const named = curves.filter(curve => curve.name);
  const longest = Math.max(0, ...named.map(curve => curve.name.length));
  const columns = Math.max(1, Math.floor(width / (45 + longest * LETTER_PX)));
  const rows = Math.ceil(named.length / columns);
  const svg = named.map((curve, i) => {
    const x = 10 + Math.floor(i / rows) * (width / columns);
    const y = top + (i % rows) * 18;
    return lineSvg(curve, [[x, y], [x + 26, y]]) + (curve.symbol ? symbolSvg(curve, x + 13, y) : "") +
      textSvg(x + 33, y + 4, curve.name);
  });
  return { svg: svg.join(""), height: rows * 18 + 8 };
}

/** Each label beside its point where nothing is in the way; the others are left out. */
function labelsSvg(labels, taken, frame) {
  const meets = (a, b) => a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];
  let svg = "";
  for (const { x, y, text } of labels) {
    const long = text.length * LETTER_PX;
    for (const [dx, dy] of [[9, -9], [-9 - long, 10], [9, 10], [-9 - long, -9], [10, 0], [-10 - long, 0]]) {
      const box = [x + dx, y + dy - LINE_PX / 2, x + dx + long, y + dy + LINE_PX / 2];
      if (box[0] < frame.left || box[2] > frame.right || box[1] < frame.top || box[3] > frame.bottom) continue;
      if (taken.some(other => meets(box, other))) continue;
      taken.push(box);
      svg += textSvg(box[0], y + dy + 4, text);
      break;
    }
  }
  return svg;
}

function axesSvg(plot, frame, at) {
  let svg = `<path d="M${frame.left} ${frame.top}V${frame.bottom}H${frame.right}" fill="none" stroke="currentColor"/>\n`;
  const used = { x: -Infinity };
  for (const tick of plot.x.ticks) {
    const x = at.x(tick.at);
    if (x - used.x < tick.text.length * LETTER_PX + 6) continue;
    used.x = x;
    svg += `<path d="M${round(x)} ${frame.bottom}v4" stroke="currentColor"/>` + textSvg(x, frame.bottom + 17, tick.text, `text-anchor="middle"`);
  }
  for (const tick of plot.y.ticks) {
    svg += `<path d="M${frame.left} ${round(at.y(tick.at))}h-4" stroke="currentColor"/>` +
      textSvg(frame.left - 7, at.y(tick.at) + 4, tick.text, `text-anchor="end"`);
  }
  svg += textSvg((frame.left + frame.right) / 2, frame.bottom + 36, plot.x.name, `text-anchor="middle"`);
  return svg + textSvg(4, frame.top - 9, plot.y.name);
}

function guidesSvg(plot, frame, at, taken) {
  let svg = "";
  const line = path => `<path d="${path}" stroke="currentColor" stroke-opacity="0.35" stroke-dasharray="2 4"/>`;
  for (const guide of plot.x.guides.filter(guide => isInside(plot.x, guide.at))) {
    const x = at.x(guide.at);
    const long = guide.name.length * LETTER_PX;
    svg += line(`M${round(x)} ${frame.bottom}V${frame.top}`) +
      `<text transform="translate(${round(x - 4)} ${frame.top + 2}) rotate(-90)" text-anchor="end" ${SOFT}>${esc(guide.name)}</text>\n`;
    taken.push([x - LINE_PX, frame.top, x + 2, frame.top + long]);
  }
  for (const guide of plot.y.guides.filter(guide => isInside(plot.y, guide.at))) {
    const y = at.y(guide.at);
    svg += line(`M${frame.left} ${round(y)}H${frame.right}`) + textSvg(frame.right - 3, y - 4, guide.name, `text-anchor="end" ${SOFT}`);
    taken.push([frame.right - guide.name.length * LETTER_PX - 6, y - LINE_PX - 3, frame.right, y]);
  }
  return svg;
}

function diagram(plot, isNarrow) {
  const width = isNarrow ? 380 : 900;
  const frame = { left: 62, right: width - 12, top: 30, bottom: isNarrow ? 330 : 430 };
  const share = (axis, value) => (Math.log10(value) - axis.low) / (axis.high - axis.low);
  const at = { x: value => frame.left + (frame.right - frame.left) * share(plot.x, value),
    y: value => frame.bottom - (frame.bottom - frame.top) * share(plot.y, value) };
  const taken = [];
  const labels = [];
  let svg = guidesSvg(plot, frame, at, taken) + axesSvg(plot, frame, at);
  let symbols = "";
  for (const curve of plot.curves) {
    const inside = curve.points.filter(point => isInside(plot.x, point.x) && isInside(plot.y, point.y));
    svg += lineSvg(curve, inside.map(point => [at.x(point.x), at.y(point.y)]));
    for (const point of curve.symbol ? inside : []) {
      const [x, y] = [at.x(point.x), at.y(point.y)];
      if (point.to > point.x && isInside(plot.x, point.to)) {
        symbols += `<path d="M${round(x)} ${round(y)}H${round(at.x(point.to))}m0 -4v8" fill="none" stroke="${curve.color}" stroke-opacity="0.6"/>\n`;
      }
      symbols += symbolSvg(curve, x, y, point.tip);
      taken.push([x - 4, y - 4, x + 4, y + 4]);
      if (point.label) labels.unshift({ x, y, text: point.label });
    }
  }
  const key = keySvg(plot.curves, width - 20, frame.bottom + 58);
  const height = frame.bottom + 48 + key.height;
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" role="img" aria-label="${esc(plot.name)}" ` +
    `font-family="system-ui, 'DejaVu Sans', sans-serif" font-size="12" fill="currentColor">\n` +
    `${svg}${symbols}${labelsSvg(labels, taken, frame)}${key.svg}</svg>\n`;
}
