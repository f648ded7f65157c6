"""Writes docs/verification/guha2009.md and its figures: every table and figure of the thesis, printed value beside ours.

    python3 docs/verification/make_guha2009.py build/release/percal

Some ten minutes of processor time from nothing, seconds when the store has the runs. Options: --store FILE for the evaluations (default: the program's
own), --jobs N scenes side by side. Needs gnuplot.
"""
import math
import statistics

from guha2009_figures import Figures
from guha2009_text import HEAD, NOTES
from harness import THESIS, Store, changed, command_line, figures_of, mean_size, number, percent, percent_off, replicates, rows_of, table, um, with_numbers, write_page
from prism_scenes import ball_scene, cm, depth_text, prisms, thesis_scene

ONE, THREE = replicates(1), replicates(3)
MESHES = (7, 10, 14, 20, 28, 42)  # elements per radius of Figure 3-5


def printed(name):
    return with_numbers(rows_of(THESIS / name))


def mean_off(pairs):
    return mean_size([ours / theirs - 1 for ours, theirs in pairs])


def line_through(x, y):
    """Slope, intercept."""
    mx, my = statistics.mean(x), statistics.mean(y)
    slope = sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx) ** 2 for a in x)
    return slope, my - slope * mx


def predictions(result, system, density):
    found = [p for p in result["predictions"] if p["system"] == system and p["target_density_kg_m3"] == density]
    assert found, (system, density)
    return found


def groups_table(scale):
    rows = [[g["symbol"], g["formula"], g["prototype"], g["model"], percent(g["difference"], "+.1f"), g["agreement"]]
            for g in scale["groups"]]
    return table(["group", "formula", "gold, 651 m/s", "steel, 83 m/s", "difference", ""], rows)


def compared(result, *names, only=""):
    """The rows of tables of the result, beside the printed values; those alone whose text starts with `only`."""
    rows = []
    for name in names:
        found = next(t for t in result["tables"] + result["steps"] if t["name"] == name)
        for row in found["rows"]:
            if not row["what"].startswith(only):
                continue
            rows.append([row["what"], row["unit"] or "-", row["reference"], row["ours"], percent_off(row["ours"], row["reference"]), number(row["error"], ".2g")])
    return table(["", "unit", "printed", "percal", "difference", "error"], rows)


def gold_table(result):
    as_printed = predictions(result, "gold into skin, printed pair", 1000.0)
    identified = predictions(result, "gold into skin, identified pair", 1000.0)
    rows = []
    for row, ours, own in zip(printed("gold_skin.csv"), as_printed, identified):
        depth, spread = ours["depth_m"] * 1e6, ours["depth_spread_m"] * 1e6
        rows.append([f"{row['radius_um']:g}", row["velocity_m_s"], row["penetration_um"], row["scaled_um"], row["fe_um"], f"{depth:.2f} ± {spread:.2f}",
                     percent_off(depth, row["fe_um"]), percent_off(depth, row["penetration_um"]), own["depth_m"] * 1e6])
    text = table(["radius, um", "m/s", "measured, um", "scaled (printed)", "LS-DYNA (printed)", "percal, printed pair", "to LS-DYNA", "to measured", "percal, identified pair"], rows)
    mean = lambda ps, key: mean_off([(p["depth_m"], p[key]) for p in ps])
    lsdyna = mean_off([(row["fe_um"], row["penetration_um"]) for row in printed("gold_skin.csv")])
    return text + (f"\n\nMean deviation of percal from LS-DYNA {mean(as_printed, 'thesis_fe_m')}, from the measured depths {mean(as_printed, 'measured_m')}; of LS-DYNA from the "
                   f"measured depths {lsdyna}; with the identified pair {mean(identified, 'measured_m')}. ± is the standard deviation of five runs.")


def shots_table(result):
    rows, light, heavy = [], predictions(result, "gelatin", 464.0), predictions(result, "gelatin", 1010.0)
    for row, a, b in zip(printed("gelatin_shots.csv"), light, heavy):
        ours = [100 * p["depth_m"] for p in (a, b)]
        rows.append([row["material"], f"{row['diameter_corrected_mm']:g}", row["velocity_m_s"], row["penetration_cm"], ours[0], percent_off(ours[0], row["penetration_cm"]),
                     ours[1], percent_off(ours[1], row["penetration_cm"])])
    means = [mean_off([(p["depth_m"], p["measured_m"]) for p in ps]) for ps in (light, heavy)]
    return table(["ball", "diameter, mm", "m/s", "measured, cm", "percal, 464 kg/m3", "", "percal, 1010 kg/m3", ""], rows) + f"\n\nMean deviation {means[0]} and {means[1]}."


def angular(program, prism):
    """Depths of the six shots in the thesis's own domain, three runs each, with the table of them."""
    results = program.impacts([thesis_scene(prism, speed=f'"{shot["velocity_m_s"]:g} m/s"') for shot in prism.shots], *THREE)
    rows = [[shot["velocity_m_s"], shot["penetration_cm"], shot["fe_cm"], depth_text(r), percent_off(cm(r), shot["fe_cm"]), percent_off(cm(r), shot["penetration_cm"])]
            for shot, r in zip(prism.shots, results)]
    means = [mean_off([(cm(r), shot[key]) for shot, r in zip(prism.shots, results)]) for key in ("fe_cm", "penetration_cm")]
    return results, table(["m/s", "measured, cm", "LS-DYNA, cm", "percal, cm", "to LS-DYNA", "to measured"], rows) + f"\n\nMean deviation {means[0]} from LS-DYNA, {means[1]} from the measured depths."


def equal_mass(program, result, square, rhombus):
    computed = program.impacts([thesis_scene(rhombus, speed='"40 m/s"'), thesis_scene(square, speed='"40 m/s"', mass='"0.7027 g"', half_width=5.64 * math.sqrt(0.5),
                                                                                     side='"5.64 mm"'), ball_scene(2.78, 40, 0.7, 464, mould=False)], *THREE)
    lines = next(t for t in result["tables"] if t["name"] == "Table 5-3")["rows"]
    rows = [[row["shape"], row["penetration_cm"], line["ours"], percent_off(line["ours"], row["penetration_cm"]), depth_text(r), percent_off(cm(r), row["penetration_cm"])]
            for row, line, r in zip(printed("angularity.csv"), lines, computed)]
    return table(["shape", "printed, cm", "by the refitted lines, cm", "", "percal by impacts, cm", ""], rows)


def mesh_study(program):
    scene = (THESIS / "mesh_study.toml").read_text()
    at = lambda n: program.impact(changed(scene, ("elements_per_radius = 14", f"elements_per_radius = {n}")), *(THREE if n <= 20 else ONE))
    found = [(n, at(n)) for n in MESHES]
    rows, before = [], None
    for n, r in found:
        rows.append([n, r.elements, um(r.depth), um(r.spread), percent_off(before, r.depth), f"{r.element_steps / 1e6:.0f}"])
        before = r.depth
    return found, table(["elements per radius", "elements", "depth, um", "spread of 3 runs", "the coarser mesh's differs by", "million element-steps a run"], rows)


def page(program):
    result = program.ask("identify", THESIS / "skin.toml", "--out", program.folder, *program.kept(), accepted=(0,))
    scale = program.ask("scale", THESIS / "similar.toml", "--write-scene", program.folder / "model.toml")
    square, rhombus = prisms()
    mesh, mesh_rows = mesh_study(program)
    square_results, square_rows = angular(program, square)
    rhombus_results, rhombus_rows = angular(program, rhombus)
    equal = equal_mass(program, result, square, rhombus)
    figures = Figures(figures_of(program.options.page), line_through)
    figures.mesh(mesh)
    figures.gold(printed("gold_skin.csv"), predictions(result, "gold into skin, printed pair", 1000.0))
    figures.ridge(result["ridge"])
    at_100 = figures.balls(printed("gelatin_shots.csv"), predictions(result, "gelatin", 464.0))
    figures.scaled(printed("gold_skin.csv"))
    figures.prism("guha2009_5_1", "60 degree rhombus", rhombus.shots, rhombus_results)
    figures.prism("guha2009_5_2", "45 degree square", square.shots, square_results)
    text = HEAD.format(machine=program.machine(), alpha=result["alpha"]["value"])
    return text + NOTES.format(
        groups=groups_table(scale), mesh=mesh_rows,
        ridge=compared(result, "Table 4-1, identified modulus", "Table 4-1, modulus of the model system"),
        known=compared(result, "ridge: modulus and erosion strain that give 26 um", only="depth"),
        gelatin=compared(result, "gelatin: modulus against concentration"),
        line=compared(result, "Table 4-3: line through the model's shots"), shots=shots_table(result),
        scaled=compared(result, "Table 4-4, scaled column"), gold=gold_table(result),
        check=compared(result, "similar model system: steel into gelatin", "finite-element check of the model system", "skin"),
        rhombus=rhombus_rows, square=square_rows, lines=compared(result, "Table 5-1, 60 degree rhombus: line", "Table 5-2, 45 degree square: line"),
        equal=equal, at_100=table(["ball", "measured line at 100 m/s, cm", "percal's line at 100 m/s, cm", ""],
                                  [[name, a, b, percent_off(b, a)] for name, a, b in at_100]))


if __name__ == "__main__":
    write_page(command_line(__doc__, "guha2009.md", store=Store.PERCALS, jobs=2), page)
