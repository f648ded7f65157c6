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


BB = ["--diameter", "4.5mm", "--particle-density", "7800 kg/m3", "--speed", "180m/s", "--density", "1060 kg/m3", "--alpha", "8.5", "--layer-depth", "150mm"]
GOLD = ["--diameter", "2um", "--particle-density", "16800 kg/m3", "--speed", "651m/s", "--density", "1000 kg/m3", "--alpha", "8.5", "--layer-depth", "75um"]
# Name, options, width of the layer as the shot asks for it.
DEPTHS = [("BB at 85 mm, modulus", ["--depth", "85mm", "--depth-error", "5mm", "--erosion-strain", "0.9", *BB], 27, "mm"),
          ("BB at 49.7 mm, modulus", ["--depth", "49.7mm", "--depth-error", "0.75mm", "--erosion-strain", "0.9", *BB], 27, "mm"),
          ("BB at 49.7 mm, erosion strain", ["--depth", "49.7mm", "--depth-error", "0.75mm", "--mu", "300kPa", *BB], 27, "mm"),
          ("gold at 26 um, modulus", ["--depth", "26um", "--depth-error", "0.9um", "--erosion-strain", "0.7", *GOLD], 5, "um")]
UNFELT = 0.999  # of the width: so much nearer a wall changes no depth, and there is no atlas


def searched(percal, options, width, unit):
    """Runs, seconds of processor time, and the answer with its interval."""
    found = percal.ask("invert", *options, "--layer-width", f"{width:.6g}{unit}", *percal.kept(), accepted=(0, 3))
    number_of = "mu_Pa" if found["looked_for"] == "mu" else "erosion_strain"
    interval = found["ridge"][2]["mu_interval_Pa" if number_of == "mu_Pa" else "erosion_strain_interval"]
    size, digits, words = (1e6, ".3f", " MPa") if number_of == "mu_Pa" else (1, ".3f", "")
    value, low, high = (number(one / size, digits) for one in (found["pair"][number_of], interval["low"], interval["high"]))
    return [found["cost"]["runs"], number(found["cost"]["cpu_s"], ".1f"), f"{value}{words} ({low} to {high})"]


def page(percal):
    checked = percal.ask("atlas", "check", "--points", POINTS, *percal.kept(), accepted=(0, 1, 3))["atlases"][0]
    found = {name: percal.ask("calibrate", job, *percal.kept(), "--out", "none", accepted=(0, 1, 3)) for name, job in JOBS.items()}
    regions = table(["reach", "fresh runs", "half are within", "r.m.s.", "r.m.s. over the stated", "within the stated 95 %"], region_rows(checked["regions"]))
    calibrations = table(["job", "runs of the atlas", "runs", "emulator's error", "data's error", "processor time of the runs, s"],
                         [calibration_row(name, one) for name, one in found.items()])
    depths = table(["depth", "runs without", "s", "95 %", "runs with the atlas", "s", "95 %"],
                   [[name, *searched(percal, options, UNFELT * width, unit), *searched(percal, options, width, unit)] for name, options, width, unit in DEPTHS])
    return f"""# How good the atlas is

Made by make_atlas.py; [theory/atlas.md](../theory/atlas.md). {checked["runs"]} runs.

## Fresh runs

{POINTS} points half-way between neighbours among its runs, each run once and held against what the 300 runs about it say. The fresh run's own scatter over the phase of its mesh, and that of the runs it is held against, are in the difference: the smooth depth is known better.

{regions}

## Calibrations that begin with it

With a store that knows none of their runs. The runs are those that the emulator asked for besides, and one of every fitted shot at the best point of every hypothesis, twice: before the thorough fit and after it.

{calibrations}

## Searches that begin with it

`percal invert` with the wall where the shot asks for it, and a thousandth nearer, where there is no atlas and next to the same depths. Five searches each; processor time of their runs.

{depths}

{percal.machine()}.
"""


if __name__ == "__main__":
    write_page(command_line(__doc__, "atlas.md", store=Store.OF_PAGE), page)
