"""Writes docs/verification/guha2009.md and its figures: every table and figure of the thesis, printed value beside ours.

    python3 docs/verification/make_guha2009.py build/release/percal

Some ten minutes of processor time from nothing, seconds when the store has the runs. Options: --store FILE for the evaluations (default: the program's
own), --jobs N scenes side by side. Needs gnuplot.
"""
import argparse
import csv
import json
import math
import pathlib
import statistics
import subprocess
import tempfile

from guha2009_figures import Figures
from guha2009_text import HEAD, NOTES
from machine import processor
from make_prisms import Program, ball_scene, cm, depth_text, prisms, thesis_scene

DOCS = pathlib.Path(__file__).resolve().parent.parent
DATA = DOCS.parent / "data" / "guha2009"
MESHES = (7, 10, 14, 20, 28, 42)  # elements per radius of Figure 3-5


def rows_of(name):
    with open(DATA / name, newline="") as file:
        return [{key: number_or_text(value) for key, value in row.items()} for row in csv.DictReader(line for line in file if not line.startswith("#"))]


def number_or_text(text):
    try:
        return float(text)
    except ValueError:
        return text


def table(header, rows):
    text = lambda cell: cell if isinstance(cell, str) else "-" if cell is None else f"{cell:.4g}"
    return "\n".join(["| " + " | ".join(header) + " |", "| " + " | ".join(["---"] * len(header)) + " |"]
                     + ["| " + " | ".join(text(cell) for cell in row) + " |" for row in rows]) + "\n"


def percent(ours, theirs):
    return "-" if ours is None or not theirs else f"{100 * (ours / theirs - 1):+.1f} %"


def mean_size(pairs):
    return f"{100 * statistics.mean(abs(ours / theirs - 1) for ours, theirs in pairs):.1f} %"


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
    rows = [[g["symbol"], g["formula"], g["prototype"], g["model"], "-" if g["difference"] is None else f"{100 * g['difference']:+.1f} %", g["agreement"]]
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
            error = "-" if row["error"] is None else f"{row['error']:.2g}"
            rows.append([row["what"], row["unit"] or "-", row["reference"], row["ours"], percent(row["ours"], row["reference"]), error])
    return table(["", "unit", "printed", "percal", "difference", "error"], rows)


def gold_table(result):
    printed = predictions(result, "gold into skin, printed pair", 1000.0)
    identified = predictions(result, "gold into skin, identified pair", 1000.0)
    rows = []
    for row, ours, own in zip(rows_of("gold_skin.csv"), printed, identified):
        depth, spread = ours["depth_m"] * 1e6, ours["depth_spread_m"] * 1e6
        rows.append([f"{row['radius_um']:g}", row["velocity_m_s"], row["penetration_um"], row["scaled_um"], row["fe_um"], f"{depth:.2f} ± {spread:.2f}",
                     percent(depth, row["fe_um"]), percent(depth, row["penetration_um"]), own["depth_m"] * 1e6])
    text = table(["radius, um", "m/s", "measured, um", "scaled (printed)", "LS-DYNA (printed)", "percal, printed pair", "to LS-DYNA", "to measured", "percal, identified pair"], rows)
    mean = lambda ps, key: mean_size([(p["depth_m"], p[key]) for p in ps])
    lsdyna = mean_size([(row["fe_um"], row["penetration_um"]) for row in rows_of("gold_skin.csv")])
    return text + (f"\nMean deviation of percal from LS-DYNA {mean(printed, 'thesis_fe_m')}, from the measured depths {mean(printed, 'measured_m')}; of LS-DYNA from the "
                   f"measured depths {lsdyna}; with the identified pair {mean(identified, 'measured_m')}. ± is the standard deviation of three runs.\n")


def shots_table(result):
    rows, light, heavy = [], predictions(result, "gelatin", 464.0), predictions(result, "gelatin", 1010.0)
    for row, a, b in zip(rows_of("gelatin_shots.csv"), light, heavy):
        ours = [100 * p["depth_m"] for p in (a, b)]
        rows.append([row["material"], f"{row['diameter_corrected_mm']:g}", row["velocity_m_s"], row["penetration_cm"], ours[0], percent(ours[0], row["penetration_cm"]),
                     ours[1], percent(ours[1], row["penetration_cm"])])
    means = [mean_size([(p["depth_m"], p["measured_m"]) for p in ps]) for ps in (light, heavy)]
    return table(["ball", "diameter, mm", "m/s", "measured, cm", "percal, 464 kg/m3", "", "percal, 1010 kg/m3", ""], rows) + f"\nMean deviation {means[0]} and {means[1]}.\n"


def angular(program, prism):
    """Depths of the six shots in the thesis's own domain, three runs each, with the table of them."""
    results = program.impacts([thesis_scene(prism, speed=f'"{shot["velocity_m_s"]:g} m/s"') for shot in prism.shots], 3)
    rows = [[shot["velocity_m_s"], shot["penetration_cm"], shot["fe_cm"], depth_text(r), percent(cm(r), shot["fe_cm"]), percent(cm(r), shot["penetration_cm"])]
            for shot, r in zip(prism.shots, results)]
    means = [mean_size([(cm(r), shot[key]) for shot, r in zip(prism.shots, results)]) for key in ("fe_cm", "penetration_cm")]
    return results, table(["m/s", "measured, cm", "LS-DYNA, cm", "percal, cm", "to LS-DYNA", "to measured"], rows) + f"\nMean deviation {means[0]} from LS-DYNA, {means[1]} from the measured depths.\n"


def equal_mass(program, result, square, rhombus):
    computed = program.impacts([thesis_scene(rhombus, speed='"40 m/s"'), thesis_scene(square, speed='"40 m/s"', mass='"0.7027 g"', half_width=5.64 * math.sqrt(0.5),
                                                                                     side='"5.64 mm"'), ball_scene(2.78, 40, 0.7, 464, mould=False)], 3)
    lines = next(t for t in result["tables"] if t["name"] == "Table 5-3")["rows"]
    rows = [[row["shape"], row["penetration_cm"], line["ours"], percent(line["ours"], row["penetration_cm"]), depth_text(r), percent(cm(r), row["penetration_cm"])]
            for row, line, r in zip(rows_of("angularity.csv"), lines, computed)]
    return table(["shape", "printed, cm", "by the refitted lines, cm", "", "percal by impacts, cm", ""], rows)


def mesh_study(program):
    scene = (DATA / "mesh_study.toml").read_text()
    at = lambda n: program.impact(scene.replace("elements_per_radius = 14", f"elements_per_radius = {n}"), 3 if n <= 20 else 1)
    found = [(n, at(n)) for n in MESHES]
    rows, before = [], None
    for n, r in found:
        depth, spread = r["depth_m"] * 1e6, r["depth_spread_m"]
        rows.append([str(n), str(r["elements"]), f"{depth:.2f}", "-" if spread is None else f"{spread * 1e6:.2f}", percent(before, depth) if before else "-", f"{r['element_steps'] / 1e6:.0f}"])
        before = depth
    return found, table(["elements per radius", "elements", "depth, um", "spread of 3 runs", "the coarser mesh's differs by", "million element-steps a run"], rows)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("percal")
    parser.add_argument("--store", default="")
    parser.add_argument("--jobs", type=int, default=2)
    arguments = parser.parse_args()
    store = ["--store", arguments.store] if arguments.store else []

    def ask(*words):
        done = subprocess.run([arguments.percal, *words, "--json"], capture_output=True, text=True, check=True)
        return json.loads(done.stdout)

    with tempfile.TemporaryDirectory() as folder:
        result = ask("identify", str(DATA / "skin.toml"), "--out", folder, *store)
        scale = ask("scale", str(DATA / "similar.toml"), "--write-scene", folder + "/model.toml")
        program = Program(arguments.percal, arguments.store, folder, arguments.jobs)
        square, rhombus = prisms()
        mesh, mesh_rows = mesh_study(program)
        square_results, square_rows = angular(program, square)
        rhombus_results, rhombus_rows = angular(program, rhombus)
        equal = equal_mass(program, result, square, rhombus)
    figures = Figures(DOCS / "figures", line_through)
    figures.mesh(mesh)
    figures.gold(rows_of("gold_skin.csv"), predictions(result, "gold into skin, printed pair", 1000.0))
    figures.ridge(result["ridge"])
    at_100 = figures.balls(rows_of("gelatin_shots.csv"), predictions(result, "gelatin", 464.0))
    figures.scaled(rows_of("gold_skin.csv"))
    figures.prism("guha2009_5_1", "60 degree rhombus", rhombus.shots, rhombus_results)
    figures.prism("guha2009_5_2", "45 degree square", square.shots, square_results)
    text = HEAD.format(version=result["percal"], isa=result["isa"], machine=processor(), alpha=result["alpha"]["value"])
    filled = NOTES.format(
        groups=groups_table(scale), mesh=mesh_rows,
        ridge=compared(result, "Table 4-1, identified modulus", "Table 4-1, modulus of the model system"),
        known=compared(result, "ridge: modulus and erosion strain that give 26 um", only="depth"),
        gelatin=compared(result, "gelatin: modulus against concentration"),
        line=compared(result, "Table 4-3: line through the model's shots"), shots=shots_table(result),
        scaled=compared(result, "Table 4-4, scaled column"), gold=gold_table(result),
        check=compared(result, "similar model system: steel into gelatin", "finite-element check of the model system", "skin"),
        rhombus=rhombus_rows, square=square_rows, lines=compared(result, "Table 5-1, 60 degree rhombus: line", "Table 5-2, 45 degree square: line"),
        equal=equal, at_100=table(["ball", "measured line at 100 m/s, cm", "percal's line at 100 m/s, cm", ""],
                                  [[name, a, b, percent(b, a)] for name, a, b in at_100]))
    (DOCS / "verification" / "guha2009.md").write_text(text + filled)


if __name__ == "__main__":
    main()
