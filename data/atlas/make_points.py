"""The points of the atlas: python3 make_points.py writes points.csv beside it. data/atlas/README.md

Kronecker sequences x_i = frac(1/2 + i g), g_j = phi^-j with phi the root above 1 of phi^(d+1) = phi + 1: evenly spread for any number of
points, so that a part may be made longer without moving what it has. Erosion strains run up to the one that costs e^1.5 times rho_t v^2 to
reach in a tension test: beyond it next to nothing erodes, and a dent is a dent.
"""

import csv
import math
import pathlib

COLUMNS = ["pi4", "pi5", "pi6", "pi7", "pi1", "mesh.elements_per_radius"]
LEAST_EXCESS = -1.5  # of ln(rho_t v^2/W), W what a tension test stores until the material erodes


def sequence(count, dimensions):
    phi = 2.0
    for _ in range(60):
        phi = (1 + phi) ** (1 / (dimensions + 1))
    steps = [phi**-j for j in range(1, dimensions + 1)]
    return [[(0.5 + i * step) % 1 for step in steps] for i in range(1, count + 1)]


def log_between(low, high, share):
    return low * (high / low) ** share


def log_energy(alpha, strain):
    """ln(W/mu), docs/theory/emulator.md (2)."""
    stretch = 1 + strain
    return math.log(2 / alpha**2 * (stretch**alpha + 2 * stretch ** (-alpha / 2) - 3))


def largest_strain(pi4, alpha, low, high):
    """The largest strain of the box that this shot may reach."""
    if math.log(pi4) - log_energy(alpha, high) > LEAST_EXCESS:
        return high
    inside, outside = low, high
    for _ in range(60):
        middle = math.sqrt(inside * outside)
        if math.log(pi4) - log_energy(alpha, middle) > LEAST_EXCESS:
            inside = middle
        else:
            outside = middle
    return inside


def part(count, pi4, density_ratio, alpha, strain, depth, meshes):
    for x in sequence(count, 6):
        p4 = log_between(*pi4, x[0])
        a = alpha[0] + (alpha[1] - alpha[0]) * x[2]
        a = math.copysign(max(abs(a), 0.2), a)
        most = largest_strain(p4, a, *strain)
        # three of four on coarse meshes
        n = meshes[0] + (meshes[1] - meshes[0]) * x[5] / 0.75 if x[5] < 0.75 else meshes[1] + (meshes[2] - meshes[1]) * (4 * x[5] - 3)
        yield [p4, 1 / log_between(*density_ratio, x[1]), a, log_between(strain[0], max(most, strain[0] * 1.01), x[3]), log_between(*depth, x[4]), n]


def main():
    rows = [
        # what gels, skin and their spheres are like
        *part(4000, (3, 200), (1, 20), (2, 14), (0.2, 1.8), (6, 150), (5, 8, 13)),
        # the whole box; finer meshes are dear where shots are fast
        *part(2000, (0.5, 1000), (1, 20), (-10, 20), (0.1, 3), (2, 150), (5, 8, 11)),
    ]
    with open(pathlib.Path(__file__).parent / "points.csv", "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        writer.writerows([f"{value:.5g}" for value in row] for row in rows)


if __name__ == "__main__":
    main()
