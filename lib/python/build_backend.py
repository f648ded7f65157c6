"""The wheel of percal for pip (PEP 517), built by CMake.

It takes what the program takes, and pybind11 (`sh tools/setup.sh build python`); nothing is downloaded. The build stands in build/pip and is
used again; `--config-settings build-dir=build/release` takes the module of a build that is there."""

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def version():
    return re.search(r"project\(percal VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]


def metadata():
    return f"Metadata-Version: 2.1\nName: percal\nVersion: {version()}\nLicense: GPL-3.0-or-later\nRequires-Python: >=3.10\nRequires-Dist: numpy\n"


def tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{re.sub('[-.]', '_', sysconfig.get_platform())}"


def package(settings):
    """The folder of the package, built."""
    given = (settings or {}).get("build-dir")
    build = pathlib.Path(given or ROOT / "build" / "pip").resolve()
    if not given:
        options = ["-DCMAKE_BUILD_TYPE=Release", "-DPERCAL_TESTS=OFF", "-DPERCAL_PYTHON=ON", f"-DPython3_EXECUTABLE={sys.executable}"]
        subprocess.run(["cmake", "-S", ROOT, "-B", build, "-G", "Ninja", *options], check=True)
    subprocess.run(["cmake", "--build", build, "--target", "percal_python"], check=True)
    return build / "python" / "percal"


def get_requires_for_build_wheel(config_settings=None):
    return []


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Writes the wheel and returns its name."""
    name, info = f"percal-{version()}-{tag()}.whl", f"percal-{version()}.dist-info"
    files = {f"percal/{file.name}": file.read_bytes() for file in sorted(package(config_settings).iterdir()) if file.is_file()}
    files[f"{info}/METADATA"] = metadata().encode()
    files[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: percal\nRoot-Is-Purelib: false\nTag: {tag()}\n".encode()
    record = [f"{file},sha256={_hash(content)},{len(content)}" for file, content in files.items()] + [f"{info}/RECORD,,"]
    files[f"{info}/RECORD"] = ("\n".join(record) + "\n").encode()
    with zipfile.ZipFile(os.path.join(wheel_directory, name), "w", zipfile.ZIP_DEFLATED) as wheel:
        for file, content in files.items():
            wheel.writestr(file, content)
    return name


def _hash(content):
    return base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
