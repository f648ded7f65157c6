"""Writes docs/verification/powder.md from percal's runs: gold powder in skin against the spread of depths that was measured, its dose by layer, a design
and the solver's word on it.

    python3 docs/verification/make_powder.py build/release/percal
"""
import math
import shutil
import statistics

from harness import THESIS, Store, changed, command_line, number, percent, table, um, write_page

PARTICLES = 24  # of the design's powder, run by the solver

DESIGN = """title = "Gold between 20 and 50 um"
calibration = "gold_length.out"
layer_depth = "75 um"
{head}
[powder]
density = "16800 kg/m3"
{powder}
[band]
from = "20 um"
to = "50 um"
{design}"""

SIZES = """[powder.radius]
median = "{radius}"
geometric_deviation = 1.15
weighting = "number"
[powder.speed]
median = "{speed}"
geometric_deviation = 1.05
"""

SEARCH = """[design]
radius = ["0.6 um", "1.4 um"]
speed = ["420 m/s", "780 m/s"]
map = 15
[limits]
bounced = "10 %"
beyond = "20 %"
"""


def job(percal, name, text):
    (percal.folder / name).write_text(text)
    return name


def length(estimate):
    return f"{um(estimate['best'])} ({um(estimate['low'])} to {um(estimate['high'])})"


def share(estimate):
    return f"{percent(estimate['best'])} ({percent(estimate['low'])} to {percent(estimate['high'])})"


def dose(percal, name, text):
    return percal.ask("dose", job(percal, name, text), "--out", "none")


def kendall_rows(percal, text):
    """Under what is not known: how deep the target counts, whether slow and small particles bounce, how single particles scatter."""
    for layer in ("75 um", "150 um", "300 um"):
        for bounce in ("breach", "none"):
            for scatter in (None, 0.3):
                lines = f'bounce = "{bounce}"\n' + (f"scatter = {scatter}\n" if scatter else "")
                found = dose(percal, "variant.toml", changed(text, ('layer_depth = "150 um"', f'layer_depth = "{layer}"'), ("\n[powder]", lines + "\n[powder]")))
                spread = {source["source"]: source for source in found["spread"]}
                depths = found["depths_by_number"]
                yield [layer, bounce, number(found["scatter"], ".2f"), length(depths["mean_m"]), length(spread["size"]["spread_m"]), length(depths["deviation_m"]),
                       percent(found["by_number"]["bounced"]["best"]), percent(found["by_number"]["passed"]["best"]),
                       "yes" if found["measured"]["explained_by_size"] else "no"]


def share_rows(found):
    for name, key in (("bounced", "bounced"), *((layer["name"], k) for k, layer in enumerate(found["by_mass"]["layers"])), ("below them", "deeper"), ("passed", "passed")):
        of = [found[by]["layers"][key]["share"] if isinstance(key, int) else found[by][key] for by in ("by_mass", "by_number")]
        yield [name, *map(share, of)]


def quantile(share_below):
    return statistics.NormalDist().inv_cdf(share_below)


def particles(radius, speed):
    """Of equal weight in number: radii at even quantiles, speeds at the same ones in another order (the golden ratio's)."""
    for k in range(PARTICLES):
        size, pace = (k + 0.5) / PARTICLES, math.fmod((k + 0.5) * 0.6180339887498949, 1)
        yield radius * 1.15 ** quantile(size), speed * 1.05 ** quantile(pace)


def solver_rows(percal, best):
    """The design's powder particle by particle: the solver's depth and the emulator's."""
    rows = list(particles(best["radius_m"], best["speed_m_s"]))
    job(percal, "particles.csv", "radius_m,speed_m_s\n" + "\n".join(f"{r!r},{v!r}" for r, v in rows) + "\n")
    said = percal.ask("predict", "gold_length.out", "--shots", "particles.csv", "--layer-depth", "75 um", "--verify", *percal.kept(), "--threads", "1")
    return [(r, shot["depth_m"], shot["checked"]["run_depth_m"]) for (r, _), shot in zip(rows, said["shots"])]


def by_mass(rows, column):
    """Mean and standard deviation of a depth, m."""
    weights = [row[0] ** 3 for row in rows]
    mean = sum(w * row[column] for w, row in zip(weights, rows)) / sum(weights)
    return mean, math.sqrt(sum(w * (row[column] - mean) ** 2 for w, row in zip(weights, rows)) / sum(weights))


def page(percal):
    for name in ("gold_length.toml", "gold_skin.csv"):
        shutil.copy(THESIS / name, percal.folder)
    percal.run("calibrate", "gold_length.toml", "--quiet", "--threads", "1", *percal.kept())
    text = (THESIS / "gold_dose.toml").read_text()
    found = dose(percal, "gold_dose.toml", text)
    spread = {source["source"]: source for source in found["spread"]}
    variants = list(kendall_rows(percal, text))
    powder = SIZES.format(radius="1 um", speed="600 m/s")
    design = percal.ask("design", job(percal, "design.toml", DESIGN.format(head="", powder=powder, design=SEARCH)), "--out", "none")
    best = design["best"]
    again = dose(percal, "best.toml", DESIGN.format(head="scatter = 0", powder=SIZES.format(radius=f"{best['radius_m']!r} m", speed=f"{best['speed_m_s']!r} m/s"), design=""))
    rows = solver_rows(percal, best)
    ratios = [math.log(run / by_emulator) for _, by_emulator, run in rows]
    return f"""# Powders

Written by docs/verification/make_powder.py from runs of {percal.version}: the calibration of data/guha2009/gold_length.toml (nine mean depths of gold in skin), then `percal dose` and `percal design`. How: docs/theory/powder.md.

## Is 26 um ± 18 um the spread of sizes?

Kendall et al. (2004), as Guha (2009) has it: 26 um ± 18 um of 401 gold particles in human skin at 651 m/s; the ± is read as the standard deviation of single particles (data/guha2009/README.md, erratum 10). Radii of 0.9 um ± 0.6 um are reported for Kendall's gold, of which powder could not be checked against the source. data/guha2009/gold_dose.toml takes
them as a lognormal distribution by number, all at 651 m/s, in a target of 150 um:

{table(["", "standard deviation of depth, um", "mean depth, um"], [[source, length(spread[source]["spread_m"]), length(spread[source]["spread_mean_m"])] for source in spread] + [["measured", length(found["measured"]["measured_deviation_m"]), um(found["measured"]["measured_mean_m"])]])}

In brackets: 95 %, by the parameters and the emulator. The program says: {next(finding for finding in found["findings"] if "measured" in finding)}

So sizes alone explain the spread, and the mean is near 26 um where small particles do not bounce or are not found; scatter of single particles about the mean of their like adds next to nothing. **This is no proof.** The radii may be those of another powder than the one whose depths were measured;
{percent(next(one["by_number"] for one in found["beyond"] if one["of"] == "radii"), ".0f")} of the particles have radii beyond the 0.6 to 1.4 um that were fitted, where depths are those of the emulator's trend; and the answer hangs on what is not known:

{table(["target", "bounce", "scatter", "mean, um", "by sizes alone, um", "standard deviation, um", "bounced", "passed", "sizes explain 18 um"], variants)}

- Target: the shots were run in 75 um of skin, the thesis's block, whose free bottom is no bottom of skin. What goes as deep counts as passed and is not in the spread: the deepest particles make much of it.
- Bounce: below 7 kg/(m s) ("breach"), or never. Two of the nine fitted shots went in below it.
- Scatter of ln depth of single particles: {number(found["scatter"], ".2f")} is that of the nine fitted depths about the model. They are means over many particles, so it is not that of one; 0.3 stands for a much larger one.

## The same powder by layer

The bounds of layers are an illustration, the material goes through all of them. Mass and number tell different stories:

{table(["", "of the mass", "of the number"], share_rows(found))}

## A design, and the solver's word on it

Gold with radii of a geometric deviation of 1.15 and speeds of 1.05, most of the mass between 20 and 50 um, no more than 10 % bounced and 20 % beyond the fitted shots, medians of 0.6 to 1.4 um and 420 to 780 m/s: `percal design` finds {um(best["radius_m"])} um at {number(best["speed_m_s"], ".0f")} m/s with {share(best["dose"])} of the mass in the band.
The best speed at this radius is {number(best["best_speed_interval_m_s"]["low"], ".0f")} to {number(best["best_speed_interval_m_s"]["high"], ".0f")} m/s for all parameters that are not ruled out; 90 % of the dose are left from {number(best["speed_tolerance_m_s"]["low"], ".0f")} to {number(best["speed_tolerance_m_s"]["high"], ".0f")} m/s. It is one point of a line:

{table(["radius, um", "best speed, m/s", "in the band", "bounced", "beyond the fitted"], [[um(point["radius_m"]), number(point["speed_m_s"], ".0f"), percent(point["dose"]), percent(point["bounced"]), percent(point["beyond_fitted"])] for point in design["line"]])}

{PARTICLES} particles of that powder, of equal weight in number, were run by the solver at the best point. Runs lie {percent(statistics.mean(ratios), "+.1f")} from the emulator in the mean, with a standard deviation of {percent(statistics.stdev(ratios))}. Depth by mass:

{table(["", "mean, um", "standard deviation, um"], [
    [f"the solver, {PARTICLES} particles", *map(um, by_mass(rows, 2))],
    ["the emulator, the same", *map(um, by_mass(rows, 1))],
    ["`percal dose`, the whole powder without scatter", *(um(again["depths_by_mass"][key]["best"]) for key in ("mean_m", "deviation_m"))]])}

## Closed forms

Tests hold these (tests/powder): depths that go as powers of radius, density and speed make a lognormal powder's dose lognormal: shares within 1e-4 of the error function, mean and median within 5e-4, by number and by mass, with and without scatter; what is below the breach within 2e-4; shares add up to 1 within 1e-9.
The best design is the analytic one within 1e-3 of the dose, on its line; a limit moves it to the edge. Of 200 truths the 95 % interval of the mean depth holds 90 to 99 %.
"""


if __name__ == "__main__":
    write_page(command_line(__doc__, "powder.md", store=Store.OF_PAGE), page)
