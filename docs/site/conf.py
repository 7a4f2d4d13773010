# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Settings of Sphinx for the site. docs is the source, as it is; docs/site/build.sh calls Sphinx with these."""

import os
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE / "parts"), str(ROOT / "tests/structure"), str(ROOT / "bindings/swig")]

project = "libhgrid"
author = "The libhgrid developers"
copyright = author
version = release = re.search(r"project\(hgrid VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]

extensions = [
    "myst_parser",
    "breathe",
    "sphinx.ext.autodoc",
    "sphinx_copybutton",
    "sphinx_inline_tabs",
    "code_blocks",
    "pages_of_the_tree",
    "python_types",
    "whole_theme",
]
root_doc = "index"
exclude_patterns = ["site", "man", "doxygen"]
nitpicky = False

# Headings are linked to as the repository host names them.
myst_heading_anchors = 4
myst_enable_extensions = ["colon_fence"]

breathe_projects = {"hgrid": os.environ["HGRID_XML"] + "/xml"}
breathe_default_project = "hgrid"
breathe_domain_by_extension = {"h": "c", "hpp": "cpp"}
breathe_default_members = ("members",)

# What SWIG and a compiler make is not there; nothing of it is documented.
autodoc_mock_imports = ["hgrid.capi", "hgrid.mpi_capi", "mpi4py"]
autodoc_member_order = "bysource"
autodoc_default_options = {"members": True}

html_theme = "furo"
html_title = f"libhgrid {release}"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sphinx = False
html_last_updated_fmt = None
html_theme_options = {"navigation_with_keys": True}
templates_path = []
copybutton_prompt_text = r"\$ "
copybutton_prompt_is_regexp = True
