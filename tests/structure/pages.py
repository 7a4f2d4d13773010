# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""The Markdown pages of the tree, taken apart: headings, tables, code, links, what stands in backticks."""

import itertools
import pathlib
import re

LINK = re.compile(r"(!?)\[([^][]*)\]\(([^)\s]+)\)")
TICKED = re.compile(r"`([^`]+)`")


def is_skipped(name):
    """Of what lies in the root: builds, what programs have written there, git."""
    return re.fullmatch(r"build.*|\..*|demo-output|figures-work", name) is not None


def files(root, pattern):
    for path in sorted(root.rglob(pattern)):
        if not is_skipped(path.relative_to(root).parts[0]) and path.is_file():
            yield path


def expand(pattern):
    """What bash makes of a{b,c}d."""
    braces = re.search(r"\{([^{}]*,[^{}]*)\}", pattern)
    if not braces:
        return [pattern]
    choices = braces[1].split(",")
    return [rest for word in choices for rest in expand(pattern[: braces.start()] + word + pattern[braces.end() :])]


def slug(heading):
    """The anchor that a heading gets."""
    return re.sub(r"[^\w\- ]", "", heading.replace("`", "").lower()).replace(" ", "-")


def cells_of(line):
    """The cells of a row; a bar within one is written \\|."""
    return [cell.strip().replace("\\|", "|") for cell in re.split(r"(?<!\\)\|", line.strip())[1:-1]]


class Table:
    def __init__(self, rows):
        self.head, self.rows = rows[0], rows[2:]

    def column(self, name):
        return [row[self.head.index(name)] for row in self.rows] if name in self.head else []


class Page:
    """`prose` is the text without code, tables and headings included; `code` is (language, text) of each block."""

    def __init__(self, root, path):
        self.path, self.name = path, path.relative_to(root).as_posix()
        self.lines = path.read_text(encoding="utf-8").splitlines()
        self.code, self.tables, prose = [], [], []
        rest = iter(self.lines)
        for line in rest:
            if line.startswith("```"):
                block = itertools.takewhile(lambda text: not text.startswith("```"), rest)
                self.code.append((line[3:].strip(), "\n".join(block)))
            elif line.startswith("    "):
                self.code.append(("", line.strip()))
            else:
                prose.append(line)
        self.prose = "\n".join(prose)
        self.headings = [line.lstrip("#").strip() for line in prose if re.match(r"#+ ", line)]
        self.sections = {int(number[1]) for number in (re.match(r"(\d+)\. ", text) for text in self.headings) if number}
        for is_table, lines in itertools.groupby(prose, lambda line: line.startswith("|")):
            if is_table:
                self.tables.append(Table([cells_of(line) for line in lines]))

    def links(self):
        """(is a picture, target) of each link."""
        return [(mark == "!", target) for mark, _, target in LINK.findall(self.prose)]

    def ticked(self):
        """What stands in backticks, line breaks as spaces."""
        return [" ".join(text.split()) for text in TICKED.findall(self.prose)]

    def shell(self):
        """The lines of code that are commands, with their continuations."""
        blocks = [text for language, text in self.code if language in ("", "sh")]
        return "\n".join(blocks).replace("\\\n", " ").splitlines()


def read_pages(root):
    return [Page(root, path) for path in files(root, "*.md")]


def path_of(page, target):
    """The file that a link of a page leads to."""
    return pathlib.Path(page.path.parent, target.partition("#")[0]).resolve() if target[0] != "#" else page.path


def written(index):
    """(files, command, is repeated) of each row of the table of docs/README.md that says which command writes what."""
    for table in index.tables:
        for names, command, again in table.rows if "written by" in table.head else ():
            files_of_row = ["docs/" + name for ticked in TICKED.findall(names) for name in expand(ticked)]
            yield files_of_row, TICKED.search(command)[1], again == "yes"
