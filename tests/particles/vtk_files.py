# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Binary files of VTK, packed here by the standard library of Python, are read as the same particles: vtk_files.py HGRID.

The same spheres go into every kind of file: legacy in big-endian bytes; XML inline or appended, as base64 or raw, as
they are or through zlib, in both byte orders, with short and long sizes. The contacts must be those of the CSV file.
"""

import base64
import itertools
import random
import struct
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

COUNT = 300
BLOCK = 1000  # bytes: several blocks, the last one shorter

generator = random.Random(5)
points = [generator.randrange(640) / 64 for _ in range(3 * COUNT)]
radii = [generator.randrange(1, 60) / 64 for _ in range(COUNT)]


def csv():
    rows = (f"{x},{y},{z},{r}\n" for x, y, z, r in zip(points[0::3], points[1::3], points[2::3], radii))
    return ("x,y,z,radius\n" + "".join(rows)).encode()


def legacy(with_table):
    table = b"LOOKUP_TABLE default\n" if with_table else b""
    head = f"# vtk DataFile Version 3.0\nspheres\nBINARY\nDATASET POLYDATA\nPOINTS {COUNT} float\n".encode()
    vertices = struct.pack(f">{2 * COUNT}i", *(n for k in range(COUNT) for n in (1, k)))
    return b"".join(
        [head, struct.pack(f">{3 * COUNT}f", *points)]
        + [f"\nVERTICES {COUNT} {2 * COUNT}\n".encode(), vertices]
        + [f"\nPOINT_DATA {COUNT}\nFIELD FieldData 1\nid 1 {COUNT} int\n".encode(), bytes(4 * COUNT)]
        + [b"\nSCALARS radius double\n", table, struct.pack(f">{COUNT}d", *radii), b"\n"]
    )


def stored(data, order, word, pack, encode):
    size = lambda *numbers: struct.pack(order + word * len(numbers), *numbers)
    if not pack:
        return encode(size(len(data)) + data)
    blocks = [data[k : k + BLOCK] for k in range(0, len(data), BLOCK)]
    packed = [zlib.compress(block) for block in blocks]
    head = size(len(blocks), BLOCK, len(data) % BLOCK, *map(len, packed))
    return encode(head) + encode(b"".join(packed))


def xml(order, word, pack, place, grid):
    raw = place == "raw"
    arrays = [("Float32", "points", 3, struct.pack(f"{order}{3 * COUNT}f", *points))]
    arrays.append(("Float64", "Radius", 1, struct.pack(f"{order}{COUNT}d", *radii)))
    appended, tags = b"", []
    for kind, name, width, data in arrays:
        content = stored(data, order, word, pack, bytes if raw else base64.b64encode)
        tag = f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{width}" '.encode()
        if place == "inline":
            tags.append(tag + b'format="binary">\n  ' + content + b"\n</DataArray>")
        else:
            tags.append(tag + f'format="appended" offset="{len(appended)}"/>'.encode())
            appended += content
    kind = "UnstructuredGrid" if grid else "PolyData"
    text = f'<?xml version="1.0"?>\n<VTKFile type="{kind}" version="1.0" '
    text += f'byte_order="{"LittleEndian" if order == "<" else "BigEndian"}" '
    text += f'header_type="{"UInt64" if word == "Q" else "UInt32"}"'
    text += ' compressor="vtkZLibDataCompressor">' if pack else ">"
    text += f'<{kind}><Piece NumberOfPoints="{COUNT}">'
    body = b"<Points>" + tags[0] + b"</Points><PointData>" + tags[1] + b"</PointData>"
    result = text.encode() + body + f"</Piece></{kind}>".encode()
    if place != "inline":
        encoding = "raw" if raw else "base64"
        result += f'<AppendedData encoding="{encoding}">\n _'.encode() + appended + b"\n</AppendedData>"
    return result + b"</VTKFile>\n"


def main():
    hgrid = str(Path(sys.argv[1]).resolve())
    files = {f"legacy, table {table}": legacy(table) for table in (False, True)}
    kinds = itertools.product("<>", "IQ", (False, True), ("inline", "base64", "raw"), (False, True))
    files.update({f"xml {kind}": xml(*kind) for kind in kinds})
    with tempfile.TemporaryDirectory() as folder:

        def contacts(data):
            path = Path(folder) / "spheres"
            path.write_bytes(data)
            return subprocess.run([hgrid, "pairs", path, "--order", "id"], capture_output=True, text=True, check=False)

        expected = contacts(csv()).stdout
        assert expected.count("\n") > 100, "too few contacts to tell anything"
        wrong = [(name, contacts(data)) for name, data in files.items()]
        wrong = [f"{name}: {found.stderr or 'other contacts'}" for name, found in wrong if found.stdout != expected]
    for line in wrong:
        print(line)
    print(f"{len(files)} files, {len(wrong)} wrong")
    sys.exit(1 if wrong else 0)


main()
