"""Writes docs/verification/three_dimensions.md from runs of the program (about two hours of processor time, nothing when the store has them):

    python3 docs/verification/make_three_dimensions.py build/release/percal

Options: --store FILE for the evaluations (default: the program's own), --page FILE to write elsewhere, --jobs N scenes side by side, --part rules|costs to write that section of the page alone, as the rest stands.
"""
import itertools
import math
import random
import re
import statistics
from dataclasses import dataclass

from harness import THESIS, Store, changed, command_line, in_percent, mean_size, percent, replicates, rows_of, table, with_numbers, write_page
from prism_scenes import cm, depth_text, with_keys

ONE, THREE, FIVE = replicates(1), replicates(3), replicates(5)


@dataclass(frozen=True)
class Hypothesis:
    """A gelatin of the balls' calibration, docs/verification/calibration.md; its erosion strain belongs to elements of an eighth of a ball's radius."""
    name: str
    mu: float      # kPa, true
    alpha: float
    strain: float


HYPOTHESES = (Hypothesis("mu held at 113 kPa, as MU1", 837, 14.8, 0.299), Hypothesis("mu free", 1110, 13, 0.279), Hypothesis("mu held at the curve's 113 kPa", 113, 16, 0.537))
BALL, BALL_ELEMENTS = 1.59, 8  # mm; on the radius
BALL_OF_MASS = 2.78            # mm: of 0.7027 g


@dataclass(frozen=True)
class Prism:
    name: str
    text: str
    half_thickness: float  # mm
    fitted: float          # m/s: the shot at which the thesis fitted its erosion strain
    shots: tuple


def prisms():
    def one(name, angularity, half_thickness, fitted):
        shots = tuple(with_numbers(rows_of(THESIS / "angular_shots.csv", angularity_deg=angularity)))
        return Prism(name, (THESIS / f"{name}_block.toml").read_text(), half_thickness, fitted, shots)
    return one("rhombus", "60", 1.55, 40), one("square", "45", 1.45, 50)


# The erosion strain of other elements, by a ball that goes as deep on both.

def ball(hypothesis, elements, strain):
    return f"""[particle]
radius = "{BALL} mm"
density = "7800 kg/m3"
speed = "83 m/s"
[target]
density = "1010 kg/m3"
mu = "{hypothesis.mu} kPa"
alpha = {hypothesis.alpha}
depth = "100 mm"
width = "37.5 mm"
bottom = "fixed"
[target.erosion]
strain = {strain}
[mesh]
elements_per_radius = {elements}
"""


def strain_at(program, hypothesis, element):
    return strain_and_ball(program, hypothesis, element)[0]


def strain_and_ball(program, hypothesis, element):
    """Of elements of this side, mm: a straight line through ln depth over ln strain of five trials, as `percal card export --element-size` has it."""
    own = program.impact(ball(hypothesis, BALL_ELEMENTS, hypothesis.strain), *FIVE)
    factors = (0.8, 0.9, 1.0, 1.1, 1.25)
    trials = program.impacts([ball(hypothesis, round(BALL / element, 3), round(hypothesis.strain * f, 4)) for f in factors], *FIVE)
    x, y = [math.log(f) for f in factors], [math.log(t.depth / own.depth) for t in trials]
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    slope = sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x)
    return round(hypothesis.strain * math.exp(mean_x - mean_y / slope), 4), own


# Scenes.

def prism_scene(prism, hypothesis, strain, on_half_thickness=6, tilt=0, **keys):
    keys = {"mu": f'"{hypothesis.mu} kPa"', "convention": '"true"', "alpha": hypothesis.alpha, "strain": strain, **keys}
    text = with_keys(prism.text, **keys)
    if on_half_thickness != 6:
        half_width = {"rhombus": 3.0, "square": 5.83 * math.sqrt(0.5)}[prism.name]
        text += f"elements_per_radius = {on_half_thickness * half_width / prism.half_thickness:.6f}\n"
    if tilt:
        text = text.replace("[target]", f'orientation = "{tilt} deg"\nrotation = "free"\n\n[target]', 1)
    return text


def sphere_block(elements, erosion, pi4_mu, depth, wall):
    """Gold in skin, or a dent: lengths in um of a ball of 1 um."""
    return f"""geometry = "block"
[particle]
radius = "1 um"
density = "16800 kg/m3"
speed = "1000 m/s"
[target]
density = "1000 kg/m3"
mu = "{pi4_mu}"
alpha = 8.5
bulk_to_shear = 50
depth = "{depth} um"
width = "{wall} um"
bottom = "fixed"
{erosion}
[mesh]
elements_per_radius = {elements}
"""


def as_round(text, wall):
    """The axisymmetric scene with its wall there, on as many elements."""
    return with_keys(text.replace('geometry = "block"\n', ""), width=f'"{wall} um"')


DENT_MU, SKIN_MU = "1000 MPa", "150.4347 MPa"  # pi4 1 and 6.6474
SKIN_EROSION = "[target.erosion]\nstrain = 0.7"


def dent(program):
    rows = []
    for n in (4, 6, 8, 12):
        square, same_area, round_ = program.impacts([sphere_block(n, "", DENT_MU, 15, 5), sphere_block(n, "", DENT_MU, 15, round(5 * math.sqrt(math.pi) / 2, 6)),
                                                     as_round(sphere_block(n, "", DENT_MU, 15, 5), 5)], *ONE)
        radii = lambda r: f"{r.depth * 1e6:.3f}"
        rows.append([n, radii(round_), radii(same_area), in_percent(same_area.depth / round_.depth - 1, "+.1f"), radii(square), f"{same_area.energy['hourglass']:.3f}",
                     f"{same_area.worst_closure:.0e}", same_area.elements, f"{same_area.cpu():.2f}"])
    return table(["elements on the radius", "axisymmetric", "block of the cylinder's area", "difference, %", "block, wall at 5", "hourglass", "closure", "elements", "CPU s"], rows)


def eroding_sphere(program):
    rows = []
    for n in (4, 6, 8):
        block, round_ = program.impacts([sphere_block(n, SKIN_EROSION, SKIN_MU, 45, 5), as_round(sphere_block(n, SKIN_EROSION, SKIN_MU, 45, 5), 5)], *FIVE)
        rows.append([n, round_.depth_words(1e6), block.depth_words(1e6), in_percent(block.depth / round_.depth - 1, "+.1f"), f"{block.worst_closure:.1e}", block.elements,
                     f"{block.cpu():.1f}", f"{round_.cpu():.2f}"])
    return table(["elements on the radius", "axisymmetric", "block", "difference, %", "closure", "elements", "CPU s a run", "axisymmetric, CPU s a run"], rows)


def oblique(program):
    rows = []
    for angle in (0, 15, 30, 45, 60):
        text = sphere_block(4, SKIN_EROSION, SKIN_MU, 45, 5).replace("[target]", f'angle = "{angle} deg"\n[target]', 1) + "fine_depth = 32\n"
        answer = program.ask("impact", program.scene(text), "--threads", "1", *program.kept(), *ONE)
        run = answer["runs"][0]
        program.cpu += run["cpu_s"]
        depth, side = 1e6 * run["depth_m"], 1e6 * run.get("sideways_m", 0)
        rows.append([angle, answer["outcome"], f"{depth:.1f}", f"{side:.1f}", f"{math.hypot(depth, side):.1f}", f"{math.degrees(math.atan2(side, depth)):.1f}", answer["elements"], f"{run['cpu_s']:.1f}"])
    return table(["angle, deg", "outcome", "tip's depth", "sideways", "length of the path", "its direction, deg", "elements", "CPU s"], rows)


# Prisms.

def deviation(result, reference):
    return cm(result) / reference - 1 if math.isfinite(cm(result)) else math.nan


def means(prism, results, but=None):
    kept = [(shot, r) for shot, r in zip(prism.shots, results) if shot["velocity_m_s"] != but]
    return tuple(mean_size([deviation(r, shot[column]) for shot, r in kept]) for column in ("penetration_cm", "fe_cm"))


def twice_as_many_cubes(program, prism, speeds):
    """The slowest, the middle and the fastest shot, by speed, with the erosion strain converted to cubes of half the side."""
    strain = strain_at(program, HYPOTHESES[0], prism.half_thickness / 12)
    chosen = (speeds[0], prism.fitted, speeds[-1])
    found = program.impacts([prism_scene(prism, HYPOTHESES[0], strain, on_half_thickness=12, speed=f'"{v:g} m/s"') for v in chosen], *ONE)
    return dict(zip(chosen, found))


def transferred(program, prism, strains):
    """The six shots with each hypothesis, nothing fitted; what wall, mesh and tilt do beside the first."""
    first = HYPOTHESES[0]
    speeds = [shot["velocity_m_s"] for shot in prism.shots]
    at = lambda count, h=first, **changes: program.impacts([prism_scene(prism, h, strains[h.name], speed=f'"{v:g} m/s"', **changes) for v in speeds], *count)
    base = at(THREE)
    others = [at(ONE, h=h) for h in HYPOTHESES[1:]]
    variants = [("wall x 1/2", at(ONE, width='"18.75 mm"')), ("wall x 2", at(ONE, width='"75 mm"')), ("8 cubes for 6", at(ONE, on_half_thickness=8)),
                ("tilt 5 deg", at(ONE, tilt=5)), ("tilt 20 deg", at(ONE, tilt=20))]
    finer = twice_as_many_cubes(program, prism, speeds)
    rows = []
    for k, shot in enumerate(prism.shots):
        rows.append([f"{speeds[k]:g}", f"{shot['penetration_cm']:.2f}", f"{shot['fe_cm']:.2f}", depth_text(base[k]), in_percent(deviation(base[k], shot["penetration_cm"]), "+.1f"),
                     *(depth_text(found[k]) for found in others), *(depth_text(found[k]) for _, found in variants), depth_text(finer[speeds[k]]) if speeds[k] in finer else ""])
    changes = [in_percent(sum(cm(a) / cm(b) - 1 for a, b in zip(found, base)) / len(base), "+.1f") for _, found in variants]
    of_finer = in_percent(sum(cm(found) / cm(base[speeds.index(v)]) - 1 for v, found in finer.items()) / len(finer), "+.1f")
    rows.append(["mean change, %", *[""] * (4 + len(others)), *changes, of_finer])
    text = table(["m/s", "measured", "LS-DYNA, one strain fitted", first.name, "to measured, %", *(h.name for h in HYPOTHESES[1:]), *(name for name, _ in variants), "12 cubes for 6"], rows)
    tilts = [f"{math.degrees(abs(r.runs[0].turn or 0)):.0f}" for r in variants[3][1]]
    summary = "; ".join(f"{h.name} {means(prism, r)[0]}" for h, r in zip(HYPOTHESES, (base, *others)))
    return f"""{text}

Mean deviation from the measurements: {summary}. Started 5 degrees aslant and free to turn, it has turned by {', '.join(tilts)} degrees when it stops. A run costs {sum(r.cpu() for r in base) / len(base):.1f} CPU s ({base[0].elements} elements)
with six cubes on half the thickness, {sum(r.cpu() for r in variants[2][1]) / len(base):.1f} with eight, {sum(r.cpu() for r in finer.values()) / len(finer):.0f} with twelve; energies close within {max(r.worst_closure for r in base):.1%}.
"""


def fitted(program, prism, balls_strain):
    """The erosion strain fitted to one shot, by bisection on single runs, and the other shots with it."""
    first = HYPOTHESES[0]
    shot = next(s for s in prism.shots if s["velocity_m_s"] == prism.fitted)
    low, high, best = 0.6 * balls_strain, 1.3 * balls_strain, None
    while high - low > 0.03 * balls_strain:
        strain = round((low + high) / 2, 4)
        result = program.impact(prism_scene(prism, first, strain, speed=f'"{prism.fitted} m/s"'), *ONE)
        off = abs(deviation(result, shot["penetration_cm"]))
        if best is None or not off >= best[0]:
            best = (off, strain)
        low, high = (strain, high) if cm(result) > shot["penetration_cm"] else (low, strain)
    results = program.impacts([prism_scene(prism, first, best[1], speed=f'"{s["velocity_m_s"]:g} m/s"') for s in prism.shots], *ONE)
    measured, fe = means(prism, results, but=prism.fitted)
    return [prism.name, f"{best[1]:g}", *(depth_text(r) for r in results), measured, fe]


def equal_masses(program, prisms, strains):
    """Table 5-3: 0.7027 g of each shape at 40 m/s; the ball on elements of the square's size."""
    rhombus, square = prisms
    rows = []
    for h in HYPOTHESES:
        scenes = [prism_scene(rhombus, h, strains["rhombus"][h.name], speed='"40 m/s"'), prism_scene(square, h, strains["square"][h.name], speed='"40 m/s"', side='"5.64 mm"', mass='"0.7027 g"')]
        element = square.half_thickness / 6
        ball_ = with_keys(ball(h, round(BALL_OF_MASS / element, 3), strains["square"][h.name]), radius=f'"{BALL_OF_MASS} mm"', speed='"40 m/s"')
        rows.append([h.name, *(depth_text(program.impact(text, *THREE)) for text in (*scenes, ball_))])
    printed = [row["penetration_cm"] for row in with_numbers(rows_of(THESIS / "angularity.csv"))]
    return table(["hypothesis", "rhombus", "square of 5.64 mm", f"ball of {BALL_OF_MASS} mm radius"], [["thesis, from its lines", *printed], *rows])


def blunt(text, side, by):
    """The square with its corners cut off, `by` of each side at each end; all in mm."""
    c = side * math.sqrt(0.5)
    corners = [(0, -c), (c, 0), (0, c), (-c, 0)]
    cut = []
    for k, (x, y) in enumerate(corners):
        for other in (corners[k - 1], corners[(k + 1) % 4]):
            share = by / side
            cut.append((x + share * (other[0] - x), y + share * (other[1] - y)))
    vertices = ", ".join(f'["{x:.4f} mm", "{y:.4f} mm"]' for x, y in cut)
    return changed(text, ('shape = "rhombus"', f'shape = "profile"\nvertices = [{vertices}]'), ('side = "5.83 mm"\n', ""), ('tip_angle = "90 deg"\n', ""))


def missing_fifth(program, square, strains):
    """What would have the square go deeper: one number changed at a time, the shots of 50 and 60 m/s."""
    first = HYPOTHESES[0]
    strain = strains["square"][first.name]
    changes = [("as it is", {}, None), ("mass + 5 %", {"mass": '"0.7884 g"'}, None), ("mass + 25 %", {"mass": '"0.9386 g"'}, None), ("thickness - 5 %, mass as it is", {"thickness": '"2.755 mm"'}, None),
               ("speed + 5 %", {}, 1.05), ("erosion strain - 5 %", {"strain": round(0.95 * strain, 4)}, None), ("erosion strain - 10 %", {"strain": round(0.9 * strain, 4)}, None),
               ("mu - 20 %", {"mu": f'"{0.8 * first.mu:g} kPa"'}, None), ("gelatin's density - 5 %", {"density": '"960 kg/m3"'}, None)]
    speeds = (50, 60)
    rows = []
    for words, keys, faster in changes:
        texts = [prism_scene(square, first, keys.get("strain", strain), speed=f'"{v * (faster or 1):g} m/s"', **{k: v for k, v in keys.items() if k not in ("strain", "mu")}) for v in speeds]
        if "mu" in keys:
            texts = [with_keys(text, mu=keys["mu"]) for text in texts]
        rows.append([words, *program.impacts(texts, *ONE)])
    straight = [prism_scene(square, first, strain, speed=f'"{v} m/s"') for v in speeds]
    rows.append(["corners cut by 0.1 mm of each side", *program.impacts([blunt(text, 5.83, 0.1) for text in straight], *ONE)])
    rows.append(["face first, held", *program.impacts([text.replace("[target]", 'orientation = "45 deg"\n\n[target]', 1) for text in straight], *ONE)])
    rows += [[f"friction {c}", *program.impacts([text.replace("[target]", f"friction = {c}\n\n[target]", 1) for text in straight], *ONE)] for c in (0.1, 0.3)]
    own = rows[0][1:]
    measured = [next(s["penetration_cm"] for s in square.shots if s["velocity_m_s"] == v) for v in speeds]
    lines = [["measured", *(f"{m:.2f}" for m in measured), in_percent(sum(m / cm(r) - 1 for m, r in zip(measured, own)) / 2, "+.1f")]]
    lines += [[words, *(depth_text(r) for r in found), in_percent(sum(cm(r) / cm(o) - 1 for r, o in zip(found, own)) / 2, "+.1f")] for words, *found in rows]
    return table(["change", "50 m/s, cm", "60 m/s, cm", "mean change, %"], lines)


# What a block can that the axisymmetric solver cannot.

SKIN_FIBRES = "k1 = \"{k1} kPa\"\nk2 = 0.13\nkappa = {kappa}\nangle = \"{angle} deg\"\n"  # k2 as of human skin (Annaidh et al. 2012)


def directions(program, rhombus, strains):
    """Fibres along and across the rhombus's edge, and tension of the block in one or the other direction."""
    first = HYPOTHESES[0]
    base = prism_scene(rhombus, first, strains["rhombus"][first.name], speed='"40 m/s"')
    with_fibres = lambda kappa, angle: base.replace("[target.erosion]", "[target.fibres]\n" + SKIN_FIBRES.format(k1=200, kappa=kappa, angle=angle) + "[target.erosion]", 1)
    taut = lambda x, y: base.replace("[target.erosion]", f"stretch = {x}\nstretch_across = {y}\n[target.erosion]", 1)
    cases = [("none of either", base), ("fibres across the edge, along x", with_fibres(0, 0)), ("fibres along the edge, along y", with_fibres(0, 90)), ("two families at 45 deg to either", with_fibres(0, 45)),
             ("fibres in all directions, kappa 1/3", with_fibres(0.333333, 0)), ("stretched by 1.1 across the edge", taut(1.1, 1)), ("stretched by 1.1 along the edge", taut(1, 1.1)), ("stretched by 1.05 in both", taut(1.05, 1.05))]
    found = [program.impact(text, *THREE) for _, text in cases]
    lines = [[words, depth_text(r), in_percent(cm(r) / cm(found[0]) - 1, "+.1f"), percent(r.worst_closure, ".1f")] for (words, _), r in zip(cases, found)]
    return table(["gelatin of the first hypothesis with", "rhombus at 40 m/s, cm", "change, %", "closure"], lines)


# Whether the rules of errors hold, docs/theory/errors.md (13).

def random_block(rng):
    """A sphere or a prism on coarse cubes, slow or fast, in a soft or a firm target; every third prism stands aslant and is free to turn. The scene, and its half width in mm."""
    mu, alpha, strain = round(10 ** rng.uniform(1.5, 3), 1), round(rng.uniform(2, 14), 1), round(10 ** rng.uniform(-0.6, 0), 3)
    wall, speed = round(rng.uniform(15, 45), 1), round(rng.uniform(25, 110), 0)
    if rng.random() < 0.4:
        radius = round(rng.uniform(1.5, 3), 2)
        half_width, elements = radius, 4
        particle = f'radius = "{radius} mm"\ndensity = "{rng.choice((2500, 4500, 7800))} kg/m3"'
    else:
        side, thickness = round(rng.uniform(4, 8), 2), round(rng.uniform(2.5, 5), 2)
        tip, density = rng.choice((45, 60, 75, 90)), rng.choice((2700, 7800))
        half_width = side * math.sin(math.radians(tip / 2))
        elements = round(4 * max(1, half_width / (thickness / 2)), 3)
        particle = f'shape = "rhombus"\nside = "{side} mm"\ntip_angle = "{tip} deg"\nthickness = "{thickness} mm"\ndensity = "{density} kg/m3"'
        if rng.random() < 1 / 3:
            particle += f'\norientation = "{rng.randint(3, 25)} deg"\nrotation = "free"'
    return f"""geometry = "block"
[particle]
{particle}
speed = "{speed} m/s"
[target]
density = "1010 kg/m3"
mu = "{mu} kPa"
alpha = {alpha}
depth = "{DEEPEST} mm"
width = "{wall} mm"
[target.erosion]
strain = {strain}
[mesh]
elements_per_radius = {elements}
fine_depth = {0.9 * DEEPEST / half_width:.4f}
""", half_width


DEEPEST, SCENES = 40, 20  # mm; of those that fit
MEASURED = re.compile(r"moves the depth by ([-+.\d]+) %, standard error ([.\d]+) %")
BETTER = {"wall": ("wall x 1.5", 1), "time step": ("half the time step", 4 / 3), "K": ("2 K", 2)}  # the change, and q of (12): the whole effect over it


@dataclass(frozen=True)
class Effect:
    """Shares of the depth, of one scene: what the better setting did, the standard error of that, and the rule."""
    change: float
    error: float
    rule: float


def effects(program):
    """Of each source on random blocks that stop among the cubes, two half widths deep or more."""
    rng, found = random.Random(7), {source: [] for source in BETTER}
    for _ in itertools.count():
        if len(found["wall"]) == SCENES:
            return found
        text, half_width = random_block(rng)
        scene = program.scene(text)
        ask = lambda *options: program.ask("impact", scene, "--threads", "1", *program.kept(), *FIVE, *options)
        ruled = ask()
        if ruled["outcome"] != "stopped" or not 2e-3 * half_width <= ruled["depth_m"] <= 0.9e-3 * DEEPEST:
            continue
        measured = ask("--measure-errors")
        rules = {part["source"]: part["half_width_m"] / ruled["depth_m"] for part in ruled["depth_error"]["sources"] if part["half_width_m"]}
        program.cpu += sum(run["cpu_s"] for run in measured["runs"])
        for part in measured["depth_error"]["sources"]:
            if seen := MEASURED.search(part["how"]):
                found[part["source"]].append(Effect(*(float(words) / 100 for words in seen.groups()), rules[part["source"]]))


STEP_OF_ROUND = 0.02  # the rule of axisymmetric scenes for the time step


def rules(program):
    rows, found = [], effects(program)
    steps = [(BETTER["time step"][1] * abs(e.change), BETTER["time step"][1] * (abs(e.change) - 2 * e.error)) for e in found["time step"]]
    for source, pairs in found.items():
        setting, whole = BETTER[source]
        over = [whole * abs(e.change) / e.rule for e in pairs]
        less_noise = [whole * max(0, abs(e.change) - 2 * e.error) / e.rule for e in pairs]
        size = math.sqrt(max(0, statistics.mean(e.change ** 2 - e.error ** 2 for e in pairs)))
        rows.append([source, setting, len(pairs), in_percent(statistics.mean(e.change for e in pairs), "+.1f"), in_percent(size), in_percent(math.sqrt(statistics.mean(e.error ** 2 for e in pairs))),
                     f"{100 * min(e.rule for e in pairs):.0f} to {100 * max(e.rule for e in pairs):.0f}", sum(o <= 1 for o in over), sum(o <= 1 for o in less_noise), f"{max(over):.1f}"])
    return f"""## The rules of errors

`percal impact` says what wall, time step and K may cost by rules ([errors.md](../theory/errors.md), (13)). {SCENES} random shots that stop among the cubes of a block, two half widths deep or more: spheres and prisms, some aslant and free to turn, on four cubes to the radius or to half
the thickness, mu of 32 to 1000 kPa, alpha of 2 to 14, erosion strain of 0.25 to 1, 25 to 110 m/s, the wall at 15 to 45 mm; each with `--replicates 5 --measure-errors`. Changes of the depth in per cent: mean, root mean square with the standard error of the pairs taken off, and
that error. "Within": the whole effect, (12) without t, is within the rule; "or by error": it is beyond by less than two standard errors of the pairs. "Worst": the largest whole effect, over its rule.

{table(["source", "change", "scenes", "mean, %", "r.m.s., %", "error, %", "rule, %", "within", "or by error", "worst"], rows)}

Wall and K go by the rules of axisymmetric scenes. Their rule for the time step, {percent(STEP_OF_ROUND, ".0f")}, would hold {sum(whole <= STEP_OF_ROUND for whole, _ in steps)} of these, or {sum(less <= STEP_OF_ROUND for _, less in steps)} by error: here half the step does twice what it did there, and a block's own rule was chosen on these scenes. More cubes were not tried.
"""


# What options cost.

PAIRS = 5


def prism_of_gel(particle, rest="", before="", solver=""):
    """A prism of 6 x 6 x 4 mm, edge first, 40 mm of gel; `particle` is its shape, `rest` stands in the target, `before` behind it."""
    return f"""geometry = "block"
replicates = 1
[particle]
{particle}
density = "7800 kg/m3"
speed = "50 m/s"
[target]
density = "1010 kg/m3"
mu = "600 kPa"
alpha = 8
depth = "40 mm"
width = "25 mm"
{rest}
[target.erosion]
strain = 0.5
{before}
[mesh]
elements_per_radius = 14
[solver]
{solver}
"""


def options_of_a_block():
    half = 6 * math.sqrt(0.5)
    shape = 'shape = "rhombus"\nside = "6 mm"\ntip_angle = "90 deg"\nthickness = "4 mm"'
    corners = ", ".join(f'["{x:.6f} mm", "{y} mm", "{z:.6f} mm"]' for y in (-2, 2) for x, z in ((0, -half), (half, 0), (0, half), (-half, 0)))
    below = '[[below]]\ndensity = "1010 kg/m3"\nmu = "600 kPa"\nalpha = 8\ndepth = "20 mm"\n[below.erosion]\nstrain = 0.5'
    return prism_of_gel(shape), [
        ("friction, 0.2", changed(prism_of_gel(shape), ("[particle]", "[particle]\nfriction = 0.2"))),
        ("two layers, alike", changed(prism_of_gel(shape, before=below), ('depth = "40 mm"', 'depth = "20 mm"'))),
        ("stretched by 1.05 both ways", prism_of_gel(shape, rest="stretch = 1.05")),
        ("two families of fibres", prism_of_gel(shape, rest='[target.fibres]\nk1 = "60 kPa"\nk2 = 0.1\nangle = "45 deg"')),
        ("double arithmetic", prism_of_gel(shape, solver='arithmetic = "double"')),
        ("the same body as a polyhedron", prism_of_gel(f'shape = "polyhedron"\nvertices = [{corners}]'))]


def costs(program):
    """CPU time of each option over that of the plain prism, runs of either in turn."""
    plain, options = options_of_a_block()
    new_store = lambda: ("--store", program.folder / f"cost{next(program.count)}.store")
    def cost(text):
        answer = program.ask("impact", program.scene(text), "--threads", "1", *new_store())
        seconds = answer["runs"][0]["cpu_s"]
        program.cpu += seconds
        return seconds, answer["element_steps"], answer
    rows, plains = [], []
    for words, text in options:
        pairs = [(cost(plain), cost(text)) for _ in range(PAIRS)]
        plains += [a[0] for a, _ in pairs]
        run = [b[0] / a[0] for a, b in pairs]
        each = [(b[0] / b[1]) / (a[0] / a[1]) for a, b in pairs]
        first, last = pairs[0][0][2], pairs[0][1][2]
        rows.append([words, f"{statistics.median(run):.2f}", f"{min(run):.2f} to {max(run):.2f}", f"{statistics.median(each):.2f}", f"{min(each):.2f} to {max(each):.2f}",
                     f"{last['element_steps'] / first['element_steps']:.2f}", in_percent(last["depth_m"] / first["depth_m"] - 1, "+.1f") if last["depth_m"] else last["outcome"]])
    return f"""## Cost of options

A steel prism of 6 x 6 x 4 mm, edge first at 50 m/s, into 40 mm of gel of 600 kPa that erodes at 0.5; a quarter of the block on 14 cubes to half the width. Its CPU time, {statistics.median(plains):.2f} s a run, and the option's, in turn, {PAIRS} pairs: median, least and greatest ratio, of a run and of
an element's step ({program.machine()}, one thread). An option that has the prism go deeper or makes the step shorter takes more of them, "steps" times as many.

{table(["option", "a run", "from, to", "an element's step", "from, to", "steps", "depth, %"], rows)}
"""


SECTIONS = {"rules": rules, "costs": costs}


def with_section(text, section):
    """The page with this section in the place of the one of the same heading, or at its end."""
    heading = section[:section.index("\n")]
    before, found, old = text.partition(f"{heading}\n")
    after = old[old.index("\n## ") + 1:] if "\n## " in old else ""
    return before.rstrip("\n") + "\n\n" + section + ("\n" + after if after else "")


def page(program):
    if program.options.part:
        return with_section(program.options.page.read_text(), SECTIONS[program.options.part](program))
    both = prisms()
    strains = {p.name: {h.name: strain_at(program, h, p.half_thickness / 6) for h in HYPOTHESES} for p in both}
    balls = [[h.name, f"{h.mu:g}", f"{h.alpha:g}", f"{h.strain:g}", depth_text(strain_and_ball(program, h, both[0].half_thickness / 6)[1]), *(f"{strains[p.name][h.name]:g}" for p in both)] for h in HYPOTHESES]
    dents, sphere, aslant = dent(program), eroding_sphere(program), oblique(program)
    tables = {p.name: transferred(program, p, strains[p.name]) for p in both}
    fits = [fitted(program, p, strains[p.name][HYPOTHESES[0].name]) for p in both]
    masses, tried, aligned = equal_masses(program, both, strains), missing_fifth(program, both[1], strains), directions(program, both[0], strains)
    return f"""# Three dimensions

Written by `docs/verification/make_three_dimensions.py` from `percal impact` ({program.machine()}, one thread a run), from `data/guha2009/rhombus_block.toml` and `square_block.toml`. What is solved:
[theory/solid.md](../theory/solid.md). Formulas are held by tests/solid: stress against an eigensolver on 20,000 states of each kind for alpha from -6 to 20, in single precision within 2e-4 of max(mu, P) at worst and
1e-5 rms; stress and forces as derivatives of energies; patch test; plane waves; the step bound against eigenvalues of whole elements for alpha of both signs; momentum to 1e-12; both halves against a quarter to 1e-6; the same
bits on 1, 2 and 7 threads.

± is the standard error of the mean over the phase of the mesh; a figure without it is one run.

## A sphere, against the axisymmetric solver

A dent, nothing erodes: pi4 1, density ratio 16.8, alpha 8.5, K 50 mu, 15 radii deep. Depths in radii. "Closure" is what the energies lack.

{dents}

Gold in skin, eroding at 0.7: pi4 6.6474, 45 radii deep, wall at 5, five runs over the phase of the mesh. Depths in radii.

{sphere}

At 6 and 8 elements the block's channel is 1 and 3 % shallower, at 4 deeper: the phases of so coarse meshes scatter by as much, and no difference is beyond both errors. Five phases tell a mean no better than that: a build whose bits differ in rounding had 23.3 ± 0.3 at 8 elements.

The same sphere aslant, four elements on the radius, free to move sideways, cubes down to 32 radii. Lengths in radii.

{aslant}

## Prisms with the balls' material

Steel prisms into 12 wt% gelatin, in the mould (wall at 37.5 mm, 100 mm deep, bottom held), gelatin of 1010 kg/m3. Modulus, exponent and erosion strain are those that the balls' calibration found ([calibration.md](calibration.md)), one column a hypothesis;
**nothing is fitted to a prism**. The erosion strain belongs to elements of an eighth of the ball's radius, 0.20 mm; it is converted to the prisms' cubes by the ball that goes as deep on both (as `percal card export --element-size` does it).

{table(["hypothesis", "mu, kPa", "alpha", "strain on the ball", "the ball at 83 m/s, cm (measured 4.04)", *(f"strain on the {p.name}'s cubes" for p in both)], balls)}

The wall, which decides everything in plane strain ([prisms.md](prisms.md)), moves no mean by more than about 3 %, a third more cubes by 3 to 4 %, twice as many, with the strain that the ball has on them, by 2 to 6 %, always deeper. What decides is the material: three that fit the balls alike have the rhombus off by 8, 15 and 26 %. The square is 15 to 17 % off with each of them, and too shallow from
45 m/s on with all: its measured line rises by 1.3 mm for each m/s, the computed one by 0.9. Neither wall, mesh nor standing aslant explains it; what else was tried is below. The rhombus tumbles: 20 degrees aslant it stops a quarter short, and how straight the sabot let it go is not known.

### Rhombus, 60 degrees, tip first (Table 5-1), cm

{tables["rhombus"]}
### Square, corner first (Table 5-2), cm

{tables["square"]}
### The square's missing fifth

One number changed at a time, hypothesis "{HYPOTHESES[0].name}", one run each:

{tried}

No change that the experiment's own figures leave room for gives it. Mass, thickness and speed are printed to a per cent or better and would have to be off by 25, 25 and 15 %; corners that are worn, or a start on a face, change a few per cent; friction only takes
depth away, 9 and 19 % with coefficients of 0.1 and 0.3. A sabot that goes in with the prism would have to weigh a quarter of it. What would do it is a gelatin that tears 15 % earlier or is a quarter softer under the square than under the balls and the rhombus, and then the slow shots come out too deep ("fitted to one shot", below). So it is the
material's law or the rule of erosion, not the geometry, or something about these six shots that the thesis does not say: left open.

### Equal mass at 40 m/s (Table 5-3), cm

0.7027 g each: the rhombus as it is, a square of 5.64 mm, a steel ball of {BALL_OF_MASS} mm radius (axisymmetric, on elements of the square's side, with its erosion strain). Three runs each, nothing fitted. The thesis's column is computed itself, from its lines of depth over speed.

{masses}

The order, rhombus before ball before square, is the thesis's with each hypothesis, and the ball's depth is within 4 % of it.

### The erosion strain fitted to one shot, as the thesis did

Hypothesis "{HYPOTHESES[0].name}", six cubes, one run each; the shot of 40 m/s (rhombus) and 50 m/s (square) fitted. Depths of the six shots in cm, and the mean deviation of the other five.

{table(["prism", "strain", *(f"shot {k}" for k in range(1, 7)), "to measured", "to LS-DYNA"], fits)}

## Fibres and tension that have a direction

The rhombus at 40 m/s into the gelatin of the first hypothesis (mu 837 kPa, eroding at 0.287) with two families of fibres (k1 200 kPa each, k2 0.13; at 0 and 90 degrees the two are one) or stretched before the impact; the edge of its tip lies along y. Three runs each.

{aligned}

Fibres take 3 to 7 % of the depth, whichever way they lie: between along and across the edge there is no difference beyond the scatter. This gelatin erodes at 0.287, before fibres of this stiffness carry much. Tension across the edge opens the way by half: erosion counts the whole strain, and a tenth of 0.287 is there before the edge comes.
Along the edge it does little.

{rules(program)}
{costs(program)}"""


if __name__ == "__main__":
    arguments = command_line(__doc__, "three_dimensions.md", store=Store.PERCALS, jobs=1)
    arguments.add_argument("--part", choices=SECTIONS, help="the section to write, of a page that stands")
    write_page(arguments, page)
