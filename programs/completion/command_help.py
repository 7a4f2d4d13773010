# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""What a command says with --help, taken apart: its own options and those of each of its subcommands."""

import dataclasses
import os
import re
import subprocess

COLUMN = 30  # where CLI11 begins the text of an option; a longer name has a line of its own


@dataclasses.dataclass
class Option:
    names: list  # -o, --output; of a positional its name alone
    form: str  # what stands behind the names: kind of value, default, ...
    text: str

    @property
    def takes_value(self):
        return re.match(r"[A-Z]{3,}\b", self.form) is not None

    @property
    def values(self):
        """The words that the value can be, if it is one of some words."""
        words = re.search(r"\{([^{}]*)\}", self.form)
        return words[1].split(",") if words else []

    @property
    def is_number(self):
        return re.match(r"(?:U?INT|FLOAT|NONNEGATIVE|POSITIVE)\b", self.form) is not None

    @property
    def is_list(self):
        return "..." in self.form


@dataclasses.dataclass
class Command:
    name: str  # of a subcommand its own; of the command itself ""
    text: str
    usage: str
    positionals: list
    options: list
    subcommands: list  # of Option
    footer: str


# What CLI11 writes behind the kind of a value; where the text of an option would begin, it belongs to the name.
REST_OF_NAME = re.compile(r"Excludes:|Needs:|REQUIRED|\.\.\.|-[ -]")


def entries(block):
    """The options of a section."""
    found = []
    for line in block:
        if line.startswith(" " * COLUMN):
            found[-1].append(line[COLUMN:])
        elif len(line) <= COLUMN or line[COLUMN - 1] != " " or REST_OF_NAME.match(line[COLUMN:]):
            found.append([line.strip()])
        else:
            found.append([line[:COLUMN].strip(), line[COLUMN:]])
    for name, *text in found:
        names, _, form = name.partition(" ")
        yield Option(names.split(","), form.strip(), "\n".join(text).strip())


def parse(name, text):
    head, _, rest = text.partition("Usage:")
    usage, _, rest = rest.partition("\n")
    positionals, options, subcommands, footer = [], [], [], []
    section, lines = None, rest.split("\n")
    for line, following in zip(lines, [*lines[1:], ""]):
        if line in ("Positionals:", "Subcommands:"):
            section = positionals if line == "Positionals:" else subcommands
        elif re.fullmatch(r"\w[\w ]*:", line) and following.startswith("  -"):  # of options, in groups
            section = options
        elif section is not None and line.startswith("  ") and not footer:
            section.append(line)
        elif line.strip() or footer:
            footer.append(line)
    return Command(name, head.strip(), usage.strip(), list(entries(positionals)), list(entries(options)),
                   list(entries(subcommands)), "\n".join(footer).strip())


def ask(program, *arguments):
    # A program that is built with MPI may be started alone, also by root.
    environment = {
        **os.environ,
        "OMPI_ALLOW_RUN_AS_ROOT": "1",
        "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
        "OMPI_MCA_plm_rsh_agent": "/bin/false",
    }
    run = subprocess.run([program, *arguments], capture_output=True, text=True, check=True, env=environment)
    return run.stdout


def read(program):
    """The command itself, then its subcommands."""
    main = parse("", ask(program, "--help"))
    return [main, *(parse(sub.names[0], ask(program, sub.names[0], "--help")) for sub in main.subcommands)]
