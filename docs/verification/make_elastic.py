"""Writes docs/verification/elastic_particle.md from runs of the program (about a minute of processor time):

    python3 docs/verification/make_elastic.py build/release/percal
"""
import dataclasses
import json
import math
import pathlib
import platform
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
REPLICATES = 7
ELEMENTS_PER_RADIUS = 7


@dataclasses.dataclass
class Case:
    name: str
    scene: str  # of `scenes`
    density: float  # kg/m3
    modulus: float  # Pa
    poisson: float
    speed: float | None = None  # m/s; None: the scene's


# Densities and moduli: data/guha2009/constants.csv. Poisson's ratios of all but steel: handbook values (gold 0.42, titanium 0.34, PMMA 0.37,
# tungsten carbide 0.22), not stated there.
CASES = [
    Case("gold", "skin", 16800, 79e9, 0.42),
    Case("titanium", "skin", 4540, 100e9, 0.34),
    Case("PMMA", "skin", 1150, 2.45e9, 0.37),
    Case("PMMA, E/10", "skin", 1150, 0.245e9, 0.37),
    Case("steel", "gelatin", 7800, 210e9, 0.3, 83),
    Case("titanium", "gelatin", 4540, 100e9, 0.34, 85),
    Case("PMMA", "gelatin", 1150, 2.45e9, 0.37, 83),
    Case("tungsten carbide", "gelatin", 15600, 550e9, 0.22, 66),
    Case("steel, 20 m/s", "gelatin", 7800, 210e9, 0.3, 20),
    Case("steel, 2 m/s", "gelatin", 7800, 210e9, 0.3, 2),
]

TARGETS = {
    "skin": dict(radius="1 um", speed=651.0, target='name = "skin"\ndensity = "1000 kg/m3"\nmu = "15 MPa"\nconvention = "mu/alpha"\nalpha = 8.5\nbulk_to_shear = 50\n'
                 'depth = "75 um"\nwidth = "5 um"'),
    "gelatin": dict(radius="1.59 mm", speed=83.0, target='name = "gelatin"\ndensity = "1010 kg/m3"\nmu = "113 kPa"\nconvention = "mu/alpha"\nalpha = 8.5\n'
                    'depth = "119.25 mm"\nwidth = "7.95 mm"'),
}


def scene(case, elasticity):
    target = TARGETS[case.scene]
    return f"""replicates = {REPLICATES}
[particle]
radius = "{target['radius']}"
density = "{case.density} kg/m3"
speed = "{case.speed or target['speed']} m/s"
youngs_modulus = "{case.modulus} Pa"
poisson_ratio = {case.poisson}
elasticity = "{elasticity}"
[target]
{target['target']}
[target.erosion]
strain = 0.7
[mesh]
elements_per_radius = {ELEMENTS_PER_RADIUS}
"""


def run(program, folder, case, elasticity):
    name = f"{case.name} {case.scene} {elasticity}".replace(" ", "_").replace("/", "_")
    file = pathlib.Path(folder) / f"{name}.toml"
    file.write_text(scene(case, elasticity))
    done = subprocess.run([program, "impact", file, "--store", f"{folder}/{name}.store", "--threads", "1", "--json"], capture_output=True, text=True)
    if done.returncode not in (0, 3):
        sys.exit(done.stderr)
    return json.loads(done.stdout)


def depth(result, radius):
    if result["depth_m"] is None:
        return result["outcome"]
    return f"{result['depth_m'] / radius:.2f} ± {result['depth_standard_error_m'] / radius:.2f}"


def difference(rigid, elastic):
    if rigid["depth_m"] is None or elastic["depth_m"] is None:
        return "-"
    share = elastic["depth_m"] / rigid["depth_m"] - 1
    error = math.hypot(rigid["depth_standard_error_m"] / rigid["depth_m"], elastic["depth_standard_error_m"] / elastic["depth_m"])
    return f"{100 * share:+.1f} ± {100 * error:.1f}"


def cpu(result):
    return sum(r["cpu_s"] for r in result["runs"]) / len(result["runs"])


def short(share, runs):
    return f"{share:.1e}" if runs and share is not None else "-"


def line(program, folder, case):
    rigid, elastic = run(program, folder, case, "rigid"), run(program, folder, case, "elastic")
    radius = {"skin": 1e-6, "gelatin": 1.59e-3}[case.scene]
    speed = case.speed or TARGETS[case.scene]["speed"]
    density = {"skin": 1000, "gelatin": 1010}[case.scene]
    figure = (density * speed**2 + 10 * rigid["mu_true_Pa"]) / case.modulus
    runs = elastic["steps"] > 0
    return "| " + " | ".join([
        f"{case.name} into {case.scene}", f"{speed:g}", f"{figure:.2g}", depth(rigid, radius), depth(elastic, radius) if runs else "not run", difference(rigid, elastic),
        short(elastic["energy"]["particle_elastic"], runs), short(elastic["energy_worst_closure"], runs), f"{cpu(rigid):.2f}",
        f"{cpu(elastic) / cpu(rigid):.1f}" if runs else "-"]) + " |", elastic


def main(program):
    lines, isa, reasons = [], "", set()
    with tempfile.TemporaryDirectory() as folder:
        for case in CASES:
            text, elastic = line(program, folder, case)
            print(text, flush=True)
            lines.append(text)
            isa = elastic["isa"]
            reasons |= {warning for warning in elastic["warnings"] if "stiff" in warning}
    quoted = "\n".join(f"> {reason}" for reason in sorted(reasons))
    not_run = f"\n\nWhat is not run says:\n\n{quoted}" if reasons else ""
    (HERE / "elastic_particle.md").write_text(f"""# Elastic against rigid particles

Written by `docs/verification/make_elastic.py`: the same scene with `elasticity = "rigid"` and `"elastic"`, {REPLICATES} replicates each, {ELEMENTS_PER_RADIUS} elements per radius, one thread, {isa},
{platform.machine()}, on a machine that others use too. Skin: 15 MPa as given, alpha 8.5, K = 50 mu, a sphere of 1 um radius; gelatin: 113 kPa as given, K for a Mach number of 0.3, 1.59 mm; both 75 radii
deep, five wide, erosion strain 0.7. Densities and Young's moduli are those of data/guha2009/constants.csv (gold 79 GPa, titanium 100, PMMA 2.45, steel 210, tungsten
carbide 550); Poisson's ratios but steel's are handbook values (gold 0.42, titanium 0.34, PMMA 0.37, tungsten carbide 0.22). "PMMA, E/10" is made up, to see
deformation. The rule is (rho_t v^2 + 10 mu)/E: below 0.02 a particle is rigid where the scene leaves it open. Depths in radii, ± one standard error.

| case | speed, m/s | rule | rigid depth | elastic depth | difference, % | stored in the particle at the end, of the impact energy | worst energy closure | CPU s, rigid | CPU, elastic over rigid |
| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |
{chr(10).join(lines)}{not_run}

How it is computed: [../theory/elastic_particle.md](../theory/elastic_particle.md).
""")


if __name__ == "__main__":
    main(sys.argv[1])
