"""Draws docs/figures/skin.svg and writes docs/verification/guha2009_skin.md from an identification's result:

    percal identify data/guha2009/skin.toml --out skin.out
    python3 docs/figures/make.py skin.out/result.json

Needs gnuplot for the figure.
"""
import json
import pathlib
import subprocess
import sys

DOCS = pathlib.Path(__file__).resolve().parent.parent


def number(value, digits=4):
    return "-" if value is None else f"{value:.{digits}g}"


def markdown(table):
    lines = [f"### {table['name']}", "", f"| | unit | {table['reference']} | percal | difference | error | |", "| --- | --- | --- | --- | --- | --- | --- |"]
    for row in table["rows"]:
        difference = "-" if row["difference"] is None else f"{100 * row['difference']:+.1f} %"
        lines.append(f"| {row['what']} | {row['unit'] or '-'} | {number(row['reference'])} | {number(row['ours'])} | {difference} | "
                     f"{number(row['error'], 2)} | {row['remark']} |")
    if table["mean_difference"] is not None and len(table["rows"]) > 2:
        lines += ["", f"Mean of the differences' sizes: {100 * table['mean_difference']:.1f} %."]
    if table["note"]:
        lines += ["", table["note"][0].upper() + table["note"][1:] + "."]
    return "\n".join(lines) + "\n"


def page(result):
    cost = result["cost"]
    head = f"""# Guha 2009: the chain from gelatin shots to skin

Written by `docs/figures/make.py` from the result of `percal identify data/guha2009/skin.toml` (percal {result['percal']}, {result['isa']}). Evaluations: {cost['runs']} run
and {cost['reused']} from the store. The figures differ in their last digits between instruction levels, and by the scatter given beside them.

"""
    findings = "\n".join(f"- {finding[0].upper() + finding[1:]}" for finding in result["findings"])
    steps = "\n".join(markdown(table) for table in result["steps"])
    tables = "\n".join(markdown(table) for table in result["tables"])
    means = "\n".join(
        f"| {m['system']} | {m['target_density_kg_m3']:g} | {number(m['mean_deviation_from_measured'] and 100 * m['mean_deviation_from_measured'], 3)} | "
        f"{number(m['mean_deviation_from_thesis_fe'] and 100 * m['mean_deviation_from_thesis_fe'], 3)} |" for m in result["prediction_means"])
    return (head + "![The ridge, and the nine gold cases](../figures/skin.svg)\n\n## What to know first\n\n" + findings
            + "\n\n## Predictions, mean deviation in per cent\n\n| system | kg/m3 | from the measured depths | from the thesis's finite elements |\n"
            + "| --- | --- | --- | --- |\n" + means + "\n\n## The steps of the chain\n\n" + steps + "\n## Published tables recomputed\n\n" + tables)


def figure(result):
    ridge = [r for r in result["ridge"] if r["mu_as_given_Pa"] is not None]
    theirs = "\n".join(f"{r['erosion_strain']} {r['table_mu_as_given_Pa'] / 1e6}" for r in ridge if "table_mu_as_given_Pa" in r)
    ours = "\n".join(f"{r['erosion_strain']} {r['mu_as_given_Pa'] / 1e6} {r['mu_as_given_Pa'] / 1e6 * (r['relative_error_solver'] ** 2 + r['relative_error_data'] ** 2) ** 0.5}"
                     for r in ridge)
    gold = [p for p in result["predictions"] if p["system"] == "gold into skin, printed pair" and p["depth_m"] is not None]
    percal = "\n".join(f"{p['measured_m'] * 1e6} {p['depth_m'] * 1e6} {p['depth_spread_m'] * 1e6}" for p in gold)
    thesis = "\n".join(f"{p['measured_m'] * 1e6} {p['thesis_fe_m'] * 1e6}" for p in gold)
    script = f"""
set terminal svg size 900,420 font "sans,13" background rgb "white"
set output "{DOCS / 'figures' / 'skin.svg'}"
set multiplot layout 1,2 margins 0.09,0.98,0.17,0.88 spacing 0.1
set border 3 lw 0.8
set tics nomirror out
$theirs << EOD
{theirs}
EOD
$ours << EOD
{ours}
EOD
$percal << EOD
{percal}
EOD
$thesis << EOD
{thesis}
EOD
set title "Modulus and erosion strain that give 26 um"
set xlabel "erosion strain, engineering"
set ylabel "shear modulus as given, MPa"
set logscale y
set yrange [8:70]
set ytics (10,20,30,40,60)
set xrange [0.25:0.85]
set key top right samplen 1.5
plot $ours using 1:2:3 with yerrorbars pt 7 ps 0.8 lc rgb "#1b6ca8" title "percal", $ours using 1:2 with lines lc rgb "#1b6ca8" notitle, \\
     $theirs using 1:2 with points pt 6 ps 1.1 lw 1.5 lc rgb "#c8553d" title "Guha 2009 (LS-DYNA)"
unset logscale y
set title "Gold into skin, nine cases"
set xlabel "measured depth, um"
set ylabel "computed depth, um"
set xrange [0:40]
set yrange [0:40]
set ytics 10
set key bottom right
plot x with lines lc rgb "#999999" dt 2 notitle, $percal using 1:2:3 with yerrorbars pt 7 ps 0.8 lc rgb "#1b6ca8" title "percal", \\
     $thesis using 1:2 with points pt 6 ps 1.1 lw 1.5 lc rgb "#c8553d" title "Guha 2009 (LS-DYNA)"
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


if __name__ == "__main__":
    data = json.loads(pathlib.Path(sys.argv[1]).read_text())
    figure(data)
    (DOCS / "verification" / "guha2009_skin.md").write_text(page(data))
