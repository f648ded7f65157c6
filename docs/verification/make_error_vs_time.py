"""Writes docs/verification/error_vs_time.md from studies of six scenes, each with erosion by the element's own strain and over a length (some
twenty minutes of processor time):

    python3 docs/verification/make_error_vs_time.py build/release/percal

Options: --page FILE to write elsewhere, --store FILE for the evaluations (default: a new one for every study, so that every run is timed here).
"""
from dataclasses import dataclass

from harness import THESIS, changed, command_line, data_block, draw, figures_of, in_percent, number, percent, plus_minus, table, write_page

LENGTH = 0.43       # radii, of erosion: seven elements per radius have three in it
DEFAULT_MESH = 10   # elements per radius
FIGURE = "error_vs_time.svg"


@dataclass(frozen=True)
class Case:
    name: str
    title: str
    local: str                    # the scene, in TOML
    over_length: str
    radius: float                 # m
    meshes: tuple = (None, None)  # of the ladders, as --meshes has them; None: the program's own


def scene(title, pi4, alpha, density_ratio, bulk_to_shear, strain, depth):
    """A sphere of 1 mm at 100 m/s into a target of 1000 kg/m3; depth in radii."""
    return f'''[particle]
name = "sphere"
radius = "1 mm"
density = "{1000 * density_ratio:g} kg/m3"
speed = "100 m/s"

[target]
name = "{title}"
density = "1000 kg/m3"
mu = "{1e7 / pi4:.8g} Pa"
alpha = {alpha}
bulk_to_shear = {bulk_to_shear}
depth = "{depth} mm"

[target.erosion]
strain = {strain}
'''


def over_length(text, strain):
    """The scene with its erosion judged over the length; `strain` as the text has it."""
    return changed(text, (f"strain = {strain}\n", f"strain = {strain}\nlength_in_radii = {LENGTH}\n"))


def case(name, title, pi4, alpha, density_ratio, bulk_to_shear, strain, depth, averaged_strain=None, meshes=(None, None)):
    local, averaged = (scene(name, pi4, alpha, density_ratio, bulk_to_shear, eps, depth) for eps in (strain, averaged_strain or strain))
    return Case(name, f"{title}: pi4 {pi4}, alpha {alpha}, density ratio {density_ratio}, K/mu {bulk_to_shear}, strain {strain}", local,
                over_length(averaged, averaged_strain or strain), 1e-3, meshes)


MESH_STUDY = changed((THESIS / "mesh_study.toml").read_text(), ("elements_per_radius = 14", f"elements_per_radius = {DEFAULT_MESH}"))
COARSE = ("5,7,10,14", "7,8,10,14")
CASES = (
    case("S", "S, gold into skin of 15 MPa", 6.6474, 8.5, 16.8, 50, 0.7, 60),
    case("M", "M, gold into skin of 55 MPa (over the length: strain 0.25)", 1.813, 8.5, 16.8, 50, 0.3, 60, averaged_strain=0.25),
    case("P", "P, PMMA into gelatin", 13.52, 11, 1.139, 150, 0.35, 20),
    case("F", "F, a steel BB into soft gelatin", 601, 13.8, 7.573, 800, 0.626, 120, meshes=COARSE),
    case("U", "U, a steel BB into stiff gelatin", 118.4, 3.95, 7.573, 400, 2.98, 90, meshes=COARSE),
    Case("D", "D, the thesis's mesh study: `data/guha2009/mesh_study.toml`, gold into 4.2 MPa at 580 m/s, strain 0.6", MESH_STUDY,
         over_length(MESH_STUDY, 0.6), 1e-6),
)


# The studies.

def study(program, one, rule):
    """The result for rule 0, by the element's own strain, or 1, over the length."""
    name = one.name + ("_over_length" if rule else "")
    meshes = ["--meshes", one.meshes[rule]] if one.meshes[rule] else []
    return program.ask("study", program.scene((one.local, one.over_length)[rule], name), "--error-vs-time", "--threads", "1", "--out", "none", *program.kept(), *meshes)


def has_limit(result):
    return result["convergence"]["outcome"] != "no limit"


def off(result, rung):
    """Where there is a limit the error against it, else the distance from the finest mesh, which has none itself; with its interval."""
    if has_limit(result):
        return rung["error"] or {}
    return {} if rung is result["meshes"][-1] else rung["from_finest"] or {}


def in_radii(one, rung):
    return rung["outcome"] if rung["depth_m"] is None else plus_minus(rung["depth_m"] / one.radius, rung["depth_standard_error_m"] / one.radius)


def signed(share):
    """In per cent; no -0.0."""
    return "-" if share is None else f"{round(100 * share, 1) + 0.0:+.1f}"


def interval(band):
    return f"{signed(band['low'])} to {signed(band['high'])}" if band else "-"


def moves(result, one_from):
    """What each step of the ladder moves the depth by, from a mesh on."""
    meshes = [rung for rung in result["meshes"] if rung["elements_per_radius"] >= one_from]
    steps = ", ".join(signed(fine["depth_m"] / coarse["depth_m"] - 1) for coarse, fine in zip(meshes, meshes[1:]))
    return f"{steps} % ({', '.join(number(rung['elements_per_radius']) for rung in meshes)} elements per radius)"


# The page.

def rungs(one, result):
    limit, rows = has_limit(result), []
    for rung in result["meshes"]:
        row = [number(rung["elements_per_radius"]), *([number(rung["element_over_erosion_length"], ".2f")] if limit else []), rung["elements"], in_radii(one, rung),
               in_percent(rung["depth_m"] and rung["depth_spread_m"] / rung["depth_m"]), signed(off(result, rung).get("value")), interval(off(result, rung))]
        if limit:
            row.append(in_percent((rung["error_of_mean_of"] or {}).get("3", {}).get("value")))
        rows.append([*row, f"{rung['steps']:.0f}", f"{rung['cpu_s']:.3g}"])
    return table(["elements per radius", *(["h/l"] if limit else []), "elements", "depth, radii", "a run's sd, %", "error, %" if limit else "from the finest, %", "interval",
                  *(["mean of 3, %"] if limit else []), "steps", "CPU s a run"], rows)


def change(what, c):
    if c["share"] is None:
        return f"{what} on {c['elements_per_radius']:g}: not both stopped"
    return f"{what} on {c['elements_per_radius']:g}: {signed(c['share'])} ± {100 * c['standard_error']:.1f} %"


def changes(result):
    return "; ".join([change("half the time step", c) for c in result["change_by_half_the_step"]] + [change("double precision", result["change_by_double_precision"])]) + "."


def limit_words(one, result):
    c = result["convergence"]
    if c["outcome"] != "fitted":
        return "No limit was found."
    low, high = (c[f"extrapolated_depth_{end}_m"] / one.radius for end in ("low", "high"))
    return f"At h = 0: {c['extrapolated_depth_m'] / one.radius:.2f} radii ({low:.2f} to {high:.2f}), error {c['form']}, from {c['fitted_from_elements_per_radius']:g} elements per radius."


def section(one, results):
    local, averaged = results
    text = [f"## {one.title}", "", "By the element's own strain; no limit:", "", rungs(one, local), "", changes(local).capitalize(), "", f"Over {LENGTH} radii:", "", rungs(one, averaged), "",
            f"{limit_words(one, averaged)} {changes(averaged).capitalize()}", ""]
    notes = [f"- {rule}: {finding}." for rule, result in (("own strain", local), ("length", averaged)) for finding in result["findings"] if "no limit in the element" not in finding]
    return "\n".join(text + notes).rstrip() + "\n"


def advice(result):
    cells = []
    for a in result["advice"]:
        if not a["found"]:
            cells.append("none")
        else:
            cells.append(f"{a['elements_per_radius']:g} x {a['replicates']}{' (beyond)' if has_limit(result) and a['cost_estimated'] else ''}: {a['cpu_s']:.2g} s")
    return cells


def summary(cases):
    rows = []
    for one, results in cases:
        for rule, result in zip(("own strain", "length"), results):
            rung = next(r for r in result["meshes"] if r["elements_per_radius"] == DEFAULT_MESH)
            band = off(result, rung)
            rows.append([one.name, rule, in_radii(one, rung), f"{signed(band.get('value'))} ({interval(band)})", f"{rung['replicates'] * rung['cpu_s']:.2g}", *advice(result)])
    return table(["scene", "erosion by", f"depth on {DEFAULT_MESH}, radii", "off there, %", "CPU s", "for 5 %", "for 2 %", "for 1 %"], rows)


def beside_the_thesis(results):
    """The thesis's meshes have 42 and 50 elements per radius."""
    local, averaged = results
    ten, band = local["convergence"]["spread_of_a_run"], averaged["meshes"][-1]["error"] or {}
    two = ten * ((DEFAULT_MESH / 42) ** 2 + (DEFAULT_MESH / 50) ** 2) ** 0.5
    return f"""The thesis finds 2.41 % between 204,750 and 288,750 elements, one run each: 42 and 50 elements per radius. The ladder ends before, so that no run of its own stands beside that. From mesh to mesh the means here move by
{moves(local, DEFAULT_MESH)} by the element's own strain. The difference of two single runs on 42 and 50 has a standard deviation of {percent(two)} from the
mesh phase, if a run's {percent(ten)} on {DEFAULT_MESH} goes on falling as the element; 2.41 % is {0.0241 / two:.1f} of these. What it says of the error is nothing: without a length there is no depth to be off from. Over {LENGTH} radii the mesh of
{averaged['meshes'][-1]['elements_per_radius']:g} is {signed(band.get('value'))} % from its limit ({interval(band)} %).
"""


# The figure: of each scene the distance of every mesh against its cost.

def panel(one, results):
    blocks, plots = "", []
    for rule, (result, name) in enumerate(zip(results, ("own strain, from the finest", "length, from h = 0"))):
        points = [(r["cpu_s"] * r["replicates"], *(100 * band[key] for key in ("value", "low", "high"))) for r in result["meshes"] if (band := off(result, r)) and None not in band.values()]
        if not points:
            continue
        blocks += data_block(f"{one.name}{rule}", points)
        plots.append(f"${one.name}{rule} using 1:2:3:4 with yerrorlines linecolor {rule + 1} pointtype {7 - 2 * rule} pointsize 0.6 title '{name if one.name == 'P' else ''}'")
    return f"{blocks}set title '{one.name}'\nplot 0 linecolor 'gray' notitle, {', '.join(plots)}\n"


def figure(cases, file):
    draw(file, "set multiplot layout 2,3\nset logscale x\nset format x '10^{%T}'\nset yrange [-18:18]\nset key bottom right samplen 2 font ',9'\nset xlabel 'CPU s of five runs'\nset ylabel 'off, %'\n"
         + "".join(panel(*pair) for pair in cases) + "unset multiplot\n", "1080,640", 12)


def page(program):
    cases = [(one, [study(program, one, rule) for rule in (0, 1)]) for one in CASES]
    figure(cases, figures_of(program.options.page) / FIGURE)
    sections = [section(one, results) + ("\n" + beside_the_thesis(results) if one.name == "D" else "") for one, results in cases]
    return f"""# Error against processor time

Written by `docs/verification/make_error_vs_time.py` from `percal study SCENE --error-vs-time` ({program.machine()}, one thread). Six scenes, each with erosion by the element's own strain and over a length of
{LENGTH} radii. Depths are means of five runs over the mesh phase with their standard errors, columns grow by at most 1.2 on every mesh, walls are where the
program puts them (5 radii, 12 for F and U). What the errors mean: [theory/errors.md](../theory/errors.md).

By the element's own strain depths have no limit: what is off is the distance from the finest mesh of the ladder, which is no better than the others, and the setting for an error is how many runs the phase needs on
{DEFAULT_MESH} elements per radius. Over the length it is the error against the depth at h = 0 of that length, and the setting is the cheapest mesh x runs. Intervals are of 95 %.

{summary(cases)}

![Distance of each mesh against its cost](../figures/{FIGURE})

""" + "\n".join(sections)


if __name__ == "__main__":
    write_page(command_line(__doc__, "error_vs_time.md"), page)
