# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Line charts as SVG that reads on light and on dark pages: panels side by side, each line labelled where it ends."""

import html
import math

# (light, dark) of ink, quiet text, grid lines, page, and the lines in the order of `Line.colour`.
INK, MUTED, GRID, PAGE = ("#1f2933", "#e4e7eb"), ("#52606d", "#9aa5b1"), ("#e4e7eb", "#323f4b"), ("#ffffff", "#11161c")
COLOURS = (
    ("#0f8b8d", "#4fd1c5"),
    ("#2563a8", "#7db4f0"),
    ("#c46f16", "#f0a858"),
    ("#b83280", "#f08cc4"),
    ("#6b7280", "#a3adb8"),
    ("#6d4fa3", "#b9a3e8"),
)

PANEL_WIDTH, PANEL_HEIGHT, LEFT, LABELS, TOP, BOTTOM = 240, 230, 62, 122, 40, 56
FONT_SIZE = 12
LETTER_WIDTH = 6.1  # of a label, on average


class Line:
    """A line of one panel: `points` are (x, y) or (x, y, low, high), the latter drawn as a band.
    `notes` stand above the first points. `dots`: no line, but rings, with notes (words, right, down, anchor) that many
    pixels from each."""

    def __init__(self, label, points, colour, dashed=False, notes=(), dots=False):
        self.label, self.colour, self.dashed, self.notes, self.dots = label, colour, dashed, list(notes), dots
        self.points = sorted(points)


class Axis:
    """Maps values to pixels. Logarithmic axes show powers of ten and, on short ranges, 2 and 5 times these, or what of
    `marks` lies on them."""

    def __init__(self, label, values, logarithmic, from_zero=False, whole=False, marks=()):
        self.label, self.logarithmic, self.smallest_step = label, logarithmic, 1 if whole else 0
        self.marks = marks
        low, high = min(values), max(values)
        if from_zero:
            low = 0
        if logarithmic:
            low, high = low / 1.15, high * 1.15
        else:
            room = (0.12 if from_zero else 0.06) * (high - low) or 0.5
            low, high = low - (0 if from_zero else room), high + room
        self.low, self.high = low, high

    def share(self, value):
        if self.logarithmic:
            return math.log(value / self.low) / math.log(self.high / self.low)
        return (value - self.low) / (self.high - self.low)

    def ticks(self):
        if not self.logarithmic:
            step = 10 ** math.floor(math.log10(self.high - self.low))
            step *= next(m for m in (0.1, 0.2, 0.5, 1, 2) if (self.high - self.low) / (m * step) <= 7)
            step = max(step, self.smallest_step)
            first = math.ceil(self.low / step - 1e-9)
            return [k * step for k in range(first, math.floor(self.high / step + 1e-9) + 1)]
        if self.marks:
            return [mark for mark in self.marks if self.low <= mark <= self.high]
        decades = range(math.floor(math.log10(self.low)), math.ceil(math.log10(self.high)) + 1)
        factors = (1,) if math.log10(self.high / self.low) > 1.8 else (1, 2, 5)
        ticks = [f * 10.0**d for d in decades for f in factors]
        return [t for t in ticks if self.low <= t <= self.high]


def number_text(value):
    if value != 0 and (abs(value) >= 1e5 or abs(value) < 1e-3):
        exponent = math.floor(math.log10(abs(value)) + 1e-9)
        factor = value / 10.0**exponent
        power = f'10<tspan dy="-5" font-size="9">{exponent}</tspan>'
        return power if abs(factor - 1) < 1e-6 else f"{factor:g}·{power}"
    return f"{value:,g}".replace(",", "\u202f")


class Picture:
    def __init__(self, width, height):
        self.width, self.height, self.parts = width, height, []

    def add(self, text):
        self.parts.append(text)

    def text(self, x, y, words, kind="ink", anchor="middle", size=FONT_SIZE, turn=0, weight="normal"):
        rotated = f' transform="rotate({turn} {x:.1f} {y:.1f})"' if turn else ""
        self.add(
            f'<text x="{x:.1f}" y="{y:.1f}" class="{kind}" text-anchor="{anchor}" font-size="{size}" '
            f'font-weight="{weight}"{rotated}>{words}</text>'
        )

    def line(self, x0, y0, x1, y1, kind):
        self.add(f'<line x1="{x0:.1f}" y1="{y0:.1f}" x2="{x1:.1f}" y2="{y1:.1f}" class="{kind}"/>')

    @staticmethod
    def style():
        def rules(shade):
            lines = [f".ink{{fill:{INK[shade]}}}.muted{{fill:{MUTED[shade]}}}.page{{fill:{PAGE[shade]}}}"]
            lines.append(f".grid{{stroke:{GRID[shade]}}}.frame{{stroke:{MUTED[shade]};fill:none}}")
            for k, colour in enumerate(COLOURS):
                value = colour[shade]
                lines.append(f".l{k}{{stroke:{value};fill:none;stroke-width:2}}")
                lines.append(f".t{k},.b{k}{{fill:{value}}}.b{k}{{opacity:.2}}")
            return "".join(lines)

        return f"<style>{rules(0)}@media(prefers-color-scheme:dark){{{rules(1)}}}</style>"

    def save(self, path):
        head = (
            # REUSE-IgnoreStart
            "<!-- SPDX-FileCopyrightText: The libhgrid developers; SPDX-License-Identifier: BSD-3-Clause -->\n"
            # REUSE-IgnoreEnd
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{self.width}" height="{self.height}" '
            f'viewBox="0 0 {self.width} {self.height}" font-family="Helvetica, Arial, sans-serif">\n'
            f'{self.style()}\n<rect width="100%" height="100%" class="page"/>\n'
        )
        path.write_text(head + "\n".join(self.parts) + "\n</svg>\n", encoding="utf-8")


def spread(places, gap):
    """Moves label places apart until neighbours are `gap` apart, as little as possible, order kept."""
    order = sorted(range(len(places)), key=lambda k: places[k])
    moved = list(places)
    for _ in range(200):
        for one, other in zip(order, order[1:]):
            short = gap - (moved[other] - moved[one])
            if short > 0:
                moved[one] -= short / 2
                moved[other] += short / 2
    return moved


def draw_axes(picture, left, top, x_axis, y_axis, title, first):
    right, bottom = left + PANEL_WIDTH, top + PANEL_HEIGHT
    for tick in y_axis.ticks():
        y = bottom - PANEL_HEIGHT * y_axis.share(tick)
        picture.line(left, y, right, y, "grid")
        picture.text(left - 6, y + 4, number_text(tick), "muted", "end")
    for tick in x_axis.ticks():
        x = left + PANEL_WIDTH * x_axis.share(tick)
        picture.line(x, top, x, bottom, "grid")
        picture.text(x, bottom + 17, number_text(tick), "muted")
    picture.add(f'<rect x="{left}" y="{top}" width="{PANEL_WIDTH}" height="{PANEL_HEIGHT}" class="frame"/>')
    picture.text(left + PANEL_WIDTH / 2, bottom + 38, html.escape(x_axis.label))
    picture.text(left + PANEL_WIDTH / 2, top - 12, html.escape(title), weight="bold", size=13)
    if first:
        picture.text(left - 46, top + PANEL_HEIGHT / 2, html.escape(y_axis.label), turn=-90)


def draw_line(picture, line, place):
    band = [p for p in line.points if len(p) == 4]
    if band:
        edge = [place(p[0], p[2]) for p in band] + [place(p[0], p[3]) for p in reversed(band)]
        corners = " ".join(f"{x:.1f},{y:.1f}" for x, y in edge)
        picture.add(f'<polygon points="{corners}" class="b{line.colour}"/>')
    if line.dots:
        for k, point in enumerate(line.points):
            x, y = place(point[0], point[1])
            picture.add(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4.5" class="l{line.colour}"/>')
            if k < len(line.notes):
                words, right, down, anchor = line.notes[k]
                picture.text(x + right, y + down, html.escape(words), f"t{line.colour}", anchor, size=11)
        return
    corners = " ".join("{:.1f},{:.1f}".format(*place(p[0], p[1])) for p in line.points)
    dash = ' stroke-dasharray="5 4"' if line.dashed else ""
    picture.add(f'<polyline points="{corners}" class="l{line.colour}"{dash}/>')
    for k, point in enumerate(line.points):
        x, y = place(point[0], point[1])
        if not line.dashed:
            picture.add(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.6" class="t{line.colour}"/>')
        if k < len(line.notes):
            picture.text(x, y - 8, html.escape(line.notes[k]), "muted", size=10)


def draw_chart(path, panels, x_label, y_label, x_log=True, y_log=True, from_zero=False, whole=False, marks=(), room=()):
    """panels: list of (title, [Line]); one y axis for all of them, and one x axis too if `marks` name its ticks. `whole`:
    x counts something. `room`: y values that also belong on the axis."""
    heights = [h for _, lines in panels for line in lines for p in line.points for h in p[1:]]
    y_axis = Axis(y_label, heights + list(room), y_log, from_zero)
    all_places = [p[0] for _, lines in panels for line in lines for p in line.points]
    columns = len(panels) if len(panels) <= 3 else 2
    rows = -(-len(panels) // columns)
    longest = max(len(line.label) for _, lines in panels for line in lines)
    labels = max(LABELS, math.ceil(LETTER_WIDTH * longest) + 12)
    wide, high = LEFT + PANEL_WIDTH + labels, TOP + PANEL_HEIGHT + BOTTOM
    picture = Picture(wide * columns, high * rows)
    for k, (title, lines) in enumerate(panels):
        left, top = LEFT + k % columns * wide, TOP + k // columns * high
        places = all_places if marks else [p[0] for line in lines for p in line.points]
        x_axis = Axis(x_label, places, x_log, whole=whole, marks=marks)

        def place(x, y, left=left, top=top, x_axis=x_axis):
            return left + PANEL_WIDTH * x_axis.share(x), top + PANEL_HEIGHT * (1 - y_axis.share(y))

        draw_axes(picture, left, top, x_axis, y_axis, title, k % columns == 0)
        for line in lines:
            draw_line(picture, line, place)
        ends = [place(line.points[-1][0], line.points[-1][1])[1] for line in lines]
        for line, y in zip(lines, spread(ends, FONT_SIZE + 2)):
            picture.text(left + PANEL_WIDTH + 6, y + 4, html.escape(line.label), f"t{line.colour}", "start")
    picture.save(path)
