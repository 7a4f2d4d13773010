#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws which colour is which size in the pictures of Fig. 3 (programs/bench/figures/figure3.sh):

    python3 programs/bench/plot/sizes.py --output docs/evidence/images
"""

import argparse
import pathlib
import sys

from chart import Picture

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "figures"))
from scene import ONE_SIZE, share_of, shades, srgb  # noqa: E402

# (system, smallest, largest, whether colours go by the size itself, sizes named; the whole range or these alone).
ROWS = (
    ("equal spheres", 1, 1, False, (1,), False),
    ("two sizes, ratio 10", 1, 10, False, (1, 10), False),
    ("uniform size, ratio 50", 1, 50, True, (1, 10, 20, 30, 40, 50), True),
    ("uniform volume, ratio 50", 1, 50, False, (1, 2, 5, 10, 20, 50), True),
)
NAMES, BAR, HEIGHT, ROW, TOP, RIGHT = 176, 330, 16, 46, 40, 24
STRIPS = 66  # of a bar


def hexadecimal(colour):
    return "#" + "".join(f"{round(part):02x}" for part in colour)


def draw_row(picture, top, row, palette):
    name, smallest, largest, linear, named, is_range = row
    picture.text(NAMES - 14, top + 13, name, anchor="end")

    def shade(radius):
        if largest == smallest:
            return hexadecimal(palette[ONE_SIZE])
        return hexadecimal(srgb(share_of(radius, smallest, largest, linear), palette))

    def place(radius):
        return NAMES + BAR * share_of(radius, smallest, largest, linear)

    if is_range:
        for k in range(STRIPS):
            share = (k + 0.5) / STRIPS
            radius = smallest + share * (largest - smallest) if linear else smallest * (largest / smallest) ** share
            x, width = NAMES + BAR * k / STRIPS, BAR / STRIPS
            picture.add(
                f'<rect x="{x:.1f}" y="{top}" width="{width + 0.3:.1f}" height="{HEIGHT}" fill="{shade(radius)}"/>'
            )
        picture.add(f'<rect x="{NAMES}" y="{top}" width="{BAR}" height="{HEIGHT}" class="frame"/>')
    for radius in named:
        if not is_range:
            picture.add(
                f'<circle cx="{place(radius):.1f}" cy="{top + 8}" r="8" fill="{shade(radius)}"/>'
            )
        picture.text(place(radius), top + HEIGHT + 14, f"{radius:g}", "muted", size=11)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("."), help="folder of the picture")
    folder = parser.parse_args().output
    folder.mkdir(parents=True, exist_ok=True)
    picture = Picture(NAMES + BAR + RIGHT, TOP + ROW * len(ROWS))
    picture.text(NAMES, 20, "Radius over that of the smallest", anchor="start", weight="bold", size=13)
    for k, row in enumerate(ROWS):
        draw_row(picture, TOP + k * ROW, row, shades())
    picture.save(folder / "packing-sizes.svg")
    print(folder / "packing-sizes.svg")


if __name__ == "__main__":
    main()
