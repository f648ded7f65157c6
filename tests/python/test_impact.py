"""Scenes and impacts, and what Ctrl-C does to them."""

import contextlib
import json
import os
import signal
import sqlite3
import subprocess
import tempfile
import threading
import time
import unittest
import unittest.mock

import numpy as np

import percal

DATA = os.environ["PERCAL_DATA"]
GOLD = percal.Scene.read(os.path.join(DATA, "guha2009", "gold.toml"))


def keys_of(value):
    """Every key, with those below it."""
    return {key: keys_of(inner) for key, inner in value.items()} if isinstance(value, dict) else None


class AScene(unittest.TestCase):
    def test_comes_back_from_text_and_dict(self):
        self.assertEqual(percal.Scene.parse(GOLD.to_toml()), GOLD)
        self.assertEqual(percal.Scene.from_dict(GOLD.to_dict()), GOLD)

    def test_is_changed_key_by_key(self):
        slower = GOLD.changed(particle={"speed": "500 m/s"})
        self.assertNotEqual(slower, GOLD)
        self.assertIn("500 m/s", repr(slower))

    def test_that_cannot_be_used_names_the_key(self):
        with self.assertRaisesRegex(ValueError, r"gold.toml, changed:\d+: particle.speed: found"):
            GOLD.changed(particle={"speed": 500})
        with self.assertRaisesRegex(FileNotFoundError, "nowhere.toml"):
            percal.Scene.read("nowhere.toml")


class AnImpact(unittest.TestCase):
    def test_has_depth_scatter_energy_and_history(self):
        found = percal.impact(GOLD, elements_per_radius=4, threads=1)
        self.assertEqual(found.outcome, "stopped")
        self.assertAlmostEqual(found.depth, found.depths.mean(), places=12)
        self.assertAlmostEqual(found.spread, found.depths.std(ddof=1), places=12)
        self.assertAlmostEqual(sum(v for k, v in found.energy.items() if k != "sum"), found.energy["sum"], places=9)
        self.assertAlmostEqual(found.history["tip_m"].max(), found.depths[2], delta=0.01 * found.depth)
        self.assertTrue(np.all(np.diff(found.history["time_s"]) > 0))
        self.assertEqual(found.history["energy_particle"][0], 1)
        self.assertRegex(repr(found), r"stopped, depth .* um \+- .* \(standard error of 5 runs\)")

    def test_has_what_a_field_measures(self):
        thin = GOLD.changed(target={"depth": "6 um"}, output={"after": "rest", "channel": True})
        found = percal.impact(thin, elements_per_radius=4, replicates=2, threads=1, history=False)
        self.assertEqual((found.outcome, found.final["ending"]), ("passed through", "passed through"))
        (name, behind), = found.speeds_behind
        self.assertEqual(name, "skin")
        self.assertLess(found.exit_speed, behind)
        self.assertEqual(found.exit_speed, found.final["speed_m_s"])
        self.assertEqual(found.channel["largest_radius_m"].shape, (10,))
        self.assertTrue(np.all(found.channel["largest_radius_m"] >= found.channel["end_radius_m"]))
        self.assertAlmostEqual(found.sectional_density, 0.0224, places=12)  # 4/3 rho a
        self.assertRegex(repr(found), r"passed through, deeper than .* um, left with .* m/s")
        plain = percal.impact(GOLD, elements_per_radius=4, replicates=1, threads=1, history=False)
        self.assertIsNone(plain.final)
        self.assertIsNone(plain.channel)
        self.assertIsNone(plain.exit_speed)

    def test_has_the_same_bits_at_any_number_of_threads(self):
        one, two = (percal.impact(GOLD, 4, replicates=2, threads=n, history=False) for n in (1, 2))
        np.testing.assert_array_equal(one.depths, two.depths)
        self.assertEqual(one.history, {})

    def test_has_the_keys_of_the_programs_result(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([os.environ["PERCAL_PROGRAM"], "impact", GOLD.source, "--elements-per-radius", "4", "--history", "h.csv", "--out",
                            "out", "--store", "store", "--quiet"], cwd=folder, check=True)
            with open(os.path.join(folder, "out", "result.json"), encoding="utf-8") as file:
                printed = json.load(file)
        found = percal.impact(GOLD, elements_per_radius=4).result
        self.assertEqual(keys_of(found), keys_of(printed))
        self.assertEqual(found["depth_m"], printed["depth_m"])
        self.assertEqual((found["convention"], found["bulk_was_chosen"]), ("mu/alpha", False))

    def test_measures_its_errors_where_asked_to(self):
        ruled = percal.impact(GOLD, elements_per_radius=4, replicates=2)
        measured = percal.impact(GOLD, elements_per_radius=4, replicates=2, measure_errors=True)
        self.assertEqual(measured.depth, ruled.depth)
        self.assertNotEqual(measured.depth_error, ruled.depth_error)
        with self.assertRaisesRegex(ValueError, "--extrapolate: found a scene without target.erosion.length"):
            percal.impact(GOLD, extrapolate=True)

    def test_is_found_again_in_its_store(self):
        with tempfile.TemporaryDirectory() as folder:
            store = os.path.join(folder, "percal.store")
            first, second = (percal.impact(GOLD, 4, replicates=1, store=store, history=False) for _ in range(2))
        self.assertEqual([run["reused"] for run in first.result["runs"] + second.result["runs"]], [False, True])
        self.assertEqual(first.depth, second.depth)

    def test_whose_store_cannot_be_written_is_an_os_error(self):
        with self.assertRaisesRegex(OSError, "/dev/null"):
            percal.impact(GOLD, 4, replicates=1, store="/dev/null/percal.store")

    def test_options_go_through_the_readers_checks(self):
        with self.assertRaisesRegex(ValueError, "replicates"):
            percal.impact(GOLD, replicates=0)

    def test_lets_other_threads_run(self):
        seen = []

        def count():
            while not seen or seen[-1] != "end":
                seen.append(time.monotonic())
                time.sleep(0.001)

        other = threading.Thread(target=count, daemon=True)
        other.start()
        before = len(seen)
        percal.impact(GOLD, 8, replicates=2, threads=1, history=False)
        self.assertGreater(len(seen) - before, 5)
        seen.append("end")
        other.join(1)

    def test_ends_by_ctrl_c_before_the_next_run(self):
        with tempfile.TemporaryDirectory() as folder:
            store = os.path.join(folder, "percal.store")

            def finished_runs():
                if not os.path.exists(store):
                    return 0
                with contextlib.closing(sqlite3.connect(store)) as kept:
                    with contextlib.suppress(sqlite3.OperationalError):  # it is being made
                        return kept.execute("select count(*) from evaluations").fetchone()[0]
                return 0

            def interrupt_after_the_first_run():
                while not finished_runs():
                    time.sleep(0.01)
                os.kill(os.getpid(), signal.SIGINT)

            threading.Thread(target=interrupt_after_the_first_run, daemon=True).start()
            with self.assertRaises(KeyboardInterrupt):
                percal.impact(GOLD, 6, replicates=1000, threads=1, store=store, history=False)
            finished = finished_runs()
        self.assertTrue(1 <= finished < 1000, finished)

    def test_ends_by_ctrl_c_within_a_run(self):
        threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
        start = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            percal.impact(GOLD, 100, replicates=1, threads=1, history=False)  # minutes
        self.assertLess(time.monotonic() - start, 3)


class AResultInANotebook(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.impact = percal.impact(GOLD, elements_per_radius=4, replicates=1)
        cls.fit = percal.fit([1.1, 1.2, 1.3, 1.4], [10e3, 19e3, 27e3, 36e3])

    def test_is_the_page_in_a_frame_of_its_own(self):
        for shown, words in ((self.impact, "Impact"), (self.fit, "alpha")):
            frame = shown._repr_html_()
            self.assertTrue(frame.startswith('<iframe srcdoc="&lt;!DOCTYPE html&gt;'))
            self.assertIn(words, frame)

    def test_is_drawn_into_the_axes_that_it_is_given(self):
        for shown, x, y in ((self.impact, "time, ms", "depth, mm"), (self.fit, "stretch", "nominal stress, kPa")):
            ax = unittest.mock.Mock()
            self.assertIs(shown.plot(ax), ax)
            ax.set_xlabel.assert_called_once_with(x)
            ax.set_ylabel.assert_called_once_with(y)
            self.assertTrue(ax.plot.called)

    def test_says_what_is_missing_where_there_is_no_matplotlib(self):
        with unittest.mock.patch.dict("sys.modules", {"matplotlib": None, "matplotlib.pyplot": None}):
            with self.assertRaisesRegex(ImportError, "matplotlib, which is not installed"):
                self.impact.plot()
        with self.assertRaisesRegex(ValueError, "history=True"):
            percal.impact(GOLD, 4, replicates=1, history=False).plot()


if __name__ == "__main__":
    unittest.main()
