#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Follows every link within a built site, pictures and scripts included: links.py FOLDER.

Prints each that leads nowhere, also to a place of a page that is not there; exits with 1 if there is one.
"""

import html.parser
import pathlib
import re
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.places, self.targets = {"", "top"}, []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name == "id" or (name == "name" and tag == "a"):
                self.places.add(value)
            elif name in ("href", "src", "data") and value:
                self.targets.append(value)


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    found = {path: Page(path) for path in root.rglob("*.html")}
    faults, count = [], 0
    for path, page in found.items():
        for target in page.targets:
            # To the outside, or a picture that stands in the page.
            if re.match(r"[a-z]+:|//", target):
                continue
            count += 1
            name, _, anchor = target.partition("#")
            file = (path.parent / urllib.parse.unquote(name.partition("?")[0])).resolve() if name else path
            file = file / "index.html" if file.is_dir() else file
            if not file.is_file():
                faults.append(f"{path.relative_to(root)}: {target} is not there")
            elif file in found and urllib.parse.unquote(anchor) not in found[file].places:
                faults.append(f"{path.relative_to(root)}: {target}: there is no such place on that page")
    for fault in sorted(set(faults)):
        print("FAULT", fault)
    print(f"{len(found)} pages, {count} links, {len(set(faults))} lead nowhere")
    return 1 if faults or count < 1000 else 0


if __name__ == "__main__":
    sys.exit(main())
