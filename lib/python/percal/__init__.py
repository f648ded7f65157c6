"""Material identification for soft solids from stress-stretch curves and penetration depths.

All numbers are SI: metres, seconds, kilograms, pascals; stretches, strains and exponents have no unit. Moduli called `mu` are true
small-strain shear moduli. Quantities in texts and dicts carry their unit: "1.2 MPa".

    import percal
    fit = percal.fit(stretch, stress)
    print(fit.mu, fit.alpha, fit.intervals)

Input that cannot be used raises ValueError, which names the place, what was found and what is accepted; a file that cannot be read
or written raises OSError, one that is not there FileNotFoundError. Numerical outcomes (passed through, unstable) are values. Other
Python threads run on while percal computes, and Ctrl-C ends an impact within a second. Notebooks show results as pages.
"""

from ._card import CardMaterial, card_curve, card_of, read_card, solvers, uniaxial_deck, write_card
from ._core import __version__, default_store_path, instruction_level
from ._fit import Fit, Interval, Minimum, fit, fit_csv, nominal_stress
from ._impact import Impact, Scene, impact
from ._shots import Inversion, Prediction, invert, predict
from ._powder import Design, Dose, design, dose
from ._jobs import Calibration, Identification, Hypothesis, Ridge, Scaling, Sweep, calibrate, campaign, identify, scale

__all__ = [
    "Calibration",
    "CardMaterial",
    "Design",
    "Dose",
    "Fit",
    "Identification",
    "Impact",
    "Interval",
    "Inversion",
    "Minimum",
    "Prediction",
    "Hypothesis",
    "Ridge",
    "Scaling",
    "Scene",
    "Sweep",
    "__version__",
    "calibrate",
    "campaign",
    "card_curve",
    "card_of",
    "default_store_path",
    "design",
    "dose",
    "fit",
    "fit_csv",
    "identify",
    "impact",
    "instruction_level",
    "invert",
    "nominal_stress",
    "predict",
    "read_card",
    "scale",
    "solvers",
    "uniaxial_deck",
    "write_card",
]
