# SPDX-License-Identifier: BSD-3-Clause
"""llms.txt of the site, in the form of llmstxt.org: what berm is, then each page with its first sentence, for programs that read pages for somebody."""

import re
from pathlib import Path

SECTIONS = {"": "Start", "docs": "Reference", "docs/theory": "Reference", "docs/how_to": "How to", "docs/for_users_of": "For users of", "examples": "Examples", "docs/decisions": "Decisions", "docs/decisions/annex": "Decisions"}


def plain(markdown: str) -> str:
    """Words without the marks of links, pictures and emphasis, on one line."""
    text = re.sub(r"!\[[^\]]*\]\([^)]*\)", "", markdown)
    text = re.sub(r"\[((?:[^\[\]]|\[[^\]]*\])*)\]\([^)]*\)", r"\1", text)
    return " ".join(text.replace("**", "").replace("`", "").split())


def title_and_sentence(page: str) -> tuple[str, str]:
    """The title of a page, and the first sentence of its first paragraph, list or table."""
    page = re.sub(r"<!--.*?-->|^```.*?^```", "", page, flags=re.S | re.M)
    title = re.search(r"^# (.+)$", page, re.M)
    if not title:
        return "", ""
    for block in re.split(r"\n\s*\n", page[title.end() :]):
        words = plain(re.sub(r"^(?:(?:[-*>]|\d+\.)\s+|\|\s*)", "", block.strip()))
        if words and not words.startswith("#") and not words.startswith("Date: "):
            return plain(title.group(1)), re.split(r"(?<=[.:?])\s", words)[0]
    return plain(title.group(1)), ""


def section_of(name: str) -> str:
    folder = name.rpartition("/")[0]
    return SECTIONS["examples" if folder.startswith("examples") else folder]


def text(folder: Path, names: list[str]) -> str:
    """Of the pages with these names in a folder; index.md says what berm is."""
    lines: dict[str, list[str]] = {heading: [] for heading in SECTIONS.values()}
    for name in sorted(set(names) - {"index.md"}):
        title, sentence = title_and_sentence((folder / name).read_text(encoding="utf-8"))
        lines[section_of(name)].append(f"- [{title or name}]({name.removesuffix('.md')}.html){f': {sentence}' if sentence else ''}")
    index = (folder / "index.md").read_text(encoding="utf-8")
    what = re.search(r"^One input file.*?(?=\n\n)", index, re.S | re.M)
    _, summary = title_and_sentence(index)
    parts = [f"# berm\n\n> {summary}"] + ([plain(what.group(0))] if what else [])
    return "\n\n".join(parts + [f"## {heading}\n\n" + "\n".join(of) for heading, of in lines.items() if of]) + "\n"
