#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Holds the includes against the layers of the house: layers.py [ROOT].

A file may include files of its own folder and of folders further down in LAYERS, never one further up. Includes of our
own files are written from the root; no circle of files closes. Prints which folder uses which; exits with 1 where an
include breaks a rule.
"""

import pathlib
import re
import sys

# From the bottom to the top. What stands in one entry may not include each other.
LAYERS = [
    ["include"],
    ["threads"],
    ["src/base"],
    ["src/exact"],
    ["src/space"],
    ["src/kernels"],
    ["src/particles"],
    ["src/levels"],
    ["src/index"],
    ["src/pairs"],
    ["src/search"],
    ["src/history"],
    ["src"],
    ["bindings/c"],
    ["bindings/f77"],
    ["mpi/include"],
    ["mpi"],
    ["particles"],
    ["particles/text"],
    ["particles/files"],
    ["oracle"],
    ["packing"],
    ["packing/event"],
    ["dem/base"],
    ["dem/effects"],
    ["dem/setup"],
    ["dem/state"],
    ["dem/kernels"],
    ["dem/engine"],
    ["dem/scene", "dem/output"],
    ["dem_mpi"],
    ["programs/draw", "programs/measure"],
    ["programs/ranks"],
    ["programs/accuracy"],
    ["programs/accuracy/search", "programs/accuracy/simulation"],
    ["programs/accuracy/report"],
    ["examples"],
    ["programs/hgrid", "programs/bench"],
    ["programs/hgrid_mpi"],
    ["tests/support"],
    ["tests/mpi"],
    ["fuzz"],
]
# Clients stand on the public interface alone.
PUBLIC_ONLY = ("mpi", "particles", "oracle", "packing", "dem", "programs", "tests/support", "fuzz", "examples")
INCLUDE = re.compile(r'^\s*#\s*include\s+(["<])([^">]+)[">]', re.MULTILINE)
RANK = {folder: rank for rank, entry in enumerate(LAYERS) for folder in entry}


def layer_of(path):
    """The longest entry of LAYERS that the path lies in."""
    folder = str(pathlib.PurePosixPath(path).parent)
    while folder not in RANK and "/" in folder:
        folder = folder.rsplit("/", 1)[0]
    return folder if folder in RANK else None


def includes_of(root, path):
    """What a file includes of the repository, as paths, and what it writes otherwise than from the root."""
    found, wrong = [], []
    for quote, name in INCLUDE.findall((root / path).read_text(encoding="utf-8")):
        if quote == "<":
            if name.startswith("hgrid/") and (root / "include" / name).exists():
                found.append("include/" + name)
        elif (root / name).exists():
            found.append(name)
        elif list(root.glob("*/**/" + name)) or list((root / path).parent.glob(name)):
            wrong.append(name)
    return found, wrong


def find_circle(graph):
    """A list of files that include each other in a ring, or None."""
    state = {}
    for start in graph:
        stack = [(start, iter(graph.get(start, ())))]
        if start in state:
            continue
        state[start] = "open"
        while stack:
            here, rest = stack[-1]
            for target in rest:
                if state.get(target) == "open":
                    names = [file for file, _ in stack]
                    return names[names.index(target):] + [target]
                if target not in state:
                    state[target] = "open"
                    stack.append((target, iter(graph.get(target, ()))))
                    break
            else:
                state[here] = "done"
                stack.pop()
    return None


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    faults, graph, uses = [], {}, {}
    for folder in sorted({entry.split("/")[0] for entry in RANK}):
        for file in sorted((root / folder).rglob("*")):
            path = file.relative_to(root).as_posix()
            if file.suffix not in (".c", ".h", ".cpp", ".hpp") or layer_of(path) is None:
                continue
            targets, wrong = includes_of(root, path)
            faults += [f'{path}: "{name}" is not written from the root' for name in wrong]
            graph[path] = targets
            for target in targets:
                own, other = layer_of(path), layer_of(target)
                if other is None:
                    faults.append(f"{path} includes {target}, which is in no layer")
                    continue
                if own != other:
                    uses.setdefault(own, set()).add(other)
                if RANK[other] > RANK[own] or (RANK[other] == RANK[own] and own != other):
                    faults.append(f"{path} includes {target}: {own} lies below {other}")
                if path.startswith(PUBLIC_ONLY) and other.startswith(("src", "bindings")):
                    faults.append(f"{path} includes {target}: a client has the public interface alone")
    circle = find_circle(graph)
    if circle:
        faults.append("a circle: " + " -> ".join(circle))
    for entry in LAYERS:
        for folder in entry:
            print(f"{folder:30} -> {', '.join(sorted(uses.get(folder, ()), key=RANK.get)) or '-'}")
    print(f"{len(graph)} files, {sum(map(len, graph.values()))} includes, {len(faults)} faults")
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
