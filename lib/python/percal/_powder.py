"""Powders: where one ends up by a finished calibration, and which one ends up where it is wanted."""

import json
import os

import numpy as np

from . import _core
from ._page import _Result
from ._shown import with_unit


def _estimates(rows, key):
    """Columns of {best, low, high}."""
    return {end: np.array([np.nan if row[key][end] is None else row[key][end] for row in rows]) for end in ("best", "low", "high")}


def _shares(by):
    """Each share with its interval by name; layers by theirs."""
    named = {name: by[name] for name in ("bounced", "deeper", "passed", "in_band")}
    named.update({layer["name"]: layer["share"] for layer in by["layers"]})
    return {name: {end: share[end] for end in ("best", "low", "high")} for name, share in named.items()}


class Dose(_Result):
    """Where a powder ends up: the keys of percal dose's result.json, and parts of it.

    depth (m), mass_above, number_above: arrays, the last two {"best", "low", "high"}: shares that ended above each depth; shares,
    number_shares: {"bounced", "passed", "deeper", "in_band", and the layers by name}, each {"best", "low", "high"}; mean, deviation: of
    the depths of what stays inside, by mass (m); beyond: shares of the powder that lie beyond what was fitted; findings.
    """

    def __init__(self, result):
        super().__init__(result)
        self.depth = np.array([point["depth_m"] for point in result["curve"]])
        self.mass_above = _estimates(result["curve"], "mass_above")
        self.number_above = _estimates(result["curve"], "number_above")
        self.shares, self.number_shares = _shares(result["by_mass"]), _shares(result["by_number"])
        self.mean = result["depths_by_mass"]["mean_m"]["best"]
        self.deviation = result["depths_by_mass"]["deviation_m"]["best"]
        self.beyond = result["beyond"]
        self.findings = result["findings"]

    def __repr__(self):
        return f"Dose({self['material']}: mean {with_unit(self.mean, 'm')}, standard deviation {with_unit(self.deviation, 'm')})"


def dose(job):
    """The dose over depth of a job's file: percal dose."""
    return Dose(json.loads(_core.dose(os.fspath(job))))


class Design(_Result):
    """The particle and the speed that put most of a powder into a band: the keys of percal design's result.json, and parts of it.

    found: whether any is within the limits; radius, density, speed: medians of the best, SI; dose: of the mass in the band,
    {"best", "low", "high"}; map: {"radius_m", "density_kg_m3", "speed_m_s", "dose", "allowed"}, arrays; findings.
    """

    def __init__(self, result):
        super().__init__(result)
        best = result["best"]
        self.found = best is not None
        self.radius, self.density, self.speed = (best[key] if best else None for key in ("radius_m", "density_kg_m3", "speed_m_s"))
        self.dose = {end: best["dose"][end] for end in ("best", "low", "high")} if best else None
        keys = ("radius_m", "density_kg_m3", "speed_m_s", "dose", "allowed")
        self.map = {key: np.array([point[key] for point in result["map"]]) for key in keys}
        self.findings = result["findings"]

    def __repr__(self):
        if not self.found:
            return "Design(nothing within the limits)"
        return (
            f"Design(radius {with_unit(self.radius, 'm')} at {with_unit(self.speed, 'm/s')}: {100 * self.dose['best']:.3g} % "
            "of the mass in the band)"
        )


def design(job):
    """The best particle and speed of a job's file: percal design."""
    return Design(json.loads(_core.design(os.fspath(job))))
