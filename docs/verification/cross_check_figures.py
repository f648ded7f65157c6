"""Figures of other codes, typed in from what they printed, for make_cross_check.py."""
import math
from dataclasses import dataclass

S = 6.6478  # pi4 of setting S: 1000 kg/m3 (651 m/s)^2/63.75 MPa


@dataclass(frozen=True)
class Figures:
    """Ten runs or more: mean and standard deviation of the depth in radii, processor seconds and steps of a run."""
    mean: float
    deviation: float
    cpu: float
    steps: int
    runs: int = 10

    def error(self):
        return self.deviation / math.sqrt(self.runs)


# The planning study's independent code: a throw-away total Lagrangian code in double precision with one rate, written before percal;
# none of it was taken over. Compiled with g++ -O3 -march=native -ffast-math -fopenmp-simd on x86_64 with AVX-512. Each row is ten runs
# of Case.other_arguments(cfl) with vfac=1, 1.001, 0.999, 1.002, ... 1.005. Keys: case, CFL number.
OTHER = {
    ("s10", 0.8): Figures(26.8785, 0.3536, 1.637, 13001),
    ("s14", 0.8): Figures(27.6055, 0.3851, 4.780, 19463),
    ("in_contact", 0.8): Figures(24.3241, 0.3561, 1.456, 12108),
    ("stiff_end", 0.8): Figures(26.3045, 0.3564, 1.319, 10500),
    ("soft_end", 0.8): Figures(28.0986, 0.3472, 1.652, 13989),
    ("fast", 0.8): Figures(34.6103, 0.3227, 1.790, 14796),
    ("slow", 0.8): Figures(13.1574, 0.3321, 1.052, 9129),
    ("gelatin", 0.8): Figures(21.4018, 0.2052, 0.874, 7969),
    ("alpha_16", 0.8): Figures(20.6096, 0.1932, 1.334, 12180),
    ("alpha_25", 0.8): Figures(3.3225, 0.0464, 0.128, 3403),
    ("alpha_-6", 0.8): Figures(10.5527, 0.6609, 0.356, 3248),
    ("rhombus", 0.8): Figures(10.4876, 0.2224, 0.646, 5078),
    ("dent", 0.8): Figures(1.5861, 0.0042, 0.191, 1838),
    ("alpha_16", 0.4): Figures(20.6213, 0.2799, 2.626, 24137),
    ("alpha_25", 0.4): Figures(3.3203, 0.0404, 0.293, 6807),
    ("alpha_-6", 0.4): Figures(10.2492, 0.7526, 0.759, 5944),
    ("dent", 0.4): Figures(1.5856, 0.0042, 0.369, 3677),
}
# The same at CFL 0.8 with one change: an element goes when its strain, extrapolated by half a step, is at the limit.
AHEAD = {
    "in_contact": Figures(24.6856, 0.3555, 1.566, 12210),
    "soft_end": Figures(28.4853, 0.3214, 1.797, 14086),
    "s10": Figures(27.1778, 0.2803, 1.648, 13082),
    "fast": Figures(34.7640, 0.3616, 1.918, 14800),
    "slow": Figures(13.2710, 0.3326, 1.221, 9136),
    "rhombus": Figures(10.9882, 0.3315, 0.636, 5218),
}
# The same with the tip's node on the axis pushed as percal pushes it.
RHOMBUS_TIP = Figures(10.9295, 0.3117, 0.646, 5267)
# Judged ahead, and with -q J in place of -q as well.
BOTH = {
    "in_contact": Figures(24.4228, 0.3525, 1.615, 12059),
    "slow": Figures(13.3887, 0.2675, 1.176, 9203),
}
# Alpha -6 again, 30 runs each: speed factors up to 1.015.
NEGATIVE_ALPHA = (
    ("the other code", 0.8, Figures(10.4881, 0.6577, 0.389, 3242, 30)),
    ("the other code", 0.4, Figures(10.3879, 0.9089, 0.807, 6337, 30)),
    ("the other code, judged half a step ahead", 0.8, Figures(11.0467, 0.9787, 0.439, 3447, 30)),
)

# What other groups have, as they give it. Depths of gold in um, of gelatin in cm, of OpenRadioss in radii.
RIDGE_OTHER = (26.0, 30.2, 28.0, 27.4, 26.4, 29.8)
GOLD_OTHER = (11.50, 15.29, 20.26, 13.73, 19.83, 26.03, 19.14, 26.21, 33.48)
GELATIN_OTHER = {464: (1.48, 3.56, 4.12, 5.15), 1010: (1.43, 2.81, 3.37, 4.26)}
GELATIN_LS_DYNA = {83: 4.19}
OPENRADIOSS = (  # title, pi4, erosion, nodes, (mesh, OpenRadioss, the other code), ...; no mesh: not given
    ("setting S", S, 0.7, "released", (7, "25.9 to 26.9", "27.9"), (10, "24.5", "26.3")),
    ("55 MPa, 0.3", 1.81303, 0.3, "released", (7, "23.9", "26.4"), (10, "26.6", "25.9")),
    ("10 MPa, 0.8", 9.9717, 0.8, "released", (None, "28.3", "31.2")),
    ("422 m/s", 2.79347, 0.7, "released", (7, "12.6", "14.9"), (10, "12.4", "13.1")),
    ("775 m/s", 9.42157, 0.7, "released", (7, "34.5", "37.7")),
    ("eroded nodes in contact", S, 0.7, "in contact", (None, "23.7", "24.1")),
)
