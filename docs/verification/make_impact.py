"""Writes docs/verification/impact.md from runs of the program (some minutes of processor time):

    python3 docs/verification/make_impact.py build/release/percal
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

from machine import processor

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
GOLD = ROOT / "data" / "guha2009" / "gold.toml"


class Program:
    def __init__(self, path, folder):
        self.path, self.folder, self.runs = path, folder, 0

    def impact(self, text, *options, level=None):
        """The result of one scene, from a store of its own, so that every run is timed here."""
        self.runs += 1
        scene = pathlib.Path(self.folder) / f"scene{self.runs}.toml"
        scene.write_text(text)
        environment = dict(os.environ, **({"PERCAL_ISA": level} if level else {}))
        done = subprocess.run([self.path, "impact", scene, "--store", f"{self.folder}/{self.runs}.store", "--threads", "1", "--json", *options],
                              capture_output=True, text=True, env=environment)
        return json.loads(done.stdout) if done.returncode in (0, 3) else None


def speed(result):
    """Element-steps per processor second, of the first run: its element-steps are the ones reported."""
    return result["element_steps"] / result["runs"][0]["cpu_s"] / 1e6


def mesh_table(program, gold):
    lines = ["| elements per radius | elements | depth, um | spread | steps | energy, worst closure | springs dropped | viscosity | CPU s a run | million element-steps/s |",
             "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"]
    for n, replicates in ((5, 5), (7, 5), (10, 5), (14, 5), (21, 3), (30, 3)):
        r = program.impact(gold, "--elements-per-radius", str(n), "--replicates", str(replicates))
        cpu = sum(run["cpu_s"] for run in r["runs"]) / replicates
        lines.append(f"| {n} | {r['elements']} | {r['depth_m'] * 1e6:.2f} | {r['depth_spread_m'] * 1e6:.2f} | {r['steps']} | {r['energy_worst_closure']:.2e} | "
                     f"{r['energy']['contact_dropped']:.3f} | {r['energy']['viscosity']:.3f} | {cpu:.2f} | {speed(r):.0f} |")
    return "\n".join(lines)


def level_table(program, gold):
    lines = ["| level | arithmetic | depth, um | spread | million element-steps/s |", "| --- | --- | --- | --- | --- |"]
    for level in ("x86_64_v4", "x86_64_v3", "x86_64_v2"):
        for arithmetic in ("single", "double"):
            r = program.impact(gold, "--elements-per-radius", "10", "--replicates", "5", "--arithmetic", arithmetic, level=level)
            if r:
                lines.append(f"| {level} | {arithmetic} | {r['depth_m'] * 1e6:.2f} | {r['depth_spread_m'] * 1e6:.2f} | {speed(r):.0f} |")
    return "\n".join(lines)


def step_table(program, gold):
    head, tail = gold.split("[target.erosion]")
    uneroded = head.replace("alpha = 8.5", "alpha = 3") + "[mesh]" + tail.split("[mesh]")[1]
    lines = ["| time-step factor | no erosion, double: closure | erosion, single: closure | erosion: depth, um |", "| --- | --- | --- | --- |"]
    for factor in (0.8, 0.4, 0.2, 0.1):
        solver = f"\n[solver]\ntime_step_factor = {factor}\n"
        quiet = program.impact(uneroded + solver + 'arithmetic = "double"\nend_time = "3.0722e-09 s"\n', "--elements-per-radius", "10", "--replicates", "1")
        eroding = program.impact(gold + solver, "--elements-per-radius", "10", "--replicates", "3")
        lines.append(f"| {factor} | {quiet['energy_worst_closure']:.2e} | {eroding['energy_worst_closure']:.2e} | {eroding['depth_m'] * 1e6:.2f} |")
    return "\n".join(lines)


def domain_table(program, gold):
    lines = ["| change | depth, um | spread |", "| --- | --- | --- |"]
    changes = (("as it is", []), ("bottom fixed", [('bottom = "free"', 'bottom = "fixed"')]), ("width 10 a", [('width = "5 um"', 'width = "10 um"')]),
               ("depth 45 a", [('depth = "75 um"', 'depth = "45 um"')]), ("K/mu 100", [("bulk_to_shear = 50", "bulk_to_shear = 100")]),
               ("K/mu 200", [("bulk_to_shear = 50", "bulk_to_shear = 200")]))
    for name, replacements in changes:
        text = gold
        for old, new in replacements:
            assert old in text, old
            text = text.replace(old, new)
        r = program.impact(text, "--elements-per-radius", "10", "--replicates", "5")
        lines.append(f"| {name} | {r['depth_m'] * 1e6:.2f} | {r['depth_spread_m'] * 1e6:.2f} |")
    return "\n".join(lines)


def main(path):
    gold = GOLD.read_text()
    with tempfile.TemporaryDirectory() as folder:
        program = Program(path, folder)
        page = f"""# The impact solver: mesh, noise, energy, cost

Written by `docs/verification/make_impact.py` from runs of `data/guha2009/gold.toml` (setting S, contact stiffness 0.6; gold into skin, 15 MPa as given, alpha 8.5, erosion
strain 0.7) on one core of a {processor()}. Replicates are at the speed times 1, 1.001, 0.999, 1.002, 0.998. Times are processor seconds on a machine
that others use too: compare them with each other.

## Mesh

{mesh_table(program, gold)}

A single run scatters by one to two per cent: erosion amplifies any difference. Depths are means of the replicates, and a difference between two meshes that is smaller than the spread
means nothing.

## Instruction level and arithmetic

10 elements per radius, five replicates.

{level_table(program, gold)}

## Energy and the time step

Left: no erosion, alpha 3, up to the time of two radii at impact speed: the closure falls as the square of the step. Right: with erosion, 10 elements per
radius, three replicates.

{step_table(program, gold)}

## The domain and K

10 elements per radius, five replicates.

{domain_table(program, gold)}
"""
    (HERE / "impact.md").write_text(page)


if __name__ == "__main__":
    main(sys.argv[1])
