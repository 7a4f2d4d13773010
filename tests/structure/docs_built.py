#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Holds the pages against what is built: docs_built.py ROOT BUILD CTEST.

Commands of the pages: the program is there and its help tells the options. Names, labels and patterns of tests: ctest
knows them. Files that docs/README.md says a program writes: written again, they have the same bytes.
"""

import functools
import json
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

import pages

SEPARATORS = {"|", "||", "&&", ";", "&", "(", ")"}
BEFORE_A_COMMAND = re.compile(r"(do|then|time|\w+=.*)$")


class Build:
    def __init__(self, root, folder, ctest):
        self.root, self.folder = root, folder
        shown = subprocess.run(
            [ctest, "--test-dir", folder, "--show-only=json-v1"], check=True, capture_output=True, text=True
        )
        tests = json.loads(shown.stdout)["tests"]
        self.tests = {test["name"] for test in tests}
        labels = [p["value"] for test in tests for p in test.get("properties", ()) if p["name"] == "LABELS"]
        self.labels = {label for value in labels for label in value}

    def path(self, word):
        """Of a program or script as pages call it; None if it is none of ours."""
        if word.startswith("build/"):
            return self.folder / word.removeprefix("build/")
        if re.match(r"hgrid(_\w+)?$", word):
            return self.folder / "bin" / word
        return self.root / word if word.endswith(".py") else None

    @functools.lru_cache(maxsize=None)
    def help(self, path, command):
        call = ["python3", path] if path.suffix == ".py" else [path, *command]
        run = subprocess.run([*call, "--help"], capture_output=True, text=True, check=False)
        return run.stdout + run.stderr


def commands_in(line):
    """The commands of a line of shell, as lists of words."""
    lexer = shlex.shlex(line, posix=True, punctuation_chars=";&|()")
    lexer.whitespace_split, lexer.commenters = True, "#"
    command = []
    try:
        words = [*lexer, ";"]
    except ValueError:  # prose in a block of code
        return
    for word in words:
        if word in SEPARATORS:
            if command:
                yield command
            command = []
        elif command or not BEFORE_A_COMMAND.match(word):
            command.append(word)


def check_command(build, words):
    if words[0] in ("python3", "bash"):
        words = words[1:]
    path = build.path(words[0]) if words else None
    if path is None:
        return
    if not path.exists():
        yield f"calls {words[0]}, which is not there"
        return
    options = [option[0] for option in (re.match(r"--[\w-]+", word) for word in words[1:]) if option]
    subcommand = words[1:2] if path.name in ("hgrid", "hgrid-mpi") and not words[1].startswith("-") else []
    for option in options:
        if not re.search(rf"(?<![\w-]){option}(?![\w-])", build.help(path, tuple(subcommand))):
            yield f"calls {' '.join(words[:2])} with {option}, which its help does not tell"


def check_test_call(build, words):
    """ctest or ./check with -R or -L."""
    for option, pattern in zip(words, words[1:]):
        names = {"-R": build.tests, "-L": build.labels}.get(option, ())
        if names and not any(re.search(pattern, name) for name in names):
            yield f"calls {' '.join(words)}, which finds no test"


def check_page(build, page):
    ticked = page.ticked()
    calls = [text for text in ticked if re.match(r"(\w+=\S+ )*(hgrid(_\w+)? |build/|ctest |\./check |python3 )", text)]
    for words in (words for line in page.shell() + calls for words in commands_in(line)):
        yield from check_command(build, words)
        if words[0] in ("ctest", "./check"):
            yield from check_test_call(build, words)
    for text in ticked:
        is_test = re.fullmatch(r"[a-z_]+\.[a-z0-9_]{2,}", text) and text.split(".")[0] in build.labels
        if is_test and text not in build.tests:
            yield f"names the test {text}, which ctest does not know"


def check_written(build, names, command):
    """Runs a command with its output in another place."""
    with tempfile.TemporaryDirectory() as folder:
        for name in names:
            pathlib.Path(folder, name).parent.mkdir(parents=True, exist_ok=True)
        call = re.sub(r"((?:--output|--svg|>) )(docs/)", rf"\1{folder}/\2", command)
        call = call.replace("build/bin/", f"{build.folder}/bin/")
        run = subprocess.run(["bash", "-c", call], cwd=build.root, capture_output=True, text=True, check=False)
        found = {path.relative_to(folder).as_posix() for path in pages.files(pathlib.Path(folder), "*")}
        if run.returncode != 0:
            yield f"{command} fails: {run.stderr}"
        elif found != set(names):
            yield f"{command} writes {', '.join(sorted(found))}"
        for name in sorted(found & set(names)):
            if pathlib.Path(folder, name).read_bytes() != (build.root / name).read_bytes():
                yield f"{name} is not what {command} writes"


def main():
    root, folder = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    build = Build(root, folder, sys.argv[3] if len(sys.argv) > 3 else "ctest")
    found = [f"{page.name}: {fault}" for page in pages.read_pages(root) for fault in check_page(build, page)]
    for names, command, again in pages.written(pages.Page(root, root / "docs/README.md")):
        if again:
            found += [f"docs/README.md: {fault}" for fault in check_written(build, names, command)]
    for fault in dict.fromkeys(found):
        print("FAULT", fault)
    print(f"{len(found)} faults")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
