# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Text for man pages: nothing in it is read as a request."""

import textwrap

# Neither spread lines nor hyphens within names.
LAYOUT = (".ad l", ".nh")


def escape(text):
    return text.replace("\\", "\\e").replace("'", "\\(aq").replace("`", "\\(ga").replace("^", "\\(ha").replace("~", "\\(ti")


def bold(text):
    return f"\\fB{escape(text).replace('-', chr(92) + '-')}\\fP"


def filled(text):
    """Lines of a paragraph, none of which begins as a request does."""
    lines = textwrap.wrap(text, 78, break_long_words=False, break_on_hyphens=False)
    return [("\\&" if line[0] == "." else "") + line for line in lines]
