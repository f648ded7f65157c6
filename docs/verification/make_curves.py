"""Writes docs/verification/curves.md and docs/figures/curves.svg from fits of the public curves (some seconds):

    python3 docs/verification/make_curves.py build/release/percal

Needs gnuplot for the figure.
"""
import math

from harness import ROOT, command_line, data_block, draw, figures_of, number, percent, processor, rows_of, table, write_page

PUBLIC = ROOT / "data" / "public"
TRELOAR = PUBLIC / "treloar1944_rubber_primary.csv"
MEUNIER = PUBLIC / "meunier2008_silicone_modes.csv"
BRAIN = PUBLIC / "budday2017_brain_cann_table.csv"
MEAT = PUBLIC / "stpierre2023_meat_tension_compression_shear.csv"
SKIN = PUBLIC / "tac2022_porcine_skin_biaxial.csv"

MODELS = {"neo-hooke": "neo-Hooke", "mooney-rivlin": "Mooney-Rivlin", "ogden": "Ogden 1", "ogden2": "Ogden 2", "ogden3": "Ogden 3"}
FOODS = {"ac": "plant-based chicken (A)", "tf": "tofurky (A)", "rc": "real chicken (A)", "PBsaus": "plant-based sausage", "tfky": "tofurky", "frmtf": "firm tofu",
         "Xftof": "extra firm tofu", "PBhotdog": "plant-based hotdog", "RLhotdog": "hotdog", "RLsaus": "sausage", "spam": "spam"}
REGIONS = ["cortex", "basal_ganglia", "corona_radiata", "corpus_callosum"]

# name, kind, file and rows, residual of its own
SETS = ([("rubber (Treloar)", "rubber", [TRELOAR], "relative"), ("silicone (Meunier)", "rubber", [MEUNIER], "relative")] +
        [(f"brain, {region.replace('_', ' ')}", "soft", [BRAIN, "--where", f"region={region}"], "relative") for region in REGIONS] +
        [(food, "soft", [MEAT, "--where", f"material_label={label}"], "error") for label, food in FOODS.items()])


class Fits:
    """`percal fit`, and the processor seconds of all its fits."""

    def __init__(self, program):
        self.program, self.seconds = program, 0

    def __call__(self, *arguments):
        result = self.program.ask("fit", *arguments, "--no-intervals")
        self.seconds += result["cost"]["cpu_s"]
        return result


def by_model(result):
    return {row["model"]: row for row in result["comparison"]}


def compared(percal, arguments, *options):
    """Models with positive moduli, and with free signs."""
    positive = percal(*arguments, *options, "--compare")
    return positive, by_model(positive), by_model(percal(*arguments, *options, "--compare", "--unconstrained"))


def missed(column):
    share = column["left_out_mean_relative_deviation"]
    return "> 1000 %" if share is not None and share >= 10 else percent(share, ".0f")


def stable_tension(model):
    """Stretches in uniaxial deformation at which the best fit is stable."""
    stretches = model["stability"]["stretches"]["uniaxial"]
    if stretches["low_is_searched_end"] and stretches["high_is_searched_end"]:
        return "all"
    return f"{stretches['low']:.2f} to {stretches['high']:.2f}"


def compared_sets(percal, choice):
    """The table, and for the summary (name, kind, Mooney-Rivlin, the same with free signs, Ogden 1)."""
    head = ["set", "points, tests", "neo-Hooke", "Mooney-Rivlin", "with C01 of any sign", "Ogden 1", "Ogden 2", "Ogden 3", "left out: neo-Hooke", "Mooney-Rivlin", "any sign", "Ogden 1",
            "Ogden 2", "Ogden 3", "any sign: stable"]
    rows, verdicts = [], []
    for name, kind, arguments, own in SETS:
        result, models, free = compared(percal, arguments, *choice(own))
        columns = [models["neo-hooke"], models["mooney-rivlin"], free["mooney-rivlin"], models["ogden"], models["ogden2"], models["ogden3"]]
        aicc = [column.get("aicc") for column in columns]
        lowest = min(value for value in aicc if value is not None)
        rows.append([name, f"{result['points']}, {len(result['tests'])}", *(number(None if value is None else value - lowest, ".1f") for value in aicc), *map(missed, columns),
                     stable_tension(free["mooney-rivlin"])])
        verdicts.append((name, kind, models["mooney-rivlin"], free["mooney-rivlin"], models["ogden"]))
    return table(head, rows) + "\n", verdicts


def one_summary(soft, mooney, words):
    ahead = lambda row: mooney(row)["aicc"] - row[4]["aicc"]
    deviation = "left_out_mean_relative_deviation"
    names = lambda rows: f" ({', '.join(row[0] for row in rows)})" if rows else ""
    better, worse = [row for row in soft if ahead(row) > 2], [row for row in soft if ahead(row) < -2]
    not_less = [row for row in soft if not row[4][deviation] < mooney(row)[deviation]]
    return (f"Against Mooney-Rivlin {words} (two parameters each) its AICc is lower by more than 2 in {len(better)} sets and higher by more than 2 in {len(worse)}{names(worse)}; "
            f"it misses the left-out tests by less in {len(soft) - len(not_less)}, not by less in {len(not_less)}{names(not_less)}.")


def summary(verdicts):
    soft = [row for row in verdicts if row[1] == "soft"]
    return (f"The one-term Ogden solid on the {len(soft)} soft tissues and foods. {one_summary(soft, lambda row: row[2], 'with positive constants')} "
            f"{one_summary(soft, lambda row: row[3], 'with C01 of any sign')}\n")


def skin_section(percal):
    rows = []
    for protocol, mode in [("equibiaxial", "equibiaxial"), ("strip_x (stretch_y=1)", "planar"), ("strip_y (stretch_x=1)", "planar")]:
        for axis in "xy":
            across = protocol.startswith("strip") and not protocol.startswith(f"strip_{axis}")
            if across:
                continue
            result = percal(SKIN, "--x", f"stretch_{axis}", "--y", f"cauchy_{axis * 2}_MPa", "--where", f"protocol={protocol}", "--mode", mode, "--residual", "absolute")
            best = result["minima"][0]
            rows.append([f"{protocol}, {axis * 2}", result["points"], f"{best['mu_Pa'] / 1e3:.3g}", f"{best['alpha']:.3g}", number(best["r2"], ".4f")])
    every = []
    for axis in "xy":
        result = percal(SKIN, "--x", f"stretch_{axis}", "--y", f"cauchy_{axis * 2}_MPa", "--mode", "general_biaxial", "--residual", "absolute", "--compare")
        every.append((axis, by_model(result)))
    together = [[axis * 2, *(number(models[m]["minima"][0]["r2"], ".3f") if models[m]["minima"] else "no fit" for m in MODELS)] for axis, models in every]
    return "\n".join([table(["protocol and stress", "points", "mu, kPa", "alpha", "R²"], rows), "", "All five protocols together, R² of each model's best fit:", "",
                      table(["stress", *MODELS.values()], together)]) + "\n"


# The nominal stress of a sum of terms (mu_Pa, alpha), written a second time.
def stress(terms, mode, x):
    total = 0
    for term in terms:
        mu, a = term["mu_Pa"], term["alpha"]
        if mode in ("simple_shear", "SS"):
            l = x / 2 + math.sqrt(1 + x * x / 4)
            total += 2 * mu / a * (l**a - l**-a) / (l + 1 / l)
        else:
            other = {"UT": -a / 2, "tension_compression": -a / 2, "ET": -2 * a, "PS": -a}[mode]
            total += 2 * mu / a * (x**a - x**other) / x
    return total


def panel(k, title, xlabel, unit, points, fits, mode, xs):
    """gnuplot's lines of one panel: points and a curve of each (title, terms, colour)."""
    text = data_block(f"d{k}", points, digits=6)
    plots = [f'$d{k} with points pt 6 ps 0.6 lc rgb "#555555" notitle']
    for c, (name, terms, colour) in enumerate(fits):
        text += data_block(f"c{k}_{c}", [(x, stress(terms, mode, x) / unit) for x in xs], digits=6)
        plots.append(f'$c{k}_{c} with lines lw 1.6 lc rgb "{colour}" title "{name}"')
    return text, f'set title "{title}"\nset xlabel "{xlabel}"\nplot {", ".join(plots)}\n'


def figure(percal, file):
    colours = {"mooney-rivlin": "#d55e00", "ogden": "#0072b2", "ogden3": "#0fa569"}
    panels = []

    def fits(result):
        models = by_model(result)
        return [(MODELS[m], models[m]["minima"][0]["terms"], colour) for m, colour in colours.items()]

    steps = lambda low, high: [low + (high - low) * k / 120 for k in range(121)]
    brain = fits(percal(BRAIN, "--where", "region=cortex", "--compare", "--unconstrained", "--residual", "absolute", "--weights", "tests"))
    for mode, title, label, low, high in [("tension_compression", "brain cortex, uniaxial", "stretch", 0.9, 1.1), ("simple_shear", "brain cortex, simple shear", "gamma", -0.2, 0.2)]:
        points = [(float(r["x_stretch_or_gamma"]), float(r["nominal_stress_kPa"])) for r in rows_of(BRAIN, region="cortex", mode=mode)]
        panels.append(panel(len(panels), title, label, 1e3, points, brain, mode, steps(low, high)))
    rubber = fits(percal(TRELOAR, "--compare", "--residual", "absolute", "--weights", "tests"))
    for mode, title, high in [("UT", "rubber, uniaxial", 7.7), ("ET", "rubber, equibiaxial", 4.5)]:
        points = [(float(r["stretch"]), float(r["nominal_stress_MPa"])) for r in rows_of(TRELOAR, mode=mode)]
        panels.append(panel(len(panels), title, "stretch", 1e6, points, rubber, mode, steps(1, high)))
    script = "".join(data for data, _ in panels)
    script += 'set key left top samplen 2\nset grid lc rgb "#dddddd"\nset multiplot layout 2,2\n'
    for k, (_, plot) in enumerate(panels):
        script += f'set ylabel "nominal stress, {"kPa" if k < 2 else "MPa"}"\n' + plot
    draw(file, script, size="940,720", font=12)


def page(program):
    percal = Fits(program)
    own, own_verdicts = compared_sets(percal, lambda residual: ["--residual", residual])
    same, same_verdicts = compared_sets(percal, lambda _: ["--residual", "absolute", "--weights", "tests"])
    skin = skin_section(percal)
    figure(percal, figures_of(program.options.page) / "curves.svg")
    return f"""# Models of curves on public data

Written by `docs/verification/make_curves.py` from `percal fit --compare` on data/public ({percal.seconds:.1f} s of processor time in all, {processor()}). What AICc, left-out tests and the solids are stands in
docs/theory/curves.md. No set is gelatin: no gelatin curve is published in numbers.

The thesis prefers Ogden's solid to Mooney-Rivlin's for soft tissue and gelatin. Here both are fitted to every set: by AICc (columns 3 to 8, less that of the best in the row; the best has 0), and by how far a fit to the other
tests misses a test that it has not seen (mean of the deviations' sizes over its points, then over the tests). Tests are uniaxial tension, uniaxial compression, equibiaxial, planar and simple shear, as far as a set has them.
Moduli are positive, except in the columns `any sign`: with C01 below 0 Mooney-Rivlin fits more and loses its stability; the last column has the uniaxial stretches at which that fit is stable. A left-out deviation beyond 100 % is a solid that the other tests leave undetermined in that
direction: simple shear cannot tell the sign of an exponent, and says little of tension against compression.

The points are averaged or digitised curves, so they are not independent, and differences of AICc are larger than the data warrant; their sign and the left-out tests are what to look at.

## Relative residuals; the soft foods' over their standard errors
{own}
{summary(own_verdicts)}
## Absolute residuals, every test counting the same
{same}
{summary(same_verdicts)}
![Mooney-Rivlin, one-term and three-term Ogden beside the points](../figures/curves.svg)

Absolute residuals, every test counting the same; for the brain single moduli of any sign.

## Skin: what no isotropic solid can fit
Porcine skin of one specimen (Tac et al.), absolute residuals. Were it isotropic, xx and yy of the equibiaxial protocol would be one curve, and so would the two strips.

{skin}"""


if __name__ == "__main__":
    write_page(command_line(__doc__, "curves.md", "program"), page)
