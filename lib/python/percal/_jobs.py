"""Jobs: two systems compared, materials calibrated, the whole chain of an identification."""

import json
import os

import numpy as np

from . import _core
from ._card import CardMaterial
from ._fit import interval_of
from ._impact import Scene
from ._page import _Result, axes
from ._shots import predict
from ._shown import between, with_unit
from ._toml import text_of


_UNITS = ("", "_Pa", "_m")  # that a key of a parameter may end in


def _in_si(entry, key):
    """The entry under `key` or `key` with a unit: None where there is none."""
    return next((entry[name] for name in (key + unit for unit in _UNITS) if name in entry), None)


def _array(rows, key):
    return np.array([np.nan if row[key] is None else row[key] for row in rows], dtype=float)


class Scaling(_Result):
    """Two systems side by side: the keys of percal scale's result.json.

    groups: {"pi4": (prototype, model, "agree" | "differ" | "missing")}; obstacles: what stands in the way of similarity;
    modulus_ratio: model over prototype, or None; is_similar: every group that decides agrees.
    """

    def __init__(self, result, similar_scene):
        super().__init__(result)
        self.groups = {one["symbol"]: (one["prototype"], one["model"], one["agreement"]) for one in result["groups"]}
        self.obstacles = result["not_similar_because"]
        self.modulus_ratio = result["modulus_ratio"]
        self.is_similar = not self.obstacles
        self._similar_scene = similar_scene

    def similar_scene(self):
        """The prototype's scene with the model's numbers. ValueError where the prototype is no scene, or a group contradicts."""
        return Scene.parse(self._similar_scene(), "similar scene")

    def __repr__(self):
        agree = [symbol for symbol, (_, _, word) in self.groups.items() if word == "agree"]
        ratio = "none" if self.modulus_ratio is None else f"{self.modulus_ratio:.5g}"
        return f"Scaling({', '.join(agree) or 'nothing'} agree; modulus ratio {ratio}; {len(self.obstacles)} obstacles)"


def scale(job=None, *, prototype=None, model=None, tolerance=None):
    """The ten pi groups of two systems, what follows for the model, and what stands in the way of similarity.

    job: file of a job; or prototype and model: dicts with the keys of a job's tables, {"radius": "1 um", "speed": ...} or
    {"scene": "gold.toml"}. What the model leaves out follows from the prototype. tolerance: of a group's agreement (0.01).
    """
    if (job is None) == (prototype is None or model is None):
        raise ValueError("scale: found neither or both; accepted: a job's file, or prototype= and model=")
    if job is not None:
        path = os.fspath(job)
        return Scaling(json.loads(_core.scale_file(path)), lambda: _core.similar_scene_file(path))
    text = text_of({"tolerance": tolerance, "prototype": prototype, "model": model})
    return Scaling(json.loads(_core.scale_text(text, "scale")), lambda: _core.similar_scene_text(text, "scale"))


class Ridge:
    """Pairs of two parameters that the data cannot tell apart. rise[i, j]: of the objective at (x[j], y[i]), below `threshold`
    within the 95 % region; contours: its outlines, arrays of (x, y). y in Pa where it is a modulus."""

    def __init__(self, entry):
        self.x_parameter, self.y_parameter = entry["x_parameter"], entry["y_parameter"]
        self.x, self.y = np.array(_in_si(entry, "x")), np.array(_in_si(entry, "y"))
        self.rise = np.array(entry["rise"], dtype=float)
        self.threshold = entry["threshold"]
        self.contours = [np.column_stack([_in_si(one, "x"), _in_si(one, "y")]) for one in entry["contours"]]

    def __repr__(self):
        return f"Ridge({self.y_parameter} over {self.x_parameter}, {self.rise.shape[0]} x {self.rise.shape[1]})"


class Hypothesis:
    """One way to read the data, and what it gives.

    parameters: {name: value}, intervals: {name: Interval}, identifiable: {name: bool}, SI; correlation: array in their order;
    shots: {"label", "measured_m", "depth_m", "low_m", "high_m", "deviation", "fitted"}, arrays over all shots, low to high
    being the interval of one new shot; ridges: [Ridge, ...]; findings: what a reader must know; result: everything, as a dict.
    """

    def __init__(self, entry):
        self.name = entry["name"]
        self.parameters = {one["name"]: _in_si(one, "value") for one in entry["parameters"]}
        self.intervals = {one["name"]: interval_of(_in_si(one, "interval")) for one in entry["parameters"]}
        self.identifiable = {one["name"]: one["identifiable"] for one in entry["parameters"]}
        self._units = {one["name"]: next(unit for unit in _UNITS if "value" + unit in one)[1:] for one in entry["parameters"]}
        self.correlation = np.array(entry["correlation"], dtype=float)
        rows = entry["shots"]
        self.shots = {key: _array(rows, key) for key in ("measured_m", "depth_m", "low_m", "high_m", "deviation")}
        self.shots["label"] = [row["label"] for row in rows]
        self.shots["fitted"] = np.array([row["fitted"] for row in rows], dtype=bool)
        self.ridges = [Ridge(one) for one in entry["ridges"]]
        self.findings = entry["findings"]
        self.result = entry

    def plot(self, ax=None):
        """The model's depths against the measured ones, mm, with the interval of one shot: matplotlib's axes, made where ax is None.
        ImportError where there is no matplotlib."""
        ax = axes(ax)
        measured, depth = self.shots["measured_m"] * 1e3, self.shots["depth_m"] * 1e3
        bars = np.abs(np.array([self.shots["low_m"], self.shots["high_m"]]) * 1e3 - depth)
        ax.errorbar(measured, depth, yerr=bars, fmt="o")
        ends = [np.nanmin(measured), np.nanmax(measured)]
        ax.plot(ends, ends, "--", color="grey")
        ax.set_xlabel("measured depth, mm")
        ax.set_ylabel("model, mm")
        return ax

    def __repr__(self):
        parts = []
        for name, value in self.parameters.items():
            unit = self._units[name]
            text = f"{name} = " + (with_unit(value, unit) if unit else f"{value:.4g}")
            if self.intervals[name]:
                text += " " + between(self.intervals[name], unit)
            parts.append(text + ("" if self.identifiable[name] else " not determined"))
        return f"Hypothesis({self.name}: {', '.join(parts)})"


class Calibration(_Result):
    """A calibration: the keys of its result.json, and `hypotheses`, `findings` and `cost` ready to use. No hypotheses where too many
    runs failed; the findings say so."""

    def __init__(self, result):
        super().__init__(result)
        self.hypotheses = [Hypothesis(entry) for entry in result["hypotheses"]]
        self.findings = result["findings"]
        self.cost = result["cost"]

    def predict(self, **said):
        """A shot that was not fired, by this calibration: percal.predict(self, ...)."""
        return predict(self, **said)

    def __repr__(self):
        return "Calibration(" + "; ".join(repr(hypothesis) for hypothesis in self.hypotheses) + ")"


def _seconds(budget):
    if budget is None or isinstance(budget, (int, float)):
        return budget
    return _core.seconds(budget)


def calibrate(job, budget=None, store=None, threads=0, announce=None):
    """Curves and depths together: the free parameters of the job's file, with intervals.

    budget: wall time, seconds or "5 min"; store: file of finished runs, None for the program's; threads: 0 for one on each
    core; announce: called with each sentence that the program would print.
    """
    path = _core.default_store_path() if store is None else os.fspath(store)
    return Calibration(json.loads(_core.calibrate(os.fspath(job), _seconds(budget), path, threads, announce)))


class Identification(_Result):
    """The whole chain: the keys of its result.json, and arrays of it.

    ridge: {"erosion_strain", "mu_true_Pa", "mu_as_given_Pa"}; predictions: {"depth_m", "measured_m", "speed_m_s", "radius_m",
    "particle"}; card: CardMaterial or None; findings; complete: every step of the chain could be taken.
    """

    def __init__(self, result):
        super().__init__(result)
        self.complete = result["complete"]
        self.findings = result["findings"]
        self.ridge = {key: _array(result["ridge"], key) for key in ("erosion_strain", "mu_true_Pa", "mu_as_given_Pa")}
        rows = result["predictions"]
        self.predictions = {key: _array(rows, key) for key in ("depth_m", "measured_m", "speed_m_s", "radius_m")}
        self.predictions["particle"] = [row["particle"] for row in rows]
        self.card = CardMaterial._of(result["cards"][0]) if result["cards"] else None

    def __repr__(self):
        skin = self["skin"] if "skin" in self else {}
        mu, strain = skin.get("mu_highrate_true_Pa"), skin.get("erosion_strain")
        error = skin.get("erosion_strain_error")
        text = f"mu = {with_unit(mu, 'Pa')} (true, high rate)"
        if strain is not None:
            text += f", erosion strain {strain:.4g}" + ("" if error is None else f" +- {error:.2g}")
        return f"Identification({self['title']}: {text})"


def identify(job, store=None, threads=0, announce=None):
    """The chain from gelatin to tissue of a job's file; arguments as calibrate(). announce hears the name of each finished step."""
    path = _core.default_store_path() if store is None else os.fspath(store)
    return Identification(json.loads(_core.identify(os.fspath(job), path, threads, announce)))


class Sweep(_Result):
    """The points of a plan: the keys of percal campaign's result.json, and columns of it, a row a point.

    values: {"particle.speed [m/s]": array, or list of words}; outcomes: words; depth, depth_error (m), speed_left (m/s): arrays,
    NaN where there is none.
    """

    def __init__(self, result):
        super().__init__(result)
        points = result["points"]
        self.values = {}
        for k, axis in enumerate(result["axes"]):
            column = [point["values"][k] for point in points]
            name = axis["key"] + (f" [{axis['unit']}]" if axis["unit"] else "")
            self.values[name] = np.array(column, dtype=float) if axis["is_number"] else column
        self.outcomes = [point["outcome"] for point in points]
        self.depth, self.depth_error = _array(points, "depth_m"), _array(points, "depth_error_m")
        self.speed_left = _array(points, "speed_left_m_s")
        self.cost = result["cost"]

    def __repr__(self):
        counts = ", ".join(f"{count} {outcome}" for outcome, count in self["outcomes"].items())
        return f"Sweep({', '.join(self.values)}: {counts})"


def campaign(plan, store=None, threads=0):
    """The points of a plan's file, run; arguments as calibrate()."""
    path = _core.default_store_path() if store is None else os.fspath(store)
    return Sweep(json.loads(_core.campaign(os.fspath(plan), path, threads)))
