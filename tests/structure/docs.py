#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Holds the pages against the tree: docs.py [ROOT].

What a page points to is there: links and their anchors, numbered sections (also those that comments name), pictures,
files and folders in backticks, names in files, tests. Prints each fault; exits with 1 if there is one.
"""

import functools
import pathlib
import re
import sys

import layers
import pages

COLUMNS = 120
SECTION = re.compile(
    r"(?:(?P<page>[\w./-]+\.md)[)`]*,? )?\b[Ss]ections? (?P<numbers>\d+(?:(?:, | and | to )\d+)*)"
    r"(?![\d.]*\d)(?! of the paper)"
)
# `name`, `name` in `file`; `file`: `name`; `file`, class `name`.
NAMES_IN = re.compile(r"((?:`\w+`, )*`\w+`) in `([\w./]+/[\w.]+)`")
IN_NAMES = re.compile(r"`([\w./]+/[\w.]+)`(?:: |, class )`(\w+)`")
TEST = re.compile(r"([a-z0-9_]+)/(test_\w+): (\w+)")
SOURCES = {".c", ".h", ".cpp", ".hpp", ".f90", ".f", ".py", ".sh", ".txt", ".cmake", ".in", ".toml", ".i"}
COMMENT = re.compile(r"\n\s*(?://|#|\*|!)?\s*")


class Tree:
    def __init__(self, root):
        self.root = root
        self.pages = {page.path: page for page in pages.read_pages(root)}
        folders = [path.name for path in sorted(root.iterdir()) if path.is_dir()]
        self.folders = [name for name in folders if not pages.is_skipped(name)]

    def page(self, name, folder=None):
        """The page that a text calls so, from the root or from the folder of the text."""
        return self.pages.get(self.root / name) or (folder and self.pages.get((folder / name).resolve()))


def check_links(tree, page):
    for is_picture, target in page.links():
        if re.match(r"[a-z]+:", target):
            continue
        path, anchor = pages.path_of(page, target), target.partition("#")[2]
        if not path.exists():
            yield f"links to {target}, which is not there"
        elif anchor and (path not in tree.pages or anchor not in map(pages.slug, tree.pages[path].headings)):
            yield f"links to {target}, but there is no such heading"
        elif is_picture and path.suffix not in (".svg", ".png"):
            yield f"shows {target} as a picture"


def check_headings(tree, page):
    """No two are the same, but in the change log, where each version has its kinds of change."""
    if page.name == "CHANGELOG.md":
        return
    slugs = [pages.slug(heading) for heading in page.headings]
    for heading in sorted({slug for slug in slugs if slugs.count(slug) > 1}):
        yield f"has two headings '{heading}'"


def check_width(tree, page):
    for number, line in enumerate(page.lines, 1):
        if len(line) > COLUMNS and not line.startswith("|"):
            yield f"line {number} has {len(line)} columns, more than {COLUMNS}"


def section_faults(text, own, find):
    """Of each `section N` in a text: `own` is the page meant where none is named, `find` gives the page of a name."""
    for match in SECTION.finditer(" ".join(text.split())):
        page = find(match["page"]) if match["page"] else own
        for number in map(int, re.findall(r"\d+", match["numbers"]) if page else ()):
            if number not in page.sections:
                yield f"refers to section {number} of {page.name}, which has no heading of that number"


def check_sections(tree, page):
    yield from section_faults(page.prose, page, lambda name: tree.page(name, page.path.parent))


def check_paths(tree, page):
    words = " ".join([text for text in page.ticked() if not TEST.fullmatch(text)] + page.shell()).split()
    for word in words:
        path = word.rstrip(".,:;)")
        if path.split("/")[0] not in tree.folders or "/" not in path:
            continue
        for each in pages.expand(path):
            if not list(tree.root.glob(each.rstrip("/"))):
                yield f"names {each}, which is not there"


def has_word(path, word):
    return re.search(rf"\b{re.escape(word)}\b", path.read_text(encoding="utf-8")) is not None


def check_names(tree, page):
    """That a file holds the names that a page says it holds."""
    text = " ".join(page.prose.split())
    named = [(name, [path]) for names, path in NAMES_IN.findall(text) for name in re.findall(r"\w+", names)]
    named += [(name, [path]) for path, name in IN_NAMES.findall(text)]
    for table in page.tables:
        for code, cell in zip(table.column("in the code"), table.column("file")):
            names = [name.partition("(")[0].rpartition("::")[2] for name in pages.TICKED.findall(code)]
            named += [(name, pages.TICKED.findall(cell)) for name in names if re.fullmatch(r"\w+", name)]
    for name, paths in named:
        there = [tree.root / path for path in paths if (tree.root / path).is_file()]
        if there and not any(has_word(path, name) for path in there):
            yield f"says that {name} stands in {' or '.join(paths)}"


def check_tests(tree, page, folder):
    """Every row of a table of tests names one, each is there, none of the folder is left out."""
    for table in page.tables:
        for row, cell in zip(table.rows, table.column("test")):
            if not re.search(r"`[a-z0-9_]+(/test_\w+: \w+|\.\w+)`|\bsection \d", cell):
                yield f"names no test in the row '{row[0]}'"
    named = {match.groups() for match in map(TEST.fullmatch, page.ticked()) if match}
    for place, name, word in sorted(named):
        found = list((tree.root / "tests" / place).rglob(name + ".*"))
        if len(found) != 1 or not has_word(found[0], word):
            yield f"names {place}/{name}: {word}, which is not there"
    for path in pages.files(tree.root, f"tests/{folder}/test_*.c*"):
        for word in re.findall(r"cmocka_unit_test\((?:\(report<)?(\w+)", path.read_text(encoding="utf-8")):
            if (folder, path.stem, word) not in named:
                yield f"does not name {folder}/{path.stem}: {word}"


def check_rows(tree, page):
    """CONTRIBUTING.md has a row for each folder: those of the layers in their order, no other left out."""
    rows = [cell.strip("`") for table in page.tables for cell in table.column("folder")]
    yield from (f"has a row for {folder}, which is not there" for folder in rows if not (tree.root / folder).is_dir())
    missing = [folder for entry in layers.LAYERS for folder in entry if folder not in rows]
    missing += [name for name in tree.folders if not any(folder.split("/")[0] == name for folder in rows)]
    yield from (f"has no row for {folder}" for folder in missing)
    ranks = [layers.RANK[folder] for folder in rows if folder in layers.RANK]
    if ranks != sorted(ranks):
        yield "has its rows in another order than the layers"


def check_written(tree, page):
    """docs/README.md: every picture is shown by a page and has one command that writes it."""
    links = [(each, *link) for each in tree.pages.values() for link in each.links()]
    shown = {pages.path_of(each, target) for each, is_picture, target in links if is_picture}
    written = [tree.root / name for names, _, _ in pages.written(page) for name in names]
    for path in [path for kind in ("*.svg", "*.png") for path in pages.files(tree.root, kind)]:
        name = path.relative_to(tree.root).as_posix()
        if path not in shown:
            yield f"{name} is shown by no page"
        if written.count(path) != 1:
            yield f"has {written.count(path)} commands that write {name}"
    for path in written:
        if not path.exists():
            yield f"names {path.relative_to(tree.root).as_posix()}, which is not there"


def check_source(tree, path):
    """What comments, scripts and texts of programs say about pages."""
    text = COMMENT.sub(" ", path.read_text(encoding="utf-8"))
    for name in re.findall(r"\bdocs/[\w./-]+\.md", text):
        if not tree.page(name):
            yield f"names {name}, which is not there"
    yield from section_faults(text, None, tree.page)


ANY_PAGE = (check_links, check_headings, check_width, check_sections, check_paths, check_names)
ONE_PAGE = {
    "docs/evidence/robustness.md": functools.partial(check_tests, folder="hard_cases"),
    "docs/evidence/reports.md": functools.partial(check_tests, folder="reports"),
    "CONTRIBUTING.md": check_rows,
    "docs/README.md": check_written,
}


def faults(tree):
    for page in tree.pages.values():
        for check in ANY_PAGE:
            yield from (f"{page.name}: {fault}" for fault in check(tree, page))
    for name, check in ONE_PAGE.items():
        yield from (f"{name}: {fault}" for fault in check(tree, tree.page(name)))
    for path in pages.files(tree.root, "*"):
        if path.suffix in SOURCES or path.name in ("check", "demo"):
            name = path.relative_to(tree.root).as_posix()
            yield from (f"{name}: {fault}" for fault in check_source(tree, path))


def main():
    tree = Tree(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve())
    found = list(dict.fromkeys(faults(tree)))
    for fault in found:
        print("FAULT", fault)
    print(f"{len(tree.pages)} pages, {len(found)} faults")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
