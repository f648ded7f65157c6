"""Draws docs/figures/skin.svg and writes docs/verification/guha2009_skin.md from an identification's result:

    percal identify data/guha2009/skin.toml --out skin.out
    python3 docs/figures/make.py skin.out/result.json

Needs gnuplot for the figure.
"""
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "verification"))
from harness import command_line, data_block, draw, figures_of, in_percent, number, percent, table  # noqa: E402


def comparison(found):
    rows = [[row["what"], row["unit"] or "-", row["reference"], row["ours"], percent(row["difference"], "+.1f"), number(row["error"], ".2g"), row["remark"]] for row in found["rows"]]
    lines = [f"### {found['name']}", "", table(["", "unit", found["reference"], "percal", "difference", "error", ""], rows)]
    if found["mean_difference"] is not None and len(rows) > 2:
        lines += ["", f"Mean of the differences' sizes: {percent(found['mean_difference'])}."]
    if found["note"]:
        lines += ["", capital(found["note"]) + "."]
    return "\n".join(lines) + "\n"


def capital(sentence):
    return sentence[0].upper() + sentence[1:]


def page(result):
    cost = result["cost"]
    head = f"""# Guha 2009: the chain from gelatin shots to skin

Written by `docs/figures/make.py` from the result of `percal identify data/guha2009/skin.toml` (percal {result['percal']}, {cost['isa']}). {cost['runs'] + cost['reused']}
evaluations. The figures differ in their last digits between instruction levels, and by the scatter given beside them.

"""
    findings = "\n".join(f"- {capital(finding)}" for finding in result["findings"])
    means = table(["system", "kg/m3", "from the measured depths", "from the thesis's finite elements"],
                  [[m["system"], f"{m['target_density_kg_m3']:g}", *(in_percent(m[f"mean_deviation_from_{what}"], ".3g") for what in ("measured", "thesis_fe"))]
                   for m in result["prediction_means"]])
    return f"""{head}![The ridge, and the nine gold cases](../figures/skin.svg)

## What to know first

{findings}

## Predictions, mean deviation in per cent

{means}

## The steps of the chain

{chr(10).join(map(comparison, result["steps"]))}
## Published tables recomputed

{chr(10).join(map(comparison, result["tables"]))}"""


def figure(result, file):
    ridge = [r for r in result["ridge"] if r["mu_as_given_Pa"] is not None]
    gold = [p for p in result["predictions"] if p["system"] == "gold into skin, printed pair" and p["depth_m"] is not None]
    error = lambda r: r["mu_as_given_Pa"] / 1e6 * (r["relative_error_solver"] ** 2 + r["relative_error_data"] ** 2) ** 0.5
    theirs = data_block("theirs", [(r["erosion_strain"], r["table_mu_as_given_Pa"] / 1e6) for r in ridge if "table_mu_as_given_Pa" in r])
    ours = data_block("ours", [(r["erosion_strain"], r["mu_as_given_Pa"] / 1e6, error(r)) for r in ridge])
    percal = data_block("percal", [(p["measured_m"] * 1e6, p["depth_m"] * 1e6, p["depth_spread_m"] * 1e6) for p in gold])
    thesis = data_block("thesis", [(p["measured_m"] * 1e6, p["thesis_fe_m"] * 1e6) for p in gold])
    draw(file, f"""
set multiplot layout 1,2 margins 0.09,0.98,0.17,0.88 spacing 0.1
set border 3 lw 0.8
set tics nomirror out
{theirs}{ours}{percal}{thesis}set title "Modulus and erosion strain that give 26 um"
set xlabel "erosion strain, engineering"
set ylabel "shear modulus as given, MPa"
set logscale y
set yrange [8:70]
set ytics (10,20,30,40,60)
set xrange [0.25:0.85]
set key top right samplen 1.5
plot $ours using 1:2:3 with yerrorbars pt 7 ps 0.8 lc rgb "#0072b2" title "percal", $ours using 1:2 with lines lc rgb "#0072b2" notitle, \\
     $theirs using 1:2 with points pt 6 ps 1.1 lw 1.5 lc rgb "#d55e00" title "Guha 2009 (LS-DYNA)"
unset logscale y
set title "Gold into skin, nine cases"
set xlabel "measured depth, um"
set ylabel "computed depth, um"
set xrange [0:40]
set yrange [0:40]
set ytics 10
set key bottom right
plot x with lines lc rgb "#999999" dt 2 notitle, $percal using 1:2:3 with yerrorbars pt 7 ps 0.8 lc rgb "#0072b2" title "percal", \\
     $thesis using 1:2 with points pt 6 ps 1.1 lw 1.5 lc rgb "#d55e00" title "Guha 2009 (LS-DYNA)"
""", size="900,420")


def main():
    options = command_line(__doc__, "guha2009_skin.md", "result").parse_args()
    result = json.loads(pathlib.Path(options.result).read_text())
    figure(result, figures_of(options.page) / "skin.svg")
    options.page.write_text(page(result))


if __name__ == "__main__":
    main()
