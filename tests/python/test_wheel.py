"""The wheel that pip installs: made by the backend of pyproject.toml from this build, and used from its zip."""

import os
import subprocess
import sys
import tempfile
import unittest
import zipfile

SOURCE = os.path.join(os.path.dirname(__file__), "..", "..", "lib", "python")


class TheWheel(unittest.TestCase):
    def test_has_the_module_and_its_metadata(self):
        import percal

        sys.path.insert(0, SOURCE)
        import build_backend

        build = os.path.join(os.path.dirname(percal.__file__), "..", "..")
        with tempfile.TemporaryDirectory() as folder:
            name = build_backend.build_wheel(folder, {"build-dir": build})
            with zipfile.ZipFile(os.path.join(folder, name)) as wheel:
                wheel.extractall(folder)
            info = f"percal-{percal.__version__}.dist-info"
            with open(os.path.join(folder, info, "RECORD"), encoding="utf-8") as record:
                listed = {line.split(",")[0] for line in record}
            found = {os.path.relpath(os.path.join(at, file), folder) for at, _, files in os.walk(folder) for file in files}
            self.assertEqual(found - {name}, listed)
            code = "import percal; print(percal.__file__)"
            answer = subprocess.run([sys.executable, "-B", "-c", code], env={"PYTHONPATH": folder}, check=True, capture_output=True, text=True)
            self.assertEqual(answer.stdout.strip(), os.path.join(folder, "percal", "__init__.py"))


if __name__ == "__main__":
    unittest.main()
