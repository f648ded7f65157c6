// What the page lets its reader choose, and what it then shows.
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
const layerNumber = key => ({ get: () => best()[state.layer][key()], set: value => { state.moved[state.layer][key()] = value; } });

const sliders = [
  { id: "diameter", within: "of-shot", label: "Diameter", kind: "length", range: ofShots("diameter"), ...shotNumber("diameter") },
  { id: "density", within: "of-shot", label: "Density of the sphere", kind: "density", range: ofShots("density_kg_m3"), ...shotNumber("density") },
  { id: "speed", within: "of-shot", label: "Speed", kind: "speed", range: ofShots("speed_m_s"), ...shotNumber("speed") },
  { id: "layer-depth", within: "of-shot", label: "Depth of the target", kind: "length", range: ofShots("layer_depth_m"), ...shotNumber("layerDepth") },
  { id: "mu", within: "of-material", label: "Shear modulus mu, true", kind: "pressure", range: ofSample(() => "mu", 3), ...layerNumber(() => "mu") },
  { id: "alpha", within: "of-material", label: "Exponent alpha", kind: "none", linear: true, range: ofAlpha, ...layerNumber(() => "alpha") },
  { id: "strain", within: "of-material", label: "Erosion strain", kind: "none", range: ofSample(() => strainKey(), 2), ...layerNumber(() => strainKey()) },
  { id: "powder-diameter", within: "of-powder", label: "Mean diameter", kind: "length", range: ofShots("diameter"), ...powderNumber("diameter") },
  { id: "spread", within: "of-powder", label: "Standard deviation over mean", kind: "share", linear: true, range: () => [0, 1], ...powderNumber("spread") },
  { id: "breach", within: "of-powder", label: "Bounces below density · speed · radius of", kind: "impact", linear: true, range: () => [0, 3 * skinBreach], ...powderNumber("breach") }
];

const positions = 400;  // of a slider

function make(slider) {
  const row = document.createElement("div");
  row.className = "slider";
  row.innerHTML = `<label for="${slider.id}-number">${slider.label}</label><input type="range" id="${slider.id}" min="0" max="${positions}" step="1"
    aria-label="${slider.label}"><input type="number" id="${slider.id}-number" step="any" inputmode="decimal"><span class="unit"></span>`;
  const [, bar, field, unit] = row.children;
  Object.assign(slider, { bar, field, unitWords: unit });
  bar.addEventListener("input", () => { slider.set(valueAt(slider, Number(bar.value))); changed(slider); });
  field.addEventListener("input", () => {
    const value = field.valueAsNumber * slider.unit.size, accepted = Number.isFinite(value) && (value > 0 || slider.linear);
    field.setCustomValidity(accepted ? "" : "a number above 0");
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
  if (slider.field !== typed) slider.field.value = digitsOf(value / slider.unit.size, 5);
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
  options("layer", ["the layer", ...Array.from({ length: covers }, (_, k) => covers === 1 ? "the cover" : `cover ${k + 1}`)], 0);
  found("layers").hidden = covers === 0;
  update();
}

// --- what is shown ----------------------------------------------------------------------------------------------

function put(id, value, kind) {
  found(id).value = Number.isNaN(value) ? "" : value;
  found(id).textContent = inWords(value, kind, 4, true);
}

const chosen = (some = points()) => ({ points: some, scatter: material().scatter, freedom: material().freedom, level: given.level });

// In which numbers the shot lies beyond those that were fitted.
function beyondFitted(here) {
  const fitted = given.shots.filter(one => one.fitted && one.material === state.material), ways = [];
  const compare = (name, kind, value, of) => {
    const all = fitted.map(of), low = Math.min(...all), high = Math.max(...all);
    if (all.length === 0 || (value >= low * (1 - rounding) && value <= high * (1 + rounding))) return;
    const range = high > low * (1 + rounding) ? `${inWords(low, kind, 3)} to ${inWords(high, kind, 3)}` : inWords(low, kind, 3);
    ways.push(`${name} ${inWords(value, kind, 3)}, fitted ${range}`);
  };
  compare("speed", "speed", here.speed, one => one.speed_m_s);
  compare("diameter", "length", 2 * here.radius, one => 2 * one.radius_m);
  compare("density", "density", here.density, one => one.density_kg_m3);
  compare("layer", "length", here.layerDepth, one => one.layer_depth_m);
  return ways;
}

function notesOn(here, answer) {
  const hypothesis = given.hypotheses[state.hypothesis], notes = [];
  if (!(here.layerDepth > here.radius)) notes.push("The target is no deeper than the sphere's radius: percal predict refuses this shot.");
  if (hypothesis.contradicted) notes.push("The data contradict each other under this hypothesis: what follows from it is no prediction to rely on.");
  for (const way of beyondFitted(here)) notes.push(`Beyond what was fitted: ${way}.`);
  if (answer.beyondRuns > 0) notes.push(`Beyond what was fitted: the emulator's runs end ${(50 * answer.beyondRuns).toFixed(0)} % of their range before it.`);
  if (isMoved()) notes.push("One point of the material was chosen: the band holds the emulator's error and the scatter, not that of the parameters.");
  if (hypothesis.mesh_error) notes.push(`Depths are those of the calibration's mesh; without a mesh they would change by ${hypothesis.mesh_error > 0 ? "+" : ""}${digitsOf(100 * hypothesis.mesh_error, 2)} %.`);
  return notes;
}

function showAnswer(here, answer) {
  put("depth", answer.depth, "length");
  ["low", "high"].forEach((end, k) => {
    put("shot-" + end, answer.shot[k], "length");
    put("mean-" + end, answer.mean[k], "length");
  });
  const percent = (share, digits = 2) => digitsOf(100 * share, digits) + " %";
  found("by-source").textContent = `Standard deviation of the depth by parameters ${percent(answer.byParameters)}, emulator ${percent(answer.byEmulator)}, scatter ${percent(material().scatter)}.`;
  const passing = found("passing"), chance = document.createElement("data");
  Object.assign(chance, { id: "passes", value: answer.passes, textContent: digitsOf(100 * answer.passes, 4) + " %" });
  passing.replaceChildren();
  if (given.passage) {
    const left = here.speed * shareLeft(here.layerDepth, answer.depth), speed = document.createElement("data");
    Object.assign(speed, { id: "speed-left", value: left, textContent: inWords(left, "speed", 4, true) });
    passing.append("Passes the target with a probability of ", chance, "; speed left ", speed, ".");
  } else if (answer.passes >= 0.005) {
    passing.append("As deep as the target with a probability of ", chance, ". Depths near its lower face are those of a layer that holds.");
  }
  found("notes").replaceChildren(...notesOn(here, answer).map(note => Object.assign(document.createElement("li"), { textContent: note })));
  const quoted = text => "'" + text.replaceAll("'", "'\\''") + "'";
  found("command").textContent = isMoved() ? "percal predict knows the calibrated material alone." : [
    `percal predict ${quoted(given.result)} --hypothesis ${state.hypothesis + 1} --material ${quoted(material().name)}`,
    `--diameter '${2 * here.radius} m' --particle-density '${here.density} kg/m3' --speed '${here.speed} m/s' --layer-depth '${here.layerDepth} m'`].join(" ");
}

// --- figures, each a piece of work that can be broken off between its points ------------------------------------

function* showOverSpeed(here) {
  const isLike = one => Math.abs(one.radius_m / here.radius - 1) < 0.02 && Math.abs(one.density_kg_m3 / here.density - 1) < 0.02;
  const like = given.shots.filter(one => one.material === state.material && one.depth_m && isLike(one));
  const speeds = shotsInto().map(one => one.speed_m_s), low = 0.95 * Math.min(0.85 * here.speed, ...speeds), high = 1.05 * Math.max(1.15 * here.speed, ...speeds);
  const some = points().filter((_, k, all) => k % Math.ceil(all.length / 40) === 0), curve = [];
  for (let k = 0; k <= 24; ++k, yield) {
    const speed = low + (high - low) * k / 24;
    curve.push({ speed, ...predict(emulator, bulk, chosen(some), { ...here, speed }) });
  }
  const deepest = 1.05 * Math.max(...curve.flatMap(one => [one.depth, one.shot[1]]).filter(Number.isFinite), ...like.map(one => one.depth_m));
  const band = key => curve.map(one => [one.speed, ...one[key]]);
  const name = given.passage ? "Reach" : "Depth";
  draw(found("over-speed"), `${name} over speed`, axisOf("speed", "speed", low, high), axisOf(name.toLowerCase(), "length", 0, deepest), [
    { kind: "band", class: "of-shot", points: band("shot") },
    { kind: "band", class: "of-mean", points: band("mean") },
    { kind: "line", class: "layer", points: [[low, here.layerDepth], [high, here.layerDepth]] },
    { kind: "line", class: "curve", points: curve.map(one => [one.speed, one.depth]) },
    ...["fired", "fired least"].map((name, least) => (
      { kind: "dots", class: name, points: like.filter(one => (one.seen !== "depth") == least).map(one => [one.speed_m_s, one.depth_m]) })),
    { kind: "dots", class: "here", size: 6, points: [[here.speed, Number(found("depth").value)]] }]);
  found("over-speed-words").textContent = `with the ${level} of one shot and, darker, of the mean; rings: shots fired with such spheres (${like.length}), broken where they went at least so deep; dashed: the target's lower face.`;
}

function* showRidge(here) {
  const at = best(), key = strainKey(), layer = at[state.layer];
  const sample = material().points.map((_, k) => pointOf(material(), k)[state.layer]).map(one => [one.mu, one[key]]);
  const ends = column => {
    const all = [...sample.map(pair => pair[column]), [layer.mu, layer[key]][column]];
    return [Math.min(...all) / 1.25, Math.max(...all) * 1.25];
  };
  const [lowest, highest] = ends(0), strains = ends(1), pairs = [];
  for (let k = 0; k <= 24; ++k, yield)
    pairs.push(...equalDepth(emulator, bulk, at, state.layer, here, [lowest * (highest / lowest) ** (k / 24)], strains));
  draw(found("ridge"), "Erosion strain over modulus", axisOf("mu, true", "pressure", lowest, highest, true), axisOf("erosion strain", "none", ...strains, true), [
    { kind: "dots", class: "sample", size: 3, points: sample },
    { kind: "line", class: "curve", points: pairs },
    { kind: "dots", class: "here", size: 6, points: [[layer.mu, layer[key]]] }]);
  found("ridge-words").textContent = "grey: what the data allow; line: pairs that give this shot the same depth at this alpha; orange: the point chosen.";
}

function* showDose(here) {
  const powder = { ...state.powder, weighed: state.powder.weighting === "mass", scatter: material().scatter };
  const dose = doseOf(emulator, bulk, best(), here, powder);
  yield;
  for (const by of ["mass", "number"]) {
    for (const what of ["bounced", "passed"]) {
      put(by + "-" + what, dose[by][what], "share");
      found(by + "-" + what).textContent = (100 * dose[by][what]).toFixed(2) + " %";
    }
    put(by + "-mean", dose[by].mean, "length");
    put(by + "-deviation", dose[by].deviation, "length");
  }
  const deepest = Math.min(here.layerDepth, dose.mass.mean + 4 * dose.mass.deviation || here.layerDepth), bars = 30, shares = [];
  for (let k = 0; k < bars; ++k) {
    const from = deepest * k / bars, to = deepest * (k + 1) / bars;
    shares.push([from, to, dose.above("mass", to) - (k > 0 ? dose.above("mass", from) : 0)]);
  }
  draw(found("dose"), "Share of the powder's mass over depth", axisOf("depth", "length", 0, deepest),
    axisOf("share of the mass", "share", 0, Math.max(1e-3, 1.08 * Math.max(...shares.map(one => one[2])))), [{ kind: "bars", class: "bars", points: shares }]);
}

// --- in slices, so that the page stays awake --------------------------------------------------------------------

const slice = 12;  // ms
function inSlices(work, done, isWanted = () => true) {
  const go = () => {
    for (const end = performance.now() + slice; performance.now() < end;) {
      if (!isWanted()) return;
      if (work.next().done) return done();
    }
    setTimeout(go, 0);
  };
  setTimeout(go, 0);
}

let updates = 0;
function update(typed) {
  const mine = ++updates, here = shot(), answer = predict(emulator, bulk, chosen(), here);
  for (const slider of sliders) show(slider, typed);
  found("back").disabled = !isMoved();
  found("chosen").textContent = isMoved() ? "A point that you chose." : `As calibrated: ${material().points.length} points that the data allow; the sliders show the best.`;
  showAnswer(here, answer);
  found("explorer").setAttribute("aria-busy", "true");
  function* figures() {
    yield* showOverSpeed(here);
    yield* showRidge(here);
    yield* showDose(here);
  }
  inSlices(figures(), () => found("explorer").setAttribute("aria-busy", emulator.rows ? "false" : "true"), () => mine === updates);
}

const level = digitsOf(100 * given.level, 4) + " %";
for (const words of document.querySelectorAll(".level")) words.textContent = level;
found("called").textContent = given.passage ? "Reach" : "Depth";
for (const slider of sliders) make(slider);
options("hypothesis", given.hypotheses.map(one => one.name), 0);
options("material", given.hypotheses[0].materials.map(one => one.name), given.material);
found("hypothesis").addEventListener("change", event => { state.hypothesis = Number(event.target.value); asCalibrated(); });
found("material").addEventListener("change", event => chooseMaterial(Number(event.target.value)));
found("layer").addEventListener("change", event => { state.layer = Number(event.target.value); update(); });
found("weighting").addEventListener("change", event => { state.powder.weighting = event.target.value; update(); });
found("back").addEventListener("click", asCalibrated);
for (const form of document.forms) form.addEventListener("submit", event => event.preventDefault());
addEventListener("resize", () => update());
chooseMaterial(given.material);
inSlices(emulator.factor(), () => update());
