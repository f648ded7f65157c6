"""Writes docs/verification/cross_check.md from runs of percal and from typed-in figures of others (some six minutes of processor time):

    python3 docs/verification/make_cross_check.py build/release/percal

Option: --page FILE to write elsewhere. cross_check_figures.py holds what the other codes printed; none of them is needed.
"""
import math
import statistics
from dataclasses import dataclass

from cross_check_figures import AHEAD, BOTH, GELATIN_LS_DYNA, GELATIN_OTHER, GOLD_OTHER, NEGATIVE_ALPHA, OPENRADIOSS, OTHER, RHOMBUS_TIP, RIDGE_OTHER, S, Figures
from cross_check_text import PAGE, RIDGE
from harness import THESIS, Store, command_line, in_percent, mean_size, mesh, plus_minus, replicates, rows_of, table, write_page

KAPPA = 0.6  # of the other code's contact springs; percal has none
GOLD = 16.8  # density of gold over that of the target


@dataclass(frozen=True)
class Case:
    """One problem without dimensions: lengths in radii, speeds in the impact speed, densities in the target's."""
    name: str
    title: str
    pi4: float
    alpha: float = 8.5
    erosion: float = 0.7          # engineering strain; 0: none
    mesh: int = 10
    density: float = GOLD
    depth: float = 45
    width: float = 5
    eroded_nodes: str = "released"
    is_rhombus: bool = False

    def scene(self, solver):
        shape = 'shape = "rhombus"\nside = "2 m"\ntip_angle = "60 deg"' if self.is_rhombus else 'radius = "1 m"'
        erosion = f"[target.erosion]\nstrain = {self.erosion}\n" if self.erosion else ""
        return f"""geometry = "{'plane strain' if self.is_rhombus else 'axisymmetric'}"
[particle]
{shape}
density = "{self.density} kg/m3"
speed = "1 m/s"
[target]
density = "1 kg/m3"
mu = "{1 / self.pi4:.12g} Pa"
alpha = {self.alpha}
bulk_to_shear = 50
depth = "{self.depth} m"
width = "{self.width} m"
{erosion}[mesh]
elements_per_radius = {self.mesh}
[solver]
eroded_nodes = "{self.eroded_nodes}"
{solver}"""

    def other_arguments(self, cfl=0.8):
        """Of the independent code. Its contact stiffness counts in steps that have the CFL number in them."""
        words = [f"pi4={self.pi4}", f"alpha={self.alpha}", f"eps={self.erosion or 1e9:g}", f"nf={self.mesh}", "contact=1", f"kpen={KAPPA * cfl ** 2:g}", f"L={self.depth}", f"W={self.width}", "Kmu=50"]
        if self.is_rhombus:  # its M is the mass of half the prism, whose half area is sqrt(3)
            words += ["plane=1", "shape=1", "tip=60", f"M={self.density * math.sqrt(3):.6g}"]
        elif self.density != GOLD:
            words.append(f"rr={self.density}")
        return words + (["freec=1"] if self.eroded_nodes != "released" else []) + ([f"cfl={cfl}"] if cfl != 0.8 else [])


CASES = (
    Case("s10", "setting S", S),
    Case("s14", "setting S, 14 elements per radius", S, mesh=14),
    Case("in_contact", "setting S, eroded nodes kept in contact", S, eroded_nodes="in contact"),
    Case("stiff_end", "ridge, 55 MPa, 0.3", 1.81303, erosion=0.3),
    Case("soft_end", "ridge, 10 MPa, 0.8", 9.9717, erosion=0.8),
    Case("fast", "gold at 775 m/s", 9.42157),
    Case("slow", "gold at 422 m/s", 2.79347),
    Case("gelatin", "gelatin of 1010 kg/m3, 3.18 mm steel at 83 m/s", 14.4883, density=7.72277),
    Case("alpha_16", "alpha 16, erosion strain 0.7", 28.253, alpha=16),
    Case("alpha_25", "alpha 25, erosion strain 1", 28.253, alpha=25, erosion=1.0),
    Case("alpha_-6", "alpha -6, erosion strain 0.7", S, alpha=-6),
    Case("rhombus", "60 degree rhombus in plane strain, erosion strain 0.57", 1.5458, erosion=0.57, density=15.669, depth=39.75, width=2.65, is_rhombus=True),
    Case("dent", "dent, alpha 3, no erosion", 0.2, alpha=3, erosion=0),
)


TEN, THIRTY = replicates(10), replicates(30)
SAME = 'time_step_factor = {}\nrates = 1\narithmetic = "double"\nquadratic_viscosity = 1.2\n'  # the other code's settings


def figures(program, text, *options):
    result = program.impact(text, *(options or TEN))
    assert result.outcome == "stopped", text
    depths = [run.depth for run in result.runs]
    return Figures(statistics.mean(depths), statistics.stdev(depths), result.cpu(), round(statistics.mean(run.steps for run in result.runs)), len(depths))


def shown(f, digits=2):
    return plus_minus(f.mean, f.error(), digits)


def errors_between(a, b):
    return (a.mean - b.mean) / math.hypot(a.error(), b.error())


def difference(a, b):
    """a - b in per cent of b and in standard errors."""
    return f"{in_percent(a.mean / b.mean - 1, '+.1f')} %, {errors_between(a, b):+.1f}"


def between_codes(program):
    head = ["case", "the other code", "sd", "percal, same settings", "sd", "difference, standard errors", "percal, its defaults", "difference, standard errors",
            "CPU s: other, same, defaults"]
    rows, apart, apart_by_default = [], [], []
    for case in CASES:
        same = figures(program, case.scene(SAME.format(0.8)))
        default = figures(program, case.scene(""))
        other = OTHER[case.name, 0.8]
        for kept, ours in ((apart, same), (apart_by_default, default)):
            kept.append((case.title, ours.mean / other.mean - 1, errors_between(ours, other)))
        rows.append([case.title, shown(other), f"{other.deviation:.2f}", shown(same), f"{same.deviation:.2f}", difference(same, other), shown(default), difference(default, other),
                     f"{other.cpu:.2f}, {same.cpu:.2f}, {default.cpu:.2f}"])
    return table(head, rows), summary(apart), summary(apart_by_default)


def summary(apart):
    far = [f"{title} ({errors:+.1f})" for title, _, errors in apart if abs(errors) > 2]
    return (f"{statistics.median(share for _, share, _ in apart) * 100:.1f} % deeper (median of the cases, of which {sum(share > 0 for _, share, _ in apart)} of {len(apart)} are deeper); {len(far)} "
            f"differ by more than two standard errors: {', '.join(far) or 'none'}.")


def halved_steps(program):
    rows = []
    for case in CASES:
        if (case.name, 0.4) in OTHER:
            ours = [figures(program, case.scene(SAME.format(f))) for f in (0.8, 0.4)]
            theirs = [OTHER[case.name, f] for f in (0.8, 0.4)]
            rows.append([case.title, *(shown(f, 4) for f in theirs + ours), difference(ours[1], theirs[1])])
    return table(["case", "the other code, CFL 0.8", "0.4", "percal, factor 0.8", "0.4", "difference at 0.4, standard errors"], rows)


def judged_ahead(program):
    """The table, the mean differences of percal and of the other code from small steps, and how many times shorter its steps are."""
    rows, excess, shortfall, shorter = [], [], [], []
    for case in CASES:
        if case.name in AHEAD:
            other, ahead = OTHER[case.name, 0.8], AHEAD[case.name]
            ours = figures(program, case.scene(SAME.format(0.8)))
            fine = figures(program, case.scene("time_step_factor = 0.2\nrates = 1\n"))
            excess.append((ours, fine)), shortfall.append((other, fine)), shorter.append(other.steps / ours.steps)
            rows.append([case.title, shown(other), shown(ahead), shown(ours), difference(ours, ahead), shown(fine), difference(other, fine)])
    head = ["case", "the other code", "the same, judged half a step ahead", "percal, same settings", "difference, standard errors", "percal, factor 0.2, single precision",
            "other code from that"]
    return table(head, rows), mean_difference(excess), mean_difference(shortfall), statistics.mean(shorter)


def mean_difference(pairs):
    """Of a from b in per cent, with its standard error, over pairs of figures."""
    mean = statistics.mean(a.mean / b.mean - 1 for a, b in pairs)
    error = math.sqrt(sum((a.error() ** 2 + b.error() ** 2) / b.mean ** 2 for a, b in pairs)) / len(pairs)
    return f"{mean * 100:+.1f} ± {error * 100:.1f}"


def negative_alpha(program):
    case = next(case for case in CASES if case.name == "alpha_-6")
    found = list(NEGATIVE_ALPHA)
    found += [("percal, same settings", factor, figures(program, case.scene(SAME.format(factor)), *THIRTY)) for factor in (0.8, 0.4)]
    found.append(("percal, its defaults", 0.9, figures(program, case.scene(""), *THIRTY)))
    return table(["code", "CFL number or time-step factor", "depth", "sd"], [[title, step, shown(f), f"{f.deviation:.2f}"] for title, step, f in found])


def arguments():
    return "\n".join(f"    {case.title:55} ./pen {' '.join(case.other_arguments())}" for case in CASES)


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
    return Figures(f.mean * factor, f.deviation * factor, f.cpu, f.steps, f.runs)


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
        ours = {n: figures(program, Case("", title, pi4, erosion=strain, eroded_nodes=nodes, mesh=n).scene("")) for n in (7, 10)}
        setting_s = setting_s or ours
        for n, radioss, other in lines:
            rows.append([title, n or "not given", radioss, other, *(shown(ours[m]) if n in (m, None) else "" for m in (7, 10))])
    return table(["case", "elements per radius", "OpenRadioss, one run", "the other code, one run", "percal, 7 elements per radius", "10"], rows), setting_s


def page(program):
    codes, same, default = between_codes(program)
    ahead, excess, shortfall, shorter = judged_ahead(program)
    halved, negative = halved_steps(program), negative_alpha(program)
    ridge_rows, gold_rows, gelatin_rows = ridge(program), gold(program), gelatin(program)
    radioss_rows, setting_s = openradioss(program)
    return PAGE.format(machine=program.machine(), cpu=program.cpu, pi4=S, density=GOLD, codes=codes, same=same, default=default, ahead=ahead, excess=excess, shortfall=shortfall,
                       shorter=shorter, both_slow=shown(BOTH["slow"]), both_contact=shown(BOTH["in_contact"]), tip=shown(RHOMBUS_TIP), halved=halved, negative=negative,
                       arguments=arguments(), ridge=ridge_rows, gold=gold_rows, gelatin=gelatin_rows, radioss=radioss_rows, seven=setting_s[7].cpu, ten=setting_s[10].cpu)


if __name__ == "__main__":
    write_page(command_line(__doc__, "cross_check.md", store=Store.OF_PAGE), page)
