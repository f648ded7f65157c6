"""The figures of docs/verification/guha2009.md, drawn by gnuplot: measured filled, percal open, in the colour of the material."""
from harness import data_block, draw

COLOURS = {"steel 3.18": "#0072b2", "steel 2.39": "#0fa569", "steel 1.59": "#7878ff", "titanium": "#a55a3c", "tungsten carbide": "#d55e00", "PMMA": "#693cff"}
DENSITY = {"steel": 7800, "titanium": 4540, "tungsten carbide": 15600, "PMMA": 1150}
MU_GELATIN, RHO_GELATIN = 113e3, 1010


def ball(row):
    return f"steel {row['diameter_corrected_mm']:g}" if row["material"] == "steel" else row["material"]


def radius(row):
    return row["diameter_corrected_mm"] / 2000


class Figures:
    def __init__(self, folder, line_through):
        self.folder, self.line = folder, line_through

    def draw(self, name, title, x, y, series, extra=""):
        """series: (title, rows of numbers, gnuplot's `with ...`)."""
        blocks = "".join(data_block(f"d{k}", rows) for k, (_, rows, _) in enumerate(series))
        plots = ", \\\n  ".join(f"$d{k} {how} " + (f'title "{label}"' if label else "notitle") for k, (label, _, how) in enumerate(series))
        draw(self.folder / f"{name}.svg", f"""set border 3 lw 0.8
set tics nomirror out
set key outside right top samplen 1.5 spacing 1.2
set title "{title}"
set xlabel "{x}"
set ylabel "{y}"
{extra}
{blocks}plot {plots}
""")

    def trend(self, points):
        """Both ends of the line through the first two numbers of each point."""
        slope, start = self.line([q[0] for q in points], [q[1] for q in points])
        return [(end, start + slope * end) for end in (min(q[0] for q in points), max(q[0] for q in points))]

    def mesh(self, found):
        one = [(r.elements, 1e6 * r.depth, 1e6 * (r.spread or 0)) for _, r in found]
        self.draw("guha2009_3_5", "Figure 3-5: gold, 580 m/s, 4.2 MPa, erosion strain 0.6", "elements in the skin layer", "depth, um",
                  [("percal (bars: spread of three runs)", one, 'using 1:2:3 with yerrorlines pt 7 ps 0.8 lc rgb "#0072b2"')], "set xrange [0:230000]\nset xtics 50000\nset yrange [55:75]")

    def gold(self, rows, ours):
        series = []
        for a, colour in ((0.6, "#693cff"), (1.0, "#0072b2"), (1.4, "#d55e00")):
            kept = [(row, p) for row, p in zip(rows, ours) if row["radius_um"] == a]
            x = lambda row: 16800 * row["velocity_m_s"] * row["radius_um"] * 1e-6
            series += [(f"{a} um, measured", [(x(r), r["penetration_um"]) for r, _ in kept], f'with points pt 7 ps 1.1 lc rgb "{colour}"'),
                       (f"{a} um, LS-DYNA", [(x(r), r["fe_um"]) for r, _ in kept], f'with linespoints pt 2 dt 2 lc rgb "{colour}"'),
                       (f"{a} um, percal", [(x(r), 1e6 * p["depth_m"], 1e6 * p["depth_spread_m"]) for r, p in kept], f'using 1:2:3 with yerrorbars pt 6 ps 1.1 lw 1.4 lc rgb "{colour}"')]
        self.draw("guha2009_4_1", "Figure 4-1: gold into skin", "impact parameter, kg/(m s)", "depth, um", series)

    def ridge(self, ridge):
        found = [r for r in ridge if r["mu_as_given_Pa"]]
        error = lambda r: r["mu_as_given_Pa"] / 1e6 * (r["relative_error_solver"] ** 2 + r["relative_error_data"] ** 2) ** 0.5
        self.draw("guha2009_ridge", "Table 4-1: modulus and erosion strain that give 26 um", "erosion strain, engineering", "modulus as given, MPa", [
            ("printed", [(r["erosion_strain"], r["table_mu_as_given_Pa"] / 1e6) for r in found if "table_mu_as_given_Pa" in r], 'with points pt 7 ps 1.2 lc rgb "#d55e00"'),
            ("percal", [(r["erosion_strain"], r["mu_as_given_Pa"] / 1e6, error(r)) for r in found], 'using 1:2:3 with yerrorlines pt 6 ps 1 lc rgb "#0072b2"')],
            "set logscale y\nset yrange [8:70]\nset ytics (10,20,30,40,60)\nset xrange [0.25:0.85]")

    def balls(self, rows, ours):
        """Figures 4-2 to 4-6; the depths at 100 m/s on the lines through measured and computed shots."""
        names = list(dict.fromkeys(ball(row) for row in rows))
        shots = {name: [(row, p) for row, p in zip(rows, ours) if ball(row) == name] for name in names}
        label = lambda name: name + (" mm" if name.startswith("steel") else "")

        def pairs(name, x, y, x_label, y_label, title, extra="", mean=False):
            series = []
            for one in names:
                points = [(x(r), y(r, r["penetration_cm"] / 100), y(r, p["depth_m"])) for r, p in shots[one]]
                series += [(label(one), [q[:2] for q in points], f'with points pt 7 ps 0.9 lc rgb "{COLOURS[one]}"'),
                           ("", [(q[0], q[2]) for q in points], f'with points pt 6 ps 0.9 lw 1.3 lc rgb "{COLOURS[one]}"')]
                series.append(("", self.trend(points), f'with lines lw 1 lc rgb "{COLOURS[one]}"'))
            if mean:
                series.append(("line through all", self.trend([(x(r), y(r, r["penetration_cm"] / 100)) for r in rows]), 'with lines lw 1.6 dt 2 lc rgb "#7f7f7f"'))
            self.draw(name, title, x_label, y_label, series, extra)

        impact = lambda r: r["density_kg_m3"] * r["velocity_m_s"] * radius(r)
        # Equal depth in radii needs equal pi4 and pi5: a shot stands for gold of 1 um at 651/83 times its speed.
        pairs("guha2009_4_2", impact, lambda r, depth: 100 * depth, "impact parameter of the ball, kg/(m s)", "depth in gelatin, cm", "Figure 4-2: balls into 12 wt% gelatin",
              f"set link x2 via x*{16800e-6 * 651 / (7800 * 83 * 1.59e-3):.8g} inverse x/{16800e-6 * 651 / (7800 * 83 * 1.59e-3):.8g}\nset x2tics 2 format '%g'\nset border 7\nset xrange [100:1300]\nset title offset 0,0.6\nset x2label 'equivalent gold particle in skin, kg/(m s)'")
        pairs("guha2009_4_3", lambda r: RHO_GELATIN * r["velocity_m_s"] ** 2 / MU_GELATIN, lambda r, depth: depth / radius(r), "ρ_t v^2 / μ", "depth over radius", "Figure 4-3: depth over radius")
        pairs("guha2009_4_6", lambda r: r["velocity_m_s"], lambda r, depth: depth * RHO_GELATIN / (2 * radius(r) * r["density_kg_m3"]), "speed, m/s", "P_d ρ_t / (2 a ρ_p)",
              "Figure 4-6: depth over diameter and density ratio", mean=True)
        at_100 = []
        for one in names:
            speeds = [r["velocity_m_s"] for r, _ in shots[one]]
            at = lambda depths: sum(c * 100 ** k for k, c in zip((1, 0), self.line(speeds, depths)))
            at_100.append((one, at([r["penetration_cm"] for r, _ in shots[one]]), at([100 * p["depth_m"] for _, p in shots[one]])))
        found = {one: (a, b) for one, a, b in at_100}
        steel = sorted((shots[n][0][0]["diameter_corrected_mm"] / 2, *found[n]) for n in names if n.startswith("steel"))
        measured, percal = 'using 1:2 with linespoints pt 7 ps 1.1 lc rgb "#0072b2"', 'using 1:3 with linespoints pt 6 ps 1.1 dt 2 lw 1.3 lc rgb "#d55e00"'
        self.draw("guha2009_4_4", "Figure 4-4: steel at 100 m/s", "radius, mm", "depth, cm", [("measured line", steel, measured), ("percal's line", steel, percal)], "set xrange [0.6:1.8]\nset yrange [0:]")
        by_density = sorted((DENSITY[n.split(" 3")[0]], *(v / (0.2 * radius(shots[n][0][0]) * 1000) for v in found[n])) for n in ("PMMA", "titanium", "steel 3.18", "tungsten carbide"))
        self.draw("guha2009_4_5", "Figure 4-5: depth over diameter at 100 m/s", "density, kg/m3", "P_d / 2a", [("measured line", by_density, measured), ("percal's line", by_density, percal)], "set yrange [0:]")
        return [(label(one), a, b) for one, a, b in at_100]

    def scaled(self, rows):
        x = lambda row: 16800 * row["velocity_m_s"] * row["radius_um"] * 1e-6
        self.draw("guha2009_4_7", "Figure 4-7: gold measured, and gelatin's line carried over", "impact parameter, kg/(m s)", "depth, um", [
            ("measured", [(x(r), r["penetration_um"]) for r in rows], 'with points pt 7 ps 1.1 lc rgb "#0072b2"'),
            ("scaled line, printed", [(x(r), r["scaled_um"]) for r in rows], 'with points pt 6 ps 1.1 lw 1.4 lc rgb "#d55e00"')])

    def prism(self, name, title, shots, results):
        depths = [100 * r.depth if r.depth else None for r in results]
        speeds = [s["velocity_m_s"] for s in shots]
        measured = [(s["velocity_m_s"], s["penetration_cm"]) for s in shots]
        self.draw(name, f"Figure {name[-3]}-{name[-1]}: {title}", "speed, m/s", "depth, cm", [
            ("measured", measured, 'with points pt 7 ps 1.1 lc rgb "#0072b2"'),
            ("its line", self.trend(measured), 'with lines lc rgb "#0072b2"'),
            ("LS-DYNA", [(s["velocity_m_s"], s["fe_cm"]) for s in shots], 'with points pt 2 ps 1.1 lw 1.4 lc rgb "#d55e00"'),
            ("percal", [(s["velocity_m_s"], d, 100 * (r.error or 0)) for s, d, r in zip(shots, depths, results) if d],
             'using 1:2:3 with yerrorbars pt 6 ps 1.1 lw 1.4 lc rgb "#0fa569"')],
            f"set xrange [{min(speeds) - 3:g}:{max(speeds) + 3:g}]\nset yrange [0:]")
