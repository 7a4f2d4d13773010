#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws Figs. 4 and 5 of Ogarko & Luding (2012) from what programs/bench/figures/figure4.sh, density.sh and figure5.sh
have measured:

    python3 programs/bench/plot/figures.py --output docs/evidence/images figure4.csv density.csv figure5.csv

and prints the values that docs/evidence/reproduction.md quotes.
"""

import argparse
import math
import pathlib

from chart import Line, draw_chart
from measured import STEP_NUMBERS, in_order, read

NAMES = {"library": "libhgrid", "plain": "sorted cells", "hashed": "hashed lists"}
MOST_FITTED = 20  # levels; with more, memory decides
OUT_OF_CACHE = 30000  # particles: from there on slopes are those of memory, not of growing out of caches
PAPER_DENSITY = "0.62"
OVERHEAD = 0.3  # K of Eq. 7, as in the paper's Fig. 4
LEVEL_MARKS = (1, 2, 4, 8, 16, 32)
BELOW_ONE = 0.4  # where the vertical axis of Fig. 4 begins: the notes of the paper's best levels stand there
# What the text of the paper says about its Fig. 4: (levels, slow-down), and notes beside these.
PAPER_FIGURE_4 = {
    "uniform-size": (
        [(1, 1.3), (2, 1)],
        [("+ 30 %", -4, -17, "start"), ("fastest: 2", -4, 19, "start")],
    ),
    "uniform-volume": (
        [(1, 220), (8, 1)],
        [("220 times", 10, 2, "start"), ("fastest: 8", 0, 19, "middle")],
    ),
}
PAPER_LARGEST = 1.5  # of Fig. 5: uniform volume, ratio 10
OURS, COST, FITTED, PAPER, MONO = 0, 4, 2, 3, 5
TIME_COLOURS = (MONO, 0, 1, 2)  # of equal spheres, and of the others as in the picture of relative times


def law_of(row):
    """hgrid_dem calls a system by its scene, LAW-RATIO-COUNT or, of another density than 0.62, LAW-RATIO-COUNT@DENSITY."""
    return row.system.rsplit("-", 2)[0]


def density_of(row):
    return row.system.partition("@")[2] or PAPER_DENSITY


def law_text(row):
    law, ratio, _ = row.system.rsplit("-", 2)
    return law.replace("-", " ") + (f", ratio {ratio}" if ratio != "1" else "")


def solve(matrix, right):
    """Gauss's elimination with pivots, for the few unknowns of a fit."""
    rows = [list(row) + [value] for row, value in zip(matrix, right)]
    size = len(rows)
    for k in range(size):
        pivot = max(range(k, size), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for i in range(size):
            if i != k:
                factor = rows[i][k] / rows[k][k]
                rows[i] = [a - factor * b for a, b in zip(rows[i], rows[k])]
    return [rows[k][size] / rows[k][k] for k in range(size)]


def fit(columns, times):
    """Coefficients of the columns that give the times with the least squares of relative errors; a column whose
    coefficient would be negative is left out."""
    used = list(range(len(columns)))
    while True:
        scaled = [[columns[j][i] / t for i, t in enumerate(times)] for j in used]
        normal = [[sum(a * b for a, b in zip(p, q)) for q in scaled] for p in scaled]
        found = solve(normal, [sum(p) for p in scaled])
        if min(found) >= 0:
            return [found[used.index(j)] if j in used else 0.0 for j in range(len(columns))]
        used.pop(found.index(min(found)))


def least_scaled(points):
    least = min(y for _, y in points)
    return [(x, y / least) for x, y in points]


def fit_times(rows):
    """T = a L (m + K) + c, where c is what does not depend on the grid: a, a K, c."""
    rows = [r for r in rows if r.levels <= MOST_FITTED]
    columns = [[r.levels * r.occupancy for r in rows], [r.levels for r in rows], [1.0] * len(rows)]
    a, b, c = fit(columns, [r.ns for r in rows])
    return a, b, c


def figure_4_panel(rows):
    rows = sorted(rows, key=lambda r: r.levels)
    a, overhead_cost, constant = fit_times(rows)
    overhead = f"{overhead_cost / a:.1f}" if a > 0 else "-"
    best = min(rows, key=lambda r: r.ns)
    predicted = least_scaled([(r.levels, r.levels * (r.occupancy + OVERHEAD)) for r in rows])
    fitted = [(r.levels, (r.levels * (a * r.occupancy + overhead_cost) + constant) / best.ns) for r in rows]
    measured = [(r.levels, r.ns / best.ns, *(q / best.ns for q in r.spread)) for r in rows]
    errors = [abs(f[1] / m[1] - 1) for f, m in zip(fitted, measured) if f[0] <= MOST_FITTED]
    slowdown = {r.levels: f"{r.ns / best.ns:.3g}" for r in rows}
    law, density = law_of(rows[0]).replace("-", " "), density_of(rows[0])
    print(
        f"| {law if density == PAPER_DENSITY else 'density ' + density} | {NAMES[best.contestant]} | {best.levels:.0f} | {best.ns:.0f} | "
        f"{' | '.join(slowdown.get(levels, '-') for levels in (1, 2, 7))} | {a:.2g} | {overhead} | "
        f"{constant:.0f} | {100 * max(errors):.0f} % |"
    )
    lines = [
        Line(NAMES[best.contestant], measured, OURS),
        Line("Eq. 7, K = 0.3", predicted, COST, dashed=True),
        Line(f"fit, K = {overhead}" if a > 0 else "fit, no m", fitted, FITTED, dashed=True),
    ]
    if density == PAPER_DENSITY:
        points, notes = PAPER_FIGURE_4[law_of(rows[0])]
        lines.append(Line("rings: the paper", points, PAPER, notes=notes, dots=True))
    return lines


def draw_figure_4(rows, path):
    head = "system | search | best L | its ns | T(1) / T(best) | T(2) | T(7) | a | K | c | worst of the fit"
    print(f"| {head} |\n" + "|---" * 11 + "|")
    other = any(density_of(row) != PAPER_DENSITY for row in rows)
    panels = []
    for name in in_order(r.contestant for r in rows):
        own = [r for r in rows if r.contestant == name]
        for system in in_order((law_of(r), density_of(r)) for r in own):
            title = f"density {system[1]}" if other else system[0].replace("-", " ")
            group = [r for r in own if (law_of(r), density_of(r)) == system]
            panels.append((f"{title}, {NAMES[name]}", figure_4_panel(group)))
    draw_chart(path, panels, "levels L", "slow-down T(L) / T(best)", marks=LEVEL_MARKS, room=(BELOW_ONE,))


def program_text(row):
    return NAMES[row.contestant] + (f", skin {row.skin:g}" if row.skin else "")


def slope(points):
    """Of log y against log x, by least squares."""
    xs, ys = [math.log(p[0]) for p in points], [math.log(p[1]) for p in points]
    x, y = sum(xs) / len(xs), sum(ys) / len(ys)
    return sum((u - x) * (v - y) for u, v in zip(xs, ys)) / sum((u - x) ** 2 for u in xs)


def slope_text(points):
    return f"{slope(points):.3f}" if len(points) > 1 else "-"


def relative_times(rows):
    """Lines of the laws, over equal spheres of the same number."""
    mono = {r.particles: r.ns for r in rows if law_of(r) == "mono"}
    lines = []
    for k, law in enumerate(in_order(law_text(r) for r in rows if law_of(r) != "mono")):
        points = [(r.particles, r.ns / mono[r.particles]) for r in rows if law_text(r) == law]
        lines.append(Line(law.replace("uniform ", ""), points, k))
    return lines


def draw_figure_5(rows, path):
    print("| search | system | " + " | ".join(f"{n:,.0f}" for n in in_order(r.particles for r in rows)), end=" |")
    print(f" slope of T against N | from N = {OUT_OF_CACHE:,} |")
    print("|---|---|" + "---|" * (2 + len({r.particles for r in rows})))
    panels = []
    for name in in_order(map(program_text, rows)):
        group = [r for r in rows if program_text(r) == name]
        lines = relative_times(group)
        for law in in_order(map(law_text, group)):
            own = {r.particles: r for r in group if law_text(r) == law}
            relative = next((dict(x.points) for x in lines if x.label == law.replace("uniform ", "")), None)
            cells = [
                "-" if n not in own else f"{relative[n]:.2f}" if relative else f"{own[n].ns:.1f} ns"
                for n in in_order(r.particles for r in rows)
            ]
            slopes = [slope_text([(n, n * r.ns) for n, r in own.items() if n >= least]) for least in (0, OUT_OF_CACHE)]
            print(f"| {name} | {law} | " + " | ".join(cells + slopes) + " |")
        counts = [r.particles for r in group]
        ends = min(counts), max(counts)
        lines.append(Line("paper, ratio 10: + 50 %", [(n, PAPER_LARGEST) for n in ends], PAPER, True))
        lines.append(Line("equal spheres", [(n, 1) for n in ends], COST, True))
        panels.append((name, lines))
    draw_chart(path, panels, "particles N", "time / time of equal spheres", y_log=False, from_zero=True)
    draw_times(rows, path.with_stem(path.stem + "-time"))


def draw_times(rows, path):
    """The times themselves, beside a line on which they are proportional to N."""
    panels = []
    for name in in_order(map(program_text, rows)):
        group = [r for r in rows if program_text(r) == name]
        lines = []
        for k, law in enumerate(in_order(map(law_text, group))):
            points = [(r.particles, r.particles * r.ns / 1e6) for r in group if law_text(r) == law]
            lines.append(Line(law.replace("uniform ", "").replace("mono", "equal spheres"), points, TIME_COLOURS[k]))
        (first, least), last = lines[0].points[0], lines[0].points[-1][0]
        lines.append(Line("proportional to N", [(first, least), (last, least * last / first)], COST, True))
        panels.append((name, lines))
    draw_chart(path, panels, "particles N", "ms per step")
    print(path)


DENSITY_FIGURE = "figure4-density.svg"
FIGURES = {"levels": ("figure4.svg", draw_figure_4), "size": ("figure5.svg", draw_figure_5)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("csv", nargs="+", help="files written by hgrid_dem --sweep NAME --csv FILE")
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("."), help="folder of the pictures")
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    rows = [row for row in read(arguments.csv, STEP_NUMBERS, "hgrid_dem") if row.ns is not None]
    # The paper's density and others are two pictures.
    kinds = [(row.sweep, row.sweep == "levels" and density_of(row) != PAPER_DENSITY) for row in rows]
    for sweep, is_other in in_order(kind for kind in kinds if kind[0]):
        name, draw = FIGURES[sweep]
        path = arguments.output / (DENSITY_FIGURE if is_other else name)
        draw([row for row, kind in zip(rows, kinds) if kind == (sweep, is_other)], path)
        print(path)


if __name__ == "__main__":
    main()
