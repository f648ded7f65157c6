"""Fields of a run as VTK's own reader finds them, held against the run's result. usage: fields_by_vtk.py PROGRAM ROUND_SCENE BLOCK_SCENE"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

try:
    import vtk
    from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
except ImportError:
    print("VTK is not here: skipped")
    sys.exit(77)

COMPONENTS = {"displacement": 3, "velocity": 3, "principal_stretches": 3, "stress": 6, "pressure": 1,
              "von_mises_stress": 1, "energy_density": 1, "eroded": 1, "layer": 1, "undeformed_volume": 1}


def read(path):
    """Points, arrays by name, time."""
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    assert reader.GetErrorCode() == 0, path
    grid = reader.GetOutput()
    arrays = {}
    for data in (grid.GetPointData(), grid.GetCellData()):
        for k in range(data.GetNumberOfArrays()):
            array = data.GetArray(k)
            assert array.GetNumberOfComponents() == COMPONENTS[array.GetName()], array.GetName()
            arrays[array.GetName()] = vtk_to_numpy(array)
    return grid, vtk_to_numpy(grid.GetPoints().GetData()), arrays, grid.GetFieldData().GetArray("TimeValue").GetValue(0)


def close(found, expected, tolerance, what):
    assert abs(found - expected) <= tolerance * abs(expected), f"{what}: {found} instead of {expected}"


def volumes(grid, points):
    """Of the cells, with their corners at `points`."""
    moved = vtk.vtkUnstructuredGrid()
    moved.DeepCopy(grid)
    places = vtk.vtkPoints()
    places.SetData(numpy_to_vtk(points, deep=True))
    moved.SetPoints(places)
    sizes = vtk.vtkCellSizeFilter()
    sizes.SetInputData(moved)
    sizes.Update()
    return vtk_to_numpy(sizes.GetOutput().GetCellData().GetArray("Volume"))


def block(program, scene):
    """Hexahedra that have the volumes they say; the particle's lowest point is the depth."""
    with tempfile.TemporaryDirectory() as folder:
        said = subprocess.run([program, "impact", scene, "--elements-per-radius", "4", "--replicates", "1", "--store", f"{folder}/s",
                               "--fields", "every=50%", "--out", folder, "--json"], check=True, capture_output=True)
        result = json.loads(said.stdout)
        folder = pathlib.Path(result["fields"]["list"]).parent
        last = result["fields"]["frames"] - 1
        grid, points, arrays, time = read(folder / f"target_{last:04}.vtu")
        assert grid.GetNumberOfCells() == result["elements"]
        assert all(grid.GetCellType(k) == vtk.VTK_HEXAHEDRON for k in range(grid.GetNumberOfCells()))
        found = volumes(grid, points - arrays["displacement"])
        assert abs(found / arrays["undeformed_volume"] - 1).max() < 1e-5, "volumes"
        assert int((arrays["eroded"] == 1).sum()) == result["runs"][0]["eroded"], "eroded cells"
        particle = read(folder / f"particle_{last:04}.vtu")[1]
        close(-particle[:, 2].min(), result["depth_m"], 1e-6, "depth")
    print(f"{len(found)} hexahedra as VTK reads them")


def main(program, scene, block_scene):
    block(program, block_scene)
    with tempfile.TemporaryDirectory() as folder:
        said = subprocess.run([program, "impact", scene, "--elements-per-radius", "5", "--replicates", "1", "--store", f"{folder}/s",
                               "--fields", "every=5%", "--out", folder, "--json"], check=True, capture_output=True)
        result = json.loads(said.stdout)
        pvd = pathlib.Path(result["fields"]["list"])
        entries = [e.attrib for e in xml.parse(pvd).iter("DataSet")]
        assert len(entries) == 2 * result["fields"]["frames"] >= 12, entries
        times = [float(e["timestep"]) for e in entries[::2]]
        assert times[0] == 0 and times == sorted(set(times))
        for entry in entries:
            grid, points, arrays, time = read(pvd.parent / entry["file"])
            assert time == float(entry["timestep"])
            if entry["part"] == "1":
                continue
            assert set(arrays) == set(COMPONENTS), set(arrays)
            assert grid.GetNumberOfCells() == result["elements"]
            reference = points - arrays["displacement"]
            close(-reference[:, 1].min(), 75e-6, 1e-6, "depth of the layer")
            stretches = arrays["principal_stretches"]
            assert (stretches[:, 0] >= stretches[:, 1]).all() and (stretches[:, 1] >= stretches[:, 2]).all()
            live = arrays["eroded"] == 0
            gone = arrays["stress"][~live]
            assert not gone.any()
            mean = arrays["stress"][:, :3].mean(axis=1)
            assert abs(mean + arrays["pressure"]).max() <= 1e-5 * max(1, abs(mean).max())
        assert int((~live).sum()) == result["runs"][0]["eroded"], "eroded cells"
        toml = result["input"]["toml"]
        mass = 4 / 3 * math.pi * 1e-18 * 16800
        speed = -read(pvd.parent / entries[1]["file"])[2]["velocity"][0, 1]
        assert f"speed = \"{speed:g} m/s\"" in toml, (speed, toml)
        assert "density = \"16800 kg/m3\"" in toml, toml
        grid, points, arrays, time = read(pvd.parent / entries[-2]["file"])
        stored = float((arrays["energy_density"].astype(float) * arrays["undeformed_volume"]).sum())
        close(stored, result["energy"]["elastic"] * mass * speed**2 / 2, 1e-5, "elastic energy")
        particle = read(pvd.parent / entries[-1]["file"])[1]
        close(-particle[:, 1].min(), result["depth_m"], 1e-3, "depth")
    print(f"{len(times)} frames as VTK reads them")


if __name__ == "__main__":
    main(*sys.argv[1:])
