"""Similar systems."""

import os
import unittest

import percal

DATA = os.path.join(os.environ["PERCAL_DATA"], "guha2009")
GOLD = {"radius": "1 um", "particle_density": "16.8 g/cm3", "speed": "651 m/s", "target_density": "1000 kg/m3",
        "mu": "64 MPa", "alpha": 8.5}


class TwoSystems(unittest.TestCase):
    def test_of_a_job_are_compared_group_by_group(self):
        found = percal.scale(os.path.join(DATA, "similar.toml"))
        self.assertTrue(found.is_similar)
        self.assertEqual(found.groups["pi4"][2], "agree")
        self.assertAlmostEqual(found.modulus_ratio, 0.0075471, places=6)
        self.assertEqual((found["command"], found["schema"]), ("scale", 2))

    def test_as_dicts_are_completed(self):
        steel = {"radius": "1.59 mm", "particle_density": "7800 kg/m3", "speed": "83 m/s"}
        found = percal.scale(prototype=GOLD, model=steel)
        density = 1000 * 7800 / 16800
        self.assertAlmostEqual(found["model"]["target_density_kg_m3"], density, delta=1e-9 * density)
        self.assertAlmostEqual(found.modulus_ratio, density * 83**2 / (1000 * 651**2), places=9)

    def test_make_a_similar_scene(self):
        scene = percal.scale(os.path.join(DATA, "similar.toml")).similar_scene()
        kept = percal.Scene.read(os.path.join(DATA, "steel.toml"))
        self.assertEqual(scene.to_dict()["particle"], kept.to_dict()["particle"])

    def test_without_a_scene_make_none(self):
        with self.assertRaisesRegex(ValueError, "prototype.scene"):
            percal.scale(prototype=GOLD, model={"radius": "1 mm"}).similar_scene()

    def test_are_two_or_a_job(self):
        for arguments in ({}, {"prototype": GOLD}, {"job": "x", "prototype": GOLD, "model": GOLD}):
            with self.subTest(arguments), self.assertRaisesRegex(ValueError, "scale: "):
                percal.scale(**arguments)


if __name__ == "__main__":
    unittest.main()
