# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Walls beside the states of the run that run.sh makes with them, read by Python's XML parser: read_walls.py FOLDER. They
stand where walls.csv says, and as geometry has it."""
import csv
import glob
import math
import sys
import xml.etree.ElementTree as xml

KINDS = ("box", "plane", "cylinder", "mesh")


def read_walls(path):
    """Time, and for each part: its kind, the number of its wall, its points."""
    piece = xml.parse(path).getroot().find("PolyData/Piece")

    def numbers(parent, name):
        array = next(each for each in piece.find(parent).iter("DataArray") if each.get("Name") == name)
        return [float(word) for word in (array.text or "").split()]

    flat = numbers("Points", "points")
    points = list(zip(flat[::3], flat[1::3], flat[2::3]))
    assert len(points) == int(piece.get("NumberOfPoints"))
    cells = []
    for kind, attribute in (("Lines", "NumberOfLines"), ("Polys", "NumberOfPolys")):
        places, ends = numbers(kind, "connectivity"), numbers(kind, "offsets")
        assert len(ends) == int(piece.get(attribute)) and (not ends or ends[-1] == len(places))
        cells += [[points[int(k)] for k in places[int(a) : int(b)]] for a, b in zip([0, *ends], ends)]
    kinds, walls = numbers("CellData", "kind"), numbers("CellData", "wall")
    assert len(kinds) == len(walls) == len(cells)
    time = float(xml.parse(path).getroot().find("PolyData/FieldData/DataArray").text)
    return time, [(KINDS[int(kind)], int(wall), cell) for kind, wall, cell in zip(kinds, walls, cells)]


def main(folder):
    pictures = sorted(glob.glob(folder + "/walls-*.vtp"))
    assert len(pictures) == len(glob.glob(folder + "/state-*.vtp")) >= 4, pictures
    listed = xml.parse(folder + "/walls.pvd").getroot().findall("Collection/DataSet")
    assert [folder + "/" + entry.get("file") for entry in listed] == pictures
    with open(folder + "/walls.csv") as file:
        rows = list(csv.DictReader(file))
    heights = set()
    for path in pictures:
        time, parts = read_walls(path)
        places = {row["wall"]: row for row in rows if int(row["step"]) == int(path[-16:-4])}
        shift, angle = float(places["piston"]["shift_z"]), float(places["paddle"]["angle"])
        assert math.isclose(angle, 0.7 * time, rel_tol=1e-9, abs_tol=1e-12)
        piston = {point[2] for kind, wall, cell in parts if wall == 0 for point in cell}
        assert len(piston) == 1 and math.isclose(min(piston), 5 + shift), (piston, shift)
        heights |= piston
        paddle = next(cell for kind, wall, cell in parts if wall == 2 and len(cell) == 3)
        tip = max(paddle, key=lambda point: math.hypot(*point[:2]))
        assert math.isclose(math.hypot(*tip[:2]), 2) and math.isclose(math.atan2(tip[1], tip[0]), angle, abs_tol=1e-12)
        assert sorted({(kind, wall) for kind, wall, _ in parts}) == [
            ("box", -1), ("cylinder", 1), ("mesh", 2), ("plane", 0)]
    assert len(heights) == len(pictures), "the piston does not move"


main(sys.argv[1])
