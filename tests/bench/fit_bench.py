"""Writes docs/verification/fit_speed.md: percal's curve fits beside SciPy's least_squares, in a process and as one.

    cmake --build build/release --target fit_bench percal_program
    python3 tests/bench/fit_bench.py build/release [--python PYTHON] [--page PAGE]

PYTHON is a Python with SciPy (default: the one that runs this); without SciPy its columns stay empty. Everything runs on one thread.
"""
import datetime
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs" / "verification"))
from harness import Failed, command_line, output, processor, table  # noqa: E402

PROCESSES = 11
ONE_THREAD = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}

# What SciPy does with the same file: the same objective over (ln mu, alpha), with the derivatives written out. `one start` begins at alpha = 2;
# `same search` scans alpha at 801 values with mu solved for, as percal does, and starts from every minimum of the scan.
SCIPY = r'''
import csv, json, statistics, sys, time
import numpy as np
from scipy.optimize import least_squares
rows = list(csv.DictReader(open(sys.argv[1])))
x = np.array([float(r["stretch"]) for r in rows])
y = np.array([float(r["stress_Pa"]) for r in rows])

def shape(a):
    return 2 / a * (x**a - x**(-a / 2)) / x

def residual(p):
    return np.exp(p[0]) * shape(p[1]) / y - 1

def jacobian(p):
    a, mu, l = p[1], np.exp(p[0]), np.log(x)
    f = shape(a)
    by_alpha = -f / a + 2 / a * (x**a * l + x**(-a / 2) * l / 2) / x
    return np.stack([mu * f / y, mu * by_alpha / y], axis=1)

def solve(a):
    f = shape(a)
    mu = np.sum(f / y) / np.sum((f / y)**2)
    return mu, np.sum((mu * f / y - 1)**2)

def refine(mu, a):
    return least_squares(residual, [np.log(mu), a], jacobian, xtol=1e-13, ftol=1e-15, gtol=1e-14)

def one_start():
    return refine(solve(2.0)[0], 2.0)

def same_search():
    grid = [0.1 * (i - 400) or 1e-6 for i in range(801)]
    with np.errstate(all="ignore"):
        found = [solve(a) for a in grid]
    s = [v if mu > 0 and np.isfinite(v) else np.inf for mu, v in found]
    starts = [i for i in range(801) if s[i] < np.inf and s[i] < min(s[max(i - 1, 0):i] + s[i + 1:i + 2])]
    return min((refine(found[i][0], grid[i]) for i in starts), key=lambda r: r.cost)

def milliseconds(call):
    each, start = [], time.process_time()
    while len(each) < 201 and time.process_time() - start < 1:
        before = time.process_time()
        call()
        each.append(1e3 * (time.process_time() - before))
    return statistics.median(each)

if sys.argv[2:] == ["once"]:
    same_search()
else:
    best = same_search()
    print(json.dumps({"one_start_ms": milliseconds(one_start), "same_search_ms": milliseconds(same_search), "mu_Pa": float(np.exp(best.x[0])),
                      "alpha": float(best.x[1]), "objective": float(2 * best.cost)}))
'''


def process_ms(command):
    """Median processor time of a process, milliseconds, start and end included."""
    each = []
    for _ in range(PROCESSES):
        child = subprocess.Popen(command, stdout=subprocess.DEVNULL, env={**os.environ, **ONE_THREAD})
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        if child.returncode != 0:
            raise subprocess.CalledProcessError(child.returncode, command)
        each.append(1e3 * (usage.ru_utime + usage.ru_stime))
    return statistics.median(each)


def scipy_version(python):
    try:
        return output([python, "-c", "import scipy; print(scipy.__version__)"]).strip()
    except Failed:
        return None


def measure(build, python, with_scipy, folder):
    bench, percal = str(build / "tests/bench/fit_bench"), str(build / "percal")
    script = folder / "scipy_fit.py"
    script.write_text(SCIPY)
    rows = []
    for row in json.loads(output([bench], environment=ONE_THREAD)):
        curve = folder / f"curve_{row['points']}.csv"
        curve.write_text(output([bench, "csv", row["points"]]))
        row["process_ms"] = process_ms([percal, "fit", str(curve), "--json"])
        row["bare_process_ms"] = process_ms([percal, "fit", str(curve), "--json", "--no-intervals"])
        if with_scipy:
            row["scipy"] = json.loads(output([python, script, curve], environment=ONE_THREAD))
            row["scipy"]["process_ms"] = process_ms([python, str(script), str(curve), "once"])
        rows.append(row)
    start = {"percal": process_ms([percal, "--version"])}
    if with_scipy:
        start["scipy"] = process_ms([python, "-c", "import numpy, scipy.optimize"])
    return rows, start


def page(rows, start, version):
    def of_scipy(row, key):
        return f"{row['scipy'][key]:.3g}" if "scipy" in row else ""

    head = ["points", "percal, in a process: fit", "intervals", "percal fit as a process", "without intervals", "SciPy, in a process: one start", "the same search",
            "SciPy script as a process"]
    costs = table(head, [[row["points"], *(f"{row[key]:.3g}" for key in ("fit_ms", "intervals_ms", "process_ms", "bare_process_ms")),
                          *(of_scipy(row, key) for key in ("one_start_ms", "same_search_ms", "process_ms"))] for row in rows])
    bare = f"; Python with `import numpy, scipy.optimize` {start['scipy']:.3g} ms (SciPy {version})." if version else "."
    text = f"""# What a curve fit costs

Written by `tests/bench/fit_bench.py` on {datetime.date.today()}: {processor()}, {os.cpu_count()} cores, shared with other work (load average {os.getloadavg()[0]:.1f} at the end).
Milliseconds of processor time on one thread: medians of up to 201 calls in a process and of {PROCESSES} processes. The points are uniaxial, stretch
0.65 to 1.3, of a one-term Ogden solid (mu 11.64 kPa, alpha 9) with 2 % noise; relative residuals.

{costs}

A process that starts and does nothing else: `percal --version` {start['percal']:.3g} ms{bare}

percal scans alpha at 801 values from -40 to 40, mu solved for at each, and runs Ceres from every minimum of the scan. The SciPy column `the same search`
does that too with NumPy and `least_squares` (derivatives written out); `one start` begins at alpha = 2 and would not know of a second minimum. A process reads
its CSV file; percal's also writes its JSON. `intervals` are the profile-likelihood intervals of mu and alpha, which SciPy has none of.
"""
    if version:
        worst = max(abs(row[key] / row["scipy"][key] - 1) for row in rows for key in ("mu_Pa", "alpha", "objective"))
        text += f"\nBoth find the same minimum: mu, alpha and objective differ by {worst:.1e} of themselves at most.\n"
    return text


def main():
    parser = command_line(__doc__, "fit_speed.md", "build")
    parser.add_argument("--python", default=sys.executable)
    options = parser.parse_args()
    version = scipy_version(options.python)
    with tempfile.TemporaryDirectory() as folder:
        rows, start = measure(pathlib.Path(options.build), options.python, version is not None, pathlib.Path(folder))
    text = page(rows, start, version)
    options.page.write_text(text)
    print(text, end="")


if __name__ == "__main__":
    main()
