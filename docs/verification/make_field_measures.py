"""Writes docs/verification/field_measures.md from runs of the program (about two minutes of processor time):

    python3 docs/verification/make_field_measures.py build/release/percal
"""
import statistics

from harness import changed, command_line, number, plus_minus, table, write_page

REPLICATES = 3

GOLD = f"""replicates = {REPLICATES}
[particle]
name = "gold"
radius = "1 um"
density = "16800 kg/m3"
speed = "651 m/s"
[target]
name = "skin"
density = "1000 kg/m3"
mu = "15 MPa"
convention = "mu/alpha"
alpha = 8.5
bulk_to_shear = 50
depth = "75 um"
width = "5 um"
[target.erosion]
strain = 0.7
[mesh]
elements_per_radius = 7
[output]
channel = true
"""

RELAXING = '[[target.relaxation]]\nshare = 0.5\ntime = "3 ns"\n[mesh]\n'
LIGHT = ('density = "16800 kg/m3"', 'density = "1200 kg/m3"')
TWO_LAYERS = '[[below]]\nname = "fat"\ndensity = "900 kg/m3"\nmu = "5 MPa"\nalpha = 8.5\ndepth = "4 um"\n[below.erosion]\nstrain = 0.9\n[mesh]\n'
TO_REST = ("[output]\n", '[output]\nafter = "rest"\n')

# What another code makes of the same spheres: written apart from percal for depths (double precision, one rate, nodes inside the sphere put back onto it each step, eroded where the strain is reached) and run on past the deepest point, at speeds
# within 3 % of the scene's. Elements per radius, density: runs, deepest tip in um, what followed: speed upwards in m/s or depth in um, each with its standard deviation.
THROWN_BACK = {7: (9, 1.85, 246.7, 24.9), 14: (9, 1.91, 255.6, 12.9)}
STAYED = (12, 26.1, 19.2, 2.9)


def replicates(count):
    return f"replicates = {REPLICATES}", f"replicates = {count}"


def finer(n):
    return "elements_per_radius = 7", f"elements_per_radius = {n}"


# Scenes that run until the particle rests or has left.
CASES = [
    ("gold, 5 elements per radius", changed(GOLD, finer(5))),
    ("gold, 7", GOLD),
    ("gold, 10", changed(GOLD, finer(10))),
    ("gold, 7, half of the stress relaxes in 3 ns", changed(GOLD, ("[mesh]\n", RELAXING))),
    ("1200 kg/m3, 7", changed(GOLD, LIGHT)),
    ("gold, 7, through 8 um of it and 4 um of a softer layer", changed(GOLD, ('depth = "75 um"', 'depth = "8 um"'), ("[mesh]\n", TWO_LAYERS))),
]


def in_um(metres, form=".2f"):
    return number(None if metres is None else 1e6 * metres, form)


def ending(run):
    """How one run ended, with its number."""
    final = run["final"]
    if final is None:
        return run["outcome"]
    if final["ending"] in ("left upwards", "passed through"):
        return f"{final['ending']}, {abs(final['speed_m_s']):.1f} m/s"
    return f"{final['ending']}, {plus_minus(1e6 * final['depth_m'], 1e6 * final['half_width_m'])}"


def cpu(answer):
    return sum(run["cpu_s"] for run in answer["runs"])


def ask(program, scene):
    answer = program.ask("impact", program.scene(scene), "--threads", "1", *program.kept())
    program.cpu += cpu(answer)
    return answer


def same_deepest(one, other):
    return all(a["depth_m"] == b["depth_m"] and a["energy_closure"] == b["energy_closure"] for a, b in zip(one["runs"], other["runs"]))


def final_row(name, deepest, rest):
    runs = rest["runs"]
    return [name, "; ".join(in_um(run["depth_m"]) for run in runs), "; ".join(map(ending, runs)), "yes" if same_deepest(deepest, rest) else "NO",
            number(max(abs(run["final"]["energy_closure"]) for run in runs if run["final"]), ".1e"), number(cpu(rest) / cpu(deepest), ".1f")]


def speed_rows(deepest, rest):
    """Behind each layer, in free flight, and what the ledger says of the last."""
    rows = [[f"behind {layer['name']}, at {in_um(layer['lower_face_m'], 'g')} um",
             plus_minus(layer["speed_behind_m_s"], layer["speed_behind_standard_error_m_s"], 1)] for layer in rest["layers"]]
    rows.append(["at exit, by the run to the lower face", plus_minus(deepest["exit_speed_m_s"], deepest["exit_speed_standard_error_m_s"], 1)])
    rows.append(["in free flight", plus_minus(rest["exit_speed_m_s"], rest["exit_speed_standard_error_m_s"], 1)])
    speed = float(rest["input"]["toml"].split('speed = "')[1].split()[0])
    squares = sum((run["final"]["speed_m_s"] / speed / run["speed_factor"]) ** 2 for run in rest["runs"]) / len(rest["runs"])
    rows.append(["(v/v_0)^2 less the ledger's share of the particle, mean", number(squares - rest["final"]["energy"]["particle"], ".1e")])
    return rows


def channel_rows(at_deepest, at_rest):
    both = zip(at_deepest["channel"]["depth_m"], at_deepest["channel"]["largest_radius_m"], at_deepest["channel"]["end_radius_m"],
               at_rest["channel"]["largest_radius_m"], at_rest["channel"]["end_radius_m"])
    return [[in_um(depth), *(in_um(radius) for radius in radii)] for depth, *radii in both]


def mean_and_deviation(values, form):
    return f"{statistics.mean(values):{form}} (s.d. {statistics.stdev(values):{form}})" if len(values) > 1 else "-"


def beside_rows(program):
    """What follows the deepest point, by percal and by the other code."""
    for n, (runs, depth, speed, deviation) in THROWN_BACK.items():
        found = ask(program, changed(GOLD, LIGHT, finer(n), TO_REST, replicates(runs)))["runs"]
        left = [abs(run["final"]["speed_m_s"]) for run in found if run["final"]["ending"] == "left upwards"]
        yield [f"1200 kg/m3, {n}", runs, in_um(statistics.mean(run["depth_m"] for run in found)), f"{depth:.2f}", f"{len(left)} leave, {mean_and_deviation(left, '.0f')} m/s",
               f"{runs} leave, {speed:.0f} (s.d. {deviation:.0f}) m/s"]
    runs, depth, rests, deviation = STAYED
    found = ask(program, changed(GOLD, TO_REST, replicates(runs)))["runs"]
    stay = [1e6 * run["final"]["depth_m"] for run in found if run["final"]["ending"] != "left upwards"]
    yield ["gold, 7", runs, in_um(statistics.mean(run["depth_m"] for run in found)), f"{depth:.1f}", f"{len(stay)} stay, {mean_and_deviation(stay, '.1f')} um; {runs - len(stay)} leave",
           f"{runs} stay, {rests:.1f} (s.d. {deviation:.1f}) um"]


def page(program):
    answers = {}
    rows = []
    for name, scene in CASES:
        deepest, rest = ask(program, scene), ask(program, changed(scene, TO_REST))
        answers[name] = deepest, rest
        rows.append(final_row(name, deepest, rest))
        print(*rows[-1], sep=", ", flush=True)
    layered, gold = answers[CASES[5][0]], answers[CASES[1][0]]
    final = table(["scene", "deepest tip of each run, um", "what followed, um ± half width", "deepest as without it, to the last bit", "worst energy closure at the end", "CPU over that of the run to the deepest point"], rows)
    return f"""# What a field measures besides the depth

Written by `docs/verification/make_field_measures.py`: {REPLICATES} replicates each, one thread, {program.machine()}. The sphere has a radius of 1 um and 651 m/s; skin 15 MPa as given, alpha 8.5, K = 50 mu, erosion strain 0.7, 75 um deep
and 5 um wide.

## After the deepest point

{final}

A sphere of gold creeps back up the channel, which holds it by nothing but its roughness; where it stays, or that it leaves, is the mesh's doing. Where stress relaxes the channel has set before the
sphere is far, and final depths lie within 2 um; a light sphere is thrown back with speeds within 7 % of their mean.

The same by another code that shares nothing with percal (its spheres were followed for 30 radii of time, those of gold for 1,000):

{table(["scene", "runs", "percal: deepest, um", "the other", "percal: what followed", "the other"], beside_rows(program))}

The speeds with which a light sphere is thrown back agree within the scatter. So do the depths at which gold stays; that the other code holds every sphere where percal lets a third out is no more than one time in ten would bring by chance (Fisher's
exact test: 0.09).

## Speeds left

{CASES[5][0]}, m/s ± one standard error:

{table(["", "speed"], speed_rows(*layered))}

## The channel

Radius in um along the undeformed depth, {CASES[1][0]}, means:

{table(["depth, um", "widest up to the deepest point", "at the deepest point", "widest, with what followed", "at the end"], channel_rows(*gold))}

How it is computed: [../theory/field_measures.md](../theory/field_measures.md).
"""


if __name__ == "__main__":
    write_page(command_line(__doc__, "field_measures.md"), page)
