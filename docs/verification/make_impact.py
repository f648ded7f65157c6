"""Writes docs/verification/impact.md from runs of the program (some minutes of processor time):

    python3 docs/verification/make_impact.py build/release/percal
"""
from harness import THESIS, Failed, changed, command_line, mesh, processor, replicates, table, um, write_page

TEN, FIVE = mesh(10), replicates(5)


def speed(result):
    """Million element-steps per processor second, of the first run: its element-steps are the ones reported."""
    return f"{result.element_steps / result.runs[0].cpu / 1e6:.0f}"


def mesh_table(program, gold):
    rows = []
    for n, count in ((5, 5), (7, 5), (10, 5), (14, 5), (21, 3), (30, 3)):
        r = program.impact(gold, *mesh(n), *replicates(count))
        rows.append([n, r.elements, um(r.depth), um(r.spread), r.steps, f"{r.worst_closure:.2e}", f"{r.energy['collisions']:.3f}", f"{r.energy['viscosity']:.3f}", f"{r.cpu():.2f}", speed(r)])
    return table(["elements per radius", "elements", "depth, um", "spread", "steps", "energy, worst closure", "collisions", "viscosity", "CPU s a run", "million element-steps/s"], rows)


def level_table(program, gold):
    rows = []
    for level in ("x86_64_v4", "x86_64_v3", "x86_64_v2"):
        for arithmetic in ("single", "double"):
            try:
                r = program.impact(gold, *TEN, *FIVE, "--arithmetic", arithmetic, level=level)
            except Failed:  # this processor lacks it
                continue
            rows.append([level, arithmetic, um(r.depth), um(r.spread), speed(r)])
    return table(["level", "arithmetic", "depth, um", "spread", "million element-steps/s"], rows)


def step_table(program, gold):
    head, tail = gold.split("[target.erosion]")
    uneroded = head.replace("alpha = 8.5", "alpha = 3") + "[mesh]" + tail.split("[mesh]")[1]
    rows = []
    for factor in (0.8, 0.4, 0.2, 0.1):
        solver = f"\n[solver]\ntime_step_factor = {factor}\n"
        quiet = program.impact(uneroded + solver + 'arithmetic = "double"\nend_time = "3.0722e-09 s"\n', *TEN, *replicates(1))
        eroding = program.impact(gold + solver, *TEN, *replicates(3))
        rows.append([str(factor), f"{quiet.worst_closure:.2e}", f"{eroding.worst_closure:.2e}", um(eroding.depth)])
    return table(["time-step factor", "no erosion, double: closure", "erosion, single: closure", "erosion: depth, um"], rows)


def domain_table(program, gold):
    changes = (("as it is",), ("bottom fixed", ('bottom = "free"', 'bottom = "fixed"')), ("width 10 a", ('width = "5 um"', 'width = "10 um"')),
               ("depth 45 a", ('depth = "75 um"', 'depth = "45 um"')), ("K/mu 100", ("bulk_to_shear = 50", "bulk_to_shear = 100")),
               ("K/mu 200", ("bulk_to_shear = 50", "bulk_to_shear = 200")))
    found = [(name, program.impact(changed(gold, *change), *TEN, *FIVE)) for name, *change in changes]
    return table(["change", "depth, um", "spread"], [[name, um(r.depth), um(r.spread)] for name, r in found])


def page(program):
    gold = (THESIS / "gold.toml").read_text()
    return f"""# The impact solver: mesh, noise, energy, cost

Written by `docs/verification/make_impact.py` from runs of `data/guha2009/gold.toml` (setting S; gold into skin, 15 MPa as given, alpha 8.5, erosion
strain 0.7) on one core of an {processor()}. Replicates walk the phase of the mesh, each at a speed of its own. Times are processor seconds on a machine
that others use too: compare them with each other.

## Mesh

{mesh_table(program, gold)}

A single run scatters by one to six per cent, most of it the phase of the mesh. Depths are means of the replicates; a difference of two of them that is smaller than the spread means nothing.

## Instruction level and arithmetic

10 elements per radius, five replicates.

{level_table(program, gold)}

## Energy and the time step

Left: no erosion, alpha 3, up to the time of two radii at impact speed: the closure falls as the square of the step. Right: with erosion, 10 elements per
radius, three replicates, whose means are good to 2 %.

{step_table(program, gold)}

## The domain and K

10 elements per radius, five replicates.

{domain_table(program, gold)}
"""


if __name__ == "__main__":
    write_page(command_line(__doc__, "impact.md"), page)
