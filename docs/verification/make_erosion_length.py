"""Writes docs/verification/erosion_length.md from the results of four jobs: gold in skin and balls in gelatin, each with an erosion length and without.

    python3 docs/verification/make_erosion_length.py --jobs FOLDER       # writes the two jobs without: local_gold.toml, local_gelatin.toml
    percal calibrate FOLDER/local_gold.toml --threads 1                  # likewise local_gelatin.toml, and from data/guha2009 gold_length.toml and gelatin_length.toml
    python3 docs/verification/make_erosion_length.py local_gold.out/result.json gold_length.out/result.json local_gelatin.out/result.json gelatin_length.out/result.json
"""
import argparse
import json
import math
import pathlib
import re
import statistics

from harness import PAGES, THESIS, number, percent, processor, table
from make_calibration import interval, mean_deviation, pressure

LOCAL_MESH = 10  # elements per radius of the jobs without a length


def without_length(job):
    """The text of a job in data/guha2009 with neither the parameter nor the materials' key, on a mesh of elements per radius; tables by their full names."""
    job, parameters = re.subn(r"\[parameters\.erosion_length\].*?\n\n", "", job, flags=re.S)
    job, keys = re.subn(r'^erosion_length = .*\n', "", job, flags=re.M)
    job, meshes = re.subn(r"^(coarse|fine|verify) = .*", rf"\1 = {LOCAL_MESH}", job, flags=re.M)
    assert (parameters, keys, meshes) == (1, 1, 3)
    job = re.sub(r"^# .*\n", "", job, flags=re.M)
    return re.sub(r'^file = "', f'file = "{THESIS}/', job, flags=re.M).replace(", with an erosion length", "").replace("four elements in the length", f"{LOCAL_MESH} elements per radius")


def write_jobs(folder):
    for name in ("gold", "gelatin"):
        (folder / f"local_{name}.toml").write_text(without_length((THESIS / f"{name}_length.toml").read_text()))


def only(result):
    """The one hypothesis of a result."""
    (hypothesis,) = result["hypotheses"]
    return hypothesis


def left_out(model):
    return model["leave_one_out"][0]["prediction"]["mean_deviation"]


def aicc(model):
    """Of ln depth over all fitted shots; the scatter counts as a number too."""
    squares = [math.log1p(shot["deviation"]) ** 2 for shot in model["shots"] if shot["fitted"]]
    n, k = len(squares), len(model["parameters"]) + 1
    return f"{n * math.log(statistics.mean(squares)) + 2 * k + 2 * k * (k + 1) / (n - k - 1):.1f}"


def length_of(hypothesis):
    return next((p for p in hypothesis["parameters"] if "value_m" in p), None)


def length_words(metres):
    return f"{1e6 * metres:.3g} um" if metres < 1e-4 else f"{1e3 * metres:.3g} mm"


def rule_row(data, rule, hypothesis):
    length = length_of(hypothesis)
    return [data, rule, len(hypothesis["parameters"]), percent(mean_deviation(hypothesis["shots"])), percent(hypothesis["fresh_mean_deviation"]),
            percent(left_out(hypothesis)), aicc(hypothesis),
            f"{length_words(length['value_m'])} ({interval(length, length_words)}), {'known' if length['identifiable'] else 'cannot be known'}" if length else "-"]


def dehn_row(data, result):
    dehn = result["dehn"]
    return [data, "Dehn's closed form", len(dehn["parameters"]), percent(mean_deviation(dehn["shots"])), "-", percent(left_out(dehn)), aicc(dehn), "-"]


def rows(data, local, length):
    return [rule_row(data, "each element by itself", only(local)), rule_row(data, "over a length", only(length)), dehn_row(data, length)]


def size_rows(local, length):
    """Mean signed deviations of the shots of each size, each predicted from all others."""
    shots = length["data"]["shots"]
    models = [only(local), only(length), length["dehn"]]
    for radius in sorted({shot["radius_m"] for shot in shots}):
        def mean(model):
            return statistics.mean(s["deviation"] for s in model["leave_one_out"][0]["shots"] if shots[s["shot"]]["radius_m"] == radius)
        yield [length_words(radius), sum(shot["radius_m"] == radius for shot in shots), *(percent(mean(model), "+.1f") for model in models)]


def cross_rows(local, length):
    for ours, theirs, closed in zip(only(local)["cross_validations"], only(length)["cross_validations"], length["dehn"]["cross_validations"]):
        yield [ours["name"], *(percent(one["prediction"]["mean_deviation"]) for one in (ours, theirs, closed))]


def parameter_rows(results):
    for name, result in results:
        for p in only(result)["parameters"]:
            key = next(k for k in p if k.startswith("value"))
            show = {"value_Pa": pressure, "value_m": length_words}.get(key, number)
            yield [name, p["name"], show(p[key]), interval(p, show), "yes" if p["identifiable"] else "no"]


def cost_rows(results):
    for name, result in results:
        emulator, meshes = result["emulator"], [run["elements_per_radius"] for run in only(result)["fresh_runs"]]
        yield [name, emulator["rounds"][-1]["runs"], percent(emulator["leave_one_out_error"]), percent(emulator["settings"]["noise"] if not emulator["settings"]["mesh_amplitude"] else None),
               percent(emulator["error_at_optimum"]), f"{min(meshes):.3g} to {max(meshes):.3g}", f"{emulator['rounds'][-1]['cpu_s']:.0f}", f"{result['cost']['cpu_s']:.0f}"]


def page(gold, gold_length, gelatin, gelatin_length):
    results = [("gold", gold), ("gold, length", gold_length), ("gelatin", gelatin), ("gelatin, length", gelatin_length)]
    three = ["each element by itself", "over a length", "Dehn"]
    return f"""# An erosion length fitted

Written by docs/verification/make_erosion_length.py from the results of four jobs, two of them in data/guha2009. What the columns mean: docs/formats/calibrate.md, docs/theory/calibration.md (22); what follows from it: docs/decisions/0016.

The nine gold points of skin and the 24 shots into 12 wt% gelatin, mu and the erosion strain free, alpha held at 8.5. With a length it is free too and the same for spheres of all sizes, on meshes with four elements in it for all sizes; without one
the meshes have {LOCAL_MESH} elements per radius for all sizes. Mean |deviation| of the fitted depths by the emulator, by fresh runs at the best point (means of three over the mesh phase), and of each shot predicted from all others. AICc is that of ln depth, lower is better; differences of a few mean nothing.

{table(["data", "erosion judged", "free numbers", "fitted", "fresh runs", "each left out", "AICc", "length (95 %)"], rows("gold, 9 shots", gold, gold_length) + rows("gelatin, 24 shots", gelatin, gelatin_length))}

## Is there a size effect?

Mean signed deviation of the shots of each size, each predicted from all others. A model that misses a size effect has a trend here.

Gold:

{table(["radius", "shots", *three], size_rows(gold, gold_length))}

Gelatin:

{table(["radius", "shots", *three], size_rows(gelatin, gelatin_length))}

Gelatin, mean |deviation| of what is predicted from what:

{table(["", *three], cross_rows(gelatin, gelatin_length))}

## Parameters

{table(["job", "parameter", "best", "95 % (profile)", "can be known"], parameter_rows(results))}

## Cost

On one mesh the noise of a run carries the mesh phase. Processor time on {processor()}, {gold["cost"]["isa"]}, one thread.

{table(["job", "runs learnt from", "leave one out", "noise of a run", "emulator's error at the optimum", "elements per radius at the best point", "CPU s, training", "CPU s, all"], cost_rows(results))}
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", nargs="*", type=pathlib.Path, help="of gold, gold with a length, gelatin, gelatin with a length")
    parser.add_argument("--jobs", type=pathlib.Path, help="write the jobs without a length into this folder, and nothing else")
    parser.add_argument("--page", type=pathlib.Path, default=PAGES / "erosion_length.md", help="file to write")
    options = parser.parse_args()
    if options.jobs:
        write_jobs(options.jobs)
    elif len(options.results) == 4:
        options.page.write_text(page(*(json.loads(file.read_text()) for file in options.results)))
    else:
        parser.error("four results, or --jobs FOLDER")


if __name__ == "__main__":
    main()
