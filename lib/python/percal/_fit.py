"""Stress-stretch curves."""

import json
import os
from typing import NamedTuple

import numpy as np

from . import _core
from ._page import Paged, axes
from ._shown import between, with_unit


class Interval(NamedTuple):
    """A confidence interval. An open end is where the search ended: the data say nothing against going on."""

    low: float
    high: float
    low_open: bool = False
    high_open: bool = False


def interval_of(entry):
    """From {"low", "high", ...} of a result; None where there is none."""
    if entry is None or entry["low"] is None or entry["high"] is None:
        return None
    return Interval(entry["low"], entry["high"], entry["low_open"], entry["high_open"])


class Minimum:
    """One minimum of a fit: mu (Pa, the sum over all terms), alpha (None with several terms), terms [(mu, alpha), ...],
    objective, above_best (objective over the best one's, less 1), r2, converged, at_bound."""

    def __init__(self, entry):
        self.mu = entry["mu_Pa"]
        self.alpha = entry["alpha"]
        self.terms = [(term["mu_Pa"], term["alpha"]) for term in entry["terms"]]
        self.objective = entry["objective"]
        self.above_best = entry["objective_above_best"]
        self.r2 = entry["r2"]
        self.converged = entry["converged"]
        self.at_bound = entry["at_bound"]
        self._entry = entry

    def __repr__(self):
        terms = ", ".join(f"mu {with_unit(mu, 'Pa')} alpha {alpha:.4g}" for mu, alpha in self.terms)
        r2 = "none" if self.r2 is None else f"{self.r2:.4f}"
        return f"Minimum({terms}, R2 {r2}, objective {self.objective:.4g})"


class Fit(Paged):
    """A fitted solid. mu (Pa), alpha, terms, r2 and converged are those of the best minimum; mu is None where nothing fits."""

    def __init__(self, result, points):
        self.result = result
        self.model = result["model"]
        self.minima = [Minimum(entry) for entry in result["minima"]]
        self.findings = result["findings"]
        self.level = result["uncertainty"]["level"] if result["uncertainty"] else None
        self.stretch, self.across, self.stress = points["stretch"], points["across"], points["stress"]
        self.mode = points["mode"]
        best = self.minima[0] if self.minima else None
        self.mu = best.mu if best else None
        self.alpha = best.alpha if best else None
        self.terms = best.terms if best else []
        self.r2 = best.r2 if best else None
        self.converged = best.converged if best else False

    def _uncertainty(self):
        about = (self.result["uncertainty"] or {"minima": []})["minima"]
        return next((one for one in about if one["minimum"] == 0), None)

    @property
    def region(self):
        """All that the points allow, {"mu": [(low, high), ...] (Pa), "alpha": ...}: a piece about each minimum that fits about as well."""
        pieces = (self.result["uncertainty"] or {"region": {}})["region"]
        return {key.removesuffix("_Pa"): [tuple(piece) for piece in some] for key, some in pieces.items()}

    @property
    def intervals(self):
        """{"mu": Interval (Pa), "alpha": Interval}, with several terms "mu_1", ...: the piece of the region about the best minimum; empty
        where the points leave none."""
        about = self._uncertainty()
        if about is None:
            return {}
        return {key.removesuffix("_Pa"): interval_of(about["parameters"][key]) for key in about["order"]}

    @property
    def relaxation(self):
        """The block `relaxation` of the result, docs/formats/fit.md: "mu_0_Pa", "mu_inf_Pa", "alpha", "series" and their "uncertainty"; None
        where no series was asked for, or where the data ask for none. mu, alpha and minima are then of the solid that knows no time."""
        found = self.result["relaxation"]
        return found if found and found["terms"] > 0 else None

    @property
    def covariance(self):
        """Of (mu in Pa, alpha), term after term, linearised about the best minimum: nan where the points tell nothing."""
        if not self.minima:
            return np.empty((0, 0))
        terms = self.minima[0]._entry["terms"]
        errors = [term[key] for term in terms for key in ("mu_standard_error_Pa", "alpha_standard_error")]
        deviation = np.array([np.nan if error is None else error for error in errors])
        correlation = self.minima[0]._entry["correlation"]
        between_two = np.nan if correlation is None else correlation
        matrix = np.full((deviation.size, deviation.size), np.nan)
        if deviation.size == 2:
            matrix[0, 1] = matrix[1, 0] = between_two
        np.fill_diagonal(matrix, 1)
        return matrix * np.outer(deviation, deviation)

    @property
    def stable(self):
        """Stretches at which the best solid is Drucker-stable: {"uniaxial": (low, high), "equibiaxial": ..., "planar": ...}."""
        stability = self.result["stability"]
        return {mode: (ends["low"], ends["high"]) for mode, ends in stability["stretches"].items()} if stability else {}

    def predict(self, stretch, mode=None, across=None):
        """Nominal stress (Pa) at these stretches (shears in simple shear); mode: that of the points where they have one."""
        if not self.terms:
            raise ValueError("fit: nothing to predict from: no minimum was found")
        if mode is None:
            modes = sorted(set(self.mode))
            if len(modes) != 1:
                raise ValueError(f'mode: found nothing; accepted: one of the modes of the points, {", ".join(modes)}')
            mode = modes[0]
        return nominal_stress(self.terms, stretch, mode, across)

    def plot(self, ax=None):
        """Points and curves of each mode, in kPa: matplotlib's axes, made where ax is None. ImportError where there is no matplotlib."""
        ax = axes(ax)
        for index, mode in enumerate(sorted(set(self.mode))):
            here = np.array([one == mode for one in self.mode])
            stretch, across = self.stretch[here], self.across[here]
            order = np.argsort(stretch)
            ax.plot(stretch, self.stress[here] / 1e3, "o", color=f"C{index}", label=mode)
            if self.terms:
                ax.plot(stretch[order], self.predict(stretch[order], mode, across[order]) / 1e3, "-", color=f"C{index}")
        ax.set_xlabel("stretch")
        ax.set_ylabel("nominal stress, kPa")
        ax.legend()
        return ax

    def __repr__(self):
        if not self.minima:
            return f"Fit({self.model}, {len(self.stretch)} points: no minimum)"
        intervals = self.intervals
        parts = [f"mu = {with_unit(self.mu, 'Pa')}"]
        about = self._uncertainty()
        of_mu = intervals.get("mu") or interval_of(about["small_strain_mu_Pa"] if about else None)
        region = self.region

        def allowed(key, interval, unit=""):
            pieces = region.get(key, [])
            return " or ".join(between(Interval(*piece), unit) for piece in pieces) if len(pieces) > 1 else between(interval, unit)

        if of_mu:
            parts[0] += " " + allowed("mu" if "mu" in intervals else "small_strain_mu", of_mu, "Pa")
        if self.alpha is not None:
            parts.append(f"alpha = {self.alpha:.4g}")
            if intervals.get("alpha"):
                parts[1] += " " + allowed("alpha", intervals["alpha"])
        level = f" ({100 * self.level:g} %)" if intervals else ""
        r2 = "" if self.r2 is None else f", R2 = {self.r2:.4f}"
        return f"Fit({self.model}, {len(self.stretch)} points: {', '.join(parts)}{level}{r2})"


def _options(model, residual, weights, loss, unconstrained, stretches, level, bootstrap, relaxation):
    return {
        "model": model,
        "residual": residual,
        "weights": weights,
        "loss": loss,
        "unconstrained": unconstrained,
        "stretches": stretches,
        "level": level,
        "bootstrap": bootstrap,
        "relaxation": "" if relaxation is None else str(relaxation),
    }


def fit(
    stretch,
    stress,
    mode="uniaxial",
    model="ogden",
    *,
    residual="relative",
    error=None,
    across=None,
    cauchy=False,
    weights="points",
    loss="squares",
    unconstrained=False,
    stretches=(0.1, 10.0),
    level=0.95,
    bootstrap=0,
    time=None,
    relaxation=None,
):
    """A solid from stress-stretch points, every minimum there is.

    stretch: stretches (shears in simple shear); stress: nominal stresses in Pa, Cauchy stresses with cauchy=True.
    mode: uniaxial, equibiaxial, planar, planar_held, simple_shear or general_biaxial (with `across`, the second stretch): one word,
    or one for each point.
    model: ogden, ogden2, ogden3, neo-hooke, mooney-rivlin.
    residual: relative, absolute, or error (with `error`, standard errors of the stresses in Pa).
    weights: points, tests, or {test: share}; loss: squares, huber, cauchy; unconstrained: single moduli may be negative.
    stretches: the range in which stability is looked at; level: of the intervals; bootstrap: replicates, 0 for none.
    relaxation: 1, 2, 3 terms of a Prony series or "auto", over the whole history of stress; time: of each point, in s.

    >>> fit = percal.fit([1.1, 1.2, 1.3, 1.4], [10e3, 19e3, 27e3, 36e3])
    >>> fit.mu, fit.alpha, fit.r2
    """
    modes = [mode] if isinstance(mode, str) else [str(one) for one in mode]
    options = _options(model, residual, weights, loss, unconstrained, tuple(stretches), level, bootstrap, relaxation)
    result, points = _core.fit(stretch, stress, modes, error, across, time, cauchy, options)
    return Fit(json.loads(result), points)


def fit_csv(
    path,
    mode="",
    model="ogden",
    *,
    x="",
    y="",
    error="",
    where=(),
    residual="relative",
    weights="points",
    loss="squares",
    unconstrained=False,
    stretches=(0.1, 10.0),
    level=0.95,
    bootstrap=0,
    time="",
    relaxation=None,
):
    """As fit(), from one CSV file or a list of them, with units in the headers (stress_kPa).

    mode: for files without a mode column, or one of words that nobody knows; {file: mode} where they differ; x, y, error: columns, found by their names where left out;
    time: the column of time beside `relaxation`, found by its name where left out;
    where: "COLUMN=VALUE", "COLUMN<NUMBER" (also !=, <=, >, >=) or a list of such, the rows to keep.
    """
    files = [path] if isinstance(path, (str, os.PathLike)) else list(path)
    conditions = [where] if isinstance(where, str) else list(where)
    options = _options(model, residual, weights, loss, unconstrained, tuple(stretches), level, bootstrap, relaxation)
    of_all, of_file = (mode, {}) if isinstance(mode, str) else ("", {os.fspath(file): word for file, word in mode.items()})
    result, points = _core.fit_csv([os.fspath(file) for file in files], of_all, of_file, x, y, error, time, conditions, options)
    return Fit(json.loads(result), points)


def nominal_stress(terms, stretch, mode="uniaxial", across=None):
    """Nominal stress (Pa) of the incompressible solid with terms [(mu in Pa, alpha), ...], an array like `stretch`."""
    amounts = np.asarray(stretch, dtype=float)
    second = None if across is None else np.broadcast_to(np.asarray(across, dtype=float), amounts.shape).ravel()
    return _core.nominal_stress(list(terms), mode, amounts.ravel(), second).reshape(amounts.shape)
