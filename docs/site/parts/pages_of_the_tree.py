# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pages of the site that stand elsewhere in the tree, or are made of what stands there.

A fence with one of these names is replaced before Sphinx reads the page:

    {page} FILE              the whole of a page outside of docs
    {section} FILE#HEADING   a section of one, without its heading; without HEADING, what comes before the first one
    {gallery}                every picture, with the page that shows it and the command that made it
    {calls} HEADER           the functions of a header with the first words of their comments
    {fortran} MODULE         the public interface of a Fortran module

Links that leave docs lead to the page of the site that holds their target, and pages are called by their titles.
"""

import importlib.util
import os
import pathlib
import posixpath
import re
import sys

import fortran_reference
import pages

ROOT = pathlib.Path(__file__).resolve().parents[3]
# What stands outside of docs: the page of the site that shows it.
SHOWN_BY = {
    "README.md": "index.md",
    "CHANGELOG.md": "project/changelog.md",
    "CONTRIBUTING.md": "project/contributing.md",
    "examples/hosts/README.md": "project/hosts.md",
    "bindings/swig/README.md": "project/scripting.md",
    "packaging/README.md": "project/packages.md",
    "include/hgrid": "reference/c.md",
}
FENCE = re.compile(r"^```\{(page|section|gallery|calls|fortran)\} ?(.*)\n```$", re.MULTILINE)


def rewrite(text, origin, docname):
    """Links of a text of `origin`, a path from the root, as a page of the site needs them."""
    folder, here = posixpath.dirname(origin), posixpath.dirname("docs/" + docname)

    def link(match):
        mark, words, target = match.groups()
        if re.match(r"[a-z]+:|#", target):
            return match[0]
        path, sharp, anchor = target.partition("#")
        path = posixpath.normpath(posixpath.join(folder, path))
        path = "docs/" + SHOWN_BY[path] if path in SHOWN_BY else path
        if not path.startswith("docs/") and (path.endswith(".md") or (ROOT / path).is_dir()):
            return words  # on no page of the site
        # A page that is called by the name of its file is called by its title here.
        words = "" if words == posixpath.basename(path) and path.endswith(".md") else words
        return f"{mark}[{words}]({posixpath.relpath(path, here)}{sharp}{anchor})"

    pieces = re.split(r"(^```[\s\S]*?^```$|^    .*$|`[^`\n]*`)", text, flags=re.MULTILINE)
    return "".join(piece if k % 2 else pages.LINK.sub(link, piece) for k, piece in enumerate(pieces))


def page(name, docname):
    return rewrite((ROOT / name).read_text(encoding="utf-8"), name, docname)


def section(argument, docname):
    name, _, heading = argument.partition("#")
    parts = re.split(r"^## (.*)\n", (ROOT / name).read_text(encoding="utf-8"), flags=re.MULTILINE)
    if heading:
        text = parts[parts.index(heading) + 1]
    else:
        text = parts[0].split("\n```")[0].partition("\n")[2]
    return rewrite(text.strip(), name, docname)


def gallery(_, docname):
    """A figure for each picture in the order of the table of docs/README.md."""
    tree = {each.path: each for each in pages.read_pages(ROOT / "docs")}
    shows = {}
    for each in tree.values():
        for mark, words, target in pages.LINK.findall(each.prose):
            if mark:
                shows.setdefault(pages.path_of(each, target), (each, words))
    here = ROOT / "docs" / posixpath.dirname(docname)
    out = []
    for names, command, _ in pages.written(tree[ROOT / "docs/README.md"]):
        shown = [ROOT / name for name in names if ROOT / name in shows]
        for picture in shown:
            by, words = shows[picture]
            title = by.headings[0]
            out.append(f"::::{{figure}} {posixpath.relpath(picture, here)}\n:alt: {words}\n:class: gallery\n\n"
                       f"{words}: [{title}]({posixpath.relpath(by.path, here)})\n::::\n")
        if shown:
            out.append(f"```sh\n{command.replace(chr(92) + '|', '|')}\n```\n")
    return "\n".join(out)


def manual_pages():
    """docs/man/pages.py, which reads the XML of Doxygen; its name is taken here."""
    folder = ROOT / "docs/man"
    spec = importlib.util.spec_from_file_location("manual_pages", folder / "pages.py")
    module = importlib.util.module_from_spec(spec)
    sys.path.append(str(folder))
    spec.loader.exec_module(module)
    return module


def calls(header, _):
    manual = manual_pages()
    rows = ["| function | in short |", "|---|---|"]
    for member in manual.Xml(pathlib.Path(os.environ["HGRID_XML"], "xml")).functions(header):
        words = re.sub(r"([*|<>_\[\]])", r"\\\1", manual.first_words(member))
        rows.append(f"| {{c:func}}`{member.findtext('name')}` | {words} |")
    return "\n".join(rows)


def fortran(module, _):
    return fortran_reference.page(ROOT / "bindings/fortran", module)


MAKE = {"page": page, "section": section, "gallery": gallery, "calls": calls, "fortran": fortran}


def read_source(app, docname, source):
    text = rewrite(source[0], f"docs/{docname}.md", docname)
    source[0] = FENCE.sub(lambda match: MAKE[match[1]](match[2].strip(), docname), text)
    if docname == "index":  # pages that it does not list yet come last
        listed = set(re.findall(r"^[\w/-]+$", source[0], re.MULTILINE))
        places = [path.relative_to(ROOT / "docs").with_suffix("").as_posix() for path in (ROOT / "docs").glob("[!de]*/*.md")]
        if more := sorted(set(places) - listed):
            source[0] += "\n```{toctree}\n:hidden:\n:caption: More\n\n" + "\n".join(more) + "\n```\n"
    if docname == "decisions/README":  # its table is the list that readers see
        source[0] += "\n```{toctree}\n:hidden:\n:glob:\n\n0*\n```\n"


def setup(app):
    app.connect("source-read", read_source)
    return {"parallel_read_safe": True}
