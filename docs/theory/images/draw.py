#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of docs/theory/algorithm.md: python3 docs/theory/images/draw.py --output docs/theory/images."""

import argparse
import math
import pathlib
import random

INK, MUTED, LINE, FAINT = "#1f2933", "#52606d", "#9aa5b1", "#e4e7eb"
FINE, COARSE, ACCENT = "#0f8b8d", "#d9822b", "#b83280"
FINE_FILL, COARSE_FILL, GREY_FILL, OWN_FILL = "#bfe3e0", "#f8dcb8", "#dfe3e8", "#fdf1e0"


class Picture:
    """An SVG file in units of length with y upwards."""

    def __init__(self, width, height, scale, left=0.0, bottom=0.0):
        self.width, self.height, self.scale, self.left, self.bottom = width, height, scale, left, bottom
        self.parts = []

    def at(self, x, y):
        return (x - self.left) * self.scale, (self.height - (y - self.bottom)) * self.scale

    def add(self, text):
        self.parts.append(text)

    def rect(self, x0, y0, x1, y1, fill="none", stroke="none", width=1.0, dash="", opacity=1.0):
        (left, bottom), (right, top) = self.at(x0, y0), self.at(x1, y1)
        self.add(
            f'<rect x="{left:.2f}" y="{top:.2f}" width="{right - left:.2f}" height="{bottom - top:.2f}" '
            f'fill="{fill}" stroke="{stroke}" stroke-width="{width}" stroke-dasharray="{dash}" opacity="{opacity}"/>'
        )

    def line(self, x0, y0, x1, y1, stroke=LINE, width=1.0, dash="", arrow=False):
        (a, b), (c, d) = self.at(x0, y0), self.at(x1, y1)
        marker = f' marker-end="url(#arrow)" color="{stroke}"' if arrow else ""
        self.add(
            f'<line x1="{a:.2f}" y1="{b:.2f}" x2="{c:.2f}" y2="{d:.2f}" stroke="{stroke}" stroke-width="{width}" '
            f'stroke-dasharray="{dash}"{marker}/>'
        )

    def disc(self, x, y, r, fill="none", stroke=INK, width=1.2, dash="", opacity=1.0):
        a, b = self.at(x, y)
        self.add(
            f'<circle cx="{a:.2f}" cy="{b:.2f}" r="{r * self.scale:.2f}" fill="{fill}" stroke="{stroke}" '
            f'stroke-width="{width}" stroke-dasharray="{dash}" fill-opacity="{opacity}"/>'
        )

    def dot(self, x, y, fill=INK, pixels=2.4):
        a, b = self.at(x, y)
        self.add(f'<circle cx="{a:.2f}" cy="{b:.2f}" r="{pixels}" fill="{fill}"/>')

    def text(self, x, y, words, size=13, fill=INK, anchor="middle", weight="normal", halo=False):
        a, b = self.at(x, y)
        edge = ' paint-order="stroke" stroke="#ffffff" stroke-width="4" stroke-linejoin="round"' if halo else ""
        self.add(
            f'<text x="{a:.2f}" y="{b:.2f}" font-size="{size}" fill="{fill}" text-anchor="{anchor}" '
            f'font-weight="{weight}"{edge}>{words}</text>'
        )

    def save(self, path):
        wide, high = self.width * self.scale, self.height * self.scale
        head = (
            # REUSE-IgnoreStart
            "<!-- SPDX-FileCopyrightText: The libhgrid developers; SPDX-License-Identifier: BSD-3-Clause -->\n"
            # REUSE-IgnoreEnd
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{wide:.0f}" height="{high:.0f}" '
            f'viewBox="0 0 {wide:.0f} {high:.0f}" font-family="Helvetica, Arial, sans-serif">\n'
            '<defs><marker id="arrow" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="7" markerHeight="7" '
            f'orient="auto-start-reverse"><path d="M0 0 10 5 0 10z" fill="{INK}"/></marker></defs>\n'
            '<rect width="100%" height="100%" fill="#ffffff"/>\n'
        )
        path.write_text(head + "\n".join(self.parts) + "\n</svg>\n", encoding="utf-8")


def scatter(generator, count, radius, low, high, taken):
    """Centres of `count` discs that overlap neither each other nor `taken`, a list of (x, y, r)."""
    placed = []
    while len(placed) < count:
        x, y = generator.uniform(low[0], high[0]), generator.uniform(low[1], high[1])
        if all(math.hypot(x - a, y - b) > radius + r + 0.12 for a, b, r in taken + placed):
            placed.append((x, y, radius))
    return placed


def floor_cell(x, y, size):
    return math.floor(x / size), math.floor(y / size)


def draw_levels(path):
    """Three levels of cells, each with the particles that they hold."""
    sizes, radii = (0.88, 2.2, 4.4), ((0.28, 0.36, 0.44), (0.6, 0.85, 1.1), (1.3, 1.7, 2.2))
    names = ("level 1, finest", "level 2", "level 3, coarsest")
    picture = Picture(29.2, 12.0, 30)
    generator = random.Random(3)
    for h, size in enumerate(sizes):
        left, bottom, edge = 0.6 + 9.6 * h, 1.9, 8.8
        cells = int(edge / size + 1e-9)
        side = cells * size
        for k in range(cells + 1):
            picture.line(left + k * size, bottom, left + k * size, bottom + side, LINE, 1)
            picture.line(left, bottom + k * size, left + side, bottom + k * size, LINE, 1)
        discs = []
        for k, count in ((2, 2), (1, 3), (0, 4)) if h < 2 else ((2, 1), (1, 1), (0, 2)):
            r = radii[h][k]
            low, high = (left + r, bottom + r), (left + side - r, bottom + side - r)
            discs += scatter(generator, count * (3 if h == 0 else 1), r, low, high, discs)
        for x, y, r in discs:
            picture.disc(x, y, r, (FINE_FILL, COARSE_FILL, "#e6c7dc")[h], (FINE, COARSE, ACCENT)[h], 1.4)
            picture.dot(x, y, (FINE, COARSE, ACCENT)[h], 1.6)
        picture.text(left + side / 2, bottom + side + 0.5, names[h], 16, weight="bold")
        lower = "" if h == 0 else f"s<tspan dy='3' font-size='10'>{h}</tspan><tspan dy='-3'>\u2009&lt;\u2009</tspan>"
        picture.text(
            left + side / 2, 0.8, f"{lower}2r ≤ s<tspan dy='3' font-size='10'>{h + 1}</tspan>", 16, MUTED
        )
    picture.save(path)


def example_particles(big):
    """The discs of level 1 in the worked example: A, B's contacts and others."""
    generator = random.Random(11)
    named = [(13.4, 7.6, 1.4), (6.0, 17.35, 1.2), (14.9, 16.4, 1.0)]
    taken = [big] + named
    others = scatter(generator, 12, 1.3, (1.4, 1.4), (22.6, 22.6), taken)
    return named, others


def draw_example(path):
    """The two-level example: s = (3, 8), particle B with r = 4 at (10.3, 14.5)."""
    x, y, r, fine, coarse = 10.3, 14.5, 4.0, 3, 8
    reach = r + 0.5 * fine
    first, last = floor_cell(x - reach, y - reach, fine), floor_cell(x + reach, y + reach, fine)
    named, others = example_particles((x, y, r))
    picture = Picture(27.2, 27.4, 25, -1.6, -1.8)
    for i in range(first[0], last[0] + 1):
        for j in range(first[1], last[1] + 1):
            picture.rect(fine * i, fine * j, fine * (i + 1), fine * (j + 1), GREY_FILL)
    for k in range(9):
        picture.line(fine * k, 0, fine * k, 24, LINE, 0.9, "4 3")
        picture.line(0, fine * k, 24, fine * k, LINE, 0.9, "4 3")
    for k in range(4):
        picture.line(coarse * k, 0, coarse * k, 24, INK, 1.6)
        picture.line(0, coarse * k, 24, coarse * k, INK, 1.6)
    for a, b, q in others + named:
        inside = first[0] <= a // fine <= last[0] and first[1] <= b // fine <= last[1]
        touches = math.hypot(a - x, b - y) < r + q
        fill = FINE if touches else (FINE_FILL if inside else "#ffffff")
        picture.disc(a, b, q, fill, FINE, 1.3, opacity=0.85)
        picture.dot(a, b, INK, 1.7)
    picture.disc(x, y, r, COARSE_FILL, COARSE, 2, opacity=0.75)
    picture.rect(x - reach, y - reach, x + reach, y + reach, "none", ACCENT, 1.8)
    picture.dot(x, y, INK, 3)
    picture.text(x + 0.4, y + 0.45, "B", 18, weight="bold", anchor="start")
    picture.text(named[0][0] + 0.3, named[0][1] + 0.25, "A", 15, weight="bold", anchor="start")
    for cell in (first, last):
        picture.text(fine * cell[0] + 1.5, fine * cell[1] + 1.2, f"({cell[0]}, {cell[1]})", 14, ACCENT, halo=True)
    picture.text(x - reach, y - reach - 0.85, "x⁻ = (4.8, 9.0)", 13, ACCENT, "start", halo=True)
    picture.text(x + reach, y + reach + 0.35, "x⁺ = (15.8, 20.0)", 13, ACCENT, "end", halo=True)
    for k in range(9):
        picture.text(fine * k, -0.9, str(fine * k), 12, MUTED)
        picture.text(-0.35, fine * k - 0.15, str(fine * k), 12, MUTED, "end")
    picture.save(path)


def cell_range(low, high, length, count):
    """The cells that an interval meets, as the library's map from coordinates to cells gives them."""
    return max(0, math.floor(low / length)), min(count - 1, math.floor(high / length))


def draw_rows(path):
    """One level as libhgrid stores it: rows 2 s wide, cells 0.5 s long, and the ranges one particle looks through."""
    size, height, length, rows, cells = 2.0, 4.0, 1.0, 3, 20
    picture = Picture(24.2, 15.0, 36, -2.5, -2.1)
    generator = random.Random(5)
    p = (9.7, 6.95, 0.95)
    discs = [p, (11.35, 6.3, 0.8), (8.95, 8.55, 0.85), (10.75, 8.7, 0.9)]
    for r, count in ((0.95, 9), (0.75, 12), (0.55, 16)):
        discs += scatter(generator, count, r, (r, r), (cells * length - r, rows * height - r), discs)
    own, reach = math.floor(p[1] / height), p[2] + size / 2
    ranges, chord = {}, 0.0
    for row in range(own, own + 2):
        gap = max(0.0, row * height - p[1], p[1] - (row + 1) * height)
        half = math.sqrt(reach * reach - gap * gap)
        ranges[row] = cell_range(p[0] - half, p[0] + half, length, cells)
        chord = half
        first = ranges[row][0] if row > own else math.floor(p[0] / length)
        picture.rect(first * length, row * height, (ranges[row][1] + 1) * length, (row + 1) * height, GREY_FILL)
    for k in range(cells + 1):
        picture.line(k * length, 0, k * length, rows * height, LINE, 0.8, "3 3")
    for k in range(rows + 1):
        picture.line(0, k * height, cells * length, k * height, INK, 1.6)
    for x, y, r in discs[1:]:
        row, cell = math.floor(y / height), math.floor(x / length)
        candidate = row in ranges and (ranges[row][0] if row > own else math.floor(p[0])) <= cell <= ranges[row][1]
        picture.disc(x, y, r, FINE_FILL if candidate else "#ffffff", FINE, 1.2, opacity=0.85)
        picture.dot(x, y, FINE if candidate else LINE, 2.6 if candidate else 1.8)
    picture.disc(*p, COARSE_FILL, COARSE, 1.8, opacity=0.9)
    picture.disc(p[0], p[1], reach, "none", ACCENT, 1.8, "6 4")
    picture.line(p[0] - chord, (own + 1) * height, p[0] + chord, (own + 1) * height, ACCENT, 5)
    picture.text(p[0], p[1] - 0.12, "p", 17, weight="bold")
    for row in range(rows):
        picture.text(-0.3, (row + 0.5) * height - 0.1, f"row {row}", 13, MUTED, "end")
    picture.line(20.35, 0, 20.35, height, INK, 1.2, arrow=True)
    picture.line(20.35, height, 20.35, 0, INK, 1.2, arrow=True)
    picture.text(20.5, height / 2 - 0.1, "2 s", 13, INK, "start")
    picture.line(4, -0.4, 5, -0.4, INK, 1.2, arrow=True)
    picture.line(5, -0.4, 4, -0.4, INK, 1.2, arrow=True)
    picture.text(4.5, -0.95, "0.5 s", 13)
    picture.text(p[0], -1.55, "x →", 13, MUTED)
    picture.save(path)


def draw_images(path):
    """A periodic box with the images that reach into it: forward ones full, backward ones dashed."""
    edge, reach = 12.0, 3.0
    picture = Picture(20.4, 20.4, 26, -4.2, -4.2)
    picture.rect(-reach, -reach, edge + reach, edge + reach, OWN_FILL)
    picture.rect(0, 0, edge, edge, "#ffffff", INK, 2)
    generator = random.Random(8)
    discs = [(1.1, 10.9, 1.0)]
    for r, count in ((1.4, 4), (1.0, 9)):
        discs += scatter(generator, count, r, (0.3, 0.3), (edge - 0.3, edge - 0.3), discs)
    for number, (x, y, r) in enumerate(discs):
        picture.disc(x, y, r, COARSE_FILL if number == 0 else FINE_FILL, COARSE if number == 0 else FINE, 1.4)
        for j in (-1, 0, 1):
            for i in (-1, 0, 1):
                a, b = x + i * edge, y + j * edge
                near = -reach <= a <= edge + reach and -reach <= b <= edge + reach
                if (i, j) == (0, 0) or not near:
                    continue
                forward = j > 0 or (j == 0 and i > 0)
                colour = COARSE if number == 0 else FINE
                picture.disc(a, b, r, "#ffffff", colour, 1.5, "" if forward else "4 3", 0.6)
    picture.text(edge / 2, -3.7, "within reach of the box", 13, MUTED, halo=True)
    picture.text(edge / 2, edge - 0.75, "box", 14, INK, weight="bold", halo=True)
    picture.save(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("."), help="folder of the pictures")
    folder = parser.parse_args().output
    draw_levels(folder / "levels.svg")
    draw_example(folder / "example.svg")
    draw_rows(folder / "rows.svg")
    draw_images(folder / "images.svg")


if __name__ == "__main__":
    main()
