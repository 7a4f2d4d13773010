#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Man pages of section 1 from what commands say with --help: commands.py OUT_DIR VERSION DATE PROGRAM...

One page for each program, NAME(1), and one for each of its commands, NAME-COMMAND(1).
"""

import pathlib
import re
import sys

from roff import LAYOUT, bold, escape, filled

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "programs/completion"))
import command_help  # noqa: E402


def lower(text):
    """A description as a line of NAME wants it."""
    line = " ".join(text.split()).split(". ")[0].rstrip(".")
    return escape(line if line[:2].isupper() else line[:1].lower() + line[1:]).replace("-", "\\-")


def paragraphs(text):
    """Lines as they stand where they are examples or a table of words, else filled."""
    out = []
    for line in text.split("\n"):
        if line.startswith("  "):
            out += [".RS 4", ".nf", escape(line.strip()).replace("-", "\\-"), ".fi", ".RE"]
        elif line.strip():
            out += filled(escape(line.strip()))
    return out


def entry(option, separator=", "):
    names = separator.join(bold(name) for name in option.names)
    form = re.sub(r"\s*\b(Needs|Excludes):", r"  \1:", option.form).replace("INT:INT in", "INT in").strip()
    # A long list of words may be broken behind its commas, not within a word.
    form = escape(form).replace("-", "\\-").replace(",", ",\\:")
    out = [".TP", f"{names} {form}".rstrip()]
    lines = [line for line in option.text.split("\n") if line.strip()]
    for k, line in enumerate(lines):
        out += ([".br"] if k and re.match(r"[\w-]+: ", line) else []) + filled(escape(line.strip()))
    return out if lines else [*out, "\\&"]


def footer(text):
    """(what stands before a heading, examples, exit codes, the manual) of the end of a help text."""
    parts = {"NOTES": [], "EXAMPLES": [], "EXIT STATUS": []}
    heading = "NOTES"
    for line in text.split("\n"):
        if line.startswith("Examples:"):
            heading = "EXAMPLES"
        elif line.startswith("Exit code:"):
            parts["EXIT STATUS"].append(line.partition(":")[2].strip())
            heading = "NOTES"
        elif not line.startswith("Manual, where"):
            heading = "NOTES" if heading == "EXAMPLES" and not line.startswith(" ") else heading
            parts[heading].append(line)
    return [(name, "\n".join(lines)) for name, lines in parts.items() if "".join(lines).strip()]


def page(program, command, others, version, date):
    name = f"{program}-{command.name}" if command.name else program
    lines = ['.\\" Made by docs/man/commands.py from the text of --help.',
             f'.TH {name.upper()} 1 {date} "libhgrid {version}" "libhgrid"', *LAYOUT,
             ".SH NAME", f"{name.replace('-', chr(92) + '-')} \\- {lower(command.text)}", ".SH SYNOPSIS",
             escape(command.usage).replace("-", "\\-"), ".SH DESCRIPTION", *paragraphs(command.text)]
    for heading, options in (("ARGUMENTS", command.positionals), ("OPTIONS", command.options)):
        if options:
            lines += [f".SH {heading}", *(line for option in options for line in entry(option))]
    if command.subcommands:
        lines.append(".SH COMMANDS")
        for option in command.subcommands:
            lines += [".TP", f".BR {program}-{option.names[0]} (1)".replace("-", "\\-"), *filled(escape(option.text))]
    for heading, text in footer(command.footer):
        lines += [f".SH {heading}", *paragraphs(text)]
    also = [f"{program} (1)"] if command.name else []
    also += [f"{other} (1)" for other in others if other != program] + ["libhgrid (3)"]
    lines += [".SH SEE ALSO", *(f".BR {each}{',' if k + 1 < len(also) else ''}".replace("-", "\\-")
                                for k, each in enumerate(also))]
    return name, "\n".join([*lines, ""])


def main():
    out, version, date, *programs = sys.argv[1:]
    pathlib.Path(out).mkdir(parents=True, exist_ok=True)
    names = [pathlib.Path(program).name for program in programs]
    for program, called in zip(programs, names):
        for command in command_help.read(program):
            name, text = page(called, command, names, version, date)
            pathlib.Path(out, f"{name}.1").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
