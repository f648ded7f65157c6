"""Single shots: what a calibration says of one that was not fired, what the depth of one says of its layer."""

import json
import os
from collections.abc import Mapping

import numpy as np

from . import _core
from ._fit import interval_of
from ._page import _Result
from ._shown import between, with_unit

# Of numbers without a unit: SI.
_UNITS = {
    "speed": "m/s",
    "radius": "m",
    "diameter": "m",
    "particle_density": "kg/m3",
    "particle_mass": "kg",
    "depth": "m",
    "depth_error": "m",
    "density": "kg/m3",
    "mu": "Pa",
    "erosion_length": "m",
    "layer_depth": "m",
    "layer_width": "m",
}


def _words(said):
    """The arguments as the program's options have them."""
    return {
        name: os.fspath(value)
        if isinstance(value, (str, os.PathLike))
        else f"{float(value)!r} {_UNITS.get(name, '')}".strip()
        for name, value in said.items()
        if value is not None
    }


def _store(store):
    return _core.default_store_path() if store is None else os.fspath(store)


def _arrays(rows, keys, interval_keys):
    """Columns of a list of dicts; of an interval its two ends."""

    def column(pick):
        return np.array([np.nan if pick(row) is None else pick(row) for row in rows], dtype=float)

    found = {key: column(lambda row, key=key: row[key]) for key in keys}
    for key, name in interval_keys.items():
        for end in ("low", "high"):
            found[name.format(end)] = column(lambda row, key=key, end=end: (row[key] or {end: None})[end])
    return found


class Prediction(_Result):
    """Shots that were not fired: the keys of percal predict's result.json, and arrays of it.

    shots: {"label", "speed_m_s", "depth_m", "mean_low_m", "mean_high_m", "low_m", "high_m"}, low to high being the interval of one
    shot; curve: the same over speed, without labels; depth: of a single shot, m, else None; value: the number that gives the depth
    asked for, SI, None where none was asked for or none does; findings.
    """

    def __init__(self, result):
        super().__init__(result)
        ends = {"mean_interval_m": "mean_{}_m", "shot_interval_m": "{}_m"}
        self.shots = _arrays(result["shots"], ("speed_m_s", "depth_m"), ends)
        self.shots["label"] = [row["label"] for row in result["shots"]]
        self.curve = _arrays(result["curve"], ("speed_m_s", "depth_m"), ends)
        self.depth = result["shots"][0]["depth_m"] if len(result["shots"]) == 1 else None
        solved = result["solved"] or {}
        self.value = next((solved[key] for key in ("value_m_s", "value_m", "value_kg_m3") if key in solved), None)
        self.findings = result["findings"]

    def __repr__(self):
        shots = [
            f"{label}: {with_unit(depth, 'm')} [{with_unit(low, 'm')}, {with_unit(high, 'm')}]"
            for label, depth, low, high in zip(*(self.shots[key] for key in ("label", "depth_m", "low_m", "high_m")))
        ]
        return f"Prediction({'; '.join(shots) or str(self.curve['depth_m'].size) + ' speeds'})"


def predict(result, *, level=None, v50=False, verify=False, store=None, threads=0, **said):
    """Shots that were not fired, from a finished calibration: percal predict.

    result: of percal.calibrate(), or its result.json or folder; said: the program's options as texts with their units or as SI
    numbers: speed ("83 m/s", "50..250 m/s"), radius or diameter, particle_density or particle_mass, layer_depth, speed_error, shots
    (a CSV), depth and solve_for, material, hypothesis. What is left out is what the fitted shots have in common. v50: look,
    in place of depth, for the number at which half of the shots pass the layer; verify: run the solver at every shot, with the store
    and threads of calibrate().
    """
    if isinstance(result, Mapping):
        text, name = json.dumps(getattr(result, "result", result)), "this result"
    else:
        name = os.fspath(result)
        if os.path.isdir(name):
            name = os.path.join(name, "result.json")
        with open(name, encoding="utf-8") as file:
            text = file.read()
    return Prediction(json.loads(_core.predict(text, name, _words(said), level, v50, verify, _store(store), threads)))


class Inversion(_Result):
    """The number of a layer that one depth asks for: the keys of percal invert's result.json, and parts of it.

    found: whether there is one; mu (Pa, true), erosion_strain: the pair, None for a number that was not found; interval: of the one
    that was looked for; ridge: {"mu_Pa", "erosion_strain", "low", "high"}, arrays over the given number, low to high being the interval of
    the other; warnings; findings.
    """

    def __init__(self, result):
        super().__init__(result)
        self.found = result["found"]
        pair = result["pair"]
        self.mu, self.erosion_strain = pair["mu_Pa"], pair["erosion_strain"]
        key = "mu_interval_Pa" if result["looked_for"] == "true modulus" else "erosion_strain_interval"
        self.interval = interval_of(pair[key])
        self.ridge = _arrays(result["ridge"], ("mu_Pa", "erosion_strain"), {key: "{}"})
        self.warnings = result["warnings"]
        self.findings = result["findings"]

    def __repr__(self):
        if not self.found:
            return f"Inversion(no {self['looked_for']}: {self['pair']['why_not']})"
        unit = "Pa" if self["looked_for"] == "true modulus" else ""
        value = with_unit(self.mu, "Pa") if unit else f"{self.erosion_strain:.4g}"
        return f"Inversion({self['looked_for']} {value} {between(self.interval, unit)})"


def invert(*, level=None, store=None, threads=0, **said):
    """One depth to one number of the layer, and the ridge that the depth leaves: percal invert.

    said: the program's options as texts with their units or as SI numbers: depth, depth_error, radius or diameter,
    particle_density or particle_mass, speed, speed_error, density, alpha, mu or erosion_strain (the other is looked for),
    erosion_length, layer_depth, layer_width, elements_per_radius; store, threads: as calibrate().
    """
    return Inversion(json.loads(_core.invert(_words(said), level, _store(store), threads)))
