#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the Markdown tables of the documentation from what hgrid_compare has written, so that no figure is typed:

    python3 programs/bench/plot/table.py measured/*.csv

Tables: all searches side by side, the library's settings, memory. ns per particle are medians.
"""

import argparse

from measured import OURS, TITLES, in_order, read


def name_of(row):
    count = f"{row.particles / 1e6:.3g}M" if row.particles >= 1e6 else f"{row.particles:,.0f}".replace(",", "\u202f")
    return f"{row.system}, {count}" if row.particles != 125001 else row.system


def figure(value, digits=0):
    return "-" if value is None else f"{value:,.{digits}f}".replace(",", "\u202f")


def ns_text(row):
    if row is None:
        return "-"
    if row.ns is None:
        return row.verdict
    return figure(row.ns, 0)


def table(title, head, lines):
    print(f"### {title}\n")
    print("| " + " | ".join(head) + " |")
    print("|" + "---|" * len(head))
    for line in lines:
        print("| " + " | ".join(line) + " |")
    print()


def library_row(rows, isa, threads, variant):
    found = [r for r in rows if r.contestant == "library" and (r.isa, r.threads, r.variant) == (isa, threads, variant)]
    return found[0] if found else None


def against_others(systems):
    others = in_order(r.contestant for rows in systems.values() for r in rows if r.contestant != "library")
    lines = []
    for system, rows in systems.items():
        isa = next(r.isa for r in rows if r.contestant == "library")
        library = library_row(rows, isa, 1, "grid-exact")
        by_name = {r.contestant: r for r in rows if r.contestant != "library"}
        peers = [r for r in by_name.values() if r.contestant not in OURS and r.ns is not None]
        fastest = min(peers, key=lambda r: r.ns, default=None)
        factor = f"{fastest.ns / library.ns:.1f} ({TITLES[fastest.contestant]})" if fastest and library else "-"
        classical = by_name.get("classical")
        gain = f"{classical.ns / library.ns:.1f}" if classical and classical.ns and library else "-"
        lines.append([system, ns_text(library), *(ns_text(by_name.get(o)) for o in others), factor, gain])
    titles = [TITLES.get(o, o) for o in others]
    head = ["system", "libhgrid", *titles, "fastest peer / libhgrid", "classical / libhgrid"]
    table("Side by side, one thread", head, lines)


def best_variants(systems):
    others = in_order(r.contestant for rows in systems.values() for r in rows if r.contestant not in OURS and r.variant)
    lines = []
    for system, rows in systems.items():
        by_name = {r.contestant: r for r in rows}
        lines.append([system, *(by_name[o].variant if o in by_name else "-" for o in others)])
    if others:
        table("The fastest variant of each peer", ["system", *(TITLES.get(o, o) for o in others)], lines)


def instruction_sets(systems):
    isas = in_order(r.isa for rows in systems.values() for r in rows if r.contestant == "library")
    head = ["system", *(f"{i}, {t} thread{'s' if t > 1 else ''}" for t in (1, 2) for i in isas)]
    lines = []
    for system, rows in systems.items():
        cells = [library_row(rows, isa, threads, "grid-exact") for threads in (1, 2) for isa in isas]
        lines.append([system, *(figure(c.ns, 1) if c and c.ns else "-" for c in cells)])
    table("Instruction sets and threads, exact, order of the grid", head, lines)


def settings(systems):
    words = {
        "grid-exact": "exact",
        "grid-double": "double",
        "grid-float": "float",
        "id-exact": "by id, exact",
        "id-double": "by id, double",
        "id-float": "by id, float",
        "grid-exact-paper": "levels of the paper",
        "grid-exact-L1": "one level",
    }
    lines = []
    for system, rows in systems.items():
        isa = next(r.isa for r in rows if r.contestant == "library")
        cells = [library_row(rows, isa, 1, variant) for variant in words]
        lines.append([system, *(figure(c.ns, 1) if c and c.ns else "-" for c in cells)])
    table("Settings of the library, one thread, best instruction set", ["system", *words.values()], lines)


def memory(systems):
    shown = in_order(r.contestant for rows in systems.values() for r in rows)
    lines = []
    for system, rows in systems.items():
        isa = next(r.isa for r in rows if r.contestant == "library")
        first = {r.contestant: r for r in reversed(rows)}
        first["library"] = library_row(rows, isa, 1, "grid-exact") or first["library"]
        pairs = f"{first['library'].pairs / first['library'].particles:.2f}"
        lines.append([system, pairs, *(figure(first[s].peak_bytes_per_particle) if s in first else "-" for s in shown)])
    head = ["system", "pairs per particle", *(TITLES.get(s, s) for s in shown)]
    table("Peak memory beyond the input, bytes per particle, one thread", head, lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("csv", nargs="+", help="files written by hgrid_compare --csv FILE")
    rows = [row for row in read(parser.parse_args().csv) if not row.sweep]
    if not rows:
        raise SystemExit("no row that belongs to no sweep: nothing for these tables")
    systems = {}
    for row in rows:
        systems.setdefault(name_of(row), []).append(row)
    with_library = {s: rows for s, rows in systems.items() if any(r.contestant == "library" for r in rows)}
    for where in in_order((r.machine, int(r.processors), r.compiler, r.commit) for r in rows):
        print("{}, {} processors; {}; commit {}\n".format(*where))
    against_others(with_library)
    best_variants(with_library)
    instruction_sets(with_library)
    settings(with_library)
    memory(with_library)


if __name__ == "__main__":
    main()
