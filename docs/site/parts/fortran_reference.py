# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""The public interface of a Fortran module as Markdown, from its sources and their comments.

Of each public type its components and calls, those of the types that it extends included; of each call what its binding
says, and the procedures behind it as far as their arguments. Procedures that differ from one shown in nothing but the
kinds of numbers are left out, and it is said which kinds there are.
"""

import re

PROCEDURE = re.compile(r"^ +(?:(?:pure|elemental|recursive|impure) )*(?:subroutine|function) (\w+)\(")
TYPE = re.compile(r"^ +type\b(?:, (?:abstract|bind\(c\)|extends\((?P<parent>\w+)\)|public))* :: (?P<name>\w+)$")
BINDING = re.compile(r"^ +(?:generic|procedure)(?:\([\w]+\))?(?:, (?P<kind>public|deferred|pass\(\w+\)))* :: (?P<names>.*)$")
KINDS = re.compile(r"\b(real|integer)\((?:c_double|c_float|c_int32_t|c_int64_t)\)")


def joined(lines):
    """Lines with their continuations."""
    out = []
    for line in lines:
        if out and out[-1].endswith("&"):
            out[-1] = out[-1][:-1].rstrip() + " " + line.strip()
        else:
            out.append(line.rstrip())
    return out


class Source:
    """All that the files of a module hold: types, procedures, and the comment before each."""

    def __init__(self, paths):
        self.types, self.procedures, self.modules, self.constants = {}, {}, {}, []
        for path in paths:
            self.read(joined(path.read_text(encoding="utf-8").split("\n")))

    def read(self, lines):
        comment = []
        for number, line in enumerate(lines):
            stripped = line.strip()
            if stripped.startswith("!>"):
                comment.append(stripped[2:].strip())
                continue
            if module := re.match(r"module (\w+)$", line):
                self.modules[module[1]] = text_of(comment)
            elif (type_ := TYPE.match(line)) and "end type" not in line:
                end = next(n for n in range(number, len(lines)) if lines[n].strip().startswith("end type"))
                self.types[type_["name"]] = (type_["parent"], text_of(comment), lines[number : end + 1])
            elif procedure := PROCEDURE.match(line):
                self.procedures.setdefault(procedure[1], (text_of(comment), self.head(lines, number)))
            elif constant := re.match(r" +\S.*, parameter, public :: (\w+) = (\S+)$", line):
                self.constants.append((constant[1], constant[2], text_of(comment)))
            if stripped or comment[-1:] == [""]:
                comment = []

    def head(self, lines, number):
        """A procedure up to its last argument, without what it imports."""
        out = [lines[number].strip()]
        for line in lines[number + 1 :]:
            if not line.strip() or line.strip().startswith("end "):
                break
            if not line.strip().startswith("import"):
                out.append("    " + line.strip().replace("!> ", "! "))
        return out

    def bindings(self, name):
        """(names of a call, comment, procedures) of a type and those that it extends, the first ones first."""
        parent, _, lines = self.types[name]
        yield from self.bindings(parent) if parent else ()
        comment = []
        for line in lines[1:-1]:
            if line.strip().startswith("!>"):
                comment.append(line.strip()[2:].strip())
                continue
            binding = BINDING.match(line)
            if binding and re.search(r"\bpublic\b|deferred", line.split("::")[0]):
                names, _, targets = binding["names"].partition("=>")
                called = [each.strip() for each in names.split(",")]
                behind = [each.strip() for each in targets.split(",")] if targets else called
                if called != ["assignment(=)"]:
                    for each in called:
                        yield each, text_of(comment), behind if targets else [each]
            comment = []


def text_of(comment):
    """The comment as Markdown: its paragraphs."""
    blocks = re.split(r"\n\n+", "\n".join(comment).strip())
    return "\n\n".join(escape(" ".join(block.split())) for block in blocks if block.strip())


def escape(text):
    """Names with underscores, calls and constants as code; what Markdown would read otherwise, as it is."""
    text = re.sub(r"(?<![\w`%(])([a-z_]+\([^()]*(?:\([^()]*\)[^()]*)*\)|\w*_\w+)", r"`\1`", text)
    return re.sub(r"([*<>|\[\]])(?=[^`]*(?:`[^`]*`[^`]*)*$)", r"\\\1", text)


def calls(source, name):
    for call, comment, behind in source.bindings(name):
        yield f"### {call}\n"
        if comment:
            yield comment + "\n"
        shown, kinds = [], set()
        for each in behind:
            if each not in source.procedures:
                continue
            about, head = source.procedures[each]
            text = "\n".join(head)
            kinds |= {match[0] for match in KINDS.finditer(text)}
            shape = re.sub(r"\w+", lambda word: "" if word[0] == each else word[0], KINDS.sub(r"\1", text.replace(", contiguous", "")))
            if shape not in [former for former, *_ in shown]:
                shown.append((shape, about, text))
        for _, about, text in shown:
            if about and about != comment:
                yield about + "\n"
            yield f"```fortran\n{text}\n```\n"
        if len(shown) < len([each for each in behind if each in source.procedures]):
            yield "The same for numbers of " + ", ".join(f"`{kind}`" for kind in sorted(kinds)) + ".\n"


def components(source, name):
    """The lines of a type that declare what users may set and read."""
    body = "\n".join(source.types[name][2][1:-1]).split("    contains")[0]
    return [] if "private" in body else [line for line in body.split("\n") if "::" in line]


def page(folder, module):
    source = Source(sorted(folder.glob("*.f90")))
    own = joined((folder / f"{module}.f90").read_text(encoding="utf-8").split("\n"))
    public = [name.strip() for line in own if re.match(r" +public ::", line) for name in line.split("::")[1].split(",")]
    out = [source.modules[module] + "\n"]
    for name in (each for each in public if each in source.types):
        out += [f"## type {name}\n", source.types[name][1] + "\n"]
        held = components(source, name)
        if held:
            out.append("```fortran\n" + "\n".join(line.strip() for line in held) + "\n```\n")
        out += calls(source, name)
    plain = [name for name in public if name in source.procedures]
    if plain:
        out.append("## Procedures\n")
    for name in plain:
        about, head = source.procedures[name]
        out += [f"### {name}\n", about + "\n", "```fortran\n" + "\n".join(head) + "\n```\n"]
    constants = [(name, value, about) for name, value, about in source.constants if name in public]
    if constants:
        out += ["## Constants\n", "| name | value | |\n|---|---|---|"]
        out += [f"| `{name}` | {value} | {about} |" for name, value, about in constants]
    return "\n".join(out)
