"""Seeds for fuzz_readers: files of data/ and what the program writes.    seeds.py SOURCE PROGRAM FOLDER"""
import json
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile

source, program, folder = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
JOBS = {"scene": ["gold.toml", "steel.toml", "rhombus.toml", "skin_layers.toml", "gold_length.toml"], "scale": ["similar.toml"], "identify": ["skin.toml"],
        "calibrate": ["skin_consistent.toml", "gelatin_length.toml"], "campaign": ["gold_sweep.toml"], "dose": ["gold_dose.toml"]}
# What percal new writes, and the reader of it.
TEMPLATES = {"scene": "scene", "scale": "scale", "identify": "identify", "calibrate": "calibrate", "campaign": "campaign", "dose": "dose", "design": "dose"}
QUANTITIES = ["1 kPa", "2.3e-3 kg/m3", "5 um", "1/s", "3 m/s", "10 %", "7"]
# Four corners and the triangles of their tetrahedron, anticlockwise from outside.
CHIP = [(-1, -0.7, 0), (1, -0.5, 0.2), (0, 0.9, 0.1), (0.2, 0.1, 1.6)]
CHIP_TRIANGLES = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
SOLVERS = ["lsdyna", "abaqus", "calculix", "openradioss", "febio", "ansys"]


def seed(reader, name, content):
    place = folder / reader
    place.mkdir(parents=True, exist_ok=True)
    (place / name).write_bytes(content)


def run(*words):
    subprocess.run([program, *map(str, words)], check=True, capture_output=True, cwd=work)


for reader, names in JOBS.items():
    for name in names:
        seed(reader, name, (source / "data/guha2009" / name).read_bytes())
seed("calibrate", "joint.toml", (source / "data/synthetic/joint.toml").read_bytes())
for table in [*source.glob("data/*/*.csv")]:
    for reader in ("csv", "curves"):
        seed(reader, table.name, table.read_bytes()[:4000])
for table in [*source.glob("tools/templates/*.csv"), source / "data/guha2009/gold_skin.csv"]:
    for reader in ("points", "powder"):
        seed(reader, table.name, table.read_bytes())
for variant in [*source.glob("tools/templates/variants/*.toml")]:
    reader = variant.stem.split("_")[0]
    seed(reader, variant.name, variant.read_text().replace("STEM", reader).encode())
facets = [[CHIP[k] for k in triangle] for triangle in CHIP_TRIANGLES]
vertices = lambda facet: "".join("vertex {} {} {}\n".format(*corner) for corner in facet)
seed("stl", "text.stl", ("solid chip\n" + "".join(f"facet normal 0 0 1\nouter loop\n{vertices(f)}endloop\nendfacet\n" for f in facets) + "endsolid chip\n").encode())
seed("stl", "binary.stl", bytes(80) + struct.pack("<I", 4) + b"".join(struct.pack("<12fH", 0, 0, 1, *(x for corner in f for x in corner), 0) for f in facets))
seed("stl", "chip.csv", (source / "data/synthetic/chip.csv").read_bytes())
seed("trajectory", "flight.csv", (source / "tools/templates/calibrate_flight.csv").read_bytes())
# Of a ball of 80 m/s that is slowed down evenly, to a stop or not.
for name, last in (("stopped", 1.4), ("half", 0.8), ("begun", 0.3)):
    rows = [(1.2 * last * k / 11, max(0, 1 - last * k / 11)) for k in range(12)]
    seed("trajectory", name + ".csv", ("time_ms,depth_mm,speed_m_s\n" + "".join(f"{t:.3f},{48 * (1 - left ** 2):.3f},{80 * left:.2f}\n" for t, left in rows)).encode())
for k, quantity in enumerate(QUANTITIES):
    seed("quantity", str(k), quantity.encode())
with tempfile.TemporaryDirectory() as name:
    work = pathlib.Path(name)
    run("fit", source / "data/synthetic/gelatin_12wt_quasistatic.csv", "--out", "fit")
    run("scale", source / "data/guha2009/similar.toml", "--out", "scale")
    for result in ("fit", "scale"):
        seed("result", result + ".json", (work / result / "result.json").read_bytes())
    for solver in SOLVERS:
        run("card", "write", "fit/result.json", "--solver", solver, "--density", "1000 kg/m3", "--nu", "0.495", "--units", "mm-t-s-MPa", "--file", "card")
        seed(solver, "card", (work / "card").read_bytes())
    for kind, reader in TEMPLATES.items():
        run("new", kind, "-o", kind + ".toml")
        seed(reader, f"new_{kind}.toml", (work / (kind + ".toml")).read_bytes())
    # A small part of what a calibration keeps, in the program's schema of today.
    model = {"schema": json.loads((work / "scale/result.json").read_text())["schema"], **json.loads((source / "tests/fuzz/shot_model.json").read_text())}
    (work / "skin.json").write_text(json.dumps(model))
    seed("model", "skin.json", (work / "skin.json").read_bytes())
    for kind in ("dose", "design"):
        job = (work / (kind + ".toml")).read_text().replace("skin.out", "skin.json").replace("[design]", "[design]\nmap = 5")
        (work / (kind + ".toml")).write_text(job)
        run(kind, kind + ".toml", "--out", kind)
        seed("result", kind + ".json", (work / kind / "result.json").read_bytes())
    shutil.copy(source / "tests/data/layer.toml", work)
    run("impact", "layer.toml", "--elements-per-radius", "3", "--replicates", "1", "--store", "made.store", "--out", "impact")
    (work / "sweep.toml").write_text('scene = "layer.toml"\nreplicates = 1\n[[sweep]]\nkey = "mesh.elements_per_radius"\nvalues = [3, 3.5]\n')
    run("campaign", "sweep.toml", "--store", "made.store", "--out", "campaign")
    for result in ("impact", "campaign"):
        seed("result", result + ".json", (work / result / "result.json").read_bytes())
    seed("store", "one", (work / "made.store").read_bytes())
