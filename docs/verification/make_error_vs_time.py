"""Writes docs/verification/error_vs_time.md from studies of four scenes (some ten minutes of processor time):

    python3 docs/verification/make_error_vs_time.py build/release/percal

Options: --meshes 5,7,10,14 and --replicates 3 instead of the default ladder, --page FILE to write elsewhere, --store FILE for the evaluations (default: a new one for every
study, so that every run is timed here).
"""
from harness import THESIS, changed, command_line, figures_of, in_percent, percent, table, um, write_page

GOLD = (THESIS / "gold.toml").read_text()


SCENES = (
    ("setting_s", "Setting S: 15 MPa, erosion strain 0.7, 651 m/s", GOLD),
    ("mesh_study", "The deepest: the thesis's mesh study, 4.2 MPa, 0.6, 580 m/s", (THESIS / "mesh_study.toml").read_text()),
    ("fastest", "The fastest: 0.6 um at 775 m/s", changed(GOLD, ('"1 um"', '"0.6 um"'), ('"651 m/s"', '"775 m/s"'), ('"75 um"', '"45 um"'), ('"5 um"', '"3 um"'))),
    ("smallest_strain", "The smallest erosion strain: 55 MPa, 0.3, 651 m/s", changed(GOLD, ('"15 MPa"', '"55 MPa"'), ("strain = 0.7", "strain = 0.3"))),
)


def study(program, name, text):
    """The result, and the figure that goes with it, if there is one."""
    ladder = [word for option in ("meshes", "replicates") if getattr(program.options, option) for word in (f"--{option}", getattr(program.options, option))]
    folder = program.folder / f"{name}.out"
    result = program.ask("study", program.scene(text, name), "--error-vs-time", "--threads", "1", "--out", folder, *program.kept(), *ladder)
    svg = folder / "error_against_time.svg"
    return result, svg.read_text() if svg.exists() else None


def rungs(result):
    rows = []
    for rung in result["meshes"]:
        error, means = rung["error"] or {}, rung["error_of_mean_of"] or {}
        rows.append([rung["elements_per_radius"], rung["elements"], um(rung["depth_m"]) if rung["depth_m"] else rung["outcome"], um(rung["depth_spread_m"]), in_percent(error.get("value")),
                     f"{in_percent(error.get('low'))} to {in_percent(error.get('high'))}", *(in_percent(means.get(c, {}).get("value")) for c in ("1", "3", "10")), f"{rung['steps']:.0f}",
                     f"{rung['cpu_s']:.3g}"])
    return table(["elements per radius", "elements", "depth, um", "spread", "error, %", "interval", "mean of 1, %", "of 3", "of 10", "steps", "CPU s a run"], rows)


def change(what, c):
    if c["share"] is None:
        return f"- {what} at {c['elements_per_radius']} elements per radius: not both stopped."
    return f"- {what} at {c['elements_per_radius']} elements per radius: {100 * c['share']:+.2f} ± {100 * c['standard_error']:.2f} %, {c['cost_ratio']:.1f} times the time."


def advice(result):
    rows = []
    for a in result["advice"]:
        if not a["found"]:
            rows.append([percent(a["target_error"], ".0f"), f"none: {a['why_not']}", "-", "-", "-"])
            continue
        high = "no bound" if a["cpu_high_s"] is None else f"{a['cpu_high_s']:.3g}"
        rows.append([percent(a["target_error"], ".0f"), f"{a['elements_per_radius']} elements per radius, {a['replicates']} runs{' (extrapolated)' if a['cost_estimated'] else ''}",
                     f"{in_percent(a['error'], '.2f')} ({in_percent(a['discretisation_error'], '.2f')}, {in_percent(a['noise_error'], '.2f')})", f"{a['cpu_s']:.3g}", f"{a['cpu_low_s']:.3g} to {high}"])
    return table(["error", "setting", "estimated error, % (mesh, noise)", "CPU s", "interval"], rows)


def section(title, result, image):
    c = result["convergence"]
    text = [f"## {title}", ""]
    if image:
        text += [f"![Error against processor time](../figures/{image})", ""]
    text += [rungs(result), ""]
    if c["outcome"] == "fitted":
        text += [f"Extrapolated depth {um(c['extrapolated_depth_m'])} um ({um(c['extrapolated_depth_low_m'])} to {um(c['extrapolated_depth_high_m'])}), error {c['form']}, observed order "
                 f"{c['observed_order']:.2g}, scatter about the fit {um(c['standard_deviation_m'])} um, a run's spread {in_percent(c['spread_of_a_run'])} %.", ""]
    text += [change("half the time step", one) for one in result["change_by_half_the_step"]]
    text += [change("double precision", result["change_by_double_precision"]), "", advice(result)]
    text += [""] + [f"- {finding}" for finding in result["findings"]]
    return "\n".join(text).rstrip() + "\n"


def fitted(convergence, mesh):
    h = 1 / mesh
    error = convergence["a_m"] * h + convergence["b_m"] * h * h if convergence["order"] is None else convergence["a_m"] * h ** convergence["order"]
    return convergence["extrapolated_depth_m"] + error


def beside_the_thesis(result):
    """Its meshes: 42 and 50 elements per radius, 65 and 77 columns, 75 radii deep."""
    c = result["convergence"]
    if c["outcome"] != "fitted":
        return "No curve could be fitted here, and nothing is said beside the thesis's 2.41 %.\n"
    coarse, fine = fitted(c, 42), fitted(c, 50)
    return f"""The thesis finds 2.41 % between 204,750 and 288,750 elements, one run each: 42 and 50 elements per radius. The curve fitted above gives {um(coarse)} and {um(fine)} um there, a difference of
{abs(coarse / fine - 1) * 100:.2f} %; the difference of two single runs scatters by {c['spread_of_a_run'] * 2 ** 0.5 * 100:.1f} % (a run's spread times the root of 2). At 204,750 elements the curve
is {abs(coarse / c['extrapolated_depth_m'] - 1) * 100:.1f} % from the extrapolated depth.
"""


def page(program):
    sections = []
    for name, title, text in SCENES:
        result, svg = study(program, name, text)
        image = f"error_vs_time_{name}.svg" if svg else None
        if svg:
            (figures_of(program.options.page) / image).write_text(svg)
        sections.append(section(title, result, image) + ("\n" + beside_the_thesis(result) if name == "mesh_study" else ""))
    return f"""# Error against processor time

Written by `docs/verification/make_error_vs_time.py` from `percal study SCENE --error-vs-time` ({program.machine()}, one thread), for `data/guha2009/gold.toml`, `mesh_study.toml` and
two changes of the first. Errors are against the depth extrapolated from the same ladder, after Eca and Hoekstra (2014): [theory/errors.md](../theory/errors.md). The error of a mean of so many
runs is the root of the sum of squares of the mesh's error and the noise.

""" + "\n".join(sections)


if __name__ == "__main__":
    ladder = command_line(__doc__, "error_vs_time.md")
    for option in ("--meshes", "--replicates"):
        ladder.add_argument(option)
    write_page(ladder, page)
