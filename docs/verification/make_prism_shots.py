"""Writes docs/verification/prism_shots.md from calibrations of the program on shots of prisms (some half an hour of processor time, little when the store has their runs):

    python3 docs/verification/make_prism_shots.py build/release/percal

Options: --store FILE for the evaluations (default: the program's own), --page FILE to write elsewhere.
"""
from harness import ROOT, THESIS, Store, command_line, in_percent, rows_of, table, write_page

TRUE_MU, TRUE_STRAIN = 500e3, 0.35  # of data/synthetic/make_prism_shots.py


def calibrated(program, job):
    return program.ask("calibrate", ROOT / job, *program.kept(), "--threads", "2", "--out", program.folder / "out")


def number(found):
    """A parameter with its interval."""
    key, scale, unit, digits = ("value_Pa", 1e-3, " kPa", ".0f") if "value_Pa" in found else ("value", 1, "", ".3f")
    interval = found["interval_Pa" if unit else "interval"]
    words = [f"{scale * x:{digits}}" for x in (found[key], interval["low"], interval["high"])]
    return f"{words[0]}{unit} ({'below ' * interval['low_open']}{words[1]} to {'above ' * interval['high_open']}{words[2]})"


def of(hypothesis, name):
    return next(one for one in hypothesis["parameters"] if one["name"] == name)


def fitted_set(hypothesis, name):
    return next(one for one in hypothesis["sets"] if one["name"].startswith(name))


def depths(answer, ls_dyna):
    rows = []
    hypothesis = answer["hypotheses"][0]
    fresh = {run["shot"]: run for run in hypothesis["fresh_runs"]}
    for k, (shot, finite_elements) in enumerate(zip(hypothesis["shots"], ls_dyna)):
        cm = lambda m: f"{100 * m:.2f}"
        rows.append([f"{answer['data']['shots'][k]['speed_m_s']:g}", cm(shot["measured_m"]), finite_elements, cm(shot["depth_m"]), in_percent(shot["deviation"], "+.1f"),
                     f"{cm(shot['low_m'])} to {cm(shot['high_m'])}", f"{100 * shot['model_error']:.1f}", cm(fresh[k]["depth_m"])])
    return table(["m/s", "measured, cm", "LS-DYNA, its strain fitted to one shot", "fitted", "to measured, %", "95 % of one shot", "the emulator's error, %", "a fresh run"], rows)


def cost(answer):
    rounds = answer["emulator"]["rounds"]
    return [sum(one["runs"] for one in answer["emulator"]["outcomes"]), f"{rounds[-1]['cpu_s']:.0f}", in_percent(answer["emulator"]["bodies"][0]["leave_one_out_error"], ".1f"),
            in_percent(answer["emulator"]["error_at_optimum"], ".1f")]


def alone(program, name, angularity):
    answer = calibrated(program, f"data/guha2009/{name}_shots.toml")
    hypothesis = answer["hypotheses"][0]
    ls_dyna = [row["fe_cm"] for row in rows_of(THESIS / "angular_shots.csv", angularity_deg=angularity)]
    own = fitted_set(hypothesis, "Table")
    row = [name, number(of(hypothesis, "erosion_strain")), in_percent(own["mean_deviation"], ".1f"), in_percent(hypothesis["mesh_error"], "+.1f"), *cost(answer)]
    return depths(answer, ls_dyna), row


def synthetic(program):
    answer = calibrated(program, "data/synthetic/prism.toml")
    truths = {"mu": (TRUE_MU, "500 kPa"), "erosion_strain": (TRUE_STRAIN, "0.35")}
    rows = []
    for hypothesis in answer["hypotheses"]:
        for found in hypothesis["parameters"]:
            truth, words = truths[found["name"]]
            interval = found["interval_Pa" if "interval_Pa" in found else "interval"]
            is_held = (interval["low_open"] or interval["low"] <= truth) and (interval["high_open"] or truth <= interval["high"])
            rows.append([hypothesis["name"], found["name"], words, number(found), "inside" if is_held else "outside"])
    return table(["hypothesis", "parameter", "truth", "found (95 % interval)", "the truth is"], rows), cost(answer)


def together(program):
    answer = calibrated(program, "data/guha2009/balls_and_prisms.toml")
    hypothesis = answer["hypotheses"][0]
    rows = [["balls, Table 4-3", fitted_set(hypothesis, "Table 4-3")], ["rhombus, Table 5-1", fitted_set(hypothesis, "Table 5-1")],
            ["square, Table 5-2", fitted_set(hypothesis, "Table 5-2")]]
    sets = table(["set", "shots", "mean deviation, %", "signed, %", "within their 95 %"],
                 [[name, one["shots"], in_percent(one["mean_deviation"], ".1f"), in_percent(one["mean_signed_deviation"], "+.1f"), one["within_interval"]] for name, one in rows])
    bodies = ", ".join(f"{one['runs']} of {one['name']}" for one in answer["emulator"]["bodies"])
    scatter = ", ".join(f"{one['group']} {100 * one['standard_deviation']:.0f} %" for one in hypothesis["minima"][0]["scatter"] if one["standard_deviation"])
    return sets, number(of(hypothesis, "mu")), number(of(hypothesis, "erosion_strain")), bodies, scatter, answer["emulator"], hypothesis["mesh_error"]


def page(program):
    rhombus, rhombus_row = alone(program, "rhombus", "60")
    square, square_row = alone(program, "square", "45")
    recovered, recovered_cost = synthetic(program)
    sets, mu, strain, bodies, scatter, emulator, mesh_error = together(program)
    return f"""# Shots of prisms as data

Written by `docs/verification/make_prism_shots.py` from `percal calibrate` ({program.machine()}). How it goes: [theory/emulator.md](../theory/emulator.md), Other bodies; the scenes: [three_dimensions.md](three_dimensions.md).

## The thesis's prisms, their erosion strain fitted

`data/guha2009/rhombus_shots.toml` and `square_shots.toml`: modulus (113 kPa as MU1, truly 837 kPa) and exponent (14.8) are those of the balls' calibration, the erosion strain is fitted to the six shots of each prism, on 5.5 cubes on half the thickness; the thesis fitted it to one shot. Runs: of the emulator's design;
besides, each of the six shots is run anew at the best point, once where the emulator is checked and once at the end.

{table(["prism", "erosion strain (95 % interval)", "mean deviation, %", "mesh, %", "runs", "CPU s", "leave-one-out error, %", "the emulator's error at the best point, %"], [rhombus_row, square_row])}

"Mesh" is what a depth would change by without a mesh, as the emulator has it from runs on 4 and 5.5 cubes; the strain makes up for it.

### Rhombus

{rhombus}

### Square

{square}

Each prism asks for the strain of the other within both intervals, and for less than the ball's (0.287 and 0.289 on six cubes on half the thickness, [three_dimensions.md](three_dimensions.md)). Fast shots come out too deep and slow ones too shallow with the rhombus, the other way round with the square, and no strain cures either. That is what the scatter says.

## A truth that is known

`data/synthetic/prism.toml`: six depths of the rhombus made by the solver itself at mu 500 kPa and an erosion strain of 0.35, each a mean of five runs, with noise of 3 %; alpha is known, the erosion strain is fitted, the modulus known or fitted as well.

{recovered}

Prisms of one shape tell a pair of modulus and strain no better than balls of one size do: a ridge of pairs fits them, and the interval of either is wide. {recovered_cost[0]} runs, {recovered_cost[1]} CPU s; leave-one-out error {recovered_cost[2]} %, the emulator's error at the best point {recovered_cost[3]} %.

## Balls and prisms together

`data/guha2009/balls_and_prisms.toml`: the 24 shots of balls and the twelve of prisms, one modulus and one erosion strain for all, alpha 14.8, each kind with a scatter of its own. Modulus (true) {mu}, erosion strain {strain}; scatter: {scatter}. Runs: {bodies}; of spheres {emulator["from_atlas"]} of the atlas besides. {emulator["rounds"][-1]["cpu_s"]:.0f} CPU s.

{sets}

With the modulus free one gelatin is as near to the prisms as a strain of their own for each is with the modulus of the balls alone, and as near to the balls as Dehn's closed form (8.7 %): what the prisms ask for is a stiffer gelatin that tears earlier. Elements are coarse here, 5.5 on a ball's radius; without a mesh depths would be {in_percent(mesh_error, "+.0f")} % different in the mean,
and modulus and strain belong to these elements.
"""


if __name__ == "__main__":
    write_page(command_line(__doc__, "prism_shots.md", store=Store.PERCALS), page)
