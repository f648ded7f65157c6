"""Writes docs/verification/friction.md from runs of the program (half a minute of processor time):

    python3 docs/verification/make_friction.py build/release/percal
"""
from five_scenes import SCENES, scene
from harness import command_line, mesh, percent, percent_off, processor, replicates, table, write_page

COEFFICIENTS = (0.1, 0.3)
MESH = 7


def rows_of(program, name, *numbers, count):
    smooth = None
    for friction in (0, *COEFFICIENTS):
        run = program.impact(scene(*numbers, particle=f"friction = {friction}"), *mesh(MESH), *replicates(count))
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
