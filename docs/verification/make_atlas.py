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

With a store that knows none of their runs. The runs are those that the emulator asked for besides, and one of every fitted shot at the best point of every hypothesis, twice: before the thorough fit and after it.

{calibrations}

{percal.machine()}.
"""


if __name__ == "__main__":
    write_page(command_line(__doc__, "atlas.md", store=Store.OF_PAGE), page)
