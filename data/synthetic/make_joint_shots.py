"""Writes joint_shots.csv: depths of balls in the gel of joint.toml, by percal's own solver, with noise.

    python3 data/synthetic/make_joint_shots.py PERCAL      writes the file beside this script; takes half a minute

Each depth is the mean of five runs on 10 elements per radius with the wall at 20 radii, times exp(4 % z) with z standard normal. The solver's bits depend on the
processor's instruction level, so that another machine writes depths that differ by the solver's own scatter (about 1 %).
"""
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
MU_KPA, ALPHA, EROSION_STRAIN, DENSITY = 120.0, 6.0, 1.1, 1010
ELEMENTS, REPLICATES, WALL, SCATTER, SEED = 10, 5, 20, 0.04, 20090334
BALLS = [("steel", 7800, 3.18, [45, 55, 65, 78, 90]), ("steel", 7800, 2.39, [80, 95, 110]),
         ("tungsten carbide", 15600, 1.59, [55, 70, 85])]
SCENE = """[particle]
radius = "{radius} mm"
density = "{density} kg/m3"
speed = "{speed} m/s"

[target]
density = "{gel} kg/m3"
mu = "{mu} kPa"
alpha = {alpha}
depth = "10 cm"
width = "{width} mm"

[target.erosion]
strain = {strain}
measure = "engineering"

[mesh]
elements_per_radius = {elements}
"""


def normal(uniform):
    """One standard normal number from two uniform ones (Box and Muller)."""
    radius = math.sqrt(-2 * math.log(1 - uniform()))
    return radius * math.cos(2 * math.pi * uniform())


def depth_cm_of(percal, folder, text, replicates):
    """Of a scene, the mean of its replicates."""
    scene = folder / "shot.toml"
    scene.write_text(text)
    run = subprocess.run([percal, "impact", str(scene), "--json", "--replicates", str(replicates), "--out", str(folder / "out")],
                         check=True, capture_output=True, text=True)
    return 100 * json.loads(run.stdout)["depth_m"]


def depth_cm(percal, folder, density, diameter, speed):
    return depth_cm_of(percal, folder, SCENE.format(radius=diameter / 2, density=density, speed=speed, gel=DENSITY, mu=MU_KPA, alpha=ALPHA,
                                                    width=WALL * diameter / 2, strain=EROSION_STRAIN, elements=ELEMENTS), REPLICATES)


def main(percal):
    uniform = random.Random(SEED).random
    lines = ["# SYNTHETIC: made by data/synthetic/make_joint_shots.py with percal's own solver, not measured.",
             f"# Gel: {DENSITY} kg/m3, mu = {MU_KPA:g} kPa (small-strain shear modulus), alpha = {ALPHA:g}, erosion strain {EROSION_STRAIN:g}"
             f" (engineering); seed {SEED}",
             f"# Depth: mean of {REPLICATES} runs on {ELEMENTS} elements per radius, the wall at {WALL} radii, times exp({SCATTER:g} z), z standard normal",
             "material,density_kg_m3,diameter_mm,velocity_m_s,penetration_cm"]
    with tempfile.TemporaryDirectory() as name:
        for material, density, diameter, speeds in BALLS:
            for speed in speeds:
                depth = depth_cm(percal, pathlib.Path(name), density, diameter, speed) * math.exp(SCATTER * normal(uniform))
                lines.append(f"{material},{density},{diameter},{speed},{depth:.3f}")
    (HERE / "joint_shots.csv").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main(sys.argv[1])
