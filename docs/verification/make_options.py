"""Writes docs/verification/options.md from runs of the program (about three minutes of processor time):

    python3 docs/verification/make_options.py build/release/percal
"""
from harness import THESIS, changed, command_line, mesh, percent_off, processor, replicates, table, write_page

GOLD = (THESIS / "gold.toml").read_text()
MESHES, REPLICATES = (10, 14), 5

MU, ALPHA, DENSITY, SPEED = 15e6 * 8.5 / 2, 8.5, 1000, 651  # of the scene, mu as it truly is


def stress_at(stretch):
    """Uniaxial tension at constant volume, Pa."""
    return 2 * MU / ALPHA * (stretch**ALPHA - stretch**(-ALPHA / 2))


def energy_at(stretch):
    """The same, J/m3."""
    return 2 * MU / ALPHA**2 * (stretch**ALPHA + 2 * stretch**(-ALPHA / 2) - 3)


def solver(*lines):
    return lambda scene: scene + "\n[solver]\n" + "\n".join(lines) + "\n"


def erosion(*lines):
    old = GOLD[GOLD.index("[target.erosion]"):GOLD.index("[mesh]")]
    return lambda scene: changed(scene, (old, "[target.erosion]\n" + "\n".join(lines) + "\n\n"))


def relaxation(share, radii):
    """Time in a/v, a being 1 um."""
    term = f'[[target.relaxation]]\nshare = {share}\ntime = "{radii * 1e3 / SPEED:.6g} ns"\n\n'
    return lambda scene: changed(scene, ("[mesh]", term + "[mesh]"))


def layered(top_um, top_mpa, below_mpa, below_density=1000):
    def change(scene):
        scene = changed(scene, ('mu = "15 MPa"', f'mu = "{top_mpa} MPa"'), ('depth = "75 um"', f'depth = "{top_um} um"'))
        return scene + (f'\n[[below]]\nname = "lower"\ndensity = "{below_density} kg/m3"\nmu = "{below_mpa} MPa"\nalpha = 8.5\nbulk_to_shear = 50\n'
                        f'depth = "{75 - top_um} um"\n\n[below.erosion]\nstrain = 0.7\n')
    return change


# Name, what is altered in the scene. The first of each group is what the group is compared with.
GROUPS = [
    ("Strain measure, at a limit of 0.7", [
        ("engineering", None),
        ("Green-Lagrange (stretch 1.55)", erosion("strain = 0.7", 'measure = "green-lagrange"')),
        ("true (stretch 2.01)", erosion("strain = 0.7", 'measure = "true"'))]),
    ("What erosion is judged by, at the point that uniaxial tension to a stretch of 1.7 reaches", [
        ("strain 0.7", None),
        (f"stress {stress_at(1.7) / 1e6:.0f} MPa", erosion(f'stress = "{stress_at(1.7) / 1e6:.6g} MPa"')),
        (f"energy {energy_at(1.7) / 1e6:.1f} MJ/m3", erosion(f'energy = "{energy_at(1.7) / 1e3:.6g} kJ/m3"'))]),
    ("Eroded nodes", [("released", None), ("in contact", solver('eroded_nodes = "in contact"'))]),
    ("Hourglass control", [
        ("springs, 0.5 mu", None),
        ("none", solver("hourglass = 0")),
        ("springs, 0.1 mu", solver("hourglass = 0.1")),
        ("springs, 2 mu", solver("hourglass = 2")),
        ("dashpots, 0.02", solver('hourglass_form = "viscosity"')),
        ("dashpots, 0.1", solver('hourglass_form = "viscosity"', "hourglass = 0.1")),
        ("dashpots, 0.5", solver('hourglass_form = "viscosity"', "hourglass = 0.5"))]),
    ("Volumetric law", [
        ("log-quadratic", None),
        ("quadratic", solver('volumetric_law = "quadratic"')),
        ("logarithmic", solver('volumetric_law = "logarithmic"'))]),
    ("Bulk viscosity, linear and quadratic", [
        ("0.06, 0.6", None), ("0.12, 0.6", solver("linear_viscosity = 0.12")), ("0.06, 1.2", solver("quadratic_viscosity = 1.2")),
        ("none", solver("linear_viscosity = 0", "quadratic_viscosity = 0"))]),
    ("Rates", [("2", None), ("1", solver("rates = 1"))]),
    ("Relaxation of half the modulus", [
        ("none", None),
        ("in 100 a/v", relaxation(0.5, 100)), ("in 10 a/v", relaxation(0.5, 10)), ("in a/v", relaxation(0.5, 1)), ("in 0.1 a/v", relaxation(0.5, 0.1)),
        ("half the modulus, no relaxation", lambda scene: changed(scene, ('mu = "15 MPa"', 'mu = "7.5 MPa"')))]),
    ("Layers", [
        ("one", None),
        ("two alike, cut at 7 um", layered(7, 15, 15)),
        ("the first 2 um 4 times as stiff", layered(2, 60, 15)),
        ("half as stiff below 10 um", layered(10, 15, 7.5)),
        ("1.2 times as dense below 10 um", layered(10, 15, 15, 1200))]),
]


def depth_words(result):
    """In um with its standard error."""
    if result.depth is None:
        return ", ".join(sorted({run.outcome for run in result.runs}))
    return result.depth_words(1e6)


def least_cpu(result):
    """Of the run that the machine disturbed least."""
    return min(run.cpu for run in result.runs)


def row(name, here, plain):
    cells = [name]
    for n in MESHES:
        h, p = here[n], plain[n]
        cells += [depth_words(h), "" if h is p or h.depth is None else percent_off(h.depth, p.depth), f"{least_cpu(h) / least_cpu(p):.2f}"]
    fine = here[MESHES[-1]]
    return cells + [*(f"{fine.energy.get(term, 0):.2f}" for term in ("viscosity", "eroded", "relaxation")), f"{fine.worst_closure:.1e}"]


def group_table(program, cases):
    """The plain scene is run again for each group: what else the machine does changes with time."""
    def found(scene):
        return {n: program.impact(scene, *mesh(n), *replicates(REPLICATES)) for n in MESHES}
    plain = found(GOLD)
    head = ["", *(words for n in MESHES for words in (f"nf {n}: depth, um", "change", "CPU")), "viscosity", "eroded", "relaxation", "energy error"]
    return table(head, [row(name, plain if altered is None else found(altered(GOLD)), plain) for name, altered in cases])


def page(program):
    sections = "\n\n".join(f"## {title}\n\n{group_table(program, cases)}" for title, cases in GROUPS)
    return f"""# What each option of the target and the solver does

Written by `docs/verification/make_options.py` from runs of `data/guha2009/gold.toml` (setting S: gold of 1 um radius at 651 m/s into skin of 15 MPa as given, alpha 8.5,
erosion strain 0.7), one thing changed at a time, at 10 and 14 elements per radius (nf). Theory: [target.md](../theory/target.md).

Depths are means of {REPLICATES} runs with their standard error; a change within twice the two errors together, about 3 %, says nothing. CPU is the least processor time of the {REPLICATES} runs over
that of the plain scene, run just before: it grows with the depth as well, and the machine (one core of an {processor()}) has other users, which makes it uncertain by a tenth or two.
Viscosity, eroded and relaxation are shares of the impact energy at {MESHES[-1]} elements per radius, the energy error the worst of the {REPLICATES} runs.

{sections}
"""


if __name__ == "__main__":
    write_page(command_line(__doc__, "options.md"), page)
