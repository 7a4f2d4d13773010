# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the files of the theme, as Debian 12 ships it, work on pages that no server hands out.

Its script imports another one, which a browser refuses of a file, and its style another one from a folder of Debian's
web server. Both are joined here. And its style knows the dark colours for those who choose them, but not for those whose
system asks for them; the colours are taken from its rule for the former.
"""

import pathlib
import re

NORMALIZE = pathlib.Path("/usr/share/javascript/normalize.css/normalize.css")
IMPORTED = "@import url(/javascript/normalize.css/normalize.css);"


def join(app, exception):
    if exception or app.builder.format != "html":
        return
    static = pathlib.Path(app.outdir, "_static")
    script, style = static / "scripts/furo.js", static / "styles/furo.css"
    first, _, rest = script.read_text(encoding="utf-8").partition("\n")
    if first.startswith("import Gumshoe"):
        script.write_text((static / "scripts/gumshoe-patched.js").read_text(encoding="utf-8") + rest, encoding="utf-8")
    text = style.read_text(encoding="utf-8")
    text = text.replace(IMPORTED, NORMALIZE.read_text(encoding="utf-8"))
    if "prefers-color-scheme" not in text:
        dark = re.search(r'body\[data-theme="dark"\] \{([^}]*)\}', text)[1]
        text += f'\n@media (prefers-color-scheme: dark) {{\n  body[data-theme="auto"] {{{dark}}}\n}}\n'
    style.write_text(text, encoding="utf-8")


def setup(app):
    app.connect("build-finished", join)
    return {"parallel_read_safe": True}
