"""Impacts: a scene in, a depth out."""

import json
import os

import numpy as np

from . import _core
from ._page import Paged, axes
from ._shown import with_unit
from ._toml import text_of


def _merged(table, changes):
    both = dict(table)
    for key, value in changes.items():
        both[key] = _merged(both.get(key, {}), value) if isinstance(value, dict) else value
    return both


class Scene:
    """A particle, the layers it hits, mesh and solver settings. Made by read(), parse() or from_dict()."""

    def __init__(self, core):
        self._core = core

    @classmethod
    def read(cls, path):
        """From a TOML file; its keys are those of `percal new scene`."""
        return cls(_core.Scene.read(os.fspath(path)))

    @classmethod
    def parse(cls, text, name="scene"):
        """From TOML text; `name` stands in messages, and files that the text names are sought in its folder."""
        return cls(_core.Scene.parse(text, name))

    @classmethod
    def from_dict(cls, table):
        """From a dict of dicts as TOML has it: {"particle": {"radius": "1 um", ...}, "target": {...}}."""
        return cls.parse(text_of(table), "scene")

    @property
    def source(self):
        """The file it was read from."""
        return self._core.source

    def to_toml(self):
        """TOML text with every setting written out, in SI: parse() makes the same scene of it."""
        return self._core.to_toml()

    def to_dict(self):
        """As from_dict() takes it."""
        import tomllib

        return tomllib.loads(self.to_toml())

    def changed(self, **tables):
        """Another scene with some keys replaced: scene.changed(particle={"speed": "500 m/s"}, replicates=1)."""
        return Scene.parse(text_of(_merged(self.to_dict(), tables)), f"{self.source}, changed")

    def __eq__(self, other):
        return isinstance(other, Scene) and self.to_toml() == other.to_toml()

    __hash__ = None

    def __repr__(self):
        table = self.to_dict()
        particle, target = table["particle"], table["target"]
        return (
            f"Scene({particle.get('name', 'particle')}, radius {particle.get('radius')}, speed {particle['speed']}, "
            f"into {target.get('name', 'target')}, mu {target['mu']})"
        )


class Impact(Paged):
    """What the runs of an impact say together, SI.

    outcome: stopped, passed through, time up or unstable; depth: mean of the runs, None unless all stopped; spread: sample standard
    deviation of a run; standard_error: of the mean; depth_error: the 95 % half width and its sources, None without a depth; at_least: a layer's depth that a run passed through; depths: of each run;
    speeds_behind: [(layer, m/s or None)], what is left at each layer's lower face, means of the runs; exit_speed: m/s, None unless all
    passed through; final: where and how the particle ended, None unless the scene has output.after = "rest"; channel: {"depth_m",
    "largest_radius_m", "end_radius_m", ...}, None unless the scene has output.channel; impact_parameter, sectional_density: rho v a and
    mass over area; energy: shares of the impact energy; history: {"time_s", "tip_m", "speed_m_s", "force_N", "energy_..."} of the middle run, in
    plane strain with "force_N_per_m"; left_out, warnings: lists of sentences; result: percal impact's result.json, as a dict.
    """

    def __init__(self, result):
        self.result = result
        self.outcome = result["outcome"]
        self.depth = result["depth_m"]
        self.spread = result["depth_spread_m"]
        self.standard_error = result["depth_standard_error_m"]
        self.depth_error = result["depth_error"]
        self.at_least = result["depth_at_least_m"]
        self.depths = np.array([run["depth_m"] for run in result["runs"]])
        self.speeds_behind = [(layer["name"], layer["speed_behind_m_s"]) for layer in result["layers"]]
        self.exit_speed = result["exit_speed_m_s"]
        self.final = result["final"]
        self.channel = _channel(result["channel"])
        self.impact_parameter = result["impact_parameter_kg_m_s"]
        self.sectional_density = result["sectional_density_kg_m2"]
        self.energy = result["energy"]
        self.mu = result["mu_true_Pa"]
        self.left_out = [f"{one['what']}: {one['why']}" for one in result["left_out"]]
        self.warnings = result["findings"]
        self.history = _columns(result["history"])

    def plot(self, ax=None):
        """Depth over time of the middle run: matplotlib's axes, made where ax is None. ImportError where there is no matplotlib."""
        if not self.history:
            raise ValueError("plot: found no history; accepted: an impact with history=True")
        ax = axes(ax)
        ax.plot(self.history["time_s"] * 1e3, self.history["tip_m"] * 1e3)
        ax.set_xlabel("time, ms")
        ax.set_ylabel("depth, mm")
        return ax

    def __repr__(self):
        text = self.outcome
        if self.depth is not None:
            text += f", depth {with_unit(self.depth, 'm')}"
        if self.standard_error is not None:
            text += f" +- {with_unit(self.standard_error, 'm', 3)} (standard error of {len(self.depths)} runs)"
        if self.at_least is not None:
            text += f", deeper than {with_unit(self.at_least, 'm')}"
        if self.exit_speed is not None:
            text += f", left with {self.exit_speed:.4g} m/s"
        if self.final and self.final["depth_m"] is not None:
            text += f", comes to rest at {with_unit(self.final['depth_m'], 'm')} +- {with_unit(self.final['half_width_m'], 'm', 2)}"
        return f"Impact({text})"


def _columns(history):
    energy = {f"energy_{term}": shares for term, shares in history["energy"].items()} if history else {}
    columns = {key: values for key, values in (history or {}).items() if key != "energy"} | energy
    return {key: np.array(values, dtype=float) for key, values in columns.items()}


def _channel(channel):
    return channel and {key: np.array(values, dtype=float) for key, values in channel.items() if key != "particle"}


def impact(scene, elements_per_radius=None, replicates=None, threads=0, store=None, history=True, measure_errors=False, extrapolate=False):
    """Runs the impacts of a scene (or of the file of one).

    elements_per_radius, replicates: instead of the scene's; threads: 0 for one on each core; store: file in which finished runs are
    kept and found again (percal.default_store_path() is the program's), None for no store; history: of the middle run. A
    run whose history is wanted is never taken from the store. measure_errors, extrapolate: more runs, as percal impact's options of
    these names make them.
    """
    if not isinstance(scene, Scene):
        scene = Scene.from_dict(scene) if isinstance(scene, dict) else Scene.read(scene)
    path = None if store is None else os.fspath(store)
    return Impact(json.loads(_core.impact(scene._core, elements_per_radius, replicates, threads, path, history, measure_errors, extrapolate)))
