// What the page says and draws of what was chosen.
"use strict";

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
  const ways = beyondFitted(here), { mesh_error: meshError } = hypothesis;
  if (answer.beyondRuns > 0) ways.push(`the emulator's runs end ${(50 * answer.beyondRuns).toFixed(0)} % of their range before it`);
  if (!(here.layerDepth > here.radius)) notes.push("The target is no deeper than the sphere's radius: percal predict refuses this shot.");
  if (hypothesis.contradicted)
    notes.push("The data contradict each other under this hypothesis: what follows from it is no prediction to rely on.");
  notes.push(...ways.map(way => `Beyond what was fitted: ${way}.`));
  if (isMoved())
    notes.push("One point of the material was chosen: the band holds the emulator's error and the scatter, not that of the parameters.");
  if (meshError)
    notes.push("Depths are those of the calibration's mesh; without a mesh they would change by " +
      `${meshError > 0 ? "+" : ""}${digitsOf(100 * meshError, 2)} %.`);
  return notes;
}

// Of which rate, size and material the numbers on the sliders are.
function wordsOnMaterial() {
  const { rateExponent, sizeExponent, relaxation, of } = best()[state.layer];
  const words = [isMoved() ? "A point that you chose."
    : `As calibrated: ${material().points.length} points that the data allow; the sliders show the best.`];
  if (relaxation.length > 0) words.push("The modulus is the instantaneous one.");
  else if (rateExponent !== 0) words.push(`The modulus is that at a rate of ${digitsOf(of.reference_rate_1_s, 3)} 1/s.`);
  if (sizeExponent !== 0) words.push(`The erosion strain is that at a radius of ${inWords(of.reference_radius_m, "length", 3)}.`);
  if (of.cell_m > 0)
    words.push(`It is that of spheres ${strainKey() === "strain" ? "above" : "below"} the cell of ${inWords(of.cell_m, "length", 3)}.`);
  return words.join(" ");
}

function showAnswer(here, answer) {
  put("depth", answer.depth, "length");
  ["low", "high"].forEach((end, k) => {
    put("shot-" + end, answer.shot[k], "length");
    put("mean-" + end, answer.mean[k], "length");
  });
  const percent = (share, digits = 2) => digitsOf(100 * share, digits) + " %";
  const sources = { parameters: answer.byParameters, emulator: answer.byEmulator, scatter: material().scatter };
  found("by-source").textContent =
    `Standard deviation of the depth by ${Object.entries(sources).map(([name, share]) => `${name} ${percent(share)}`).join(", ")}.`;
  const passing = found("passing"), chance = document.createElement("data");
  Object.assign(chance, { id: "passes", value: answer.passes, textContent: digitsOf(100 * answer.passes, 4) + " %" });
  passing.replaceChildren();
  if (given.passage) {
    const left = here.speed * shareLeft(here.layerDepth, answer.depth), speed = document.createElement("data");
    Object.assign(speed, { id: "speed-left", value: left, textContent: inWords(left, "speed", 4, true) });
    passing.append("Passes the target with a probability of ", chance, "; speed left ", speed, ".");
  } else if (answer.passes >= 0.005) {
    passing.append("As deep as the target with a probability of ", chance,
      ". Depths near its lower face are those of a layer that holds.");
  }
  const item = note => Object.assign(document.createElement("li"), { textContent: note });
  found("notes").replaceChildren(...notesOn(here, answer).map(item));
  const quoted = text => "'" + text.replaceAll("'", "'\\''") + "'";
  found("command").textContent = isMoved() ? "percal predict knows the calibrated material alone." : [
    `percal predict ${quoted(given.result)} --hypothesis ${state.hypothesis + 1} --material ${quoted(material().name)}`,
    `--diameter '${2 * here.radius} m' --particle-density '${here.density} kg/m3'`,
    `--speed '${here.speed} m/s' --layer-depth '${here.layerDepth} m'`].join(" ");
}

// --- figures, each a piece of work that can be broken off between its points ------------------------------------

function* showOverSpeed(here) {
  const isNear = (a, b) => Math.abs(a / b - 1) < 0.02;
  const like = given.shots.filter(one => one.material === state.material && one.depth_m &&
    isNear(one.radius_m, here.radius) && isNear(one.density_kg_m3, here.density));
  const speeds = shotsInto().map(one => one.speed_m_s);
  const low = 0.95 * Math.min(0.85 * here.speed, ...speeds), high = 1.05 * Math.max(1.15 * here.speed, ...speeds);
  const some = points().filter((_, k, all) => k % Math.ceil(all.length / 40) === 0), curve = [];
  for (let k = 0; k <= 24; ++k, yield) {
    const speed = low + (high - low) * k / 24;
    curve.push({ speed, ...predict(emulator, bulk, chosen(some), { ...here, speed }) });
  }
  const depths = [...curve.flatMap(one => [one.depth, one.shot[1]]), ...like.map(one => one.depth_m)];
  const deepest = 1.05 * Math.max(...depths.filter(Number.isFinite));
  const fired = atLeast => like.filter(one => (one.seen !== "depth") === atLeast).map(one => [one.speed_m_s, one.depth_m]);
  const band = key => curve.map(one => [one.speed, ...one[key]]);
  const name = given.passage ? "Reach" : "Depth";
  draw(found("over-speed"), `${name} over speed`, axisOf("speed", "speed", low, high), axisOf(name.toLowerCase(), "length", 0, deepest), [
    { kind: "band", class: "of-shot", points: band("shot") },
    { kind: "band", class: "of-mean", points: band("mean") },
    { kind: "line", class: "layer", points: [[low, here.layerDepth], [high, here.layerDepth]] },
    { kind: "line", class: "curve", points: curve.map(one => [one.speed, one.depth]) },
    { kind: "dots", class: "fired", points: fired(false) },
    { kind: "dots", class: "fired least", points: fired(true) },
    { kind: "dots", class: "here", size: 6, points: [[here.speed, Number(found("depth").value)]] }]);
  found("over-speed-words").textContent = `with the ${level} of one shot and, darker, of the mean; rings: shots fired with such spheres ` +
    `(${like.length}), broken where they went at least so deep; dashed: the target's lower face.`;
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
  const x = axisOf("mu, true", "pressure", lowest, highest, true), y = axisOf("erosion strain", "none", ...strains, true);
  draw(found("ridge"), "Erosion strain over modulus", x, y, [
    { kind: "dots", class: "sample", size: 3, points: sample },
    { kind: "line", class: "curve", points: pairs },
    { kind: "dots", class: "here", size: 6, points: [[layer.mu, layer[key]]] }]);
  found("ridge-words").textContent =
    "grey: what the data allow; line: pairs that give this shot the same depth at this alpha; orange: the point chosen.";
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
  found("dose-words").textContent = `${(100 * (1 - dose.mass.bounced - dose.mass.passed)).toFixed(1)} % within the target; ` +
    "by the best point, or the one chosen. percal dose gives intervals, too, and spreads of density and speed.";
  const deepest = Math.min(here.layerDepth, dose.mass.mean + 4 * dose.mass.deviation || here.layerDepth), bars = 30, shares = [];
  for (let k = 0; k < bars; ++k) {
    const from = deepest * k / bars, to = deepest * (k + 1) / bars;
    shares.push([from, to, dose.above("mass", to) - dose.above("mass", from)]);
  }
  const highest = Math.max(1e-3, 1.08 * Math.max(...shares.map(one => one[2])));
  draw(found("dose"), "Share of the powder's mass over depth", axisOf("depth", "length", 0, deepest),
    axisOf("share of the mass", "share", 0, highest), [{ kind: "bars", class: "bars", points: shares }]);
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
  found("chosen").textContent = wordsOnMaterial();
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
let width = innerWidth;
addEventListener("resize", () => { if (innerWidth !== width) { width = innerWidth; update(); } });
chooseMaterial(given.material);
inSlices(emulator.factor(), () => update());
