"""Cards: written, read, and the curve that they mean."""

import os
import tempfile
import unittest

import numpy as np

import percal

GEL = percal.CardMaterial("gel", 1010.0, 50e3, 3.0, 5e6, 0.7)


class ACard(unittest.TestCase):
    def test_comes_back_from_every_solver(self):
        with tempfile.TemporaryDirectory() as folder:
            for solver in percal.solvers():
                with self.subTest(solver):
                    path = os.path.join(folder, solver)
                    with open(path, "w", encoding="utf-8") as file:
                        file.write(percal.write_card(GEL, solver, "mm-t-s-MPa"))
                    again = percal.read_card(path, solver, "mm-t-s-MPa")
                    np.testing.assert_allclose(
                        [again.mu, again.alpha, again.density, again.bulk_modulus],
                        [GEL.mu, GEL.alpha, GEL.density, GEL.bulk_modulus],
                        rtol=1e-2,
                    )
                    self.assertAlmostEqual(again.mu / GEL.mu, 1, places=6)

    def test_is_converted_to_what_the_solver_means(self):
        self.assertIn("0.0333333", percal.write_card(GEL, "lsdyna", "mm-t-s-MPa"))  # 2 mu/alpha in MPa

    def test_says_its_solver_and_units_itself(self):
        with tempfile.NamedTemporaryFile("w", suffix=".k") as file:
            file.write(percal.write_card(GEL, "lsdyna", "mm-ms-kg-GPa"))
            file.flush()
            self.assertAlmostEqual(percal.read_card(file.name).mu / GEL.mu, 1, places=5)

    def test_says_what_it_passed_over_and_does_not_know(self):
        with tempfile.NamedTemporaryFile("w", suffix=".inp") as file:
            file.write("*MATERIAL, NAME=X\n*HYPERELASTIC, OGDEN, N=1\n0.1, 9., 0.\n*MULLINS EFFECT\n1, 2, 3\n")
            file.flush()
            with self.assertWarnsRegex(UserWarning, "passed over: .MULLINS EFFECT"):
                card = percal.read_card(file.name, units="mm-t-s-MPa")
        self.assertIsNone(card.density)
        self.assertIsNone(card.bulk_modulus)
        self.assertIn("density unknown", repr(card))

    def test_of_a_fit_takes_density_and_bulk_ratio(self):
        fit = percal.fit(np.linspace(0.8, 1.5, 8), percal.nominal_stress([(50e3, 3.0)], np.linspace(0.8, 1.5, 8)))
        card = percal.card_of(fit, name="gel", density=1010, bulk_to_shear=100)
        self.assertAlmostEqual(card.bulk_modulus, 5e6, delta=1)
        with self.assertRaisesRegex(ValueError, "density"):
            percal.card_of(fit)

    def test_of_something_else_is_a_value_error(self):
        with self.assertRaisesRegex(ValueError, 'solver: found "nastran"; accepted: lsdyna'):
            percal.write_card(GEL, "nastran")
        with self.assertRaisesRegex(ValueError, "units"):
            percal.write_card(GEL, "lsdyna", "mm-t-s-GPa")

    def test_means_a_curve(self):
        np.testing.assert_allclose(percal.card_curve(GEL, [1.5]), percal.nominal_stress([(50e3, 3.0)], [1.5]))

    def test_has_a_deck_ready_to_run(self):
        files = percal.uniaxial_deck(GEL, "calculix", "mm-t-s-MPa", job="gel")
        self.assertTrue(all(name.startswith("gel") for name in files))
        self.assertTrue(any("*HYPERELASTIC" in text for text in files.values()))

    def test_says_what_it_is(self):
        self.assertEqual(
            repr(GEL), "CardMaterial(gel: mu = 50 kPa, alpha = 3, K = 5 MPa, 1010 kg/m3, erosion strain 0.7 engineering)"
        )


if __name__ == "__main__":
    unittest.main()
