# SPDX-License-Identifier: BSD-3-Clause
"""Texts with tokens deleted, doubled, swapped, or replaced by others and by hostile ones."""

import re

TOKEN = re.compile(
    r'(?P<blank>[ \t\r\n]+|#[^\n]*)|(?P<quantity>"[-+]?\d[^"\n]*")'
    r'|(?P<string>"""[\s\S]*?"""|"(?:\\.|[^"\\\n])*"|\'[^\'\n]*\')'
    r"|(?P<number>[-+]?\d[\w.+-]*)|(?P<word>[A-Za-z_][\w-]*)|(?P<sign>.)"
)

# What a number or a string may be replaced by.
HOSTILE = ["nan", "inf", "-inf", "1e300", "-1e300", "1e-300", "1e999", "-1", "0", "-0.0", "1", "2", "0.5", "1e6", "1e-6", "2147483648", "9223372036854775807",
           "9223372036854775808", "0x7fffffff", "true", "false", "[]", "[[]]", "{}", "[nan, nan]", "[1e300, 1e300]", "[0, 0, 0]", "[-1, 1]", "1979-05-27", '""', '" "',
           '"nan"', '"inf m"', '"1e300 m"', '"1e-300 m"', '"-1 m"', '"0 m"', '"1 m"', '"1 mm"', '"1 km"', '"1 s"', '"1 kg"', '"1 Pa"', '"1 kN"', '"1 m/s"', '"1 deg"',
           '"400 deg"', '"7 furlongs"', '"1 gravity"', '"%n%s"', '"\\u001b[2J"', '"\\n"', '"../../x"', '"/dev/zero"', '"$(touch x)"', '"=1+1"', '"\u221e"',
           '"' + "x" * 100000 + '"', "9" * 400, '"' + "9" * 400 + ' m"', "[" * 500, "]", "=", ".", ",", "\x00", "\ufeff"]


KINDS = ("quantity", "string", "number", "word")
FACTORS = ("{}0", "{}000", "-{}", "0.00{}", "{}.5", "{}e9", "{}e-9", "1{}", "2{}", "0.{}")


class Pool:
    """Tokens of all inputs, by their kind."""

    def __init__(self, texts):
        self.of_kind = {kind: sorted({token for text in texts for token, its in tokens(text) if its == kind}) for kind in KINDS}


def tokens(text):
    return [(match[0], match.lastgroup) for match in TOKEN.finditer(text)]


def another(token, kind, pool, chance):
    if kind in ("number", "quantity") and chance.random() < 0.5:  # by a factor
        return re.sub(r"[-+]?[\d.]+", lambda number: chance.choice(FACTORS).format(number[0]), token, count=1)
    if kind == "quantity" and chance.random() < 0.3:
        return re.sub(r"[-+]?\d[\w.+-]*", lambda _: chance.choice(("0", "-1", "1e9", "1e-9", "nan", "3", "1e300")), token, count=1)
    if kind in KINDS and chance.random() < 0.6:
        return chance.choice(pool.of_kind[kind])
    return chance.choice(HOSTILE)


def changed_lines(text, chance):
    lines = text.splitlines(keepends=True)
    at = chance.randrange(len(lines))
    line = lines.pop(at)
    lines[at:at] = [line, line] if chance.random() < 0.3 else []
    if chance.random() < 0.5:
        lines.insert(chance.randrange(len(lines) + 1), line)
    return "".join(lines)


def mutant(text, pool, chance):
    """The text with one to three changes."""
    for _ in range(chance.choice((1, 1, 1, 1, 2, 3))):
        if chance.random() < 0.07 and text:
            text = changed_lines(text, chance)
            continue
        parts = tokens(text)
        places = [k for k, (_, kind) in enumerate(parts) if kind != "blank"]
        if not places:
            return chance.choice(HOSTILE)
        words = [token for token, _ in parts]
        # values more often than signs and keys, of which there are many
        kinds = chance.choice((("number", "quantity"), ("number", "quantity"), ("number", "quantity", "string", "word"), None))
        at = chance.choice([k for k in places if kinds is None or parts[k][1] in kinds] or places)
        way = chance.random()
        if way < 0.05:
            words[at] = ""
        elif way < 0.1:
            words[at] += " " + words[at]
        elif way < 0.2:
            other = chance.choice(places)
            words[at], words[other] = words[other], words[at]
        else:
            words[at] = another(*parts[at], pool, chance)
        text = "".join(words)
    return text
