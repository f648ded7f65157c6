"""Writes docs/verification/closed_forms.md from a run of the verification tests (about a minute of processor time):

    python3 docs/verification/make_closed_forms.py build/release/tests/verification_test
"""
import pathlib
import tempfile

from harness import command_line, output, table

# Sections in the order of the page, each with what it is about.
SECTIONS = {
    "Homogeneous states": "The patch test: every node of a distorted mesh is put where a linear field has it. `found` is the largest error of any element's stress, or of any inner "
                          "node's force, over the modulus; the closed form is written a second time in the test, from W by principal values of F F^T.",
    "Waves": "Speeds from the period of the longest standing wave of a bar; a bar of square elements, nu = 0, that hits a wall of springs. No viscosity.",
    "Inflation at rest": "The inner face is moved to the stretch named, the rest of the body is relaxed (`relax`), and the pressure on the inner face is found. Two references: the "
                         "radial solution of the same compressible solid, integrated on its own in the test, which shows the mesh's error; and the incompressible closed form, which "
                         "is approached as 1/K. A cavity's outer face bears the pressure that the rest of an infinite medium would put on it.",
    "Radial oscillation": "A pressure is put on at once; it follows the surface, and its work is in the ledger.",
    "Hertz impact": "An elastic sphere (nu = 0.3) on a rigid frictionless plane, contact by springs of 5 E/h a unit area, linear viscosity 0.06. Hertz's law is that of a half space: "
                    "the sphere is stiffer by a share of contact radius over radius (0.14 at the higher speed, 0.08 at the lower), which is what remains on the finest mesh. The "
                    "largest force is that of one step, unfiltered.",
    "Invariance": "What should not change at all.",
    "Orders of convergence": "Slopes of the logarithm of the error; viscosity off unless named, a fixed step.",
    "Stable step": "`Body::stable_step` over 2/omega of the differenced forces, random quads on the axis, near it and away from it, deformed at random.",
}


def rows_of(tests):
    with tempfile.TemporaryDirectory() as folder:
        rows = pathlib.Path(folder) / "table"
        output([tests, "--gtest_brief=1"], environment={"PERCAL_TABLE": str(rows)})
        return [line.split("\t") for line in rows.read_text().splitlines()]


def sections(rows):
    unknown = {row[0] for row in rows} - SECTIONS.keys()
    if unknown:
        raise SystemExit(f"sections that the page does not know: {', '.join(sorted(unknown))}")
    head = ["check", "reference", "mesh", "found", "exact, or bound", "error"]
    for section, meaning in SECTIONS.items():
        yield f"\n## {section}\n\n{meaning}\n\n" + table(head, [row[1:] for row in rows if row[0] == section]) + "\n"


HEAD = """# Closed forms

Written by `docs/verification/make_closed_forms.py` from a run of tests/verification, which hold every line of it. The body is `Body` (impact/particle/body.hpp) in double precision; its solid is the
block's (docs/theory/impact.md (2), (3)). Exact values are those of data/verification where a file is named.

Its element: one point, the mean of the displacement gradient over the element's volume (`QuadForm`, there as well), in axisymmetry with r in every mean, the hoop stretch included. So rigid
motions and linear fields are exact on any quad. The hourglass pattern, orthogonal to all linear fields, is held by a constant elastic spring, c_hg mu/12 V sum |grad N_a|^2 with c_hg = 0.5.
"""


def main():
    options = command_line(__doc__, "closed_forms.md", "tests").parse_args()
    options.page.write_text(HEAD + "".join(sections(rows_of(options.tests))))


if __name__ == "__main__":
    main()
