"""Writes docs/verification/layers.md from the result of data/synthetic/layers.toml.

    percal calibrate data/synthetic/layers.toml
    python3 docs/verification/make_layers.py layers.out/result.json
"""
import argparse
import json
import pathlib

from harness import PAGES, number, percent, processor, table
from make_calibration import fresh_deviation, interval, mean_deviation, pressure, round_rows

TRUTH = {"mu_gel": 150e3, "strain_gel": 0.7, "mu_skin": 1200e3, "strain_skin": 0.45}  # data/synthetic/make_layers_shots.py


def parameter_rows(hypothesis):
    for p in hypothesis["parameters"]:
        in_pascal = "value_Pa" in p
        show, value, ends = (pressure, p["value_Pa"], p["interval_Pa"]) if in_pascal else (number, p["value"], p["interval"])
        truth = TRUTH[p["name"]]
        holds = (ends["low"] is None or ends["low"] <= truth) and (ends["high"] is None or truth <= ends["high"])
        yield [hypothesis["name"], p["name"], show(truth), show(value), interval(p, show), "yes" if holds else "no", "yes" if p["identifiable"] else "no"]


def shot_rows(result):
    for k, shot in enumerate(result["data"]["shots"]):
        found = result["hypotheses"][0]["shots"][k]
        yield [shot["target"], f"{2e3 * shot['radius_m']:g}", f"{shot['speed_m_s']:g}", f"{1e3 * shot['measured_m']:.1f}", percent(found["deviation"], "+.1f")]


def page(result):
    emulator = result["emulator"]
    return f"""# Two layers from depths alone

Written by docs/verification/make_layers.py from the result of data/synthetic/layers.toml. Covers: docs/theory/emulator.md, Covers.

Steel balls of 4.5 and 6.35 mm at 25 to 65 m/s, {len(result["data"]["shots"])} of them, into a gel, bare and under 2 and 4 mm of skin. Depths are percal's own, ten runs each on the job's mesh, with 3 % scatter; the numbers below are to be found again. Both alpha are held at the truth.

{table(["hypothesis", "parameter", "truth", "found", "95 %", "holds the truth", "can be known"], [row for hypothesis in result["hypotheses"] for row in parameter_rows(hypothesis)])}

- Of a cover depths tell what it costs to pass: mu and the erosion strain together. Free, they make up for one another; with the strain known, the modulus follows.
- Of the gel the same is true, as of every gel shot bare (calibration.md): a ridge of mu and strain. The bare shots tell it, the covered ones hardly add.
- Shots that only just pass tell a cover best: at 65 m/s the thick skin takes 6 % off the depth, at 35 m/s a quarter. A shot that sticks in it tells nothing of the gel, and its depth scatters by more than a tenth.
- Thickness is given, not fitted.
- After {emulator["runs"]} runs the emulator's own error at the best points, {percent(emulator["error_at_optimum"])}, stands beside the data's {percent(emulator["data_error"])} and widens every interval: where a sphere just passes a cover its depth is steep in everything.

{table(["target", "diameter, mm", "speed, m/s", "depth, mm", "off by, %"], shot_rows(result))}

Depths are off by {percent(mean_deviation(result["hypotheses"][0]["shots"]))} in the mean by the emulator, {percent(result["hypotheses"][0]["fresh_mean_deviation"])} by fresh runs at the best point.

## Cost

{emulator["rounds"][-1]["runs"]} runs, each left out off by {percent(emulator["leave_one_out_error"])}, the emulator at the best point by {percent(emulator["error_at_optimum"])}; {result["cost"]["cpu_s"]:.0f} CPU s (reused runs not counted), on {processor()}, {result["cost"]["isa"]}, beside other work.
"""


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("result")
    result = json.loads(pathlib.Path(parser.parse_args().result).read_text())
    (PAGES / "layers.md").write_text(page(result))
