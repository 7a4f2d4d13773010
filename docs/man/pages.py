#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Man pages of section 3 from what Doxygen reads in the headers: pages.py XML_DIR OUT_DIR VERSION DATE [HEADER...].

One page for each function and each struct, and one over all: libhgrid(3), with libhgrid_mpi(3) for hgrid/mpi.h. HEADERs
are names such as grid.h; by default, all of them.
"""

import argparse
import pathlib
import re
import textwrap
import xml.etree.ElementTree as tree

from roff import LAYOUT, bold, escape, filled

HEADERS = ("base.h", "types.h", "grid.h", "history.h", "mpi.h")


def inline(node):
    """The text of a paragraph, roff in place of elements; blocks in it are left out."""
    out = escape(node.text or "")
    for child in node:
        if child.tag == "ref":
            out += bold("".join(child.itertext())) + "(3)"
        elif child.tag == "computeroutput":
            out += bold("".join(child.itertext()))
        elif child.tag not in ("simplesect", "verbatim"):
            out += inline(child)
        out += escape(child.tail or "")
    return " ".join(out.split()).replace("(3)()", "(3)")


def described(node):
    """(lines before any heading, [(heading, lines)]) of a description."""
    lead, parts = [], []

    def paragraph(lines, text):
        if text:
            lines += ([".PP"] if lines else []) + filled(text)

    for para in node.iter("para") if node is not None else ():
        sections = para.findall("simplesect")
        if sections:
            paragraph(lead, inline(para))
            for part in sections:
                rest = []
                for each in part.iter("para"):
                    paragraph(rest, inline(each))
                parts.append((part.findtext("title"), rest))
        elif para.find("verbatim") is not None:
            paragraph(lead, inline(para))
            lead += [".PP", ".nf", *map(escape, para.findtext("verbatim").strip("\n").split("\n")), ".fi"]
        elif not any(para in list(section) for section in node.iter("simplesect")):
            paragraph(lead, inline(para))
    return lead, parts


def plain(node):
    return " ".join("".join(node.itertext()).split())


def first_words(member):
    """The first sentence, or what of it comes before a colon, in plain text."""
    para = member.find("detaileddescription/para")
    text = "".join(para.itertext()) if para is not None else member.findtext("name")
    text = re.split(r"(?<!e\.g)(?<!Eq)[.;:] ", " ".join(text.split()))[0].rstrip(".:;")
    return text if re.match(r"(?:[A-Z]{2}|\w*_)", text) else text[:1].lower() + text[1:]


def summary(member):
    """The same as a line of NAME wants it."""
    return escape(first_words(member)).replace("-", "\\-")


def prototype(member):
    """A declaration of C: names of arguments in italics."""
    kind = plain(member.find("type"))
    arguments = []
    for parameter in member.findall("param"):
        name = parameter.findtext("declname")
        type_ = plain(parameter.find("type"))
        joint = "" if type_.endswith("*") else " "
        array = parameter.findtext("array") or ""
        arguments.append(f"{type_}{joint}\\fI{name}\\fP{array}" if name else type_)
    joint = "" if kind.endswith("*") else " "
    head = f"{kind}{joint}{member.findtext('name')}("
    lines, line = [], head
    for k, argument in enumerate(arguments or ["void"]):
        piece = argument + (", " if k + 1 < len(arguments) else ");")
        if len(line.replace("\\fI", "").replace("\\fP", "") + piece.replace("\\fI", "").replace("\\fP", "")) > 78:
            lines.append(line.rstrip())
            line = "    "
        line += piece
    return [f"\\fB{each.replace(chr(92) + 'fP', chr(92) + 'fB')}\\fP" for each in [*lines, line]]


class Writer:
    def __init__(self, out, version, date):
        self.out, self.version, self.date = out, version, date

    def page(self, name, lines):
        head = ['.\\" Made by docs/man/pages.py from the comments of the headers.',
                f'.TH {name.upper()} 3 {self.date} "libhgrid {self.version}" "libhgrid"',
                *LAYOUT]
        (self.out / f"{name}.3").write_text("\n".join([*head, *lines, ""]), encoding="utf-8")


def include_of(header):
    return "hgrid/mpi.h" if header == "mpi.h" else "hgrid/hgrid.h"


def library_of(header):
    return "libhgrid_mpi" if header == "mpi.h" else "libhgrid"


def see_also(member, header):
    refs = [ref.text for ref in member.iter("ref") if ref.text != member.findtext("name")]
    names = [*sorted({ref for ref in refs if ref.startswith("hg_")}), library_of(header)]
    return [".SH SEE ALSO", *(f".BR {name} (3)," for name in names[:-1]), f".BR {names[-1]} (3)"]


def function_page(writer, header, member):
    name = member.findtext("name")
    lead, parts = described(member.find("detaileddescription"))
    package = "hgrid-mpi" if header == "mpi.h" else "hgrid"
    lines = [".SH NAME", f"{name} \\- {summary(member)}", ".SH LIBRARY",
             f"{library_of(header)}: $(pkg\\-config \\-\\-cflags \\-\\-libs {package})",
             ".SH SYNOPSIS", ".nf", f"\\fB#include <{include_of(header)}>\\fP", ".PP", *prototype(member), ".fi",
             ".SH DESCRIPTION", *lead]
    if plain(member.find("type")) == "hg_status" and name != "hg_status_string":
        lines += [".SH RETURN VALUE", *filled(f"{bold('HG_OK')} (0), or another status, of which {bold('hg_last_error')}(3) "
                                              "then tells the text.")]
    for title, rest in parts:
        lines += [f".SH {title.upper()}", *rest]
    writer.page(name, lines + see_also(member, header))


def typedef_page(writer, header, member):
    lead, parts = described(member.find("detaileddescription"))
    name = member.findtext("name")
    lines = [".SH NAME", f"{name} \\- {summary(member)}", ".SH SYNOPSIS", ".nf",
             f"\\fB#include <{include_of(header)}>\\fP", ".PP", *textwrap.wrap(f"{plain(member.find('definition'))};", 78),
             ".fi", ".SH DESCRIPTION", *lead]
    for title, rest in parts:
        lines += [f".SH {title.upper()}", *rest]
    writer.page(name, lines + see_also(member, header))


def members_of(struct):
    for member in struct.iter("memberdef"):
        kind = plain(member.find("type"))
        name = f"{member.findtext('name')}{member.findtext('argsstring') or ''}"
        yield f"{kind}{'' if kind.endswith('*') else ' '}{name}", member


def struct_page(writer, header, struct):
    name = struct.findtext("compoundname")
    lead, parts = described(struct.find("detaileddescription"))
    members = list(members_of(struct))
    lines = [".SH NAME", f"{name} \\- {summary(struct)}", ".SH SYNOPSIS", ".nf",
             f"\\fB#include <{include_of(header)}>\\fP", ".PP", f"typedef struct {name} {{",
             *(f"    {escape(text)};" for text, _ in members), f"}} {name};", ".fi", ".SH DESCRIPTION", *lead]
    for _, member in members:
        about, _ = described(member.find("detaileddescription"))
        if about:
            lines += [".TP", f"{bold(member.findtext('name'))}", *about]
    for title, rest in parts:
        lines += [f".SH {title.upper()}", *rest]
    writer.page(name, lines + see_also(struct, header))


def constants(sections):
    """The enumerations, with what they say of their values."""
    for member in (each for section in sections for each in section.iter("memberdef") if each.get("kind") == "enum"):
        lead, _ = described(member.find("detaileddescription"))
        if lead:
            yield [".PP", *lead]
        for value in member.findall("enumvalue"):
            about, _ = described(value.find("detaileddescription"))
            yield [".TP", bold(f"{value.findtext('name')} {value.findtext('initializer') or ''}".strip()), *about]


def overview(writer, name, headers, xml):
    """The page over all, from what the files say of themselves."""
    title = {"libhgrid": "every overlapping pair among particles of very different sizes",
             "libhgrid_mpi": "pairs of particles that lie on several ranks of MPI"}[name]
    lines = [".SH NAME", f"{name} \\- {title}", ".SH SYNOPSIS", ".nf", f"\\fB#include <{include_of(headers[-1])}>\\fP",
             ".fi", ".SH DESCRIPTION"]
    constant_lines = []
    for header in headers:
        file = xml.files[header]
        lead, parts = described(file.find("detaileddescription"))
        lines += [f".SS hgrid/{header}", *lead]
        for part, rest in parts:
            lines += [".PP", f"\\fB{escape(part)}.\\fP", *rest]
        named = [(each.findtext("name"), each) for each in xml.functions(header) + xml.typedefs(header)]
        for each, member in named + [(each.findtext("compoundname"), each) for each in xml.structs(header)]:
            lines += [".TP", f".BR {each} (3)", *filled(summary(member))]
        constant_lines += [line for block in constants(file.iter("sectiondef")) for line in block]
    if constant_lines:
        lines += [".SH CONSTANTS", *constant_lines[1 if constant_lines[0] == ".PP" else 0 :]]
    others = [each for each in ("hgrid (1)", "libhgrid (3)") if each != f"{name} (3)"]
    lines += [".SH SEE ALSO", *(f".BR {each}{',' if k + 1 < len(others) else ''}" for k, each in enumerate(others))]
    writer.page(name, lines)


class Xml:
    def __init__(self, folder):
        self.folder = folder
        index = tree.parse(folder / "index.xml").getroot()
        refs = {(each.get("kind"), each.findtext("name").rpartition("/")[2]): each.get("refid") for each in index}
        self.files = {name: self.compound(ref) for (kind, name), ref in refs.items() if kind == "file" and name in HEADERS}

    def compound(self, ref):
        return tree.parse(self.folder / f"{ref}.xml").getroot().find("compounddef")

    def functions(self, header):
        members = self.files[header].iter("memberdef")
        return [member for member in members if member.get("kind") == "function"]

    def typedefs(self, header):
        """Names that stand for no struct which has a page of its own."""
        structs = {struct.findtext("compoundname") for struct in self.structs(header)}
        members = self.files[header].iter("memberdef")
        return [each for each in members if each.get("kind") == "typedef" and each.findtext("name") not in structs]

    def structs(self, header):
        """Those with members that users see."""
        found = [self.compound(inner.get("refid")) for inner in self.files[header].findall("innerclass")]
        return [struct for struct in found if struct.find("sectiondef") is not None]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("xml", "out"):
        parser.add_argument(name, type=pathlib.Path)
    for name in ("version", "date"):
        parser.add_argument(name)
    parser.add_argument("headers", nargs="*")
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    xml, writer = Xml(arguments.xml), Writer(arguments.out, arguments.version, arguments.date)
    headers = arguments.headers or HEADERS
    for header in headers:
        for member in xml.functions(header):
            function_page(writer, header, member)
        for struct in xml.structs(header):
            struct_page(writer, header, struct)
        for member in xml.typedefs(header):
            typedef_page(writer, header, member)
    core = [header for header in headers if header != "mpi.h"]
    if core:
        overview(writer, "libhgrid", core, xml)
    if "mpi.h" in headers:
        overview(writer, "libhgrid_mpi", ["mpi.h"], xml)


if __name__ == "__main__":
    main()
