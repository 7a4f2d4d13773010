# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Colours of code: FORTRAN 77 under the name that the repository host gives it, and indented code by its page."""

from docutils import nodes
from pygments.lexers import FortranFixedLexer

# The language of code that is indented, on pages where that is one language.
INDENTED = {"guide/api": "c", "guide/cpp": "cpp"}


def colour(app, document):
    language = INDENTED.get(app.env.docname)
    for block in document.findall(nodes.literal_block) if language else ():
        if block.get("language") in (None, "none"):
            block["language"] = language


def setup(app):
    app.add_lexer("fortran77", FortranFixedLexer)
    app.connect("doctree-read", colour)
    return {"parallel_read_safe": True}
