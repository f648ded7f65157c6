"""Writes docs/verification/angularity.md and its figure from the campaign data/guha2009/angularity_block.toml (about an hour of processor time, nothing when the store has its runs; needs gnuplot):

    python3 docs/verification/make_angularity.py build/release/percal

Options: --store FILE for the evaluations (default: the program's own), --page FILE to write elsewhere, --jobs N runs side by side.
"""
import math

from harness import THESIS, Store, command_line, data_block, draw, figures_of, number, table, write_page


def angularity(program, file):
    """The campaign of data/guha2009/angularity_block.toml as a figure and a table."""
    answer = program.ask("campaign", THESIS / "angularity_block.toml", "--threads", str(program.options.jobs), "--out", "none", *program.kept())
    names = [axis["key"] for axis in answer["axes"]]
    points = [{**dict(zip(names, point["values"])), **point} for point in answer["points"]]
    depth = lambda angle, side, turned: next(p for p in points if p["particle.tip_angle"] == angle and p["particle.side"] == side and p["particle.orientation"] == turned)
    shapes = list(dict.fromkeys((p["particle.tip_angle"], p["particle.side"]) for p in points))
    turns = list(dict.fromkeys(p["particle.orientation"] for p in points))
    degrees = lambda text: float(str(text).split()[0])
    rows = []
    for angle, side in shapes:
        cells = [depth(angle, side, turned) for turned in turns]
        rows.append([f"{degrees(angle):g}", f"{side:g}", *(number(None if c["depth_m"] is None else 100 * c["depth_m"], ".2f") if c["outcome"] == "stopped" else c["outcome"] for c in cells), f"{sum(c['cpu_s'] for c in cells):.0f}"])
    own = [(angle, side) for angle, side in shapes if not (degrees(angle) == 60 and side != 6)]
    lines = [(degrees(angle), *(100 * (depth(angle, side, turned)["depth_m"] or math.nan) for turned in turns)) for angle, side in own]
    sizes = sorted((side, *(100 * (depth(angle, side, turned)["depth_m"] or math.nan) for turned in turns)) for angle, side in shapes if degrees(angle) == 60)
    colours = ("#0072b2", "#d55e00", "#009e73", "#cc79a7")
    curves = lambda block: ", ".join(f"${block} using 1:{k + 2} with linespoints lw 2 lc rgb '{colours[k]}' pt {(7, 5, 9, 13)[k]} title 'turned by {degrees(turned):g} deg'" for k, turned in enumerate(turns))
    draw(file, data_block("angle", lines) + data_block("size", sizes) + f"""set multiplot layout 1,2
set grid; set key top right; set yrange [0:*]; set ylabel 'depth, cm'
set xlabel "angle of the tip, deg (area across 31.2 mm^2)"; set xrange [25:95]; plot {curves("angle")}
unset key; set xlabel "side, mm (tip of 60 deg)"; set logscale x 2; set xrange [2.5:14.5]; set xtics (3, 6, 12); plot {curves("size")}
""", size="900,420")
    cm = lambda angle, side, turned: 100 * depth(angle, side, turned)["depth_m"]
    (sharp, sharp_side), (blunt, blunt_side) = own[0], own[-1]
    said = (f"Straight, the tip of {degrees(sharp):g} degrees goes {cm(sharp, sharp_side, turns[0]) / cm(blunt, blunt_side, turns[0]):.1f} times as deep as that of {degrees(blunt):g}; turned by {degrees(turns[-1]):g} degrees it goes "
            f"{cm(sharp, sharp_side, turns[-1]) / cm(blunt, blunt_side, turns[-1]):.2f} times as deep, for it meets the target with its long side. What a turn takes grows with sharpness: at {degrees(turns[1]):g} degrees already "
            f"{100 * (1 - cm(sharp, sharp_side, turns[1]) / cm(sharp, sharp_side, turns[0])):.0f} % of the depth of the sharpest, {100 * (1 - cm(*own[2], turns[1]) / cm(*own[2], turns[0])):.0f} % of that of {degrees(own[2][0]):g} degrees and nothing of the square's, so that a scatter of the "
            f"attitude at impact of some degrees decides the depths of sharp prisms and hardly those of blunt ones. At one mass and energy half the size goes {sizes[0][1] / sizes[1][1]:.1f} times as deep and twice the size {sizes[2][1] / sizes[1][1]:.2f} times, as energy over the area across would have it by {2 ** 2} and {1 / 2 ** 2}.")
    head = ["tip, deg", "side, mm", *(f"turned by {degrees(turned):g} deg" for turned in turns), "CPU s, of the row"]
    return said + "\n\n" + table(head, rows)


def page(program):
    angles = angularity(program, figures_of(program.options.page) / "angularity.svg")
    return f"""# Angle, size and orientation at equal mass and speed

Written by `docs/verification/make_angularity.py` ({program.machine()}, one thread a run).

The study that the thesis leaves to others, as the campaign `data/guha2009/angularity_block.toml`: steel rhombi of one area across (31.2 mm2), 0.7027 g, 40 m/s, tips of 30 to 90 degrees, started straight or turned and free to turn further; the rhombus of 60 degrees also at half and twice its size (its mass and energy as before). One run each, depths
in cm, cubes in proportion to the particle with one erosion strain. A single run of such a block scatters by some per cent; the wall of the widest turned prisms is nearer than a run of their own would have it, which is worth up to 6 % of a depth.

![depth over the angle of the tip, and over the size](../figures/angularity.svg)

{angles}
"""


if __name__ == "__main__":
    write_page(command_line(__doc__, "angularity.md", store=Store.PERCALS, jobs=1), page)
