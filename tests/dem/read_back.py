# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads what a run wrote with Python's own XML parser and numpy, and compares the formats: read_back.py FOLDER."""

import base64
import glob
import re
import sys
import xml.etree.ElementTree as xml

import numpy as np

TYPES = {"Float64": np.float64, "Int64": np.int64}


def arrays_of(parent):
    """The DataArrays below an element, by name, as numpy arrays [tuples, components]."""
    found = {}
    for array in parent.iter("DataArray"):
        if array.get("format") != "binary":
            continue
        data = base64.b64decode(array.text, validate=True)
        size = int(np.frombuffer(data[:8], dtype=np.uint64)[0])
        assert size == len(data) - 8, array.get("Name")
        numbers = np.frombuffer(data[8:], dtype=TYPES[array.get("type")])
        components = int(array.get("NumberOfComponents"))
        found[array.get("Name")] = numbers.reshape(-1, components)
    return found


def read_vtp(path):
    root = xml.parse(path).getroot()
    assert root.tag == "VTKFile" and root.get("type") == "PolyData", path
    assert root.get("byte_order") == ("LittleEndian" if sys.byteorder == "little" else "BigEndian")
    assert root.get("header_type") == "UInt64"
    piece = root.find("PolyData/Piece")
    count = int(piece.get("NumberOfPoints"))
    points = arrays_of(piece.find("Points"))["centers"]
    data = arrays_of(piece.find("PointData"))
    vertices = arrays_of(piece.find("Verts"))
    assert points.shape == (count, 3)
    assert all(len(array) == count for array in data.values())
    assert (vertices["connectivity"][:, 0] == np.arange(count)).all()
    assert (vertices["offsets"][:, 0] == np.arange(1, count + 1)).all()
    time = float(root.find("PolyData/FieldData/DataArray").text)
    return time, points, data


def read_xyz(path):
    with open(path) as file:
        count = int(file.readline())
        comment = file.readline()
        rows = [line.split() for line in file]
    assert len(rows) == count and all(row[0] == "X" for row in rows)
    time = float(re.search(r" Time=(\S+)", comment).group(1))
    lattice = np.array(re.search(r'Lattice="([^"]*)"', comment).group(1).split(), dtype=float)
    assert re.search(r'pbc="T T F"', comment)
    properties = re.search(r"Properties=(\S+)", comment).group(1).split(":")
    columns, place = {}, 0
    for name, kind, width in zip(properties[::3], properties[1::3], map(int, properties[2::3])):
        if kind == "R":
            columns[name] = np.array([row[place : place + width] for row in rows], dtype=float)
        place += width
    assert all(len(row) == place for row in rows)
    return time, lattice.reshape(3, 3), columns


def read_table(path):
    """CSV or a LAMMPS dump: time and step, and its columns by their names."""
    with open(path) as file:
        text = file.read()
    if path.endswith(".csv"):
        comment = re.search(r"# step: (\d+) time: (\S+)\n", text)
        step, time = comment.group(1), comment.group(2)
        header, *rows = [line.split(",") for line in text.splitlines() if not line.startswith("#")]
    else:
        time, step = re.match(r"ITEM: TIME\n(\S+)\nITEM: TIMESTEP\n(\d+)\n", text).groups()
        titles, body = re.search(r"ITEM: ATOMS (.*)\n([^I]*)$", text).groups()
        header, rows = titles.split(), [line.split() for line in body.splitlines()]
    table = np.array(rows, dtype=float)
    return float(time), int(step), {name: table[:, k] for k, name in enumerate(header)}


def check_table(path, names, time, points, data):
    """`names`: the first words of what the table calls velocity and spin."""
    other_time, step, columns = read_table(path)
    assert other_time == time and f"{step:012d}" in path
    for k, axis in enumerate("xyz"):
        assert (columns[axis] == points[:, k]).all()
        for name, own in zip(("velocity", "spin"), names):
            assert (columns[own + axis] == data[name][:, k]).all()
    assert (columns["radius"] == data["radius"][:, 0]).all() and (columns["mass"] == data["mass"][:, 0]).all()


def overlaps(points, radii, lattice):
    """By brute force: pairs and their overlaps, in a box that is periodic along x and y."""
    apart = points[None, :, :] - points[:, None, :]
    for axis in (0, 1):
        apart[:, :, axis] -= lattice[axis, axis] * np.round(apart[:, :, axis] / lattice[axis, axis])
    overlap = radii[None, :] + radii[:, None] - np.linalg.norm(apart, axis=2)
    return {(a, b): overlap[a, b] for a, b in zip(*np.nonzero(np.triu(overlap > 0, 1)))}


def check_network(path, points, data, lattice):
    """Every contact of particles is a line of its length, and walls bear what overlaps them."""
    piece = xml.parse(path).getroot().find("PolyData/Piece")
    ends, lines = arrays_of(piece.find("Points"))["ends"], arrays_of(piece.find("Lines"))
    count, cells = int(piece.get("NumberOfLines")), arrays_of(piece.find("CellData"))
    assert (lines["connectivity"][:, 0] == np.arange(2 * count)).all()
    assert (lines["offsets"][:, 0] == np.arange(2, 2 * count + 1, 2)).all()
    a, b, overlap = (cells[name][:, 0] for name in ("a", "b", "overlap"))
    way = np.linalg.norm(ends[1::2] - ends[::2], axis=1)
    radii, pairs = data["radius"][:, 0], b >= 0
    assert (ends[::2] == points[a]).all()
    assert np.allclose(way + overlap, radii[a] + np.where(pairs, radii[b], 0))
    expected = overlaps(points, radii, lattice)
    found = dict(zip(zip(a[pairs], b[pairs]), overlap[pairs]))
    assert found.keys() == expected.keys() and all(abs(found[key] - expected[key]) < 1e-9 for key in found)
    beyond = np.maximum(radii - points[:, 2], radii + points[:, 2] - lattice[2, 2])
    touching = set(a[~pairs])  # of a packing some touch but for rounding
    assert set(np.nonzero(beyond > 1e-12)[0]) <= touching <= set(np.nonzero(beyond > -1e-12)[0])
    assert (cells["tangential force"] >= 0).all()
    return 2 * len(expected) + np.count_nonzero(~pairs)


def main(folder):
    pictures = sorted(glob.glob(folder + "/state-*.vtp"))
    assert len(pictures) >= 2, pictures
    listed = xml.parse(folder + "/states.pvd").getroot().findall("Collection/DataSet")
    assert [folder + "/" + entry.get("file") for entry in listed] == pictures
    for path, entry in zip(pictures, listed):
        time, points, data = read_vtp(path)
        other_time, lattice, columns = read_xyz(path.replace(".vtp", ".xyz"))
        assert time == other_time == float(entry.get("timestep"))
        assert (points == columns["pos"]).all()
        assert (data["radius"] == columns["radius"]).all() and (data["radius"] >= 1).all()
        assert (data["velocity"] == columns["velo"]).all()
        assert (data["mass"] == columns["mass"]).all()
        assert (data["spin"] == columns["angular_velocity"]).all()
        check_table(path.replace(".vtp", ".csv"), ("velocity_", "spin_"), time, points, data)
        check_table(path.replace(".vtp", ".lammps"), ("v", "omega"), time, points, data)
        ends = check_network(path.replace("state-", "contacts-"), points, data, lattice)
        for axis in (0, 1):  # the periodic axes
            assert (points[:, axis] >= 0).all() and (points[:, axis] < lattice[axis, axis]).all()
        assert np.allclose(data["mass"], 4 / 3 * np.pi * data["radius"] ** 3)
    table = np.genfromtxt(folder + "/energy.csv", delimiter=",", names=True)
    parts = table["translation"] + table["rotation"] + table["contact"] + table["gravity"]
    assert np.allclose(table["energy"], parts) and table["step"][-1] == 300
    bulk = np.genfromtxt(folder + "/bulk.csv", delimiter=",", names=True)
    assert np.isclose(bulk["coordination"][-1], ends / len(points)) and (bulk["step"] == table["step"]).all()
    traces = bulk["stress_xx"] + bulk["stress_yy"] + bulk["stress_zz"]
    assert np.allclose(traces, 3 * bulk["pressure"]) and (bulk["pressure"] > 0).all()
    assert np.allclose(bulk["fabric_xx"] + bulk["fabric_yy"] + bulk["fabric_zz"], 1)
    taken = table["dashpot"] + table["friction"] + table["rolling"] + table["drag"] - table["input"]
    assert np.allclose(table["balance"], table["energy"] + taken)
    assert np.ptp(table["balance"]) < 1e-3 * (table["translation"][0] + taken[-1]) and taken[-1] > 0
    print(f"{len(pictures)} pictures read back")


main(sys.argv[1])
