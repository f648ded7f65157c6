"""Writes docs/verification/cell_limit.md from runs of the program (half a minute of processor time):

    python3 docs/verification/make_cell_limit.py build/release/percal
"""
import pathlib

from harness import command_line, in_percent, mean_size, mesh, replicates, rows_of, table, with_numbers, write_page

DATA = pathlib.Path(__file__).resolve().parents[2] / "data/guha2009"
MESH, COUNT = 10, 5
STRAIN, BELOW = 0.7, (0.7, 0.85, 1.0, 1.2, 1.5)
CELL = 1.5  # um, between the diameters of the smallest spheres and of the others


def scene(shot, below):
    return f"""[particle]
radius = "{shot['radius_um']} um"
density = "16800 kg/m3"
speed = "{shot['velocity_m_s']} m/s"

[target]
density = "1000 kg/m3"
mu = "15 MPa"
convention = "mu/alpha"
alpha = 8.5
bulk_to_shear = 50
depth = "75 um"

[target.erosion]
strain = {STRAIN}
strain_below = {below}
cell = "{CELL} um"
"""


def page(program):
    shots = with_numbers(rows_of(DATA / "gold_skin.csv"))
    depths = {}
    for below in BELOW:
        for shot in shots:
            if below == BELOW[0] or 2 * shot["radius_um"] < CELL:
                depths[below, shot["radius_um"], shot["velocity_m_s"]] = program.impact(scene(shot, below), *mesh(MESH), *replicates(COUNT))
    of = lambda below, shot: depths.get((below, shot["radius_um"], shot["velocity_m_s"])) or depths[BELOW[0], shot["radius_um"], shot["velocity_m_s"]]
    off = lambda below, chosen: [1e6 * of(below, shot).depth / shot["penetration_um"] - 1 for shot in chosen]
    small, large = [s for s in shots if 2 * s["radius_um"] < CELL], [s for s in shots if 2 * s["radius_um"] >= CELL]
    rows = [[f"{below:g}", *(of(below, shot).depth_words(1e6) for shot in small), in_percent(sum(off(below, small)) / len(small), "+.1f"), mean_size(off(below, small)), mean_size(off(below, shots))]
            for below in BELOW]
    others = [[f"{shot['radius_um']:g}", f"{shot['velocity_m_s']:g}", f"{shot['penetration_um']:g}", of(BELOW[0], shot).depth_words(1e6), in_percent(off(BELOW[0], [shot])[0], "+.1f")] for shot in large]
    return f"""# Erosion by the particle's size against a cell's

Made by make_cell_limit.py. The nine gold points of Guha 2009 (Table 4-4; depths measured by Kendall et al. 2004) with the published pair, mu 15 MPa as MU1, alpha 8.5, erosion strain {STRAIN}: once with that strain for
all, and with another one for particles of a diameter below `cell` ([scene.md](../formats/scene.md)). {MESH} elements per radius for every size, so that all have the same h/a; means of {COUNT} replicates over the phase of the mesh
with their standard errors. Means of the differences from the measured depths in per cent.

`cell` = {CELL} um is no cell's size: those of the epidermis are ten times as large, and all these particles would be below it. It stands where it parts the smallest spheres from the others, to show what a second
limit can do for a size effect in these data.

{table([f"strain_below", *(f"{s['radius_um']:g} um, {s['velocity_m_s']:g} m/s (measured {s['penetration_um']:g} um)" for s in small), "mean of the three, %", "mean size", "mean size of all nine"], rows)}

The six others, which have {STRAIN} in every row:

{table(["radius, um", "speed, m/s", "measured, um", "depth, um", "off, %"], others)}

A second limit has one number more for three points more; it fits a size effect, and cannot tell it from one of the mesh, of a rate or of a layer. {program.machine()}, {program.cpu:.0f} s of processor time.
"""


if __name__ == "__main__":
    write_page(command_line(__doc__, "cell_limit.md"), page)
