#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws ns per particle by world, with the fastest other program beside, from the table of programs/bench/worlds.sh:

    python3 programs/bench/plot/worlds.py --output docs/evidence/images programs/bench/results/PROCESSOR/worlds.csv

and prints the table that docs/evidence/performance.md shows.
"""

import argparse
import csv
import html
import pathlib

from chart import FONT_SIZE, Axis, Picture, number_text
from measured import TITLES

LABELS, WIDTH, NAMES, ROW, TOP, BOTTOM = 190, 420, 190, 20, 46, 44
OURS, PEER, REFERENCE = 0, 2, 4  # colours
K_D_TREE = "nanoflann"


def words(world):
    return world.replace("-", " ")


def number(text):
    return float(text) if text else None


def add_dot(picture, x, y, colour):
    picture.add(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" class="t{colour}"/>')


def add_bar(picture, x, y, colour):
    picture.add(f'<rect x="{x - 1.5:.1f}" y="{y - 7:.1f}" width="3" height="14" class="t{colour}"/>')


def draw_legend(picture):
    place = LABELS
    for draw, colour, label in (
        (add_dot, OURS, "libhgrid"),
        (add_bar, REFERENCE, "its reference, even or open"),
        (add_dot, PEER, "fastest other program"),
    ):
        draw(picture, place, 18, colour)
        picture.text(place + 10, 22, label, f"t{colour}", "start")
        place += 30 + 7 * len(label)


def draw_axis(picture, axis, bottom):
    for tick in axis.ticks():
        x = LABELS + WIDTH * axis.share(tick)
        picture.line(x, TOP, x, bottom, "grid")
        picture.text(x, bottom + 17, number_text(tick), "muted")
    picture.text(LABELS + WIDTH / 2, bottom + 36, "ns per particle, medians")


def draw_row(picture, axis, row, y):
    def place(text):
        return LABELS + WIDTH * axis.share(number(text))

    picture.text(LABELS - 10, y + 4, html.escape(words(row["world"])), "ink", "end")
    if row["peer_ns"]:
        x = place(row["peer_ns"])
        picture.line(place(row["ns"]), y, x, y, "frame")
        add_dot(picture, x, y, PEER)
        label = f'{number(row["peer_ratio"]):.1f} x  {TITLES[row["fastest_peer"]]}'
    else:
        label = "no other program can"
    picture.text(LABELS + WIDTH + 10, y + 4, html.escape(label), f"t{PEER}", "start", FONT_SIZE - 1)
    if row["reference_ns"]:
        add_bar(picture, place(row["reference_ns"]), y, REFERENCE)
    add_dot(picture, place(row["ns"]), y, OURS)


def draw_worlds(rows, path):
    times = [number(row[name]) for row in rows for name in ("ns", "reference_ns", "peer_ns") if row[name]]
    axis = Axis("", times, logarithmic=True)
    bottom = TOP + ROW * len(rows)
    picture = Picture(LABELS + WIDTH + NAMES, bottom + BOTTOM)
    draw_legend(picture)
    draw_axis(picture, axis, bottom)
    for k, row in enumerate(rows):
        draw_row(picture, axis, row, TOP + ROW * (k + 0.5))
    picture.save(path)


def print_table(rows):
    print("| world | particles | libhgrid | over its reference | fastest other program | its time over ours | k-d tree over ours |")
    print("|" + "---|" * 7)
    for row in rows:
        ratio = f'{number(row["ratio"]):.2f} ({words(row["reference"])})' if row["ratio"] else "-"
        peer = TITLES.get(row["fastest_peer"], "none")
        over = f'{number(row["peer_ratio"]):.1f}' if row["peer_ratio"] else "-"
        try:
            tree = f'{number(row[K_D_TREE]) / number(row["ns"]):.1f}'
        except ValueError:  # words
            tree = row[K_D_TREE]
        count = f'{int(row["particles"]):,}'.replace(",", "\u202f")
        print(f'| {words(row["world"])} | {count} | {number(row["ns"]):.0f} | {ratio} | {peer} | {over} | {tree} |')


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("csv", help="worlds.csv, written by worlds.sh")
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("."), help="folder of the picture")
    arguments = parser.parse_args()
    with open(arguments.csv, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    print_table(rows)
    arguments.output.mkdir(parents=True, exist_ok=True)
    draw_worlds(rows, arguments.output / "worlds.svg")


if __name__ == "__main__":
    main()
