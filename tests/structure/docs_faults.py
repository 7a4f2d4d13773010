#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Each check of the pages fails where it should: docs_faults.py ROOT [BUILD CTEST].

A copy of the tree gets a fault of every kind, each a text at the end of a file.
"""

import pathlib
import shutil
import sys
import tempfile

import docs
import docs_built
import pages

API, INDEX, ROBUST = "docs/guide/api.md", "docs/README.md", "docs/evidence/robustness.md"
REPORTS = "docs/evidence/reports.md"
NOWHERE = "nowhere.md"  # apart, as the check reads this file too
# File, what is added to it, a part of what must be said.
FAULTS = [
    (API, "[x](nowhere.md)", "links to nowhere.md, which is not there"),
    (API, "[x](command.md#nowhere)", "but there is no such heading"),
    (API, "![x](api.md)", "shows api.md as a picture"),
    (API, "## Threads", "has two headings 'threads'"),
    (API, "x " * 61, "122 columns"),
    (API, "see section 2", "refers to section 2 of docs/guide/api.md"),
    (API, "([exactness.md](../theory/exactness.md), sections 3 and 98)", "section 98 of docs/theory/exactness.md"),
    ("src/grid.cpp", "// docs/theory/exactness.md,\n// section 99.", "section 99 of docs/theory/exactness.md"),
    ("src/grid.cpp", f"// docs/{NOWHERE}", f"names docs/{NOWHERE}"),
    (API, "`src/nowhere.cpp`", "names src/nowhere.cpp"),
    (API, "    python3 tests/{sanitizers,nowhere}.sh", "names tests/nowhere.sh"),
    (API, "`Grid`, `no_class` in `src/grid.cpp`", "says that no_class stands in src/grid.cpp"),
    (API, "`src/grid.cpp`: `no_name`", "says that no_name stands in src/grid.cpp"),
    (API, "| in the code | file |\n|---|---|\n| `no_call()` | `src/grid.cpp` |", "says that no_call stands in"),
    ("docs/guide/images/new.svg", "<svg/>", "docs/guide/images/new.svg is shown by no page"),
    ("docs/guide/images/new.svg", "<svg/>", "has 0 commands that write docs/guide/images/new.svg"),
    (INDEX, "| `guide/images/slice.svg` | `true` | no |", "has 2 commands that write docs/guide/images/slice.svg"),
    (INDEX, "| `guide/images/gone.svg` | `true` | no |", "names docs/guide/images/gone.svg"),
    (ROBUST, "`api/test_insert: no_such_test`", "names api/test_insert: no_such_test"),
    (ROBUST, "\n| case | test |\n|---|---|\n| new | by hand |", "names no test in the row 'new'"),
    ("tests/hard_cases/test_cells.cpp", "// cmocka_unit_test(new_case)", "does not name hard_cases/test_cells: new"),
    (REPORTS, "\n| report | test |\n|---|---|\n| unseen | by hand |", "names no test in the row 'unseen'"),
    ("tests/reports/test_axes.cpp", "// cmocka_unit_test((report<new_1>))", "does not name reports/test_axes: new_1"),
    ("CONTRIBUTING.md", "| folder |\n|---|\n| `nowhere` |", "has a row for nowhere"),
    ("CONTRIBUTING.md", "| folder |\n|---|\n| `include` |", "has its rows in another order"),
    ("new/file.txt", "", "has no row for new"),
]
# What is added to a page, a part of what must be said.
BUILT_FAULTS = [
    ("    build/bin/hgrid_nowhere packing.csv", "calls build/bin/hgrid_nowhere, which is not there"),
    ("    cd x && HGRID_ISA=sse2 hgrid pack --nowhere 3", "calls hgrid pack with --nowhere"),
    ("`python3 programs/bench/plot/draw.py --nowhere`", "with --nowhere"),
    ("    ./check -R nowhere", "finds no test"),
    ("`ctest -L nowhere`", "finds no test"),
    ("`api.test_nowhere`", "names the test api.test_nowhere"),
]
KEYS = "docs/guide/scene-keys.md"
WRITTEN_FAULTS = [
    (f"echo other > {KEYS}", f"{KEYS} is not what"),
    ("true", "writes "),
    ("false", "fails"),
]


def add(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("a", encoding="utf-8") as file:
        file.write(text + "\n")


def missed(root, build):
    """The faults that nobody names."""
    before = set(docs.faults(docs.Tree(root)))
    for name, text, _ in FAULTS:
        add(root / name, text)
    found = set(docs.faults(docs.Tree(root))) - before
    yield from (said for *_, said in FAULTS if not any(said in fault for fault in found))
    if not build:
        return
    for text, _ in BUILT_FAULTS:
        add(root / API, text)
    found = list(docs_built.check_page(build, pages.Page(root, root / API)))
    yield from (said for _, said in BUILT_FAULTS if not any(said in fault for fault in found))
    for command, said in WRITTEN_FAULTS:
        if not any(said in fault for fault in docs_built.check_written(build, [KEYS], command)):
            yield said


def main():
    source = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder).resolve() / "tree"
        outside = lambda where, names: filter(pages.is_skipped, names if where == str(source) else ())
        shutil.copytree(source, root, ignore=outside)
        build = docs_built.Build(root, pathlib.Path(sys.argv[2]).resolve(), sys.argv[3]) if len(sys.argv) > 3 else None
        silent = list(missed(root, build))
    for said in silent:
        print("FAULT nothing says:", said)
    print(len(silent), "faults that no check finds")
    return 1 if silent else 0


if __name__ == "__main__":
    sys.exit(main())
