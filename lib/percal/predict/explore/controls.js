// What the reader chooses: a hypothesis, a material or a point of one, a sphere, a target and a powder.
"use strict";

const given = JSON.parse(document.getElementById("data").textContent);
const emulator = new Emulator(given.emulator), { bulk } = given.emulator;
const found = id => document.getElementById(id);

const skinBreach = 7;  // kg/(m s), as percal dose has it: Guha 2009, 2.2.2

// --- what is chosen ---------------------------------------------------------------------------------------------

const state = {
  hypothesis: 0,
  material: 0,
  layer: 0,      // whose numbers the sliders show: the layer's, or a cover's
  moved: [],     // by layer: numbers in place of the best point's; nothing: as calibrated
  shot: {},      // diameter, density, speed, layerDepth
  powder: { spread: 0.1, weighting: "number", breach: skinBreach }
};

const material = () => given.hypotheses[state.hypothesis].materials[state.material];
const shot = () => ({ ...state.shot, radius: state.shot.diameter / 2 });
const isMoved = () => state.moved.some(numbers => Object.keys(numbers).length > 0);
const best = () => pointOf(material(), 0).map((layer, k) => ({ ...layer, ...state.moved[k] }));
const points = () => isMoved() ? [best()] : material().points.map((_, k) => pointOf(material(), k));
const shotsInto = () => {
  const into = given.shots.filter(one => one.material === state.material);
  return into.length > 0 ? into : given.shots;
};
// The number that is the erosion strain of this sphere.
const strainKey = () => isBelowCell(best()[state.layer], shot().radius) ? "strainBelow" : "strain";

// --- the sliders ------------------------------------------------------------------------------------------------

const ofShots = key => () => {
  const all = shotsInto().map(one => key === "diameter" ? 2 * one.radius_m : one[key]);
  return [Math.min(...all) / 3, Math.max(...all) * 3];
};
const ofSample = (key, factor) => () => {
  const all = material().points.map((_, k) => pointOf(material(), k)[state.layer][key()]).filter(one => one > 0);
  return [Math.min(...all) / factor, Math.max(...all) * factor];
};
const ofAlpha = () => {
  const j = given.emulator.seen.indexOf(2), middle = given.emulator.centre[j], half = given.emulator.half_range[j];
  const all = material().points.map((_, k) => pointOf(material(), k)[state.layer].alpha);
  return [Math.min(middle - half, ...all), Math.max(middle + half, ...all)];
};
const shotNumber = key => ({ get: () => state.shot[key], set: value => { state.shot[key] = value; } });
const powderNumber = key => ({ get: () => state.powder[key], set: value => { state.powder[key] = value; } });
const within = (fieldset, some) => some.map(one => ({ ...one, within: fieldset }));
const layerNumber = key => ({ get: () => best()[state.layer][key()], set: value => { state.moved[state.layer][key()] = value; } });

// Logarithmic unless they are called linear.
const sliders = [
  ...within("of-shot", [
    { id: "diameter", label: "Diameter", kind: "length", range: ofShots("diameter"), ...shotNumber("diameter") },
    { id: "density", label: "Density of the sphere", kind: "density", range: ofShots("density_kg_m3"), ...shotNumber("density") },
    { id: "speed", label: "Speed", kind: "speed", range: ofShots("speed_m_s"), ...shotNumber("speed") },
    { id: "layer-depth", label: "Depth of the target", kind: "length", range: ofShots("layer_depth_m"), ...shotNumber("layerDepth") }]),
  ...within("of-material", [
    { id: "mu", label: "Shear modulus mu, true", kind: "pressure", range: ofSample(() => "mu", 3), ...layerNumber(() => "mu") },
    { id: "alpha", label: "Exponent alpha", kind: "none", linear: true, range: ofAlpha, ...layerNumber(() => "alpha") },
    { id: "strain", label: "Erosion strain", kind: "none", range: ofSample(strainKey, 2), ...layerNumber(strainKey) }]),
  ...within("of-powder", [
    { id: "powder-diameter", label: "Mean diameter", kind: "length", range: ofShots("diameter"), ...powderNumber("diameter") },
    { id: "spread", label: "Standard deviation over mean", kind: "share", linear: true, least: 0, range: () => [0, 1], ...powderNumber("spread") },
    { id: "breach", label: "Bounces below density · speed · radius of", kind: "impact", linear: true, least: 0,
      range: () => [0, 3 * skinBreach], ...powderNumber("breach") }])
];

const positions = 400;  // of a slider

function make(slider) {
  const row = document.createElement("div");
  row.className = "slider";
  row.innerHTML = `<label for="${slider.id}-number">${slider.label}</label>
    <input type="range" id="${slider.id}" min="0" max="${positions}" step="1" aria-label="${slider.label}">
    <input type="number" id="${slider.id}-number" step="any" inputmode="decimal"><span class="unit"></span>`;
  const [, bar, field, unit] = row.children;
  Object.assign(slider, { bar, field, unitWords: unit });
  bar.addEventListener("input", () => { slider.set(valueAt(slider, Number(bar.value))); changed(slider); });
  field.addEventListener("input", () => {
    const value = field.valueAsNumber * slider.unit.size;
    const accepted = Number.isFinite(value) && (slider.linear ? value >= (slider.least ?? -Infinity) : value > 0);
    field.setCustomValidity(accepted ? "" : "no such number");
    if (accepted) { slider.set(value); changed(slider, field); }
  });
  const before = slider.within === "of-material" ? found("chosen") : null;
  found(slider.within).insertBefore(row, before);
}

const valueAt = ({ ends: [low, high], linear }, position) =>
  linear ? low + (high - low) * position / positions : low * (high / low) ** (position / positions);
const positionOf = ({ ends: [low, high], linear }, value) =>
  Math.round(positions * (linear ? (value - low) / (high - low) : Math.log(value / low) / Math.log(high / low)));

// What the sliders show is what is chosen; the field that is being typed into is left alone.
function show(slider, typed) {
  const value = slider.get();
  slider.ends = slider.range();
  slider.unit = unitOf(slider.kind, slider.linear ? slider.ends[1] : Math.sqrt(slider.ends[0] * slider.ends[1]));
  slider.bar.value = positionOf(slider, value);
  slider.bar.setAttribute("aria-valuetext", inWords(value, slider.kind));
  if (slider.field !== typed) {
    slider.field.value = digitsOf(value / slider.unit.size, 5);
    slider.field.setCustomValidity("");
  }
  slider.unitWords.textContent = slider.unit.symbol;
}

// A powder is of the sphere's size until it has one of its own.
function changed(slider, typed) {
  if (slider.id === "diameter" && !state.powder.own) state.powder.diameter = state.shot.diameter;
  if (slider.id === "powder-diameter") state.powder.own = true;
  update(typed);
}

function options(id, names, chosen) {
  found(id).replaceChildren(...names.map((name, k) => new Option(name, k, false, k === chosen)));
}

// As the first shot into it that was fitted.
function chooseMaterial(k) {
  state.material = k;
  const like = shotsInto().find(one => one.fitted) ?? shotsInto()[0];
  state.shot = { diameter: 2 * like.radius_m, density: like.density_kg_m3, speed: like.speed_m_s, layerDepth: like.layer_depth_m };
  Object.assign(state.powder, { diameter: state.shot.diameter, own: false });
  asCalibrated();
}

function asCalibrated() {
  state.layer = 0;
  state.moved = pointOf(material(), 0).map(() => ({}));
  const covers = state.moved.length - 1;
  const names = Array.from({ length: covers }, (_, k) => covers === 1 ? "the cover" : `cover ${k + 1}`);
  options("layer", ["the layer", ...names], 0);
  found("layers").hidden = covers === 0;
  update();
}

