"""Writes layers_shots.csv: depths of balls in the gel of layers.toml, bare and under two thicknesses of skin, by percal's own solver, with noise.

    python3 data/synthetic/make_layers_shots.py PERCAL      writes the file beside this script; takes some minutes

Each depth is the mean of ten runs on 10 elements per radius, times exp(3 % z) with z standard normal. The solver's bits depend on the
processor's instruction level, so that another machine writes depths that differ by the solver's own scatter (about 1 %).
"""
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

from make_joint_shots import normal

HERE = pathlib.Path(__file__).resolve().parent
GEL = {"name": "gel", "density": 1030, "mu": 150, "alpha": 8.5, "strain": 0.7}
SKIN = {"name": "skin", "density": 1100, "mu": 1200, "alpha": 9, "strain": 0.45}
ELEMENTS, REPLICATES, SCATTER, SEED = 10, 10, 0.03, 20090335
BALL_DENSITY, DEPTH_MM, WIDTH_RADII = 7800, 120, 8
SPEEDS = {4.5: [25, 35, 50, 65], 6.35: [25, 35, 50]}
SKIN_MM = [0, 2, 4]
STOPPED_IN_SKIN = {(4, 25)}  # mm and m/s: no shots of these
NUMBERS = 'name = "{name}"\ndensity = "{density} kg/m3"\nmu = "{mu} kPa"\nalpha = {alpha}\ndepth = "{depth} mm"\n'


def scene(skin, diameter, speed):
    particle = f'[particle]\ndiameter = "{diameter} mm"\ndensity = "{BALL_DENSITY} kg/m3"\nspeed = "{speed} m/s"\nelasticity = "rigid"\n\n'
    first, depth = (SKIN, skin) if skin else (GEL, DEPTH_MM)
    text = particle + "[target]\n" + NUMBERS.format(depth=depth, **first) + f'width = "{WIDTH_RADII * diameter / 2} mm"\n\n[target.erosion]\nstrain = {first["strain"]}\n\n'
    if skin:
        text += "[[below]]\n" + NUMBERS.format(depth=DEPTH_MM - skin, **GEL) + f'\n[below.erosion]\nstrain = {GEL["strain"]}\n\n'
    return text + f"[mesh]\nelements_per_radius = {ELEMENTS}\n"


def depth_mm(percal, folder, skin, diameter, speed):
    file = folder / "shot.toml"
    file.write_text(scene(skin, diameter, speed))
    run = subprocess.run([percal, "impact", str(file), "--json", "--replicates", str(REPLICATES), "--out", str(folder / "out")],
                         check=True, capture_output=True, text=True)
    return 1000 * json.loads(run.stdout)["depth_m"]


def said(material):
    return f"{material['name']} {material['density']} kg/m3, mu = {material['mu']} kPa (small-strain shear modulus), alpha = {material['alpha']:g}, erosion strain {material['strain']:g} (engineering)"


def main(percal):
    uniform = random.Random(SEED).random
    lines = ["# SYNTHETIC: made by data/synthetic/make_layers_shots.py with percal's own solver, not measured.",
             f"# {said(GEL)}; {said(SKIN)}; seed {SEED}",
             f"# Depth: mean of {REPLICATES} runs on {ELEMENTS} elements per radius, times exp({SCATTER:g} z), z standard normal; from the skin's upper face",
             "skin_mm,diameter_mm,velocity_m_s,penetration_mm"]
    with tempfile.TemporaryDirectory() as name:
        for skin in SKIN_MM:
            for diameter, speeds in SPEEDS.items():
                for speed in speeds:
                    if (skin, speed) in STOPPED_IN_SKIN:
                        continue
                    depth = depth_mm(percal, pathlib.Path(name), skin, diameter, speed) * math.exp(SCATTER * normal(uniform))
                    lines.append(f"{skin},{diameter},{speed},{depth:.2f}")
    (HERE / "layers_shots.csv").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main(sys.argv[1])
