# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of a run read by VTK (what ParaView reads with) and ASE (extended XYZ): other_readers.py HGRID.

The scene is written here from known numbers, so the first picture is known to the last bit; the later ones must agree
between the two formats. Without VTK and ASE the test is skipped (exit code 77): they are no dependencies.
"""

import glob
import subprocess
import sys
import tempfile

import numpy as np

try:
    import ase.io
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
except ImportError as missing:
    print(f"skipped: {missing} (on Debian: apt-get install python3-vtk9 python3-ase)")
    sys.exit(77)

EDGES = (8.0, 9.0, 10.0)
RADII = (1.0, 0.7)
SEED = 20

SCENE = """
[box]
max = [8, 9, 10]
[periodic]
axes = "xy"
[contact]
stiffness = 1e3
[friction]
coefficient = 0.3
[gravity]
acceleration = [0, 0, -1]
[time]
end = 6
[output]
every = 2
formats = ["vtp", "xyz"]
"""


def known_particles():
    """One sphere per corner of a cube of lattice sites, so that none overlap: centres, velocities, radii, spins."""
    random = np.random.default_rng(SEED)
    sites = np.stack(np.meshgrid(*[(0.25, 0.75)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    centers = sites * EDGES + random.uniform(-0.2, 0.2, sites.shape)
    radii = np.array([RADII[i % 2] for i in range(len(sites))])
    return centers, random.normal(size=sites.shape), radii, random.normal(size=sites.shape)


def run_scene(hgrid, folder, particles):
    groups = ""
    for center, velocity, radius, spin in zip(*particles):
        groups += f"[[particles]]\nat = [{center.tolist()}]\nvelocity = {velocity.tolist()}\n"
        groups += f"radius = {radius}\nspin = {spin.tolist()}\n"
    with open(folder + "/scene.toml", "w") as file:
        file.write(groups + SCENE)
    command = [hgrid, "run", folder + "/scene.toml", "--quiet", "--output", folder + "/out"]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


def read_vtp(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutput()
    assert data.GetNumberOfVerts() == data.GetNumberOfPoints(), path
    arrays = {"time": vtk_to_numpy(data.GetFieldData().GetArray("TimeValue"))[0]}
    arrays["centers"] = vtk_to_numpy(data.GetPoints().GetData())
    for name in ("radius", "mass", "velocity", "spin"):
        arrays[name] = vtk_to_numpy(data.GetPointData().GetArray(name))
    return arrays


def check_walls(path):
    """The box: its twelve edges, and faces where it ends in walls, in cells that VTK counts lines first."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutput()
    assert data.GetNumberOfLines() == 12 and data.GetNumberOfPolys() == 2, path
    assert data.GetBounds() == (0, EDGES[0], 0, EDGES[1], 0, EDGES[2]), path
    assert (vtk_to_numpy(data.GetCellData().GetArray("wall")) == -1).all(), path
    for cell in (12, 13):
        assert data.GetCell(cell).GetBounds()[4] == data.GetCell(cell).GetBounds()[5], path


def read_xyz(path):
    atoms = ase.io.read(path, format="extxyz")
    assert atoms.get_pbc().tolist() == [True, True, False], path
    assert np.array_equal(atoms.cell.array, np.diag(EDGES)), path
    return {
        "time": atoms.info["Time"],
        "centers": atoms.get_positions(),
        "radius": atoms.get_array("radius"),
        "mass": atoms.get_array("mass"),
        "velocity": atoms.get_array("velo"),
        "spin": atoms.get_array("angular_velocity"),
    }


def main(hgrid):
    centers, velocities, radii, spins = particles = known_particles()
    masses = 4 / 3 * np.pi * radii**3
    with tempfile.TemporaryDirectory() as folder:
        run_scene(hgrid, folder, particles)
        pictures = sorted(glob.glob(folder + "/out/state-*.vtp"))
        assert len(pictures) == 4, pictures
        for k, path in enumerate(pictures):
            check_walls(path.replace("state-", "walls-"))
            vtp, xyz = read_vtp(path), read_xyz(path.replace(".vtp", ".xyz"))
            for name in vtp:
                assert np.array_equal(vtp[name], xyz[name]), (SEED, path, name)
            known = [("radius", radii)]
            if k == 0:
                known += [("centers", centers), ("velocity", velocities), ("spin", spins)]
            for name, truth in known:
                assert np.array_equal(vtp[name], truth), (SEED, path, name)
            assert np.allclose(vtp["mass"], masses, rtol=1e-15), (SEED, path)
            assert abs(vtp["time"] - 2 * k) < 0.1, (path, vtp["time"])
        assert not np.array_equal(read_vtp(pictures[-1])["spin"], spins), "nothing has collided"
    print(f"seed {SEED}: {len(pictures)} pictures read by VTK and ASE")


main(sys.argv[1])
