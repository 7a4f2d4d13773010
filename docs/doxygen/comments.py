#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""The comments of a header as Doxygen wants them: comments.py FILE, an INPUT_FILTER.

Headers are written for people who read them as they are. Here a comment before a declaration becomes its description,
one behind a member that of the member, the first one of a file that of the file; of several declarations that follow
each other without a blank line all get the comment before the first. `Errors:`, `Complexity:` and their kind begin
paragraphs of their own, `words` are code, names of functions and structs are links.
"""

import pathlib
import re
import sys

PARTS = "Errors and complexity|Errors besides|Errors|Complexity|Thread safety|Threads|Ownership|Memory"
PART = re.compile(rf"(?:^|(?<=[.;)] ))({PARTS}): ")
WORD = re.compile(r"`[^`]+`|\bhg_[a-z0-9_]*[a-z0-9]\b(?!\()(?!\.\.)|\b(?:HG|MPI)_[A-Z0-9_]*[A-Z0-9]\b(?!\.\.)|\bNULL\b")
SPECIAL = re.compile(r'[\\@&$#<>%"]')
DECLARED = re.compile(
    r"^HG_API [\w *]*?\*?(hg_\w+)\(|^static inline \w+ (hg_\w+)\(|^typedef struct (hg_\w+) \{|^typedef \w+ (hg_\w+)[;(]",
    re.MULTILINE,
)
ROOT = pathlib.Path(__file__).resolve().parents[2]


def known_names():
    headers = [*(ROOT / "include/hgrid").glob("*.h"), *(ROOT / "mpi/include/hgrid").glob("*.h")]
    found = (DECLARED.findall(header.read_text(encoding="utf-8")) for header in headers)
    return {name for matches in found for match in matches for name in match if name}


NAMES = known_names()


def escape(text):
    return SPECIAL.sub(lambda match: "\\" + match[0], text)


def mark(match):
    word = match[0]
    if word in NAMES:
        return f'\\ref {word} "{word}"'
    return f"<code>{escape(word.strip('`'))}</code>"


def sentence(text):
    """With a capital, unless a name of C stands first."""
    return text if re.match(r"\w*_", text) else text[:1].upper() + text[1:]


def inline(text):
    """One paragraph: what is not a word to mark is escaped."""
    out, end = [], 0
    for match in WORD.finditer(text):
        out += [escape(text[end : match.start()]), mark(match)]
        end = match.end()
    return "".join(out) + escape(text[end:])


def paragraphs(lines):
    """The text of a comment, from its lines without their marks."""
    out, block = [], []

    def close():
        if block and all(line.startswith("  ") for line in block):
            out.append("\\verbatim\n" + "\n".join(block) + "\n\\endverbatim")
        elif block:
            text = " ".join(line.strip() for line in block)
            pieces = PART.split(text)
            if pieces[0].strip():
                out.append(inline(pieces[0].strip()))
            out.extend(f"\\par {part}\n{inline(sentence(rest.strip()))}" for part, rest in zip(pieces[1::2], pieces[2::2]))
        block.clear()

    for line in lines:
        if line.strip():
            block.append(line)
        else:
            close()
    close()
    return "\n\n".join(out)


def comment(lines, opening, indent=""):
    """`opening` is what Doxygen takes as the begin of a description; // comments would split verbatim lines."""
    text = paragraphs(lines).replace("*/", "* /")
    return f"{indent}{opening} {text} */"


def lines_of_block(text):
    """The lines of a /* comment */ without its marks."""
    lines = text.strip().removeprefix("/*").removesuffix("*/").split("\n")
    return [lines[0].strip()] + [re.sub(r"^\s*\* ?", "", line) for line in lines[1:]]


TRAILING = re.compile(r"(?P<code>\S[^\n]*?)[ ]+/\*(?P<text>(?:[^*]|\*(?!/))*)\*/[ ]*(?=\n)")
STANDING = re.compile(r"(?:^|(?<=\n))(?P<indent>[ ]*)/\*(?P<text>(?:[^*]|\*(?!/))*)\*/[ ]*(?=\n)")


def trailing(match):
    if match["code"].startswith(("#", "/*")):
        return match[0]
    # The lines of a trailing comment are indented beneath its first one, not marked.
    return match["code"] + " " + comment([line.strip() for line in match["text"].split("\n")], "/**<")


def c_header(text):
    text = STANDING.sub(lambda match: "\0" + match["indent"] + "\1" + match["text"] + "\2", text)
    text = TRAILING.sub(trailing, text)
    first = iter(("licence", "file"))

    def standing(match):
        kind = next(first, "")
        if kind == "licence":
            return "\n"
        lines = lines_of_block(match[2])
        if kind == "file":
            return comment(lines, "/** \\file\n")
        return comment(lines, "/**", match[1])

    text = re.sub("\0( *)\1([^\2]*)\2", standing, text)
    # The comment before the first of several declarations is that of all.
    together = re.compile(r"(/\*\* (?:[^*]|\*(?!/))*\*/)\n((?:HG_API(?:[^;]|\n)*;\n)+)")
    return together.sub(lambda match: "".join(f"{match[1]}\nHG_API{each}" for each in match[2].split("HG_API")[1:]), text)


def cpp_header(text):
    """What is private, and what closes a namespace, is left out."""
    text = re.sub(r"\n\n? private:\n(?:.*\n)*?(?=};)", "\n", text)
    out, block, first, class_of = [], [], True, ""
    lines = [re.sub(r"^} +//.*", "}", line) for line in text.split("\n")]
    for k, line in enumerate(lines):
        code, slashes, rest = line.partition("//")
        if slashes and not code.strip():
            block.append(rest.removeprefix(" "))
            continue
        indent = re.match(" *", line)[0]
        if block and first:
            first = False
            out.append(comment(block[2:], "/** \\file\n"))
        elif block:
            out.append(comment(block, "/**", indent))
        elif re.match(r"  [A-Za-z].*\) (const )?\{", line) and class_of:
            # A member without a comment: that of the C call which it makes.
            body = "\n".join(lines[k : next((n for n in range(k, len(lines)) if lines[n] in ("  }",)), k) + 1])
            body = line if line.endswith("}") else body
            calls = [name for name in re.findall(r"\bhg_\w+", body) if name + "(" in body or name + "," in body]
            calls = [name for name in calls if name in NAMES and not name.endswith(("visitor", "status", "key"))]
            if calls and re.search(r"get\(\)|_by\b", body):
                out.append(f'{indent}/** \\ref {calls[0]} "{calls[0]}" of this object. */')
        block = []
        class_of = re.match(r"class (\w+)", line)[1] if re.match(r"class (\w+)", line) else class_of
        out.append(code.rstrip() + " " + comment([rest], "/**<") if slashes else line)
    return "\n".join(out)


def main():
    path = pathlib.Path(sys.argv[1])
    text = path.read_text(encoding="utf-8")
    sys.stdout.write(cpp_header(text) if path.suffix == ".hpp" else c_header(text))


if __name__ == "__main__":
    main()
