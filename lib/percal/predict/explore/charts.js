// Charts in SVG, as wide as the page gives them room.
"use strict";

// --- numbers in words -------------------------------------------------------------------------------------------

const steps = symbols => symbols.map(([symbol, size]) => ({ symbol, size }));
const units = {
  length: steps([["m", 1], ["mm", 1e-3], ["µm", 1e-6], ["nm", 1e-9]]),
  pressure: steps([["GPa", 1e9], ["MPa", 1e6], ["kPa", 1e3], ["Pa", 1]]),
  speed: steps([["m/s", 1]]),
  density: steps([["kg/m³", 1]]),
  impact: steps([["kg/(m s)", 1]]),
  share: steps([["%", 1e-2]]),
  none: steps([["", 1]])
};
const unitOf = (kind, value) => units[kind].find(unit => Math.abs(value) >= unit.size) ?? units[kind].at(-1);
// Zeros at the end are kept where all digits are wanted.
function digitsOf(value, digits, all = false) {
  if (!Number.isFinite(value)) return "…";
  const text = value.toPrecision(digits);
  return all && !text.includes("e") ? text : String(Number(text));
}
function inWords(value, kind, digits = 4, all = false) {
  const unit = unitOf(kind, value);
  return digitsOf(value / unit.size, digits, all) + (unit.symbol && " " + unit.symbol);
}

// --- axes -------------------------------------------------------------------------------------------------------

// A range of numbers of one kind, shown in one unit.
function axisOf(label, kind, low, high, logarithmic = false) {
  const unit = unitOf(kind, logarithmic ? Math.sqrt(low * high) : high);
  const share = logarithmic ? x => Math.log(x / low) / Math.log(high / low) : x => (x - low) / (high - low);
  const ticks = ticksOf(low / unit.size, high / unit.size, logarithmic);
  return { label: unit.symbol ? `${label}, ${unit.symbol}` : label, share, ticks, unit };
}

function ticksOf(low, high, logarithmic) {
  const ticks = [];
  if (logarithmic && high > 4 * low) {
    const decades = Math.log10(high / low), leading = decades > 3 ? [1] : decades > 1.5 ? [1, 3] : [1, 2, 5];
    for (let k = Math.floor(Math.log10(low)); k <= Math.log10(high); ++k)
      for (const one of leading) ticks.push(one * 10 ** k);
  } else {
    const rough = (high - low) / 6, power = 10 ** Math.floor(Math.log10(rough)), step = [1, 2, 5, 10].find(one => one * power >= rough) * power;
    for (let k = Math.ceil(low / step); k * step <= high * (1 + 1e-9); ++k) ticks.push(k * step);
  }
  return ticks.filter(tick => tick >= low * (1 - 1e-9) && tick <= high * (1 + 1e-9));
}

// --- drawing ----------------------------------------------------------------------------------------------------

function element(name, attributes, text) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text !== undefined) made.textContent = text;
  return made;
}

// `marks`: {kind, class, points}, of a band [x, low, high], a line or dots [x, y], bars [from, to, y].
function draw(svg, words, x, y, marks) {
  const width = Math.max(240, svg.parentElement.clientWidth), height = Math.min(340, Math.max(220, 0.62 * width));
  const left = 58, right = width - 20, top = 12, bottom = height - 46;
  const px = value => left + x.share(value) * (right - left), py = value => bottom - y.share(value) * (bottom - top);
  const at = (a, b) => `${px(a).toFixed(1)},${py(b).toFixed(1)}`;
  svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
  svg.setAttribute("aria-label", words);
  const clip = svg.id + "-clip", inside = element("g", { "clip-path": `url(#${clip})` }), clipping = element("clipPath", { id: clip });
  clipping.append(element("rect", { x: left, y: top, width: right - left, height: bottom - top }));
  svg.replaceChildren(clipping);
  for (const tick of x.ticks) {
    const where = px(tick * x.unit.size);
    svg.append(element("line", { class: "grid", x1: where, x2: where, y1: top, y2: bottom }),
      element("text", { x: where, y: bottom + 17, "text-anchor": "middle" }, digitsOf(tick, 4)));
  }
  for (const tick of y.ticks) {
    const where = py(tick * y.unit.size);
    svg.append(element("line", { class: "grid", x1: left, x2: right, y1: where, y2: where }),
      element("text", { x: left - 6, y: where + 4, "text-anchor": "end" }, digitsOf(tick, 4)));
  }
  const middle = (top + bottom) / 2;
  svg.append(inside, element("path", { class: "axis", d: `M${left},${top}V${bottom}H${right}` }),
    element("text", { x: (left + right) / 2, y: height - 8, "text-anchor": "middle" }, x.label),
    element("text", { x: 14, y: middle, "text-anchor": "middle", transform: `rotate(-90 14 ${middle})` }, y.label));
  for (const { points: all, ...mark } of marks) {
    mark.points = all.filter(numbers => numbers.every(Number.isFinite));
    if (mark.points.length === 0) continue;
    const path = d => inside.append(element("path", { class: mark.class, d }));
    if (mark.kind === "line") path("M" + mark.points.map(([a, b]) => at(a, b)).join("L"));
    if (mark.kind === "band") {
      const upper = mark.points.map(([a, , high]) => at(a, high)), lower = mark.points.map(([a, low]) => at(a, low));
      path("M" + [...upper, ...lower.reverse()].join("L") + "Z");
    }
    if (mark.kind === "dots")
      for (const [a, b] of mark.points) inside.append(element("circle", { class: mark.class, cx: px(a), cy: py(b), r: mark.size ?? 4 }));
    if (mark.kind === "bars")
      for (const [from, to, b] of mark.points) {
        const width = Math.max(0.5, px(to) - px(from) - 1);
        inside.append(element("rect", { class: mark.class, x: px(from) + 0.5, width, y: py(b), height: bottom - py(b) }));
      }
  }
}
