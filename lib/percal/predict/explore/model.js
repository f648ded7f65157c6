// The twin of `percal predict` and of the best point of `percal dose`: what a calibration says of a shot, from the data that explorer.cpp
// writes. SI; depths are ln m until they are shown. Equations: E docs/theory/emulator.md, C calibration.md, P prediction.md, D powder.md.
"use strict";

const square = x => x * x;
const sum = (values, of = x => x) => values.reduce((all, x) => all + of(x), 0);

// --- a shot as inputs of the emulator ---------------------------------------------------------------------------

// The numbers of a point of a material's sample: the layer's, then those of each cover, the next to it first.
function pointOf(material, k) {
  return [material, ...(material.covers ?? [])].map(layer => {
    const [mu, alpha, strain, length, rateExponent, sizeExponent, strainBelow, ...relaxation] = layer.points[k];
    return { mu, alpha, strain, length, rateExponent, sizeExponent, strainBelow, relaxation, of: layer };
  });
}

const isBelowCell = (layer, radius) => 2 * radius < layer.of.cell_m;

// What the shot meets of a layer: its laws applied.                                                              C (3a) to (3d)
function met(layer, { radius, speed }) {
  const { of, relaxation } = layer;
  let share = (speed / radius / of.reference_rate_1_s) ** layer.rateExponent;
  if (relaxation.length > 0) share = 1;
  for (let k = 0; k < relaxation.length; k += 2) share += relaxation[k] * Math.expm1(-radius / speed / relaxation[k + 1]);
  return {
    density: of.density_kg_m3,
    mu: layer.mu * share,
    alpha: layer.alpha,
    strain: (isBelowCell(layer, radius) ? layer.strainBelow : layer.strain) * (radius / of.reference_radius_m) ** layer.sizeExponent
  };
}

// ln(W/mu) of a tension test until it erodes.                                                                    E (2)
function logErosionEnergy(alpha, strain) {
  const l = Math.log1p(strain);
  if (Math.abs(alpha) < 1e-4) return Math.log(1.5) + 2 * Math.log(l) + alpha * l / 6;
  return Math.log(2 / square(alpha) * (Math.expm1(alpha * l) + 2 * Math.expm1(-alpha * l / 2)));
}

// What the covariance sees of a shot into the layers of a point, in the order of SphereInputs.                   E (2), (2a)
function depthFeatures(shot, point, bulk) {
  const [layer, ...covers] = point.map(one => met(one, shot));
  const pi4 = layer.density * square(shot.speed) / layer.mu;
  const energy = logErosionEnergy(layer.alpha, layer.strain);
  const features = [
    Math.log(pi4) - energy,
    Math.log(layer.density / shot.density),
    layer.alpha,
    layer.strain,
    Math.log(shot.layerDepth / shot.radius),
    Math.log(Math.max(bulk.least, bulk.at_rest + bulk.by_pi4 * pi4)),
    point[0].length ? Math.log(point[0].length / shot.radius) : 0
  ];
  covers.forEach((cover, k) => {
    const thickness = point[k + 1].of.thickness_m / shot.radius, weight = Math.log1p(thickness);
    const q = 4 * thickness / (shot.density * square(shot.speed));
    features.push(
      weight,
      weight * Math.log(cover.density / layer.density),
      Math.log1p(q * cover.mu * Math.exp(logErosionEnergy(cover.alpha, cover.strain))) - Math.log1p(q * layer.mu * Math.exp(energy)),
      weight * (cover.alpha - layer.alpha),
      weight * (cover.strain - layer.strain));
  });
  return features;
}

// --- the emulator -----------------------------------------------------------------------------------------------

// E (3), Matern 5/2.
function correlation(s) {
  const r = Math.sqrt(5 * s);
  return (1 + r + r * r / 3) * Math.exp(-r);
}

class Emulator {
  // `data` as explorer.cpp writes it: the runs' scaled inputs and mesh factors g = (h/0.1)^q, K^-1 y, and what K is made of.
  constructor(data) {
    this.data = data;
    this.inputs = Float64Array.from(data.runs.flat());
    [this.perLength, this.perMeshLength] = [data.length, data.mesh_length].map(all => Float64Array.from(all, one => 1 / square(one)));
    this.rows = null;  // of L, K = L L^T
  }

  scaled(features) {
    const { seen, centre, half_range } = this.data;
    return seen.map((feature, j) => ((features[feature] ?? 0) - centre[j]) / half_range[j]);
  }

  // Of the smooth depth at the scaled inputs u, on a mesh of factor g, with the first `count` runs.                E (4)
  covariances(u, g, count = this.data.mesh.length) {
    const { amplitude, mesh_amplitude, plane_variance, mesh } = this.data, { inputs, perLength, perMeshLength } = this;
    const found = new Float64Array(count), n = u.length;
    for (let i = 0; i < count; ++i) {
      let plane = 1 + g * mesh[i], s = 0, sMesh = 0;
      for (let j = 0; j < n; ++j) {
        const other = inputs[i * n + j], difference = u[j] - other;
        plane += u[j] * other;
        s += square(difference) * perLength[j];
        sMesh += square(difference) * perMeshLength[j];
      }
      found[i] = plane_variance * plane + square(amplitude) * correlation(s);
      if (mesh_amplitude > 0) found[i] += square(mesh_amplitude) * g * mesh[i] * correlation(sMesh);
    }
    return found;
  }

  // ln(depth/radius) on the mesh of predictions.                                                                 E (6)
  mean(features) {
    const { weights, mean, mesh_here } = this.data, with_ = this.covariances(this.scaled(features), mesh_here);
    let found = mean;
    for (let i = 0; i < weights.length; ++i) found += weights[i] * with_[i];
    return found;
  }

  // Cholesky's factor, row by row: a generator, so that the page can do something else in between.
  *factor() {
    const { runs, mesh, noise } = this.data, rows = [];
    for (let i = 0; i < runs.length; ++i) {
      const row = this.covariances(runs[i], mesh[i], i + 1);
      row[i] += square(noise[i]);
      for (let j = 0; j <= i; ++j) {
        const other = j < i ? rows[j] : row;
        let left = row[j];
        for (let k = 0; k < j; ++k) left -= row[k] * other[k];
        row[j] = j < i ? left / other[j] : Math.sqrt(left);
      }
      rows.push(row);
      yield i;
    }
    this.rows = rows;
  }

  // Standard deviation of the smooth depth; NaN until the factor is there.                                       E (6)
  deviation(features) {
    if (!this.rows) return NaN;
    const { plane_variance, amplitude, mesh_amplitude, mesh_here: g } = this.data, u = this.scaled(features);
    let variance = plane_variance * (1 + sum(u, square) + square(g)) + square(amplitude) + square(mesh_amplitude * g);
    const known = this.covariances(u, g);
    this.rows.forEach((row, i) => {
      for (let k = 0; k < i; ++k) known[i] -= row[k] * known[k];
      known[i] /= row[i];
      variance -= square(known[i]);
    });
    return Math.sqrt(Math.max(0, variance));
  }

  // By how much the inputs lie beyond the runs, in half their range; 0: not at all.
  beyond(features) {
    const furthest = Math.max(...this.scaled(features).map(Math.abs));
    return furthest > 1 + rounding ? furthest - 1 : 0;
  }
}

// --- distributions ----------------------------------------------------------------------------------------------

const rounding = 1e-6;  // relative: numbers that differ by less are one

// Student's distribution function, the normal one for freedom 0: its density is integrated over x = asinh z once, by Simpson's rule, and
// read off by a cubic through values and slopes.
const studentCdf = (() => {
  const step = 0.01, half = 2000, tables = new Map();
  const table = freedom => {
    const density = z => freedom > 0 ? (1 + z * z / freedom) ** (-(freedom + 1) / 2) : Math.exp(-z * z / 2);
    const slopeAt = k => density(Math.sinh((k - half) * step)) * Math.cosh((k - half) * step);
    const slope = Float64Array.from({ length: 2 * half + 1 }, (_, k) => slopeAt(k)), below = new Float64Array(slope.length);
    for (let k = 1; k < slope.length; ++k) below[k] = below[k - 1] + (slope[k - 1] + 4 * slopeAt(k - 0.5) + slope[k]) / 6;
    const all = below[2 * half];
    return { below: below.map(one => one / all), slope: slope.map(one => one / all) };
  };
  return (z, freedom) => {
    if (!tables.has(freedom)) tables.set(freedom, table(freedom));
    const { below, slope } = tables.get(freedom), at = Math.asinh(z) / step + half, k = Math.floor(at), t = at - k;
    if (!(k >= 0 && k < 2 * half)) return k < 0 ? 0 : 1;
    const rise = below[k + 1] - below[k], first = slope[k], last = slope[k + 1];
    return below[k] + t * (first + t * (3 * rise - 2 * first - last + t * (first + last - 2 * rise)));
  };
})();
const normalCdf = z => studentCdf(z, 0);

// Where an f that rises is 0, between low and high or beyond, where it does not change its sign between them.
function rootOf(f, low, high) {
  for (let step = high - low; f(low) > 0 && step < 1e6; step *= 2) low -= step;
  for (let step = high - low; f(high) < 0 && step < 1e6; step *= 2) high += step;
  for (let k = 0; k < 50; ++k) {
    const middle = (low + high) / 2;
    if (f(middle) > 0) high = middle; else low = middle;
  }
  return (low + high) / 2;
}

// For each point of a sample a Student distribution about that point's own answer.                               P (1), (2)
const shareBelow = ({ centres, deviation, freedom }, x) => sum(centres, c => studentCdf((x - c) / deviation, freedom)) / centres.length;
function interval(mixture, level) {
  const { centres, deviation } = mixture, low = Math.min(...centres) - deviation, high = Math.max(...centres) + deviation;
  return [0.5 - level / 2, 0.5 + level / 2].map(share => Math.exp(rootOf(x => shareBelow(mixture, x) - share, low, high)));
}

// --- what is said of a shot -------------------------------------------------------------------------------------

// The part v_left/v of the speed that is left behind a layer by a reach.                                         E (1a)
const shareLeft = (layerDepth, reach) => reach > layerDepth ? Math.sqrt(1 - layerDepth / reach) : 0;

// Of a material's points, the best first, one alone where the numbers were chosen. As `percal predict` has it; what hangs on the emulator's
// error is NaN until its factor is there.
function predict(emulator, bulk, { points, scatter, freedom, level }, shot) {
  const features = points.map(point => depthFeatures(shot, point, bulk));
  const centres = features.map(one => emulator.mean(one) + Math.log(shot.radius));
  const byEmulator = emulator.deviation(features[0]);
  const mean = { centres, deviation: Math.max(1e-6, byEmulator), freedom: 0 };
  const one = { centres, deviation: Math.hypot(mean.deviation, scatter), freedom };
  const known = !Number.isNaN(byEmulator);
  return {
    depth: Math.exp(centres[0]),
    mean: known ? interval(mean, level) : [NaN, NaN],
    shot: known ? interval(one, level) : [NaN, NaN],
    passes: known ? 1 - shareBelow(one, Math.log(shot.layerDepth)) : NaN,
    byParameters: Math.sqrt(sum(centres, c => square(c - centres[0])) / centres.length),
    byEmulator,
    beyondRuns: emulator.beyond(features[0])
  };
}

// Pairs of modulus and erosion strain of a point's layer k at which the shot goes as deep as at this point, for the given moduli.
function equalDepth(emulator, bulk, point, k, shot, moduli, [lowest, highest]) {
  const key = isBelowCell(point[k], shot.radius) ? "strainBelow" : "strain", pairs = [];
  const depth = (mu, strain) => emulator.mean(depthFeatures(shot, point.map((layer, i) => i === k ? { ...layer, mu, [key]: strain } : layer), bulk));
  const wanted = depth(point[k].mu, point[k][key]);
  for (const mu of moduli) {
    let low = Math.log(lowest), high = Math.log(highest);
    if (depth(mu, lowest) < wanted || depth(mu, highest) > wanted) continue;
    for (let step = 0; step < 18; ++step) {
      const middle = (low + high) / 2;
      if (depth(mu, Math.exp(middle)) < wanted) high = middle; else low = middle;
    }
    pairs.push([mu, Math.exp((low + high) / 2)]);
  }
  return pairs;
}

// --- the dose of a powder ---------------------------------------------------------------------------------------

// Of spheres like the shot whose diameters are lognormal, of a mean and a standard deviation (a share of it), counted or weighed, at one
// point. A particle whose density times speed times radius is below `breach` bounces.
function doseOf(emulator, bulk, point, shot, { diameter, spread, weighed, breach, scatter }) {
  const s = Math.sqrt(Math.log1p(square(spread)));
  const median = diameter / 2 * Math.exp(-s * s / 2 - (weighed ? 3 * s * s : 0));                              // D (1), (2)
  const sigma = Math.max(scatter, 1e-6), cells = s > 0 ? 240 : 1, last = 5.5 + 3 * s;  // deviations of ln radius
  const goesIn = Math.log(breach / (shot.density * shot.speed) / median) / Math.max(s, 1e-9);
  const first = Math.min(last, Math.max(-5.5, goesIn)), step = (last - first) / cells;
  // Shares below an edge, tails included.
  const below = (k, shift) => k === 0 && first === -5.5 ? 0 : k === cells && first < last ? 1 : normalCdf(first + k * step - shift);
  const share = (k, shift) => below(k + 1, shift) - below(k, shift), classes = [];
  for (let k = 0; k < cells; ++k) {
    const radius = median * Math.exp(s * (first + (k + 0.5) * step));
    const depth = emulator.mean(depthFeatures({ ...shot, radius }, point, bulk)) + Math.log(radius);
    classes.push({ depth, number: share(k, 0), mass: share(k, 3 * s) });                                       // D (4)
  }
  const above = (by, depth) => sum(classes, one => one[by] * normalCdf((Math.log(depth) - one.depth) / sigma));  // D (6)
  const moment = (by, p) => sum(classes, one => one[by] * Math.exp(p * one.depth + square(p * sigma) / 2) *
    normalCdf((Math.log(shot.layerDepth) - one.depth) / sigma - p * sigma)) / above(by, shot.layerDepth);         // D (7)
  const summary = by => {
    const within = above(by, shot.layerDepth), bounced = 1 - sum(classes, one => one[by]), mean = moment(by, 1);
    return { bounced, passed: 1 - bounced - within, mean, deviation: Math.sqrt(Math.max(0, moment(by, 2) - square(mean))) };
  };
  return { above, mass: summary("mass"), number: summary("number") };
}
