"""Writes docs/verification/skin.md from runs of the program (about a minute of processor time):

    python3 docs/verification/make_skin.py build/release/percal
"""
from harness import THESIS, changed, command_line, mesh, percent, percent_off, processor, replicates, table, um, write_page

GOLD = (THESIS / "gold.toml").read_text()
MESH, REPLICATES = 10, 5
STRETCHES = (1, 1.05, 1.1, 1.2)
MU, K1, K2 = 0.2014e6, 243.6, 0.1327  # Pa; over MU; of human back skin, see the page


def scene(stretch=1, fibres=None, friction=0):
    text = changed(GOLD, ("[target.erosion]", f"stretch = {stretch}\n\n[target.erosion]"), ("[target]", f"friction = {friction}\n\n[target]"))
    if fibres:
        scale, kappa = fibres
        text = changed(text, ("[target.erosion]", f'[target.fibres]\nk1 = "{scale * K1 * MU:.6g} Pa"\nk2 = {K2}\nkappa = {kappa}\n\n[target.erosion]'))
    return text


ROWS = [*[(f"stretch {stretch}", scene(stretch)) for stretch in STRETCHES],
        *[(f"stretch {stretch}, fibres in the plane", scene(stretch, (1, 0.5))) for stretch in STRETCHES],
        *[(f"stretch {stretch}, fibres with kappa 0.4", scene(stretch, (1, 0.4))) for stretch in (1, 1.1)],
        ("ten times as stiff fibres in the plane", scene(1, (10, 0.5))),
        ("stretch 1.1, fibres in the plane, friction 0.1", scene(1.1, (1, 0.5), 0.1))]


def page(program):
    runs = [(name, program.impact(text, *mesh(MESH), *replicates(REPLICATES))) for name, text in ROWS]
    first = runs[0][1]
    rows = [[name, um(run.depth), um(run.error), percent_off(run.depth, first.depth), percent(run.energy["elastic"]), percent(run.energy["eroded"]),
             percent(run.energy["viscosity"]), f"{run.worst_closure:.0e}", f"{run.cpu():.2g}"] for name, run in runs]
    return f"""# Gold in skin that is stretched and has fibres

Made by make_skin.py. The gold sphere of data/guha2009/gold.toml, 1 um of radius at 651 m/s, into skin that is stretched in its plane before the impact, and has fibres in its plane ([theory](../theory/target.md), "Initial stretch",
"Fibres"). {MESH} elements per radius, means of {REPLICATES} replicates over the phase of the mesh with the standard error of the mean; depths in um; shares of the impact energy, counted from the stretched state; the worst closure of the ledger; CPU
seconds of one run on {processor()}.

{table(["skin", "depth", "error", "change", "elastic", "eroded", "viscosity", "closure", "CPU, s"], rows)}

The fibres are those that A. Ni Annaidh and others fitted to uniaxial tests of human back skin (Ann. Biomed. Eng. 40, 2012, 1666-1678, abstract): mu = 0.2014 MPa, k1 = 243.6 and k2 = 0.1327. Their k1 is without a unit: it is
read here as times mu, {K1 * MU / 1e6:.1f} MPa, and as that of all fibres together. Their two families at an angle are taken as lying in all directions of the plane, kappa = 1/2, or with some out of it. The
skin's matrix stays the thesis's, mu = 63.75 MPa, which an impact has shown: 300 times that of the slow tests. So the fibres, measured slowly, are of the matrix's size here and take an eighth of the depth; at the
rate of an impact nobody has measured them, and ten times as stiff ones take more than half of it.

A stretch of 1.05 takes a tenth of the depth and one of 1.2 more than a quarter: in tension the layer is stiffer, the more so the larger alpha, and that outweighs that its elements reach their limit of 0.7, which counts the whole strain,
sooner. An erosion strain and a modulus that give a measured depth in slack skin stand for both. All runs: {program.cpu:.0f} s of processor time; {program.machine()}.
"""


if __name__ == "__main__":
    write_page(command_line(__doc__, "skin.md"), page)
