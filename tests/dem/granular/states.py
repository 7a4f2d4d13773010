# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs of scenes and the tables that they leave, for the scripts beside this one."""

import csv
import glob
import os
import subprocess


def run(hgrid, scene, output, settings=()):
    """Runs a scene with pictures as CSV; settings as of hgrid run --set."""
    words = [hgrid, "run", scene, "--quiet", "--output", output, "--set", 'output.formats=["csv"]']
    for setting in settings:
        words += ["--set", setting]
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL)


def pictures(output):
    """For each picture, in the order of time: the time, and of each particle a dict of numbers."""
    found = []
    for name in sorted(glob.glob(os.path.join(output, "state-*.csv"))):
        with open(name) as table:
            lines = [line for line in table.read().split("\n") if line]
        time = next(float(line.split("time:")[1].split()[0]) for line in lines if line.startswith("# step:"))
        rows = csv.DictReader(line for line in lines if not line.startswith("#"))
        found.append((time, [{key: float(value) for key, value in row.items()} for row in rows]))
    return found


def table(output, name):
    """The rows of a table such as exchange.csv, as dicts of texts."""
    with open(os.path.join(output, name)) as rows:
        return list(csv.DictReader(rows))


def slope(x, y):
    """Of the line of least squares."""
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x)
