"""Writes docs/verification/relaxation.md from simulated tests and from muscle (a minute):

    python3 docs/verification/make_relaxation.py build/release/percal build/release/tests/fit_test
"""
import json
import pathlib
import re
import tempfile

from harness import ROOT, Program, command_line, number, output, processor, table

MUSCLE = ROOT / "data" / "public" / "vanloocke2008_muscle_rates.csv"
TRUTH = {"mu_0": "20 kPa", "mu_inf": "7 kPa", "alpha": "5", "g_1": "0.4", "tau_1": "0.5 s", "g_2": "0.25", "tau_2": "20 s"}
SUITE = "SlowRelaxationCoverage.*"


def coverage(test, folder):
    """How many of 100 intervals held the truth, by parameter; the seed is the test's."""
    report = folder / "coverage.json"
    output([test, f"--gtest_filter={SUITE}", f"--gtest_output=json:{report}"], folder)
    run = json.loads(report.read_text())["testsuites"][0]["testsuite"][0]
    return {name: int(run[name]) for name in TRUTH}, run["time"]


def interval(parameter):
    low, high = (number(parameter[end], ".3g") for end in ("low", "high"))
    return f"{'<= ' if parameter['low_open'] else ''}{low} to {'>= ' if parameter['high_open'] else ''}{high}"


def muscle(program, direction):
    found = program.ask("fit", MUSCLE, "--mode", "compression", "--where", f"direction={direction}", "--relaxation", "3")
    chosen = program.ask("fit", MUSCLE, "--mode", "compression", "--where", f"direction={direction}", "--relaxation", "auto")
    rungs = [[str(rung["terms"]), number(rung["r2"], ".3f"), number(rung["aicc_above_lowest"], ".1f")] for rung in found["relaxation"]["rungs"]]
    parameters = chosen["relaxation"]["uncertainty"]["parameters"]
    values = [[key, number(parameters[key]["value"], ".4g"), interval(parameters[key]), "yes" if parameters[key]["identifiable"] else "no"]
              for key in chosen["relaxation"]["uncertainty"]["order"]]
    correlation = chosen["relaxation"]["uncertainty"]["neighbour_correlation"]
    return f"""## Muscle, {direction}

{table(["terms", "R2", "AICc above the lowest"], rungs)}

{table(["of the chosen one", "value (SI)", "95 % interval", "told"], values)}

Correlation of neighbouring residuals: {correlation:.2f}. {chosen["cost"]["cpu_s"]:.1f} s of processor time.
"""


def main():
    parser = command_line(__doc__, "relaxation.md", "program", "test")
    options = parser.parse_args()
    options.store = None
    test = pathlib.Path(options.test).resolve()
    seed = re.search(r"relaxation_seed = (\d+)", (ROOT / "tests" / "fit" / "fit_relaxation_test.cpp").read_text())[1]
    with tempfile.TemporaryDirectory() as folder:
        program = Program(options, pathlib.Path(folder))
        held, seconds = coverage(test, pathlib.Path(folder))
        rows = [[name, truth, f"{held[name]} of 100"] for name, truth in TRUTH.items()]
        options.page.write_text(f"""# Relaxation

Made by make_relaxation.py. The equations are those of [theory/relaxation.md](../theory/relaxation.md).

## How often intervals hold the truth

100 simulated sets of three uniaxial ramps to stretch 0.7 at 1, 0.1 and 0.01 1/s, each held for 100 s (50 rows a test), of a solid with two terms; 2 % of each stress as noise, seed {seed} on, relative residuals,
`fit_test --gtest_filter='{SUITE}'`, {seconds}. Chance scatters 95 of 100 by 2.2.

{table(["parameter", "truth", "held"], rows)}

{muscle(program, "fibre")}
{muscle(program, "cross-fibre")}
What these say is in [how-to/relaxation.md](../how-to/relaxation.md).

Version {program.version}, {processor()}.
""")


if __name__ == "__main__":
    main()
