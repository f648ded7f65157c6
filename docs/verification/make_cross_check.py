"""Writes docs/verification/cross_check.md from runs of percal and from typed-in figures of others (some eight minutes of processor time):

    python3 docs/verification/make_cross_check.py build/release/percal

Option: --page FILE to write elsewhere. cross_check_figures.py holds what the other codes printed; none of them is needed.
"""
import math
import statistics
from dataclasses import dataclass

from cross_check_figures import GELATIN_LS_DYNA, GELATIN_OTHER, GOLD_OTHER, OPENRADIOSS, OTHER, RIDGE_OTHER, WITH_SPRINGS, Figures
from cross_check_text import PAGE, RIDGE
from harness import THESIS, Store, command_line, in_percent, mean_size, mesh, plus_minus, replicates, rows_of, table, write_page

GOLD = 16.8  # density of gold over that of the target


@dataclass(frozen=True)
class Case:
    """One problem without dimensions: lengths in radii, speeds in the impact speed, densities in the target's."""
    title: str
    pi4: float
    alpha: float = 8.5
    erosion: float = 0.7  # engineering strain
    density: float = GOLD
    bulk: float = 50
    depth: float = 45
    width: float = 5
    length: float = 0  # of erosion; 0: local rule
    eroded_nodes: str = "released"

    def scene(self, solver=""):
        return f"""[particle]
radius = "1 m"
density = "{self.density} kg/m3"
speed = "1 m/s"
[target]
density = "1 kg/m3"
mu = "{1 / self.pi4:.12g} Pa"
alpha = {self.alpha}
bulk_to_shear = {self.bulk}
depth = "{self.depth} m"
width = "{self.width} m"
[target.erosion]
strain = {self.erosion}
{f"length_in_radii = {self.length}" if self.length else ""}
[mesh]
elements_per_radius = 10
[solver]
eroded_nodes = "{self.eroded_nodes}"
{solver}"""


CASES = {
    "S": Case("gold at 651 m/s (S)", 6.6474),
    "slow": Case("gold at 422 m/s", 2.79347),
    "M": Case("gold, 55 MPa, 0.3 (M)", 1.813, erosion=0.3, width=8),
    "P": Case("light sphere (P)", 13.52, alpha=11, erosion=0.35, density=1.139, bulk=150, depth=15, width=8),
    "gelatin": Case("steel at 83 m/s into gelatin of 1010 kg/m3", 14.4883, density=7.72277),
    "U": Case("steel BB, alpha 3.95, 2.98 (U)", 118.4, alpha=3.95, erosion=2.98, density=7.573, bulk=400, depth=70, width=12),
    "F": Case("steel BB, alpha 13.8, 0.626 (F)", 601, alpha=13.8, erosion=0.626, density=7.573, bulk=800, depth=110, width=12),
    "alpha_16": Case("alpha 16", 28.253, alpha=16),
    "alpha_25": Case("alpha 25, erosion strain 1", 28.253, alpha=25, erosion=1.0),
    "alpha_-6": Case("alpha -6", 6.6474, alpha=-6),
    "S_l": Case("S, erosion over 0.4 radii", 6.6474, length=0.4),
    "P_l": Case("P, erosion over 0.4 radii", 13.52, alpha=11, erosion=0.35, density=1.139, bulk=150, depth=15, width=8, length=0.4),
}


FIVE, TEN = replicates(5), replicates(10)
SAME = "time_step_factor = 0.8\nrates = 1\n"  # the other code's settings


def figures(program, text, *options):
    result = program.impact(text, *(options or TEN))
    assert result.outcome == "stopped", text
    depths = [run.depth for run in result.runs]
    return Figures(statistics.mean(depths), statistics.stdev(depths), len(depths), result.cpu())


def shown(f, digits=2):
    return plus_minus(f.mean, f.error(), digits)


def difference(a, b):
    """a - b in per cent of b, with its standard error."""
    share = a.mean / b.mean
    return f"{100 * (share - 1):+.1f} ± {100 * share * math.hypot(a.error() / a.mean, b.error() / b.mean):.1f}"


def between_codes(program):
    rows = []
    for name, case in CASES.items():
        ours, (soft, stiff) = figures(program, case.scene(SAME), *FIVE), OTHER[name]
        rows.append([case.title, shown(soft), shown(stiff), shown(ours), difference(ours, stiff), difference(ours, soft)])
    return table(["case", "the other code, kappa 0.6", "kappa 40", "percal, impulses", "from kappa 40, %", "from kappa 0.6, %"], rows)


def old_contact():
    return table(["case", "the other code, kappa 0.6", "percal with such springs", "difference, %"],
                 [[CASES[name].title, shown(OTHER[name][0]), f"{ours:.4g}", f"{100 * (ours / OTHER[name][0].mean - 1):+.1f}"] for name, ours in WITH_SPRINGS.items()])


def physical(radius, speed, density, target, mu, strain, bulk=""):
    return f"""[particle]
radius = "{radius} m"
density = "{density} kg/m3"
speed = "{speed} m/s"
[target]
density = "{target} kg/m3"
mu = "{mu} Pa"
convention = "mu/alpha"
alpha = 8.5
{bulk}
depth = "{75 * radius:.10g} m"
width = "{5 * radius:.10g} m"
[target.erosion]
strain = {strain}
"""


def scaled(f, factor):
    return Figures(f.mean * factor, f.deviation * factor, f.runs, f.cpu)


def ridge(program):
    rows, fine = [], []
    for row, other in zip(rows_of(THESIS / "ridge.csv"), RIDGE_OTHER, strict=True):
        text = physical(1e-6, 651, 16800, 1000, float(row["mu_skin_MPa"]) * 1e6, row["erosion_strain"], "bulk_to_shear = 50")
        ours = [scaled(figures(program, text, *mesh(n), *TEN), 1e6) for n in (10, 14)]
        fine.append(ours[1].mean)
        rows.append([row["mu_skin_MPa"], row["erosion_strain"], 26, str(other), *map(shown, ours)])
    head = ["mu as given, MPa", "erosion strain", "LS-DYNA (thesis), um", "the other code, one run, contact 0.156", "percal, 10 elements per radius", "14"]
    return RIDGE.format(table=table(head, rows), least=min(fine), most=max(fine), above=in_percent(statistics.mean(fine) / 26 - 1, ".0f"))


def gold(program):
    rows, deviations = [], []
    for row, other in zip(rows_of(THESIS / "gold_skin.csv"), GOLD_OTHER, strict=True):
        text = physical(float(row["radius_um"]) * 1e-6, row["velocity_m_s"], 16800, 1000, 15e6, 0.7, "bulk_to_shear = 50")
        f = scaled(figures(program, text, *mesh(14), *TEN), 1e6)
        dyna, measured = float(row["fe_um"]), float(row["penetration_um"])
        deviations.append((f.mean / dyna - 1, f.mean / measured - 1, dyna / measured - 1))
        rows.append([row["radius_um"], row["velocity_m_s"], str(measured), str(dyna), f"{other:.2f}", shown(f), *(in_percent(share, "+.1f") for share in deviations[-1][:2])])
    head = ["radius, um", "speed, m/s", "measured, um", "LS-DYNA (thesis)", "the other code, one run, contact 0.156", "percal, 14 elements per radius", "from LS-DYNA, %", "from measured, %"]
    from_dyna, from_measured, dyna_from_measured = map(mean_size, zip(*deviations))
    return table(head, rows) + f"""

Mean of the sizes of these: {from_dyna} from LS-DYNA, {from_measured} from the measurements; LS-DYNA is {dyna_from_measured} from the measurements."""


def gelatin(program):
    rows = []
    for k, row in enumerate(rows_of(THESIS / "gelatin_shots.csv", material="steel", diameter_corrected_mm="3.18")):
        light, heavy = (shown(scaled(figures(program, physical(1.59e-3, row["velocity_m_s"], 7800, target, 113e3, 0.7), *mesh(10), *TEN), 100)) for target in (464, 1010))
        rows.append([row["velocity_m_s"], row["penetration_cm"], str(GELATIN_LS_DYNA.get(int(row["velocity_m_s"]), "-")), str(GELATIN_OTHER[464][k]), light, str(GELATIN_OTHER[1010][k]), heavy])
    return table(["speed, m/s", "measured, cm", "LS-DYNA (thesis)", "the other code, 464 kg/m3", "percal, 464 kg/m3", "the other code, 1010 kg/m3", "percal, 1010 kg/m3"], rows)


def openradioss(program):
    rows, setting_s = [], None
    for title, pi4, strain, nodes, *lines in OPENRADIOSS:
        case = Case(title, pi4, erosion=strain, eroded_nodes=nodes)
        ours = {n: figures(program, case.scene(), *mesh(n), *TEN) for n in (7, 10)}
        setting_s = setting_s or ours
        for n, radioss, other in lines:
            rows.append([title, n or "not given", radioss, other, *(shown(ours[m]) if n in (m, None) else "" for m in (7, 10))])
    return table(["case", "elements per radius", "OpenRadioss, one run", "the other code, one run", "percal, 7 elements per radius", "10"], rows), setting_s


def page(program):
    radioss_rows, setting_s = openradioss(program)
    return PAGE.format(machine=program.machine(), codes=between_codes(program), old=old_contact(), ridge=ridge(program), gold=gold(program), gelatin=gelatin(program),
                       radioss=radioss_rows, seven=setting_s[7].cpu, ten=setting_s[10].cpu, cpu=program.cpu)


if __name__ == "__main__":
    write_page(command_line(__doc__, "cross_check.md", store=Store.OF_PAGE), page)
