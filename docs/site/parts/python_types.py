# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""What autodoc cannot know of the Python package: types stand in .pyi files, and arguments are told line by line."""

import ast
import pathlib
import re

from sphinx.ext.autodoc.mock import mock

SWIG = pathlib.Path(__file__).resolve().parents[3] / "bindings/swig"


def read_stubs():
    """The signatures of each function by its full name; of overloaded ones all."""
    found = {}

    def visit(nodes, prefix):
        for node in nodes:
            if isinstance(node, ast.ClassDef):
                visit(node.body, f"{prefix}.{node.name}")
            elif isinstance(node, ast.FunctionDef):
                arguments = ast.unparse(node.args).replace("npt.", "").replace("np.", "")
                arguments = re.sub(r"^self(, )?", "", arguments)
                result = ast.unparse(node.returns).replace("npt.", "").replace("np.", "") if node.returns else None
                found.setdefault(f"{prefix}.{node.name}", []).append((f"({arguments})", result))

    for path in sorted([*SWIG.glob("hgrid/*.pyi"), *SWIG.glob("mpi/*.pyi")]):
        module = "hgrid" if path.stem == "__init__" else f"hgrid.{path.stem}"
        visit(ast.parse(path.read_text(encoding="utf-8")).body, module)
    return found


SIGNATURES = read_stubs()


def add_types(app, what, name, item, options, signature, result):
    full = f"{item.__module__}.{item.__qualname__}" if hasattr(item, "__qualname__") else name
    stubs = SIGNATURES.get(full + ".__init__" if what == "class" else full)
    if not stubs:
        return None
    # Of overloaded functions the widest is that of the source.
    if len(stubs) > 1:
        return signature, None
    arguments, returns = stubs[0]
    return arguments, None if what == "class" else returns


def add_fields(app, what, name, item, options, lines):
    """Lines `word: text` of a docstring become a list of fields; lines indented beneath belong to them."""
    out = []
    for line in lines:
        field = re.match(r"(\w+(?:, \w+)*): (.*)", line)
        if field and what in ("class", "method", "function") and field[1] not in ("Errors", "Returns", "Raises"):
            if out and out[-1] and not out[-1].startswith(":"):
                out.append("")
            out.append(f":{field[1]}: {field[2]}")
        elif line.startswith("    ") and any(each.startswith(":") for each in out[-6:]):
            out.append("    " + line.strip())
        else:
            if out and line and out[-1].startswith((":", "    ")):
                out.append("")
            out.append(re.sub(r"(?<![`\\])\*(?!\*)", r"\\*", re.sub(r"(?<=\w)_(?!\w)", r"\\_", line)))
    lines[:] = [re.sub(r"(?<!`)`([^`]+)`(?!`)", r"``\1``", re.sub(r"\|([^|]+)\|", r"\\|\1\\|", line)) for line in out]


def import_mpi(app):
    """hgrid.mpi lies in a folder of its own until it is installed, and asks which MPI its makers had."""
    with mock(app.config.autodoc_mock_imports):
        import hgrid
        import mpi4py

        hgrid.__path__.append(str(SWIG / "mpi"))
        from hgrid import mpi_capi

        mpi_capi.HG_MPI_FAMILY = "any"
        mpi4py.MPI = mpi4py.MPI
        mpi4py.MPI.get_vendor = lambda: ("any", ())
        import hgrid.mpi  # noqa: F401


def setup(app):
    app.connect("builder-inited", import_mpi)
    app.connect("autodoc-process-signature", add_types)
    app.connect("autodoc-process-docstring", add_fields)
    return {"parallel_read_safe": True}
