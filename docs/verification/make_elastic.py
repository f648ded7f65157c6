"""Writes docs/verification/elastic_particle.md from runs of the program (about a minute of processor time):

    python3 docs/verification/make_elastic.py build/release/percal
"""
import dataclasses
import math
import platform

from harness import command_line, in_percent, number, table, write_page

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

# Radius (m), density (kg/m3) and speed (m/s), and the words of the scene.
TARGETS = {
    "skin": dict(radius=1e-6, density=1000, speed=651.0, particle='radius = "1 um"', target='name = "skin"\ndensity = "1000 kg/m3"\nmu = "15 MPa"\nconvention = "mu/alpha"\nalpha = 8.5\n'
                 'bulk_to_shear = 50\ndepth = "75 um"\nwidth = "5 um"'),
    "gelatin": dict(radius=1.59e-3, density=1010, speed=83.0, particle='radius = "1.59 mm"', target='name = "gelatin"\ndensity = "1010 kg/m3"\nmu = "113 kPa"\nconvention = "mu/alpha"\n'
                    'alpha = 8.5\ndepth = "119.25 mm"\nwidth = "7.95 mm"'),
}


def scene(case, elasticity):
    target = TARGETS[case.scene]
    return f"""replicates = {REPLICATES}
[particle]
{target['particle']}
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


def difference(rigid, elastic):
    if rigid.depth is None or elastic.depth is None:
        return "-"
    share = elastic.depth / rigid.depth - 1
    return f"{in_percent(share, '+.1f')} ± {in_percent(math.hypot(rigid.error / rigid.depth, elastic.error / elastic.depth))}"


def row(case, rigid, elastic):
    target = TARGETS[case.scene]
    speed = case.speed or target["speed"]
    rule = (target["density"] * speed**2 + 10 * rigid.mu) / case.modulus
    cells = [f"{case.name} into {case.scene}", f"{speed:g}", f"{rule:.2g}", rigid.depth_words(1 / target["radius"])]
    if not elastic.steps:
        return [*cells, "not run", difference(rigid, elastic), "-", "-", f"{rigid.cpu():.2f}", "-"]
    return [*cells, elastic.depth_words(1 / target["radius"]), difference(rigid, elastic), number(elastic.energy["particle_elastic"], ".1e"), number(elastic.worst_closure, ".1e"),
            f"{rigid.cpu():.2f}", f"{elastic.cpu() / rigid.cpu():.1f}"]


HEAD = ["case", "speed, m/s", "rule", "rigid depth", "elastic depth", "difference, %", "stored in the particle at the end, of the impact energy", "worst energy closure", "CPU s, rigid",
        "CPU, elastic over rigid"]


def page(program):
    rows, reasons = [], set()
    for case in CASES:
        rigid, elastic = (program.impact(scene(case, elasticity)) for elasticity in ("rigid", "elastic"))
        rows.append(row(case, rigid, elastic))
        print(*rows[-1], sep=", ", flush=True)
        reasons |= {warning for warning in elastic.warnings if "stiff" in warning}
    quoted = "\n".join(f"> {reason}" for reason in sorted(reasons))
    not_run = f"\n\nWhat is not run says:\n\n{quoted}" if reasons else ""
    return f"""# Elastic against rigid particles

Written by `docs/verification/make_elastic.py`: the same scene with `elasticity = "rigid"` and `"elastic"`, {REPLICATES} replicates each, {ELEMENTS_PER_RADIUS} elements per radius, one thread, {program.level},
{platform.machine()}, on a machine that others use too. Skin: 15 MPa as given, alpha 8.5, K = 50 mu, a sphere of 1 um radius; gelatin: 113 kPa as given, K for a Mach number of 0.3, 1.59 mm; both 75 radii
deep, five wide, erosion strain 0.7. Densities and Young's moduli are those of data/guha2009/constants.csv (gold 79 GPa, titanium 100, PMMA 2.45, steel 210, tungsten
carbide 550); Poisson's ratios but steel's are handbook values (gold 0.42, titanium 0.34, PMMA 0.37, tungsten carbide 0.22). "PMMA, E/10" is made up, to see
deformation: as soft as the target (E is 1.3 times the target's 3 mu). The rule is (rho_t v^2 + 10 mu)/E: below 0.02 a particle is rigid where the scene leaves it open. Depths in radii, ± one standard error.

{table(HEAD, rows)}{not_run}

How it is computed: [../theory/elastic_particle.md](../theory/elastic_particle.md).
"""


if __name__ == "__main__":
    write_page(command_line(__doc__, "elastic_particle.md"), page)
