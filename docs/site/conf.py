# SPDX-License-Identifier: BSD-3-Clause
"""Sphinx over the Markdown of the repository, which docs/site/make lays out beside this file as it lies there. Nothing is fetched from a network."""

import os
import re
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
SOURCE = Path(os.environ["BERM_SOURCE"])
sys.path.insert(0, os.environ["BERM_PYTHON"])

project = "berm"
author = copyright = "berm developers"
release = version = re.search(r"^project\(berm VERSION ([\d.]+)", (SOURCE / "CMakeLists.txt").read_text(), re.M).group(1)
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.mathjax", "sphinx_copybutton"]
myst_enable_extensions = ["dollarmath", "deflist"]
myst_heading_anchors = 4
myst_update_mathjax = False
html_theme = "furo"
html_title = f"berm {version}"
html_static_path = ["static"]
html_css_files = ["berm.css"]
html_copy_source = False
html_show_sphinx = False
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_CHTML"
mathjax2_config = {"tex2jax": {"inlineMath": [["\\(", "\\)"]], "displayMath": [["\\[", "\\]"]], "processClass": "math"}, "messageStyle": "none", "showMathMenu": False}
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
suppress_warnings = ["myst.header"]  # pages begin with what they need
exclude_patterns = ["build"]

LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\[\]]*\])*)\]\(([^()\s]+)\)")


def repaired(text: str, folder: Path) -> str:
    """A page without its licence line; a link to a folder goes to the page in it, one to what is no part of the site becomes its text."""

    def link(match: re.Match[str]) -> str:
        picture, words, target = match.groups()
        place, hash, anchor = target.partition("#")
        if not place or re.match(r"[a-z]+:", place):
            return match.group(0)
        path = (folder / place).resolve()
        if path.is_dir():
            path = path / "README.md"
        if not path.is_file() or HERE not in path.parents:
            return f"`{words}`" if re.fullmatch(r"[\w./-]+", words) else words
        return f"{picture}[{words}]({os.path.relpath(path, folder)}{hash}{anchor})"

    text = re.sub(r"^<!-- SPDX[^\n]*-->\n", "", text)
    pieces = re.split(r"(^```.*?^```)", text, flags=re.S | re.M)  # code stays as it is
    return "".join(piece if k % 2 else LINK.sub(link, piece) for k, piece in enumerate(pieces))


def setup(app):  # type: ignore[no-untyped-def]
    def read(app, name, source):  # type: ignore[no-untyped-def]
        path = Path(app.env.doc2path(name))
        if path.suffix == ".md":
            source[0] = repaired(source[0], path.parent)

    app.connect("source-read", read)
