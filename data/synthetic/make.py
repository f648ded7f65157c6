"""Writes the synthetic curves of this folder: one-term Ogden solids in uniaxial compression and tension, with noise.

    python3 data/synthetic/make.py            writes the files beside this script
    python3 data/synthetic/make.py --check    says whether they are what it would write; exit code 1 if not

Stress of W = (2 mu/alpha^2) (sum lambda^alpha - 3), mu the small-strain shear modulus (docs/theory/curves.md, (5)):

    nominal stress = (2 mu/alpha) (lambda^alpha - lambda^(-alpha/2)) / lambda

Noise: normal, independent from point to point, with the standard deviation that stands beside each point.
"""
import math
import pathlib
import random
import sys

HERE = pathlib.Path(__file__).resolve().parent
RELATIVE = 0.02  # standard deviation over the true stress
FLOOR = 0.005  # standard deviation over mu, added in squares: what the gauge scatters at rest
STRETCHES = [s / 1000 for s in [*range(650, 1000, 25), *range(1025, 1301, 25)]]
FACTOR = 9.74  # high rate over quasi-static
CURVES = {
    "gelatin_12wt_quasistatic.csv": {"what": "12 wt% gelatin, quasi-static", "mu_kPa": 11.64, "alpha": 9.0, "seed": 1},
    "gelatin_12wt_highrate.csv": {"what": "12 wt% gelatin, high rate", "mu_kPa": 11.64 * FACTOR, "alpha": 9.0, "seed": 2},
    "joint_curve.csv": {"what": "the gel of joint.toml at impact rate", "mu_kPa": 120.0, "alpha": 6.0, "seed": 4},
}


def nominal_stress(mu, alpha, stretch):
    return 2 * mu / alpha * (stretch**alpha - stretch ** (-alpha / 2)) / stretch


def normal(uniform):
    """One standard normal number from two uniform ones (Box and Muller); random.random() is the same in every Python."""
    radius = math.sqrt(-2 * math.log(1 - uniform()))
    return radius * math.cos(2 * math.pi * uniform())


def text_of(what, mu_kPa, alpha, seed):
    uniform = random.Random(seed).random
    lines = [f"# SYNTHETIC: made by data/synthetic/make.py, not measured. Stands for {what}.",
             f"# One-term Ogden, uniaxial: mu = {mu_kPa:.6g} kPa (small-strain shear modulus), alpha = {alpha:g}; seed {seed}",
             f"# Noise: normal; standard deviation error_kPa = sqrt(({RELATIVE:g} true stress)^2 + ({FLOOR:g} mu)^2)",
             "mode,stretch,stress_kPa,error_kPa"]
    for stretch in STRETCHES:
        true = nominal_stress(mu_kPa, alpha, stretch)
        error = math.hypot(RELATIVE * true, FLOOR * mu_kPa)
        lines.append(f"uniaxial,{stretch:.3f},{true + error * normal(uniform):.5g},{error:.4g}")
    return "\n".join(lines) + "\n"


def main(check):
    wrong = []
    for name, curve in CURVES.items():
        path, text = HERE / name, text_of(**curve)
        if not check:
            path.write_bytes(text.encode("ascii"))
        elif not path.exists() or path.read_bytes() != text.encode("ascii"):
            wrong.append(name)
    print(f"not what make.py writes: {', '.join(wrong)}" if wrong else f"{len(CURVES)} files as make.py writes them")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main("--check" in sys.argv[1:]))
