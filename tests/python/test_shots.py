"""Single shots: inverted by themselves. What a calibration predicts is in test_jobs.py."""

import os
import tempfile
import unittest

import numpy as np

import percal

SHOT = {
    "depth": 0.02,
    "diameter": "4.5 mm",
    "particle_density": 2500,
    "speed": "100 m/s",
    "density": "1000 kg/m3",
    "alpha": 5,
    "layer_depth": "40 mm",
    "layer_width": "11.25 mm",
    "elements_per_radius": 4,
}


class AnInversion(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.store = os.path.join(cls.folder.name, "percal.store")
        cls.found = percal.invert(**SHOT, erosion_strain=1, depth_error="5 %", store=cls.store)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_finds_the_modulus_and_back_the_strain(self):
        low, high = self.found.interval[:2]
        self.assertTrue(self.found.found and low < self.found.mu < high)
        back = percal.invert(**SHOT, mu=self.found.mu, store=self.store)
        self.assertTrue(back.interval.low < 1 < back.interval.high)
        self.assertRegex(repr(back), r"erosion strain .*\[")

    def test_has_its_ridge_as_arrays(self):
        ridge = self.found.ridge
        np.testing.assert_allclose(ridge["erosion_strain"], [0.5, 0.7, 1, 1.4, 2])
        self.assertTrue(np.all(np.diff(ridge["mu_Pa"]) < 0) and np.all(ridge["low"] < ridge["mu_Pa"]))
        self.assertEqual(self.found["ridge"][2]["mu_Pa"], self.found.mu)

    def test_says_what_was_not_found(self):
        none = percal.invert(**(SHOT | {"depth": "0.1 mm"}), erosion_strain=1, store=self.store)
        self.assertFalse(none.found)
        self.assertIsNone(none.mu)
        self.assertIn("out of reach", repr(none))

    def test_refuses_what_it_does_not_know(self):
        with self.assertRaisesRegex(ValueError, "--mu"):
            percal.invert(**SHOT, store=self.store)
        with self.assertRaisesRegex(TypeError, "sped"):
            percal.invert(**SHOT, sped=3, store=self.store)

    def test_is_a_page_in_a_notebook(self):
        self.assertIn("The ridge", self.found._repr_html_())


if __name__ == "__main__":
    unittest.main()
