"""Curves: points and files in, the solid out."""

import json
import os
import subprocess
import tempfile
import unittest

import numpy as np

import percal

DATA = os.environ["PERCAL_DATA"]
STRETCH = np.linspace(0.7, 1.6, 10)
GEL = [(50e3, 3.0)]


def noisy(seed=1):
    stress = percal.nominal_stress(GEL, STRETCH)
    return stress * (1 + 0.01 * np.random.default_rng(seed).standard_normal(STRETCH.size))


class AFit(unittest.TestCase):
    def test_in_three_lines(self):
        stress = noisy()
        fit = percal.fit(STRETCH, stress)
        self.assertAlmostEqual(fit.mu / 50e3, 1, delta=0.02)
        self.assertAlmostEqual(fit.alpha, 3, delta=0.2)
        self.assertGreater(fit.r2, 0.999)

    def test_has_intervals_that_hold_the_estimate(self):
        fit = percal.fit(STRETCH, noisy())
        for name, value in (("mu", fit.mu), ("alpha", fit.alpha)):
            low, high = fit.intervals[name][:2]
            self.assertLess(low, value)
            self.assertGreater(high, value)

    def test_has_the_region_of_every_minimum_that_fits_as_well(self):
        plain = percal.fit(STRETCH, noisy())
        self.assertEqual(plain.region["alpha"], [plain.intervals["alpha"][:2]])
        even = percal.fit(STRETCH, percal.nominal_stress(GEL, STRETCH, "planar") * np.tile([1.01, 0.99], 5), mode="planar")
        (low, high), (other_low, other_high) = even.region["alpha"]
        self.assertAlmostEqual(low, -other_high, places=3)
        self.assertAlmostEqual(high, -other_low, places=3)
        self.assertRegex(repr(even), r"alpha = .* \[.*\] or \[.*\]")

    def test_has_the_covariance_of_its_intervals(self):
        fit = percal.fit(STRETCH, noisy())
        self.assertEqual(fit.covariance.shape, (2, 2))
        self.assertTrue(np.all(np.linalg.eigvalsh(fit.covariance) > 0))
        half = (fit.intervals["mu"].high - fit.intervals["mu"].low) / 2
        self.assertAlmostEqual(half / np.sqrt(fit.covariance[0, 0]), 2.3, delta=0.2)  # Student t, 8 degrees of freedom

    def test_predicts_nominal_stress_in_the_shape_given(self):
        fit = percal.fit(STRETCH, percal.nominal_stress(GEL, STRETCH))
        grid = np.array([[1.1, 1.2], [1.3, 1.4]])
        closed = 2 * 50e3 / 3 * (grid**2 - grid**-2.5)
        np.testing.assert_allclose(fit.predict(grid), closed, rtol=1e-6)
        np.testing.assert_allclose(fit.predict([0.1], "simple_shear"), [5e3], rtol=0.01)

    def test_of_a_mode_for_each_point_needs_one_to_predict(self):
        stress = np.concatenate([percal.nominal_stress(GEL, STRETCH, mode) for mode in ("uniaxial", "planar")])
        fit = percal.fit(np.tile(STRETCH, 2), stress, mode=["uniaxial"] * 10 + ["planar"] * 10)
        self.assertAlmostEqual(fit.alpha, 3, places=4)
        with self.assertRaisesRegex(ValueError, "mode: found nothing; accepted: .*planar, uniaxial"):
            fit.predict([1.2])

    def test_of_cauchy_stresses_is_that_of_the_nominal_ones(self):
        nominal = noisy()
        fit = percal.fit(STRETCH, nominal * STRETCH, cauchy=True)
        self.assertAlmostEqual(fit.mu, percal.fit(STRETCH, nominal).mu, delta=1e-6 * fit.mu)

    def test_of_two_terms_has_terms_and_no_single_alpha(self):
        stress = percal.nominal_stress([(50e3, 2.0), (20e3, -2.0)], STRETCH)
        fit = percal.fit(STRETCH, stress, model="mooney-rivlin")
        self.assertIsNone(fit.alpha)
        np.testing.assert_allclose(fit.terms, [(50e3, 2.0), (20e3, -2.0)], rtol=1e-6)
        self.assertAlmostEqual(fit.mu, 70e3, delta=0.1)

    def test_says_its_result_with_intervals(self):
        self.assertRegex(repr(percal.fit(STRETCH, noisy())), r"mu = .* kPa \[.*kPa, .*kPa\], alpha = .* \(95 %\), R2")

    def test_knows_where_it_is_stable(self):
        self.assertEqual(set(percal.fit(STRETCH, noisy()).stable), {"uniaxial", "equibiaxial", "planar"})

    def test_of_a_file_is_that_of_its_points(self):
        path = os.path.join(DATA, "synthetic", "gelatin_12wt_quasistatic.csv")
        of_file = percal.fit_csv(path)
        again = percal.fit(of_file.stretch, of_file.stress, mode=of_file.mode)
        self.assertEqual(of_file.mu, again.mu)
        self.assertAlmostEqual(of_file.mu / 11.64e3, 1, delta=0.05)

    def test_of_files_takes_a_mode_for_each(self):
        treloar = os.path.join(DATA, "public", "treloar1944_rubber_primary.csv")
        points = percal.fit_csv(treloar, where="stretch<3")
        with tempfile.TemporaryDirectory() as folder:
            files = {}
            for mode in ("uniaxial", "equibiaxial", "planar"):
                files[os.path.join(folder, mode + ".csv")] = mode
                with open(os.path.join(folder, mode + ".csv"), "w") as file:
                    file.write("stretch,stress_Pa\n")
                    for stretch, stress, of in zip(points.stretch, points.stress, points.mode):
                        if of == mode:
                            file.write(f"{float(stretch)!r},{float(stress)!r}\n")
            self.assertAlmostEqual(percal.fit_csv(list(files), mode=files).mu, points.mu, delta=1e-6 * points.mu)

    def test_of_a_file_has_the_result_that_the_program_writes(self):
        path = os.path.join(DATA, "synthetic", "gelatin_12wt_quasistatic.csv")
        options = ["--weights", "uniaxial=2", "--residual", "error", "--stable", "0.5:2", "--bootstrap", "5", "--level", "0.9"]
        program = [os.environ["PERCAL_PROGRAM"], "fit", path, *options, "--out", "none", "--json"]
        of_program = json.loads(subprocess.run(program, check=True, capture_output=True).stdout)
        ours = percal.fit_csv(path, weights={"uniaxial": 2}, residual="error", stretches=(0.5, 2), bootstrap=5, level=0.9).result
        self.assertEqual(ours.pop("cost").keys(), of_program.pop("cost").keys())
        self.assertEqual(ours, of_program)
        self.assertEqual(percal.fit(STRETCH, noisy()).result.keys(), percal.fit_csv(path).result.keys())

    def test_of_muscle_relaxes(self):
        path = os.path.join(DATA, "public", "vanloocke2008_muscle_rates.csv")
        fit = percal.fit_csv(path, mode="compression", where="direction=cross-fibre", relaxation="auto")
        self.assertEqual(fit.relaxation["terms"], 1)
        self.assertAlmostEqual(fit.relaxation["mu_0_Pa"], 319.2, delta=0.1)
        self.assertIsNone(percal.fit(STRETCH, noisy()).relaxation)

    def test_of_points_with_times_relaxes(self):
        time = np.concatenate([np.linspace(0.1, 1, 10), [1.5, 2, 3, 5, 8]])
        stretch = np.concatenate([np.linspace(1.05, 1.5, 10), np.full(5, 1.5)])
        left = np.where(time > 1, 0.5 + 0.5 * np.exp(-(time - 1)), 1)
        fit = percal.fit(stretch, percal.nominal_stress(GEL, stretch) * left, time=time, relaxation=1)
        self.assertLess(fit.relaxation["mu_inf_Pa"], 0.7 * fit.relaxation["mu_0_Pa"])
        self.assertEqual(len(fit.relaxation["series"]), 1)


class WhatCannotBeUsed(unittest.TestCase):
    def test_is_a_value_error_that_says_what_is_accepted(self):
        for arguments, said in (
            (dict(mode="sideways"), 'mode: found "sideways"; accepted: UT, uniaxial'),
            (dict(model="rubber"), 'model: found "rubber"; accepted: ogden, ogden2'),
            (dict(weights={"uniaxial": -1}), "weights: found -1"),
            (dict(level=2), "level: found 2"),
            (dict(stretches=(2, 3)), "stretches: found 2"),
            (dict(error=[1.0]), "error: found 1 values; accepted: 10"),
            (dict(relaxation=1), "time: found nothing"),
            (dict(time=STRETCH), "time: found times without relaxation"),
            (dict(time=STRETCH, relaxation=4), 'relaxation: found "4"; accepted: 1, 2, 3 or auto'),
        ):
            with self.subTest(arguments), self.assertRaisesRegex(ValueError, said):
                percal.fit(STRETCH, noisy(), **arguments)

    def test_names_the_point(self):
        with self.assertRaisesRegex(ValueError, r"stretch\[1\]: found -1"):
            percal.fit([1.1, -1, 1.3], [1, 2, 3])
        with self.assertRaisesRegex(ValueError, r"stretch\[2\]"):
            percal.fit([1.1, 1.2, 1.3], [1, 2, np.nan])

    def test_names_the_file(self):
        with self.assertRaisesRegex(ValueError, "nowhere.csv"):
            percal.fit_csv("nowhere.csv")


if __name__ == "__main__":
    unittest.main()
