from collections.abc import Callable, Iterator, Mapping, Sequence
from os import PathLike
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__: list[str]
__version__: str

_Path = str | PathLike[str]
_Array = NDArray[np.float64]

class Interval(NamedTuple):
    low: float
    high: float
    low_open: bool = False
    high_open: bool = False

class Minimum:
    mu: float
    alpha: float | None
    terms: list[tuple[float, float]]
    objective: float
    above_best: float | None
    r2: float | None
    converged: bool
    at_bound: bool
    def __init__(self, entry: dict[str, Any]) -> None: ...

class Fit:
    result: dict[str, Any]
    model: str
    minima: list[Minimum]
    findings: list[str]
    level: float | None
    stretch: _Array
    across: _Array
    stress: _Array
    mode: list[str]
    mu: float | None
    alpha: float | None
    terms: list[tuple[float, float]]
    r2: float | None
    converged: bool
    def __init__(self, result: dict[str, Any], points: dict[str, Any]) -> None: ...
    def plot(self, ax: Any = None) -> Any: ...
    @property
    def region(self) -> dict[str, list[tuple[float, float]]]: ...
    @property
    def intervals(self) -> dict[str, Interval | None]: ...
    @property
    def covariance(self) -> _Array: ...
    @property
    def stable(self) -> dict[str, tuple[float, float]]: ...
    @property
    def relaxation(self) -> dict[str, Any] | None: ...
    def predict(self, stretch: ArrayLike, mode: str | None = None, across: ArrayLike | None = None) -> _Array: ...

def fit(
    stretch: ArrayLike,
    stress: ArrayLike,
    mode: str | Sequence[str] = "uniaxial",
    model: str = "ogden",
    *,
    residual: str = "relative",
    error: ArrayLike | None = None,
    across: ArrayLike | None = None,
    cauchy: bool = False,
    weights: str | dict[str, float] = "points",
    loss: str = "squares",
    unconstrained: bool = False,
    stretches: tuple[float, float] = (0.1, 10.0),
    level: float = 0.95,
    bootstrap: int = 0,
    time: ArrayLike | None = None,
    relaxation: int | str | None = None,
) -> Fit: ...
def fit_csv(
    path: _Path | Sequence[_Path],
    mode: str | Mapping[_Path, str] = "",
    model: str = "ogden",
    *,
    x: str = "",
    y: str = "",
    error: str = "",
    where: str | Sequence[str] = (),
    residual: str = "relative",
    weights: str | dict[str, float] = "points",
    loss: str = "squares",
    unconstrained: bool = False,
    stretches: tuple[float, float] = (0.1, 10.0),
    level: float = 0.95,
    bootstrap: int = 0,
    time: str = "",
    relaxation: int | str | None = None,
) -> Fit: ...
def nominal_stress(
    terms: Sequence[tuple[float, float]], stretch: ArrayLike, mode: str = "uniaxial", across: ArrayLike | None = None
) -> _Array: ...

class Scene:
    def __init__(self, core: Any) -> None: ...
    @classmethod
    def read(cls, path: _Path) -> Scene: ...
    @classmethod
    def parse(cls, text: str, name: str = "scene") -> Scene: ...
    @classmethod
    def from_dict(cls, table: Mapping[str, Any]) -> Scene: ...
    @property
    def source(self) -> str: ...
    def to_toml(self) -> str: ...
    def to_dict(self) -> dict[str, Any]: ...
    def changed(self, **tables: Any) -> Scene: ...

class Impact:
    result: dict[str, Any]
    outcome: str
    depth: float | None
    spread: float | None
    standard_error: float | None
    depth_error: dict[str, Any] | None
    at_least: float | None
    depths: _Array
    speeds_behind: list[tuple[str, float | None]]
    exit_speed: float | None
    final: dict[str, Any] | None
    channel: dict[str, _Array] | None
    impact_parameter: float
    sectional_density: float
    energy: dict[str, float]
    mu: float
    left_out: list[str]
    warnings: list[str]
    history: dict[str, _Array]
    def __init__(self, result: dict[str, Any]) -> None: ...
    def plot(self, ax: Any = None) -> Any: ...

def impact(
    scene: Scene | Mapping[str, Any] | _Path,
    elements_per_radius: float | None = None,
    replicates: int | None = None,
    threads: int = 0,
    store: _Path | None = None,
    history: bool = True,
    measure_errors: bool = False,
    extrapolate: bool = False,
) -> Impact: ...

class _Result(Mapping[str, Any]):
    def __init__(self, result: dict[str, Any]) -> None: ...
    def __getitem__(self, key: str) -> Any: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...

class Scaling(_Result):
    groups: dict[str, tuple[float | None, float | None, str]]
    obstacles: list[str]
    modulus_ratio: float | None
    is_similar: bool
    def __init__(self, result: dict[str, Any], similar_scene: Callable[[], str]) -> None: ...
    def similar_scene(self) -> Scene: ...

def scale(
    job: _Path | None = None,
    *,
    prototype: Mapping[str, Any] | None = None,
    model: Mapping[str, Any] | None = None,
    tolerance: float | None = None,
) -> Scaling: ...

class Ridge:
    x_parameter: str
    y_parameter: str
    x: _Array
    y: _Array
    rise: _Array
    threshold: float
    contours: list[_Array]
    def __init__(self, entry: dict[str, Any]) -> None: ...

class Hypothesis:
    name: str
    parameters: dict[str, float]
    intervals: dict[str, Interval | None]
    identifiable: dict[str, bool]
    correlation: _Array
    shots: dict[str, Any]
    ridges: list[Ridge]
    findings: list[str]
    result: dict[str, Any]
    def __init__(self, entry: dict[str, Any]) -> None: ...
    def plot(self, ax: Any = None) -> Any: ...

class Calibration(_Result):
    hypotheses: list[Hypothesis]
    findings: list[str]
    cost: dict[str, Any]
    def __init__(self, result: dict[str, Any]) -> None: ...
    def predict(self, **said: Any) -> Prediction: ...

def calibrate(
    job: _Path,
    budget: float | str | None = None,
    store: _Path | None = None,
    threads: int = 0,
    announce: Callable[[str], Any] | None = None,
) -> Calibration: ...

class Prediction(_Result):
    shots: dict[str, Any]
    curve: dict[str, _Array]
    depth: float | None
    value: float | None
    findings: list[str]
    def __init__(self, result: dict[str, Any]) -> None: ...

def predict(
    result: _Path | Mapping[str, Any],
    *,
    level: float | None = None,
    v50: bool = False,
    verify: bool = False,
    store: _Path | None = None,
    threads: int = 0,
    **said: Any,
) -> Prediction: ...

class Inversion(_Result):
    found: bool
    mu: float | None
    erosion_strain: float | None
    interval: Interval | None
    ridge: dict[str, _Array]
    warnings: list[str]
    findings: list[str]
    def __init__(self, result: dict[str, Any]) -> None: ...

def invert(
    *, level: float | None = None, store: _Path | None = None, threads: int = 0, **said: Any
) -> Inversion: ...

class Identification(_Result):
    complete: bool
    findings: list[str]
    ridge: dict[str, _Array]
    predictions: dict[str, Any]
    card: CardMaterial | None
    def __init__(self, result: dict[str, Any]) -> None: ...

def identify(
    job: _Path, store: _Path | None = None, threads: int = 0, announce: Callable[[str], Any] | None = None
) -> Identification: ...

class Sweep(_Result):
    values: dict[str, Any]
    outcomes: list[str]
    depth: _Array
    depth_error: _Array
    speed_left: _Array
    cost: dict[str, Any]
    def __init__(self, result: dict[str, Any]) -> None: ...

def campaign(plan: _Path, store: _Path | None = None, threads: int = 0) -> Sweep: ...

class Dose(_Result):
    depth: _Array
    mass_above: dict[str, _Array]
    number_above: dict[str, _Array]
    shares: dict[str, dict[str, float]]
    number_shares: dict[str, dict[str, float]]
    mean: float
    deviation: float
    beyond: list[dict[str, Any]]
    findings: list[str]
    def __init__(self, result: dict[str, Any]) -> None: ...

def dose(job: _Path) -> Dose: ...

class Design(_Result):
    found: bool
    radius: float | None
    density: float | None
    speed: float | None
    dose: dict[str, float] | None
    map: dict[str, _Array]
    findings: list[str]
    def __init__(self, result: dict[str, Any]) -> None: ...

def design(job: _Path) -> Design: ...

class CardMaterial:
    name: str
    density: float | None
    mu: float
    alpha: float | None
    bulk_modulus: float | None
    erosion_strain: float | None
    erosion_measure: str
    comments: list[str]
    terms: list[tuple[float, float]]
    provenance: dict[str, Any]
    def __init__(
        self,
        name: str,
        density: float | None,
        mu: float,
        alpha: float | None,
        bulk_modulus: float | None,
        erosion_strain: float | None = None,
        erosion_measure: str = "engineering",
        comments: list[str] = ...,
        terms: list[tuple[float, float]] = ...,
        provenance: dict[str, Any] = ...,
    ) -> None: ...

def solvers() -> list[str]: ...
def card_of(
    result: _Path | Mapping[str, Any] | Fit,
    name: str | None = None,
    density: float | None = None,
    bulk_to_shear: float | None = None,
) -> CardMaterial: ...
def write_card(material: CardMaterial, solver: str, units: str = "si") -> str: ...
def read_card(path: _Path, solver: str | None = None, units: str | None = None) -> CardMaterial: ...
def card_curve(material: CardMaterial, stretch: ArrayLike, mode: str = "uniaxial") -> _Array: ...
def uniaxial_deck(
    material: CardMaterial,
    solver: str,
    units: str = "si",
    stretch: float = 2.0,
    increments: int = 20,
    job: str = "uniaxial",
) -> dict[str, str]: ...
def default_store_path() -> str: ...
def instruction_level() -> str: ...
