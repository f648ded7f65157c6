"""Writes prism_shots.csv: depths of a steel rhombus in the gel of prism.toml, by percal's own solver in three dimensions, with noise.

    python3 data/synthetic/make_prism_shots.py PERCAL      writes the file beside this script; takes two minutes

Each depth is the mean of five runs with four cubes on half the thickness, times exp(3 % z) with z standard normal. The solver's bits depend on the processor's instruction level, so that another
machine writes depths that differ by the solver's own scatter (about 1 %).
"""
import math
import pathlib
import random
import sys
import tempfile

from make_joint_shots import HERE, depth_cm_of, normal

MU_KPA, ALPHA, EROSION_STRAIN, DENSITY = 500.0, 12.0, 0.35, 1010
CUBES, REPLICATES, SCATTER, SEED = 4, 5, 0.03, 20090336
HALF_WIDTH, HALF_THICKNESS = 3.0, 1.55  # mm
SPEEDS = [25, 32, 38, 44, 50, 56]
SCENE = """geometry = "block"

[particle]
shape = "rhombus"
side = "6.0 mm"
tip_angle = "60 deg"
mass = "0.7027 g"
thickness = "3.10 mm"
speed = "{speed} m/s"

[target]
density = "{gel} kg/m3"
mu = "{mu} kPa"
alpha = {alpha}
depth = "100 mm"
width = "37.5 mm"

[target.erosion]
strain = {strain}
measure = "engineering"

[mesh]
elements_per_radius = {elements:.6f}
fine_depth = 22
"""


def main(percal):
    uniform = random.Random(SEED).random
    lines = ["# SYNTHETIC: made by data/synthetic/make_prism_shots.py with percal's own solver, not measured.",
             f"# Gel: {DENSITY} kg/m3, mu = {MU_KPA:g} kPa (small-strain shear modulus), alpha = {ALPHA:g}, erosion strain {EROSION_STRAIN:g}"
             f" (engineering); seed {SEED}",
             f"# Depth: mean of {REPLICATES} runs on {CUBES} cubes on half the thickness, times exp({SCATTER:g} z), z standard normal",
             "velocity_m_s,penetration_mm"]
    with tempfile.TemporaryDirectory() as name:
        for speed in SPEEDS:
            scene = SCENE.format(speed=speed, gel=DENSITY, mu=MU_KPA, alpha=ALPHA, strain=EROSION_STRAIN, elements=CUBES * HALF_WIDTH / HALF_THICKNESS)
            depth = 10 * depth_cm_of(percal, pathlib.Path(name), scene, REPLICATES) * math.exp(SCATTER * normal(uniform))
            lines.append(f"{speed},{depth:.2f}")
    (HERE / "prism_shots.csv").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main(sys.argv[1])
