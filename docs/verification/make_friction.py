"""Writes docs/verification/friction.md from runs of the program (half a minute of processor time):

    python3 docs/verification/make_friction.py build/release/percal
"""
from harness import command_line, mesh, percent, percent_off, processor, replicates, table, write_page

COEFFICIENTS = (0.1, 0.3)
MESH = 7

# Name; pi4, alpha, rho_p/rho_t, K/mu, width and depth in radii, erosion strain; replicates.
SCENES = [
    ("S, gold in skin", 6.6474, 8.5, 16.8, 50, 5, 75, 0.7, 5),
    ("M, gold in skin of 55 MPa", 1.813, 8.5, 16.8, 50, 5, 75, 0.3, 5),
    ("P, PMMA at 80 m/s in gel of 478 kPa", 13.52, 11, 1.139, 150, 8, 40, 0.35, 5),
    ("F, steel BB at 180 m/s in gel of 55 kPa", 601, 13.8, 7.573, 800, 15, 150, 0.626, 3),
    ("U, steel BB at 190 m/s in gel of 314 kPa", 118.4, 3.95, 7.573, 400, 12, 100, 2.98, 3)]


def scene(pi4, alpha, density, bulk, width, depth, strain, friction):
    """Radius, speed and target density are 1: depths are in radii."""
    return f"""[particle]
radius = "1 m"
density = "{density} kg/m3"
speed = "1 m/s"
friction = {friction}

[target]
density = "1 kg/m3"
mu = "{1 / pi4:.12g} Pa"
alpha = {alpha}
bulk_to_shear = {bulk}
depth = "{depth} m"
width = "{width} m"

[target.erosion]
strain = {strain}
"""


def rows_of(program, name, *numbers, count):
    smooth = None
    for friction in (0, *COEFFICIENTS):
        run = program.impact(scene(*numbers, friction), *mesh(MESH), *replicates(count))
        smooth = smooth or run
        yield [name, f"{friction:g}", run.depth_words(1), percent_off(run.depth, smooth.depth) if friction else "-", percent(run.energy["friction"]),
               percent(run.energy["collisions"]), percent(run.energy["viscosity"]), percent(run.energy["eroded"]), f"{run.worst_closure:.0e}", f"{run.cpu():.2g}"]


def page(program):
    rows = [row for name, *numbers, count in SCENES for row in rows_of(program, name, *numbers, count=count)]
    return f"""# What friction does to a depth

Made by make_friction.py. Five shots that the mesh and its rules were chosen by, with Coulomb friction between the rigid sphere and the target ([theory](../theory/impact.md), (10c)).
Dimensionless scenes, {MESH} elements per radius, each element judged by its own strain; means of five replicates, of three for F and U, over the phase of the mesh, with the standard error of the mean. Depths in radii; shares of the impact
energy; the worst closure of the ledger; CPU seconds of one run on {processor()}.

{table(["scene", "coefficient", "depth", "change", "friction", "collisions", "viscosity", "eroded", "closure", "CPU, s"], rows)}

Friction is no detail: a coefficient of 0.1 takes a twelfth to a fifth of the depth, one of 0.3 a fifth to a third. It acts on what the sphere touches, the wall of the channel ahead of its equator, and brakes
the sphere there with the whole pressure that opens the channel. What it takes is missing mainly in what is eroded, for the channel is shorter. An erosion strain that was chosen to give a depth without friction stands for
both: with friction it would have to be larger. Nobody has measured the coefficient of these pairs at such speeds; in percal it is 0 unless a scene gives one. All runs: {program.cpu:.0f} s of processor time; {program.machine()}.
"""


if __name__ == "__main__":
    write_page(command_line(__doc__, "friction.md"), page)
