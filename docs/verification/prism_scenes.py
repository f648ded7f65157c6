"""Scenes of the thesis's prisms and of a ball of their mass, in its own domain and in the mould, and their depths in cm: for make_prisms.py and make_guha2009.py."""
import math
import re
from dataclasses import dataclass

from harness import THESIS, rows_of, with_numbers

BALL = 1.59                  # mm: meshes are counted in elements on the radius of the thesis's ball
WALL, DEPTH = 7.95, 119.25   # mm: the thesis's domain, 5 and 75 of these
MOULD_WALL, MOULD_DEPTH = 37.5, 100
GROWTH = 1.13                # of the mould's columns from one to the next, at ten elements on the ball's radius
THESIS_MESH, MOULD_MESH = 14, 10


@dataclass(frozen=True)
class Prism:
    name: str
    text: str          # the scene that data/guha2009 has of it
    half_width: float  # mm
    calibrated: float  # m/s: the shot at which the thesis found its erosion strain
    strain: float      # with which its own domain is run here
    shots: tuple       # rows of angular_shots.csv


def prisms():
    def one(name, angularity, half_width, calibrated, strain):
        shots = tuple(with_numbers(rows_of(THESIS / "angular_shots.csv", angularity_deg=angularity)))
        return Prism(name, (THESIS / f"{name}.toml").read_text(), half_width, calibrated, strain, shots)
    return one("square", "45", 5.83 * math.sqrt(0.5), 50, 0.51), one("rhombus", "60", 3.0, 40, 0.57)


def with_keys(text, **keys):
    """The scene with other values; keys are found by name, and are unique in these files."""
    for key, value in keys.items():
        text, found = re.subn(rf"(?m)^{key} = [^#\n]*", f"{key} = {value} ", text)
        assert found == 1, key
    return text


def graded_columns(gap, growth):
    """How many columns, each wider than the last by `growth`, fill `gap` elements."""
    return max(1, round(math.log(1 + gap * (growth - 1) / growth) / math.log(growth)))


def scene(prism, mesh, wall, depth, fine, growth, half_width=None, columns=None, solver="", **keys):
    """`mesh`: elements on 1.59 mm. `fine`: mm of square columns beside the middle line; then as many `columns` as grow to the wall by `growth` each, unless their number is given."""
    half_width = half_width or prism.half_width
    elements = round(mesh * half_width / BALL)
    columns = columns or graded_columns((wall - fine) / half_width * elements, growth)
    text = re.sub(r"(?s)\[mesh\].*", "", prism.text)
    text = with_keys(text, width=f'"{wall} mm"', depth=f'"{depth} mm"', **keys)
    return text + f"[mesh]\nelements_per_radius = {elements}\nfine_width = {fine / half_width:.6f}\ngraded_columns = {columns}\n{solver}"


def ball_growth():
    """Of the balls' mesh: half as many graded columns as fine ones over four radii. The same at every mesh, to one column."""
    gap, columns = 4 * THESIS_MESH, THESIS_MESH // 2
    low, high = 1.01, 3
    for _ in range(60):
        q = (low + high) / 2
        low, high = (q, high) if q * (q ** columns - 1) / (q - 1) < gap else (low, q)
    return low


def thesis_scene(prism, mesh=THESIS_MESH, wall=WALL, fine=BALL, **keys):
    keys.setdefault("strain", prism.strain)
    if fine == BALL and wall == WALL:
        keys["columns"] = mesh // 2
    growth = ball_growth() ** (THESIS_MESH / mesh) if fine == BALL else GROWTH
    return scene(prism, mesh, wall, DEPTH, fine, growth, **keys)


def mould_scene(prism, density, mesh=MOULD_MESH, wall=MOULD_WALL, fine=None, **keys):
    settings = dict(density=f'"{density} kg/m3"', bulk_to_shear=50 if density < 500 else 100, bottom='"fixed"')
    settings.update(keys)
    return scene(prism, mesh, wall, MOULD_DEPTH, fine or prism.half_width, GROWTH ** (MOULD_MESH / mesh), **settings)


def ball_scene(radius, speed, strain, density, mould):
    wall, depth = (MOULD_WALL, MOULD_DEPTH) if mould else (5 * radius, 75 * radius)
    columns = graded_columns((wall / radius - 1) * 10, GROWTH) if mould else 5
    return f"""[particle]
radius = "{radius} mm"
density = "7800 kg/m3"
speed = "{speed} m/s"
[target]
density = "{density} kg/m3"
mu = "113 kPa"
convention = "mu/alpha"
alpha = 8.5
bulk_to_shear = {50 if density < 500 else 100}
depth = "{depth} mm"
width = "{wall} mm"
bottom = "{'fixed' if mould else 'free'}"
[target.erosion]
strain = {strain}
[mesh]
elements_per_radius = 10
graded_columns = {columns}
"""


def cm(result):
    """Depth in cm; infinite where the layer was passed through, nan where there is none."""
    if result.depth is not None:
        return 100 * result.depth
    return math.inf if result.outcome == "passed through" else math.nan


def depth_text(result):
    return "through" if result.outcome == "passed through" else result.depth_words(100)
