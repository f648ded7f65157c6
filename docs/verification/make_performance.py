"""Writes docs/verification/performance.md from runs of impact_bench (a quarter of an hour of processor time, --short one minute):

    cmake --build build/release --target impact_bench
    python3 docs/verification/make_performance.py build/release/tests/bench/impact_bench [--short] [--without-long] [--page PAGE]
"""
import datetime
import json
import math
import os
import pathlib
import statistics
import time

from harness import Failed, at_level, command_line, located, output, percent, processor, table

LEVELS = {"x86_64_v4": 140, "x86_64_v3": 70, "x86_64_v2": 12}  # wanted: million element-steps a CPU second, on the slowest mesh
SMALL, SMALL_WANTED = 75_000, 160  # elements; wanted at the best level up to so many
THESIS = {"nf": 42, "graded": 23, "depth": 75}
MILLION = {"nf": 94, "graded": 51, "depth": 75}
SIZES = [{"nf": 10}, {"nf": 14}, {"nf": 21}, {"nf": 25, "depth": 75, "end": 20}, {"nf": 28, "depth": 75, "end": 15}, {"nf": 34, "depth": 75, "end": 10}, dict(THESIS, end=10),
         {"nf": 60, "depth": 75, "end": 5}, dict(MILLION, end=4)]
TEN_MILLION = {"nf": 299, "graded": 150, "depth": 75, "end": 0.005}

# What earlier runs of this script said on other machines, with the same bits: to 75,000 elements, above, million element-steps/s; the thesis's run, CPU s and wall s on two threads.
OTHER_MACHINES = [["Intel Xeon, AVX-512, 2026-11-30, load 2 to 5", "136 to 155", "110 to 144", "20.1", "11.6"]]

# Of one element-step, counted from element.hpp, internal_forces.hpp and contact_and_motion.hpp. Additions, multiplications, divisions and
# square roots count one each; comparisons, selections, minima, maxima and integer operations are left out.
FLOPS = {"gradient and hourglass mode": 27, "principal stretches": 39, "isochoric powers (two logarithms, two exponentials)": 75, "principal stresses": 9,
         "viscosity and pressure": 15, "first Piola stress": 28, "stable step": 43, "erosion and work": 9, "corner forces": 27, "motion": 10}
DIVISIONS_AND_ROOTS = 7
# Reals read and written. Forces: u, J, q, erosion measure, alive, f; J, q, erosion measure, f. Motion: f, 1/m, u, v; u, v.
REALS_MOVED = 8 + 5 + 7 + 4


class Bench:
    def __init__(self, path):
        self.path = located(path)

    def __call__(self, what, level=None, **options):
        """One line of impact_bench, with `others`: how many cores everybody else kept busy meanwhile. None where this processor lacks the level."""
        before, start = busy_seconds(), time.monotonic()
        try:
            line = json.loads(output([self.path, what, *(f"{key}={value}" for key, value in options.items())], environment=at_level(level)))
        except Failed:
            return None
        wall = time.monotonic() - start
        if "cpu_s" in line:
            line["others"] = max(0.0, (busy_seconds() - before - line["cpu_s"]) / wall)
        return line


def busy_seconds():
    fields = [int(x) for x in pathlib.Path("/proc/stat").read_text().splitlines()[0].split()[1:]]
    return (sum(fields[:3]) + sum(fields[5:8])) / os.sysconf("SC_CLK_TCK")


def speed(run):
    return run["element_steps"] / run["cpu_s"] / 1e6


def best(bench, tries, **options):
    runs = [bench("run", **options) for _ in range(tries)]
    return None if runs[0] is None else min(runs, key=lambda run: run["cpu_s"])


def verdict(reached, missing=""):
    return "reached" if reached else f"**missed**{': ' + missing if missing else ''}"


def speeds(bench, short):
    meshes = [("nf 10, 45a", {"nf": 10}, 3), ("nf 21, 45a", {"nf": 21}, 1), ("nf 42, 75a, first 10 radii", dict(THESIS, end=10), 1)]
    rows, seen, elements = [], {}, []
    for level in LEVELS:
        for arithmetic in (0, 1):
            for rates in (2, 1):
                cells = []
                for name, mesh, tries in meshes[:1] if short else meshes:
                    run = best(bench, tries, level=level, rates=rates, double=arithmetic, **mesh)
                    cells.append("" if run is None else f"{speed(run):.0f}")
                    if run:
                        seen[level, arithmetic, rates, name] = speed(run)
                        if (name, run["elements"]) not in elements:
                            elements.append((name, run["elements"]))
                rows.append([level, "double" if arithmetic else "single", rates, *cells])
    head = ["level", "arithmetic", "rates", *(f"{name}: {count:,} elements" for name, count in elements)]
    slowest = {level: min((v for k, v in seen.items() if k[:3] == (level, 0, 2)), default=None) for level in LEVELS}
    return table(head, rows), slowest


def sizes(bench, short):
    """At the best level, single precision: (elements, speed with two rates) and the table."""
    rows, seen = [], []
    for mesh in SIZES[:1] if short else SIZES:
        two, one = best(bench, 3 if mesh["nf"] < 20 else 2, rates=2, **mesh), best(bench, 1, rates=1, **mesh)
        seen.append((two["elements"], speed(two)))
        rows.append([f"{two['elements']:,}", mesh["nf"], f"{speed(two):.0f}", f"{speed(one):.0f}"])
    return table(["elements", "per radius", "two rates", "one rate"], rows), seen


def history(bench, short):
    """A run with the usual points of a history over one without: processor time."""
    mesh = {"nf": 10 if short else 21}
    pairs = [(bench("run", **mesh), bench("run", history=400, **mesh)) for _ in range(3)]
    return min(w["cpu_s"] for _, w in pairs) / min(o["cpu_s"] for o, _ in pairs)


def thesis(bench, short):
    mesh = dict(THESIS, end=2) if short else THESIS
    return {threads: bench("run", threads=threads, **mesh) for threads in (1, 2)}


def phases(bench, short):
    rows, runs = [], []
    cases = [("nf 10", {"nf": 10, "rates": 2}), ("nf 21", {"nf": 21, "rates": 2}), ("nf 21", {"nf": 21, "rates": 1}), ("nf 42, 75a", dict(THESIS, rates=2, end=20))]
    for name, options in cases[:1] if short else cases:
        run = bench("run", **options)
        runs.append(run)
        count = sum(run["samples"].values())
        rows.append([name, options["rates"], run["steps"], f"{run['element_steps'] / 1e6:.0f}", count,
                     *(percent(run["samples"][phase] / count) for phase in ("internal forces", "contact", "motion"))])
    note = ""
    if not short:
        two, one = runs[1], runs[2]
        everybody = two["steps"] * one["element_steps"] / one["steps"]  # as many rows moving as with one rate
        again = 100 * (two["element_steps"] - everybody) / two["element_steps"]
        note = (f"With two rates at nf 21 about {again:.0f} % of the element-steps are second visits to elements near the particle (from the counts of both runs); "
                f"they take {100 * two['element_steps'] / one['element_steps']:.0f} % of the element-steps of one rate.")
    return table(["mesh", "rates", "steps", "million element-steps", "samples", "internal forces", "contact", "motion"], rows), note


def memory(bench, short):
    rows, ten = [], None
    mesh = {"nf": 94, "graded": 51, "depth": 75, "end": 0.005} if short else TEN_MILLION
    for arithmetic in (0, 1):
        for rates in (2, 1):
            run = bench("run", double=arithmetic, rates=rates, **mesh)
            rows.append(["double" if arithmetic else "single", rates, f"{run['elements']:,}", f"{run['bytes'] / run['elements']:.1f}",
                         f"{1e7 * run['bytes'] / run['elements'] / 2**30:.2f}"])
            ten = ten or run
    largest = max(float(row[-1]) for row in rows)
    return table(["arithmetic", "rates", "elements", "bytes an element", "GiB for 10 million"], rows), largest, ten


def batches(bench, short):
    """One and two cores in turn, until others leave the machine alone or patience ends; the quietest pair counts."""
    runs, quietest = 10 if short else 100, None
    for _ in range(1 if short else 6):
        one, two = bench("batch", runs=runs, nf=7, threads=1), bench("batch", runs=runs, nf=7, threads=2)
        pair = (max(one["others"], two["others"]), one, two)
        quietest = min(quietest or pair, pair, key=lambda p: p[0])
        if quietest[0] < 0.05:
            break
    return quietest


def accuracy(bench, short):
    """Depths of nine replicates of each mesh against twenty at nf 30, and what the mean of three is worth."""
    reference = [bench("run", nf=10 if short else 30, replicate=k)["depth"] for k in range(3 if short else 20)]
    true, error = statistics.mean(reference), statistics.stdev(reference) / math.sqrt(len(reference))
    rows, cheapest = [], {}
    for n in (7, 10) if short else (7, 8, 10, 12, 14, 15, 18, 21):
        runs = [bench("run", nf=n, replicate=k) for k in range(9)]
        depths = [run["depth"] for run in runs]
        bias, spread = statistics.mean(depths) - true, statistics.stdev(depths)
        bias_error = math.hypot(spread / 3, error)
        three = 3 * statistics.mean(run["cpu_s"] for run in runs)
        expected, high = math.hypot(bias, spread / math.sqrt(3)) / true, math.hypot(abs(bias) + bias_error, spread / math.sqrt(3)) / true
        rows.append([n, f"{runs[0]['elements']:,}", f"{statistics.mean(depths):.3f}", f"{spread:.3f}", f"{100 * bias / true:+.2f} +- {percent(bias_error / true, '.2f')}",
                     percent(statistics.mean(depths[:3]) / true - 1, "+.2f"), f"{percent(expected, '.2f')} (to {percent(high, '.2f')})", f"{three:.2f}"])
        if three <= 0.9:
            cheapest["affordable"] = f"at nf {n} ({three:.2f} CPU s) the mean itself is {100 * bias / true:+.1f} % off, the spread of single runs is {100 * spread / true:.1f} %"
        for wanted in (1, 2):
            for kind, value in (("expected", expected), ("safe", high)):
                if 100 * value <= wanted and (wanted, kind) not in cheapest:
                    cheapest[wanted, kind] = (n, three)
    head = ["nf", "elements", "mean of 9", "spread", "off the reference", "first three: off", "expected error of the mean of 3", "CPU s of 3"]
    return table(head, rows), cheapest, f"{true:.3f} +- {error:.3f} radii (mean of {len(reference)} at nf {10 if short else 30})"


def roofline(bench, measured):
    peak, flops, bytes_moved = bench("peak"), sum(FLOPS.values()), 4 * REALS_MOVED
    rows = [["multiply-adds, one core", f"{peak['flops'] / 1e9:.0f} Gflop/s", f"{peak['flops'] / flops / 1e6:.0f}"]]
    rows += [[f"triad in {t['level']} ({t['bytes'] / 1e6:.1f} MB)", f"{t['bytes_per_s'] / 1e9:.0f} GB/s", f"{t['bytes_per_s'] / bytes_moved / 1e6:.0f}"] for t in peak["triad"]]
    text = (f"One element-step takes {flops} additions, multiplications, divisions and roots ({DIVISIONS_AND_ROOTS} of them divisions and roots), counted from the source: "
            + ", ".join(f"{name} {count}" for name, count in FLOPS.items())
            + f". It reads and writes {REALS_MOVED} reals, {bytes_moved} bytes in single precision, where every array is streamed once in the forces and once in the motion: "
              f"{flops / bytes_moved:.1f} flop a byte.\n\n" + table(["limit", "reached here", "million element-steps/s that it allows"], rows))
    if measured:
        text += (f"\n\nMeasured, {min(measured):.0f} to {max(measured):.0f} million element-steps/s are {min(measured) * flops / 1e3:.0f} to {max(measured) * flops / 1e3:.0f} Gflop/s: "
                 f"{100 * min(measured) * 1e6 * flops / peak['flops']:.0f} to {100 * max(measured) * 1e6 * flops / peak['flops']:.0f} % of the peak of multiply-adds. "
                 "Most operations are no multiply-adds, and each element is one long chain of them (stretches, logarithm, exponential, stress, step), so what is missing to the peak is "
                 "mostly waiting for results, and for divisions and roots.")
    return text


def load():
    return " ".join(f"{x:.1f}" for x in os.getloadavg())


def targets(slowest, by_size, longer, runs, million, largest, pair, cheapest):
    for name, wanted, some in ((f"to {SMALL:,} elements", SMALL_WANTED, [v for n, v in by_size if n <= SMALL]), ("above, to a million", LEVELS["x86_64_v4"], [v for n, v in by_size if n > SMALL])):
        if some:
            yield [f"best level, single, two rates, {name}", f">= {wanted} million element-steps/s", f"{min(some):.0f} to {max(some):.0f}", verdict(min(some) >= wanted, "the roofline below says where the time goes")]
    yield from ([f"{level}, single, two rates, slowest mesh", f">= {wanted} million element-steps/s", "not run: the processor lacks it" if slowest[level] is None else f"{slowest[level]:.0f}",
                 "" if slowest[level] is None else verdict(slowest[level] >= wanted, "the roofline below says where the time goes")] for level, wanted in LEVELS.items())
    def busy(others, quiet):
        return f"measured with {others:.1f} cores busy with other work, and two threads need both" if others > 0.1 else quiet

    cpu, wall, others = runs[1]["cpu_s"], runs[2]["wall_s"], runs[2]["others"]
    yield [f"the thesis's run, {runs[1]['elements']:,} elements", "<= 32 CPU s", f"{cpu:.1f}", verdict(cpu <= 32)]
    yield ["the same, further", "<= 20 CPU s", f"{cpu:.1f}", verdict(cpu <= 20, f"{100 * (cpu / 20 - 1):.0f} % too slow; the working set no longer fits the second-level cache")]
    yield ["the same on two threads", "<= 13 s wall", f"{wall:.1f} ({others:.1f} cores busy with other work)", verdict(wall <= 13, busy(others, "the threads wait for each other at every sweep"))]
    if million:
        yield [f"{million['elements']:,} elements on two threads", "<= 480 s wall", f"{million['wall_s']:.0f} ({million['others']:.1f} cores busy with other work)", verdict(million["wall_s"] <= 480)]
    yield ["10 million elements", "<= 8 GiB", f"{largest:.2f} GiB (the dearest: double)", verdict(largest <= 8)]
    yield ["a history of 400 points", "stated", f"{longer:.2f} times the processor time without", ""]
    others, one, two = pair
    share = 100 * two["wall_s"] / one["wall_s"]
    yield [f"{one['runs']} runs on two cores over one", "<= 52.6 % of the wall time", f"{share:.1f} % ({others:.1f} cores busy with other work)", verdict(share <= 52.6, busy(others, "the runs share the third-level cache"))]
    for within, wanted in ((2, "<= 0.9 CPU s"), (1, "stated")):
        mesh, safe = cheapest.get((within, "expected")), cheapest.get((within, "safe"))
        text = "no mesh of the ladder" if not mesh else f"{mesh[1]:.2f} CPU s (nf {mesh[0]})" + (f"; {safe[1]:.2f} (nf {safe[0]}) with the standard error added" if safe else "; no mesh with the standard error added")
        yield [f"depth within {within} %, mean of 3", wanted, text, "" if within == 1 else verdict(bool(mesh) and mesh[1] <= 0.9, cheapest.get("affordable", "no mesh of the ladder is that cheap"))]


def page(bench, short, without_long):
    load_before = load()
    speed_table, slowest = speeds(bench, short)
    size_table, by_size = sizes(bench, short)
    longer = history(bench, short)
    runs = thesis(bench, short)
    phase_table, phase_note = phases(bench, short)
    memory_table, largest, _ = memory(bench, short)
    pair = batches(bench, short)
    depth_table, cheapest, reference = accuracy(bench, short)
    million = None if short or without_long else bench("run", threads=2, **MILLION)
    best_level = next(level for level in LEVELS if slowest[level])
    measured = [speed(run) for run in runs.values() if run] + [slowest[best_level]]
    compiler = output(["c++", "--version"]).splitlines()[0]
    return f"""# What the impact solver costs

Written by `docs/verification/make_performance.py` from runs of `impact_bench`{' (--short: a trial of the script, no results)' if short else ''} on {datetime.date.today()}: {processor()}, {os.cpu_count()} cores, {compiler}.
The machine is shared: load averages {load_before} at the start and {load()} at the end. Processor seconds suffer less from that than wall seconds do; compare figures of this
page with each other. Everything is setting S (pi4 6.6474, density ratio 16.8, alpha 8.5, K/mu 50, erosion strain 0.7). Element-steps are live and dead
elements of the rows that were advanced, times their steps.

## Against the targets

{table(["what", "wanted", "measured", ""], targets(slowest, by_size, longer, runs, million, largest, pair, cheapest))}

The same program on other machines, single precision, two rates:

{table(["machine", f"to {SMALL:,} elements", "above", "the thesis's run, CPU s", "on two threads, s"], OTHER_MACHINES)}

## Million element-steps a processor second, one core

{speed_table}

By size, at {best_level}, single precision:

{size_table}

## The thesis's run, {runs[1]['elements']:,} elements

42 elements per radius, 23 graded columns, 75 radii deep: 65 columns of 3,150.

{table(["threads", "depth, radii", "steps", "million element-steps", "CPU s", "wall s", "cores busy with other work"], [[n, f"{r['depth']:.3f}", r["steps"], f"{r['element_steps'] / 1e6:.0f}", f"{r['cpu_s']:.1f}", f"{r['wall_s']:.1f}", f"{r['others']:.2f}"] for n, r in runs.items()])}

## Where the time goes

From samples of the program counter, one about every few milliseconds of processor time.

{phase_table}

{phase_note}

## Memory

What the process grew by, at its largest, with everything that a run keeps.

{memory_table}

## Roofline

{roofline(bench, measured)}

## Depth against cost

Reference: {reference}. Nine replicates of each mesh; the expected error of a mean of three is the root of the squares of its offset and of spread/sqrt 3,
and in brackets the same with one standard error added to the offset.

{depth_table}
"""


def main():
    parser = command_line(__doc__, "performance.md", "bench")
    parser.add_argument("--short", action="store_true")
    parser.add_argument("--without-long", action="store_true")
    options = parser.parse_args()
    options.page.write_text(page(Bench(options.bench), options.short, options.without_long))


if __name__ == "__main__":
    main()
