"""Material cards."""

import json
import os
import warnings
from collections.abc import Mapping
from dataclasses import dataclass, field

from . import _core
from ._fit import Fit, nominal_stress
from ._shown import with_unit


@dataclass
class CardMaterial:
    """What a card says, SI: density (kg/m3), mu (Pa, true shear modulus), alpha, bulk_modulus (Pa); erosion_strain (the largest
    principal one, None for none) in erosion_measure: engineering, true or green-lagrange; comments: sources of the data.
    With several Ogden terms: terms [(mu, alpha), ...], mu their sum and alpha None. provenance: intervals, fit error and data as
    they stand in a result's card object."""

    name: str
    density: float | None
    mu: float
    alpha: float | None
    bulk_modulus: float | None
    erosion_strain: float | None = None
    erosion_measure: str = "engineering"
    comments: list = field(default_factory=list)
    terms: list = field(default_factory=list)
    provenance: dict = field(default_factory=dict)

    def __post_init__(self):
        if not self.terms:
            self.terms = [(self.mu, self.alpha)]

    @classmethod
    def _of(cls, card):
        erosion = card.get("erosion") or {}
        terms = [(one["mu_true_Pa"], one["alpha"]) for one in card.get("terms") or [card]]
        return cls(
            card["name"],
            card["density_kg_m3"],
            sum(mu for mu, _ in terms),
            terms[0][1] if len(terms) == 1 else None,
            card["bulk_modulus_Pa"],
            erosion.get("strain"),
            erosion.get("measure", "engineering"),
            list(card.get("comments", [])),
            terms,
            {key: card[key] for key in ("intervals", "fit_error", "contradiction", "data") if card.get(key)},
        )

    def _json(self):
        card = {
            "name": self.name,
            "density_kg_m3": self.density,
            "bulk_modulus_Pa": self.bulk_modulus,
            "erosion": None,
            "comments": list(self.comments),
            **self.provenance,
        }
        if self.erosion_strain is not None:
            card["erosion"] = {"strain": self.erosion_strain, "measure": self.erosion_measure}
        if len(self.terms) == 1:
            card |= {"mu_true_Pa": self.mu, "alpha": self.alpha}
        else:
            card["terms"] = [{"mu_true_Pa": mu, "alpha": alpha} for mu, alpha in self.terms]
        return json.dumps(card)

    def __repr__(self):
        erosion = "" if self.erosion_strain is None else f", erosion strain {self.erosion_strain:.4g} {self.erosion_measure}"
        density = "density unknown" if self.density is None else f"{self.density:g} kg/m3"
        alpha = f"{len(self.terms)} terms" if self.alpha is None else f"alpha = {self.alpha:.4g}"
        return (
            f"CardMaterial({self.name}: mu = {with_unit(self.mu, 'Pa')}, {alpha}, "
            f"K = {with_unit(self.bulk_modulus, 'Pa')}, {density}{erosion})"
        )


def solvers():
    """The programs that cards are written for: lsdyna, abaqus, calculix, ..."""
    return list(_core.solvers())


def card_of(result, name=None, density=None, bulk_to_shear=None):
    """The material of a result: its file, a result as identify() or calibrate() return it, or a Fit.

    A fit needs density (kg/m3) and bulk_to_shear (K over the shear modulus), which no curve tells; name chooses among several
    cards, and names that of a fit. ValueError where there is no card, or it is open which.
    """
    if isinstance(result, Fit):
        result = result.result
    if isinstance(result, Mapping):
        text, path = json.dumps(dict(result)), "result"
    else:
        path = os.fspath(result)
        with open(path, encoding="utf-8", errors="replace") as file:
            text = file.read()
    return CardMaterial._of(json.loads(_core.card_of_result(text, path, name or "", density, bulk_to_shear)))


def write_card(material, solver, units="si"):
    """The text of a card: solver as in solvers(); units such as "si", "mm-t-s-MPa", "mm-ms-kg-GPa". The modulus is converted to
    what the solver means by it."""
    return _core.write_card(solver, material._json(), units)


def read_card(path, solver=None, units=None):
    """The material of a card's file. solver and units: found in the text where a card says them. What of the card was passed
    over, and numbers that wrong units make, are warnings; density and bulk_modulus are None where the card does not say them."""
    path = os.fspath(path)
    with open(path, encoding="utf-8", errors="replace") as file:
        read = json.loads(_core.read_card(file.read(), path, solver, units))
    for text in read["warnings"] + ["passed over: " + one for one in read["passed_over"]]:
        warnings.warn(f"{path}: {text}", stacklevel=2)
    return CardMaterial._of(read["card"])


def card_curve(material, stretch, mode="uniaxial"):
    """Nominal stress (Pa) of the material at these stretches, as an incompressible solid."""
    return nominal_stress(material.terms, stretch, mode)


def uniaxial_deck(material, solver, units="si", stretch=2.0, increments=20, job="uniaxial"):
    """{file name: text} of a deck with one element that is stretched to `stretch`, ready to run; `job` names its files."""
    return dict(_core.uniaxial_deck(solver, material._json(), units, stretch, increments, job))
