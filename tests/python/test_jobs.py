"""Calibrations; seconds of processor time: label slow."""

import json
import os
import tempfile
import unittest

import numpy as np

import percal

JOB = os.path.join(os.environ["PERCAL_DATA"], "synthetic", "joint_small.toml")
SCENE = os.path.join(os.environ["PERCAL_DATA"], "guha2009", "gold.toml")


class ACalibration(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.store = os.path.join(cls.folder.name, "percal.store")
        cls.sentences = []
        cls.found = percal.calibrate(JOB, store=cls.store, threads=1, announce=cls.sentences.append)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_finds_what_the_data_were_made_with(self):
        hypothesis = self.found.hypotheses[0]
        self.assertAlmostEqual(hypothesis.parameters["mu"] / 120e3, 1, delta=0.03)
        self.assertAlmostEqual(hypothesis.parameters["alpha"], 6, delta=0.4)
        self.assertAlmostEqual(hypothesis.parameters["erosion_strain"], 1.1, delta=0.2)  # coarse meshes

    def test_has_intervals_arrays_and_a_ridge(self):
        hypothesis = self.found.hypotheses[0]
        low, high = hypothesis.intervals["mu"][:2]
        self.assertTrue(low < hypothesis.parameters["mu"] < high)
        shots = hypothesis.shots
        np.testing.assert_allclose(shots["depth_m"] / shots["measured_m"] - 1, shots["deviation"], atol=1e-9)
        ridge = hypothesis.ridges[0]
        self.assertEqual(ridge.rise.shape, (ridge.y.size, ridge.x.size))
        self.assertTrue(ridge.contours[0].shape[1] == 2)
        self.assertRegex(repr(self.found), r"mu = .* kPa \[.*erosion_strain = ")

    def test_is_its_result_as_a_dict(self):
        self.assertEqual(self.found["command"], "calibrate")
        self.assertIn("hypotheses", dict(self.found))
        self.assertTrue(self.found.cost["isa"])
        self.assertTrue(any("is fitted" in sentence for sentence in self.sentences))

    def test_predicts_a_shot_that_was_not_fired(self):
        fired = self.found["shot_model"]["shots"][0]
        speed = fired["speed_m_s"] * 1.02
        said = {"speed": speed, "radius": fired["radius_m"], "particle_density": fired["density_kg_m3"]}
        said["layer_depth"] = f"{fired['layer_depth_m']} m"
        shot = self.found.predict(**said)
        self.assertTrue(0.5 < shot.depth / fired["depth_m"] < 2)
        self.assertTrue(shot.shots["low_m"][0] < shot.shots["mean_low_m"][0] < shot.depth < shot.shots["high_m"][0])
        self.assertTrue(shot.curve["depth_m"].size > 10)
        with open(os.path.join(self.folder.name, "result.json"), "w", encoding="utf-8") as file:
            json.dump(self.found.result, file)
        for kept in (self.folder.name, os.path.join(self.folder.name, "result.json"), dict(self.found)):
            self.assertEqual(percal.predict(kept, **said)["shots"], shot["shots"])
        wanted = self.found.predict(**(said | {"speed": None}), depth=shot.depth)
        self.assertAlmostEqual(wanted.value / speed, 1, delta=1e-3)

    def test_says_where_a_powder_ends_and_which_one_ends_there(self):
        fired = self.found["shot_model"]["shots"][0]
        name = os.path.join(self.folder.name, "powder.toml")
        with open(os.path.join(self.folder.name, "found.json"), "w", encoding="utf-8") as file:
            json.dump(self.found.result, file)
        radius, speed, depth = fired["radius_m"], fired["speed_m_s"], fired["depth_m"]
        with open(name, "w", encoding="utf-8") as file:
            file.write(f'''calibration = "found.json"
bounce = "none"
layer_depth = "{fired["layer_depth_m"]} m"
[powder]
density = "{fired["density_kg_m3"]} kg/m3"
speed = "{speed} m/s"
[powder.radius]
median = "{radius} m"
geometric_deviation = 1.1
weighting = "number"
[band]
from = "{0.8 * depth} m"
to = "{1.2 * depth} m"
[design]
radius = ["{0.9 * radius} m", "{1.1 * radius} m"]
speed = ["{0.9 * speed} m/s", "{1.1 * speed} m/s"]
map = 5
''')
        dose = percal.dose(name)
        self.assertTrue(0.5 < dose.mean / depth < 2)
        self.assertTrue(np.all(np.diff(dose.mass_above["best"]) >= 0))
        design = percal.design(name)
        self.assertTrue(design.found and design.dose["best"] >= dose.shares["in_band"]["best"] - 1e-3)
        self.assertEqual(design.map["dose"].shape, (25,))
        self.assertRegex(repr(design), "of the mass in the band")

    def test_of_a_prediction_names_what_it_cannot_use(self):
        with self.assertRaisesRegex(ValueError, "--diameter: found"):
            self.found.predict(diameter="3")
        with self.assertRaisesRegex(TypeError, "velocity"):
            self.found.predict(velocity=83)
        with self.assertRaisesRegex(FileNotFoundError, "nowhere"):
            percal.predict("nowhere", speed=83)
        with self.assertRaisesRegex(ValueError, "this result: schema"):
            percal.predict({}, speed=83)

    def test_goes_on_from_its_store(self):
        again = percal.calibrate(JOB, budget="5 min", store=self.store, threads=1)
        self.assertEqual(again.cost["runs"], 0)
        self.assertEqual(again.hypotheses[0].parameters, self.found.hypotheses[0].parameters)

    def test_ends_by_an_exception_of_the_listener(self):
        def refuse(sentence):
            raise RuntimeError(sentence)

        with self.assertRaisesRegex(RuntimeError, "runs"):
            percal.calibrate(JOB, store=self.store, threads=1, announce=refuse)

    def test_a_missing_file_is_an_os_error_and_a_bad_word_a_value_error(self):
        with self.assertRaisesRegex(FileNotFoundError, "nowhere.toml"):
            percal.calibrate("nowhere.toml", store=self.store)
        with self.assertRaisesRegex(ValueError, 'budget: found "5 m"'):
            percal.calibrate(JOB, budget="5 m", store=self.store)
        with self.assertRaisesRegex(FileNotFoundError, "nowhere.toml"):
            percal.identify("nowhere.toml", store=self.store)


class ACampaign(unittest.TestCase):
    def test_has_a_row_for_each_point(self):
        with tempfile.TemporaryDirectory() as folder:
            plan, store = os.path.join(folder, "plan.toml"), os.path.join(folder, "store")
            sweeps = [("particle.speed", '["300 m/s", "500 m/s"]'), ("target.bottom", '["free"]'), ("mesh.elements_per_radius", "[4]")]
            with open(plan, "w", encoding="utf-8") as file:
                file.write(f'scene = "{os.path.abspath(SCENE)}"\nreplicates = 2\n')
                for key, values in sweeps:
                    file.write(f'[[sweep]]\nkey = "{key}"\nvalues = {values}\n')
            found = percal.campaign(plan, store=store, threads=1)
            self.assertEqual(list(found.values["particle.speed [m/s]"]), [300, 500])
            self.assertEqual(found.values["target.bottom"], ["free", "free"])
            self.assertEqual(found.outcomes, ["stopped", "stopped"])
            self.assertTrue(found.depth[0] < found.depth[1])
            self.assertEqual(percal.campaign(plan, store=store).cost["runs"], 0)
        with self.assertRaisesRegex(FileNotFoundError, "nowhere.toml"):
            percal.campaign("nowhere.toml")


if __name__ == "__main__":
    unittest.main()
