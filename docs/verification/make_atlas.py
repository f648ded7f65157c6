"""Writes docs/verification/atlas.md from percal's runs: fresh runs against the atlas by region, and what calibrations that begin with it cost.

    python3 docs/verification/make_atlas.py build/release/percal
"""
from harness import ROOT, THESIS, Store, command_line, number, percent, table, write_page

POINTS = 200
JOBS = {"data/synthetic/joint.toml": ROOT / "data/synthetic/joint.toml", "data/guha2009/skin_consistent.toml": THESIS / "skin_consistent.toml"}


def region_rows(regions):
    return [[region["region"], region["runs"], percent(region["median_error"]), percent(region["rms_error"]), number(region["standardised"], ".2f"),
             percent(region["within95"] / region["runs"])] for region in regions if region["runs"]]


def calibration_row(name, found):
    emulator, cost = found["emulator"], found["cost"]
    return [name, emulator["from_atlas"], cost["runs"], percent(emulator["error_at_optimum"]), percent(emulator["data_error"]),
            number(cost["cpu_s"], ".0f")]

# Before and after, of two builds: measured once, not by this program.
MEASURED_ONCE = """## Without a ladder, and with fewer runs

Measured once, on two shared cores of an AMD EPYC (Zen 5, AVX-512); processor time. Scene S of five_scenes.py, 10 elements per radius, at `--accuracy 2%`: 38.4 s with a ladder (37.5 s of it), 0.9 s where the atlas says how many runs its 3.0 % of scatter asks for (three), 0.34 s where it bears a part of the depth: one run of 0.21 s, 26.9 radii +- 1.9 % where 20 runs have 26.3 +- 0.3 and the atlas alone 27.5 +- 2.5 %. Scenes M and P: 0.49 and 0.19 s.

The fit of data/guha2009/skin_consistent.toml over a full store (three hypotheses, 29 shots and 27 of them fitted, profiles, bootstrap, ridges, leave-one-out): 150 s of processor time with sums over the emulator's runs by Eigen and Ceres' search along cut steps, 83 s without that search, 25 s with the sums in lanes; 14 s of wall time on two cores, where 118 s were measured before.

The chain of data/guha2009/skin.toml: 330 s and 765 runs without, 246 s and 468 runs with the atlas, which leaves the 204 s of the predictions on 14 elements per radius as they are: there one run is surer than the atlas. alpha 8.55 and 8.55, erosion strain of skin 0.695 +- 0.014 and 0.695 +- 0.015. With predictions on 10 elements per radius, those of the ridge, and two replicates the chain takes 62 s; but a depth belongs to its elements, and nine gold shots then lie 10.5 % from LS-DYNA's depths (8.5 % on 14).

`percal invert`, five searches each, before and with the atlas:

| depth | runs before | s | 95 % | runs | s | 95 % |
| --- | --- | --- | --- | --- | --- | --- |
| BB at 85 mm, modulus | 35 | 23.7 | 0.476 MPa (0.369 to 0.613) | 25 | 18.1 | 0.472 MPa (0.372 to 0.599) |
| BB at 49.7 mm, modulus | 38 | 12.9 | 1.163 MPa (1.061 to 1.275) | 30 | 10.5 | 1.170 MPa (1.054 to 1.299) |
| BB at 49.7 mm, erosion strain | 45 | 20.2 | 1.372 (1.334 to 1.411) | 30 | 14.5 | 1.370 (1.331 to 1.411) |
| gold at 26 um, modulus | 44 | 13.8 | 63.6 MPa (56.2 to 72.1) | 30 | 10.8 | 63.1 MPa (54.7 to 72.9) |

What an emulator of a place costs and how near it is to 50 of the fresh runs, by how its hyperparameters are found (the last column: how its noise differs from that of the long search, root mean square of the ln):

| nearest runs | search | s | half are within | r.m.s. | r.m.s. over the stated | noise |
| --- | --- | --- | --- | --- | --- | --- |
| 300 | begins on 150, to the end | 0.63 | 2.0 % | 4.1 % | 0.90 | |
| 300 | begins on 100, ten steps on all (as it is) | 0.16 | 1.9 % | 4.0 % | 0.87 | 0.13 |
| 300 | on 100 alone | 0.11 | 1.9 % | 4.2 % | 1.04 | 0.29 |
| 200 | begins on 100, twenty steps on all | 0.11 | 2.1 % | 4.3 % | 0.94 | 0.15 |
"""


def page(percal):
    checked = percal.ask("atlas", "check", "--points", POINTS, *percal.kept(), accepted=(0, 1, 3))["atlases"][0]
    found = {name: percal.ask("calibrate", job, *percal.kept(), "--out", "none", accepted=(0, 1, 3)) for name, job in JOBS.items()}
    regions = table(["reach", "fresh runs", "half are within", "r.m.s.", "r.m.s. over the stated", "within the stated 95 %"], region_rows(checked["regions"]))
    calibrations = table(["job", "runs of the atlas", "runs", "emulator's error", "data's error", "processor time of the runs, s"],
                         [calibration_row(name, one) for name, one in found.items()])
    return f"""# How good the atlas is

Made by make_atlas.py; [theory/atlas.md](../theory/atlas.md). {checked["runs"]} runs.

## Fresh runs

{POINTS} points half-way between neighbours among its runs, each run once and held against what the 300 runs about it say. The fresh run's own scatter over the phase of its mesh, and that of the runs it is held against, are in the difference: the smooth depth is known better.

{regions}

## Calibrations that begin with it

With a store that knows none of their runs. The runs are those that the emulator asked for besides, and one of every fitted shot at the best point of every hypothesis.

{calibrations}

{MEASURED_ONCE}
{percal.machine()}.
"""


if __name__ == "__main__":
    write_page(command_line(__doc__, "atlas.md", store=Store.OF_PAGE), page)
