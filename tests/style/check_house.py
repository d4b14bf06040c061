#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks of the house: what STYLE says and no compiler sees.

check_house.py NAME [ROOT]      runs one check on the tree at ROOT (default: the repository); exit 1 and a list where it fails, 77 where it is skipped
check_house.py NAME --broken    shows the check a sample that is wrong and one that is right; exit 1 unless it tells them apart
check_house.py --list           names of all checks
"""

import fnmatch
import io
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import tokenize

sys.dont_write_bytecode = True

from house_samples import LICENCE, SAMPLES

REPOSITORY = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SKIPPED = 77
CPP = (".cpp", ".hpp")
CODE = CPP + (".py", ".pyi", "pyproject.toml", ".sh", ".cmake", ".ts", ".js", ".geo")
MOST_LINES, MANY_LINES = 600, 400
MOST_LETTERS = 140  # in a line of the Python package and its tests
# clang-format lays code out a little differently in every version; the house uses the one of Debian 12.
CLANG_FORMAT = "14."
# Folders of src/ that hold rooms and are none; BERM_DISTRICTS of cmake/Rooms.cmake.
DISTRICTS = "base/|engine/|methods/|pipeline/|case/|run/|answers/|pages/|studies/|exports/"


class Skip(Exception):
    pass


class Tree:
    """The files of a repository, without what .gitignore names."""

    def __init__(self, root):
        self.root = root
        self.paths = []
        ignored = [line.strip() for line in self.read(".gitignore").splitlines() if line.strip() and not line.startswith("#")]
        for folder, folders, names in os.walk(root):
            here = os.path.relpath(folder, root)
            keep = lambda name: name != ".git" and not any(self._matches(pattern, here, name) for pattern in ignored)
            folders[:] = sorted(filter(keep, folders))
            self.paths += [os.path.normpath(os.path.join(here, name)) for name in sorted(filter(keep, names))]

    @staticmethod
    def _matches(pattern, folder, name):
        if pattern.startswith("/"):
            return fnmatch.fnmatch(os.path.normpath(os.path.join(folder, name)), pattern.strip("/"))
        return fnmatch.fnmatch(name, pattern.strip("/"))

    def read(self, path):
        try:
            with open(os.path.join(self.root, path), encoding="utf-8") as file:
                return file.read()
        except (OSError, UnicodeDecodeError):
            return ""

    def ending(self, endings, under=""):
        return [path for path in self.paths if path.endswith(endings) and path.startswith(under)]

    def code(self):
        """Sources, CMake files and scripts, these last by their first line."""
        special = ("CMakeLists.txt", "Makefile", ".clang-format", ".clang-tidy")
        return [
            path
            for path in self.paths
            if path.endswith(CODE) or os.path.basename(path) in special or (not os.path.splitext(path)[1] and self.read(path).startswith("#!"))
        ]


def lines_matching(tree, paths, pattern, message):
    for path in paths:
        for number, line in enumerate(tree.read(path).splitlines(), 1):
            found = re.search(pattern, line)
            if found:
                yield f"{path}:{number}: {message}: {found.group(0).strip()}"


def without_words(text):
    """C++ without comments, strings and characters; lines stay where they are."""
    blank = lambda match: re.sub(r"[^\n]", " ", match.group(0))
    return re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])+\'', blank, text, flags=re.S)


def code_matching(tree, paths, pattern, message):
    for path in paths:
        for number, line in enumerate(without_words(tree.read(path)).splitlines(), 1):
            found = re.search(pattern, line)
            if found:
                yield f"{path}:{number}: {message}: {found.group(0).strip()}"


def licence(tree):
    """Every source, script and CMake file names its licence in its first two lines."""
    for path in tree.code():
        if not any(LICENCE in line for line in tree.read(path).splitlines()[:2]):
            yield f"{path}: no '{LICENCE}' in the first two lines"


def notebook(text):
    """What a notebook says of its licence, and its cells; nothing of what is no notebook."""
    try:
        content = json.loads(text)
        return content["metadata"].get("license", ""), content["cells"]
    except (ValueError, KeyError, TypeError, AttributeError):
        return "", []


def notebooks(tree):
    """A notebook names its licence in its metadata (license), has code, and is kept without outputs."""
    for path in tree.ending(".ipynb"):
        said, cells = notebook(tree.read(path))
        if LICENCE not in said:
            yield f"{path}: its metadata has no \"license\": \"{LICENCE}\""
        if not any(cell["cell_type"] == "code" for cell in cells):
            yield f"{path}: there is no cell of code"
        if any(cell.get("outputs") or cell.get("execution_count") is not None for cell in cells):
            yield f"{path}: it has outputs; clear them"


def width(tree):
    """No line of the Python package and its tests is longer than 140 letters."""
    for path in tree.ending((".py", ".pyi"), ("python/", "tests/python/")):
        for number, line in enumerate(tree.read(path).splitlines(), 1):
            if len(line) > MOST_LETTERS:
                yield f"{path}:{number}: {len(line)} letters"


def length(tree):
    """No file of code is longer than 600 lines."""
    for path in tree.code():
        count = len(tree.read(path).splitlines())
        if count > MOST_LINES:
            yield f"{path}: {count} lines; split it, {MOST_LINES} is the most"
        elif count > MANY_LINES:
            print(f"note: {path} has {count} lines; beyond {MANY_LINES} a file should be able to say why")


def names(tree):
    """A name says what lives there."""
    for path in tree.paths:
        found = re.search(r"util|helper|misc|common", path, re.I)
        if found:
            yield f"{path}: '{found.group(0)}' says nothing of what lives there"


def rooms_of(cmake):
    """The rooms that CMakeLists.txt declares with berm_room, each with the rooms it uses, in their order; without their districts."""
    rooms = {}
    for name, rest in re.findall(rf"^\s*berm_room\((?:{DISTRICTS})?([\w/]+)\s*([^)]*)\)", cmake, re.M):
        used = re.search(r"USES\s+(.*?)(?:\bLINKS\b|\bENGINE\b|$)", rest, re.S)
        rooms[name] = used.group(1).split() if used else []
    return rooms


def room_of(path):
    """The room of a file of src/, or of the tests that mirror it: its folder in a district or a district itself; "" for main.cpp."""
    return os.path.dirname(re.sub(rf"^(?:src|tests/unit)/(?:{DISTRICTS})?", "", path))


def tiers(tree):
    """A room of src/ includes itself and what it USES in CMakeLists.txt, which are rooms above it in that list."""
    rooms = rooms_of(tree.read("CMakeLists.txt"))
    reach = {}
    for name, used in rooms.items():
        for other in used:
            if other not in reach:
                yield f"CMakeLists.txt: {name} uses {other}, which is not a room declared before it"
        reach[name] = {name}.union(*(reach.get(other, set()) for other in used))
    for path in tree.ending(CPP, "src/"):
        room = room_of(path)
        if not room:
            continue
        if room not in reach:
            yield f"{path}: CMakeLists.txt does not declare the room {room}"
            continue
        for number, line in enumerate(tree.read(path).splitlines(), 1):
            found = re.match(r'\s*#\s*include\s*"([^"]+)"', line)
            if found and os.path.dirname(found.group(1)) not in reach[room]:
                yield f'{path}:{number}: {room} may not include "{found.group(1)}"; it uses {", ".join(sorted(reach[room]))}'


# From the lowest up. Rooms of a district use those of districts before it, and of their own.
FLOORS = ("base", "engine", "settings", "methods", "formulas", "pipeline", "case", "run", "answers", "pages", "studies", "exports", "desk", "library", "commands")


# How many rooms there may be, and how many the run loop may reach (decision 0106).
MOST_ROOMS, MOST_OF_RUN = 70, 22


def floors(tree):
    """A district uses those below it only; rooms are few, and the run loop reaches few of them."""
    cmake = tree.read("CMakeLists.txt")
    district = {re.sub(rf"^(?:{DISTRICTS})", "", path): path.split("/")[0] for path in re.findall(r"^\s*berm_room\(([\w/]+)", cmake, re.M)}
    for room, used in rooms_of(cmake).items():
        if district[room] not in FLOORS:
            yield f"CMakeLists.txt: {district[room]} is none of the districts {', '.join(FLOORS)}"
            continue
        for other in used:
            pair = (district[room], district.get(other, district[room]))
            if FLOORS.index(pair[1]) > FLOORS.index(pair[0]):
                yield f"CMakeLists.txt: {room} of {pair[0]} uses {other} of {pair[1]}, which is above it"
    rooms, reached = rooms_of(cmake), set()
    new = set(rooms.get("simulation", ()))
    while new:
        reached |= new
        new = {other for room in new for other in rooms.get(room, ())} - reached
    if len(rooms) > MOST_ROOMS or len(reached) > MOST_OF_RUN:
        yield f"CMakeLists.txt: {len(rooms)} rooms, of which simulation reaches {len(reached)}; at most {MOST_ROOMS} and {MOST_OF_RUN}"


def namespace_of(room):
    """os and core are berm itself, and so is the library, of which users see that; inner rooms of the report share one namespace, a structure has its own."""
    if room in ("os", "core", "library"):
        return "berm"
    return "berm::" + (room.split("/")[1] if room.startswith("structures/") else room.split("/")[0])


def namespaces(tree):
    """What a room declares stands in the room's namespace, and what a test file does in one of its own."""
    for path in tree.ending(CPP, "src/"):
        room = room_of(path)
        opened = set(re.findall(r"^namespace (berm[\w:]*) \{", without_words(tree.read(path)), re.M))
        if room and opened - {namespace_of(room)}:
            yield f"{path}: namespace {', '.join(sorted(opened))}; it is {namespace_of(room)} in {room}"
    for path in tree.ending(".cpp", "tests/unit/") + tree.ending(".cpp", "tests/physics/"):
        if not re.search(r"^namespace berm[\w:]*::this_file \{", tree.read(path), re.M):
            yield f"{path}: the namespace of a test file ends with ::this_file"


def types_in(text):
    """The types that a file defines in a named namespace, as (namespace, type)."""
    spaces = []
    for line in text.splitlines():
        opened = re.match(r"namespace ([\w:]*) ?\{", line)
        if opened:
            spaces.append(opened.group(1))
        elif re.match(r"\}(  // namespace.*)?$", line) and spaces:
            spaces.pop()
        found = re.match(r"(?:struct|class|union|enum class|enum)\s+(?:alignas\([^)]*\)\s*)?(\w+)\b", line)
        if found and spaces and all(spaces) and ("{" in line or not line.endswith(";")):
            yield "::".join(spaces), found.group(1)


def type_names(tree):
    """A type name stands once in a namespace, in all of the program, and once in what its tests share."""
    seen = {}
    for path in tree.ending(CPP, "src/") + tree.ending(".hpp", "tests/"):
        for space, name in types_in(tree.read(path)):
            first = seen.setdefault((space, name, path.startswith("src/")), path)
            if first != path:
                yield f"{path}: {space}::{name} is a type of {first}, too"


def test_files(tree):
    """Each source of src/ has a test file of its name, or says in its second line which test it has."""
    tests = {os.path.splitext(path)[0] for path in tree.ending(".cpp", "tests/unit/")}
    for path in tree.ending(".cpp", "src/"):
        room, stem = room_of(path), os.path.splitext(os.path.basename(path))[0]
        if not room or any(re.fullmatch(rf"tests/unit/{re.escape(room)}/{stem}(?:_\w+)?_test", test) for test in tests):
            continue
        told = re.match(r"// Tests: (\S+)$", (tree.read(path).splitlines() + ["", ""])[1])
        if not told:
            yield f"{path}: there is no tests/unit/{room}/{stem}_test.cpp, and its second line is not '// Tests: FILE'"
        elif not os.path.exists(os.path.join(tree.root, told.group(1))):
            yield f"{path}: its test {told.group(1)} does not exist"
    sources = {room_of(path) + "/" + os.path.splitext(os.path.basename(path))[0] for path in tree.ending((*CPP, ".c"), "src/")}
    for path in tree.ending(".cpp", "tests/unit/"):
        stem = re.sub(r"_test$", "", os.path.splitext(path)[0])[len("tests/unit/") :]
        if not path.endswith("_test.cpp") or not any(stem == source or stem.startswith(source + "_") for source in sources):
            yield f"{path}: a test file is named after a source, SOURCE_test.cpp or SOURCE_WHAT_test.cpp"


def places(tree):
    """Nothing tracked names a folder of one machine or a package registry."""
    folder = r"(?:^|[^A-Za-z0-9_.\-])/(?:home|root|work|Users)/"
    host = "|".join(re.escape(name) for name in ("deb." + "debian.org", "snapshot." + "debian.org", "registry." + "npmjs.org", "pypi." + "org"))
    text = [path for path in tree.paths if not path.endswith(".msh")]
    yield from lines_matching(tree, text, folder, "a path of one machine")
    yield from lines_matching(tree, text, host + r"|\"resolved\": *\"https?:", "a package registry")


def loose_ends(tree):
    """What is left to do is done or written down, not marked in passing."""
    yield from lines_matching(tree, tree.paths, r"\b(?:TO" + r"DO|FIX" + r"ME|X" + r"XX)\b", "a loose end")


def toml(tree):
    """TOML is known to one file."""
    found = [path for path in tree.ending(CPP) if re.search(r"#\s*include\s*[<\"]toml", tree.read(path))]
    if len(found) > 1:
        yield "toml++ is included by " + ", ".join(found) + "; one file is the most"


def layout(tree):
    """C++ is laid out by .clang-format."""
    program = shutil.which("clang-format-14") or shutil.which("clang-format")
    if not program:
        raise Skip("clang-format is not installed")
    version = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout
    if f"version {CLANG_FORMAT}" not in version:
        raise Skip(f"clang-format {CLANG_FORMAT}x is wanted, this is: {version.strip()}")
    paths = tree.ending(CPP)
    if paths:
        told = subprocess.run([program, "--dry-run", "-Werror", "--style=file", *paths], cwd=tree.root, capture_output=True, text=True).stderr
        wrong = sorted(set(re.findall(r"^(\S+?):\d+:\d+: error", told, re.M)))
        yield from (f"{path}: run clang-format -i {path}" for path in wrong)


def examples(tree):
    """Every example has a page, a case and the numbers to expect; a study has a page and study.toml, a program a page and CMakeLists.txt."""
    for example in sorted({path.split("/")[1] for path in tree.paths if path.startswith("examples/") and path.count("/") > 1}):
        folder = f"examples/{example}/"
        files = {path[len(folder) :] for path in tree.paths if path.startswith(folder)}
        study = "study.toml" in files or "CMakeLists.txt" in files or any(name.endswith(".ipynb") for name in files)
        for needed in ("README.md",) if study else ("README.md", "expected.toml"):
            if needed not in files:
                yield f"{folder}: {needed} is missing"
        if not study and not any(name.endswith(".toml") and name != "expected.toml" for name in files):
            yield f"{folder}: there is no case (a .toml file beside expected.toml)"


def silence(tree):
    """Only what runs cases, main.cpp, the progress line, the run log and the sandbox of a geometry write to the terminal."""
    studies = tuple(f"src/studies/{room}/" for room in ("envelope", "jobs", "safety", "study", "uncertainty", "verification"))
    allowed = ("src/commands/", "src/run/simulation/", *studies, "src/main.cpp", "src/base/sandbox/sandbox.cpp", "src/run/run_folder/progress", "src/run/run_folder/run_log", "src/base/io/tell")
    paths = [path for path in tree.ending(CPP, "src/") if not path.startswith(allowed)]
    pattern = r"\bstd::(?:cout|cerr|clog)\b|\b(?:v?printf|puts|putchar)\s*\(|\b(?:fprintf|fputs|print)\s*\([^;]*\bstd(?:out|err)\b|\bio::tell\s*\("
    yield from code_matching(tree, paths, pattern, "writes to the terminal")
    yield from lines_matching(tree, paths, r"\bfmt::print\s*\(\s*\"", "writes to the terminal")


def reading(tree):
    """Files are opened for reading by os/read_file alone, which opens no FIFO and no device."""
    yield from code_matching(tree, tree.ending(CPP, "src/"), r"\bstd::i?fstream\b|\bfopen\s*\(", "opens a file by itself: open_to_read and read_file do it")


def starting(tree):
    """Libraries are loaded and processes made in a few places, so that nothing of a case starts outside of the sandbox (os/case_programs.hpp)."""
    makers = (
        "src/base/os/child_process.cpp",  # all children
        "src/base/os/threads.cpp",  # berm itself, anew
        "src/case/user_law/library.cpp",  # a law, after ask_to_load
        "src/base/sandbox/watcher.cpp",
        "src/run/simulation/run_of_ranks.cpp",  # libberm_mpi
        "src/exports/fmu/slice.c",  # libberm, in a unit
    )
    starters = ("src/base/os/", "src/base/io/", "src/base/sandbox/", "src/desk/process.", "src/studies/jobs/", "src/commands/desk.cpp")
    code = tree.ending(CPP + (".c",), "src/")
    calls = r"\b(?:dlopen|dlmopen|v?fork|f?execve?p?e?|execl[pe]?|execv|posix_spawnp?|popen|system)\s*\("
    yield from code_matching(tree, [path for path in code if path not in makers], calls, "starts a program or loads a library by itself")
    yield from code_matching(tree, [path for path in code if not path.startswith(starters)], r"\bChildProcess\b", "starts a program")


def allocation(tree):
    """The step and the contact take no memory by hand."""
    paths = tree.ending(CPP, ("src/methods/mpm/", "src/engine/contact/"))
    yield from code_matching(tree, paths, r"\bnew\b|\b(?:malloc|calloc|realloc)\s*\(", "takes memory")


# Words of earlier names that no field of engineering uses; names take the field's (docs/notation.md). "wished in place" is the field's.
DIALECT = ("asleep", "dear", "feelers", "foretold", "grip", "hangs", "manieth", "meeting", "sleepy", "spin", "spoiled", "sticky", "stumble", "swallow", "taker", "teller", "wants", "weigh", "welded", "wished")


def python_names(text):
    """Names in Python, with their lines."""
    try:
        for token in tokenize.generate_tokens(io.StringIO(text).readline):
            if token.type == tokenize.NAME:
                yield token.start[0], token.string
    except (tokenize.TokenError, SyntaxError):
        return


def names_in(path, text):
    """Names in C++, Python and the cells of a notebook, with their lines (of a notebook: those of all its code)."""
    if path.endswith(CPP):
        for number, line in enumerate(without_words(text).splitlines(), 1):
            yield from ((number, name) for name in re.findall(r"[A-Za-z_]\w*", line))
    elif path.endswith(".ipynb"):
        yield from python_names("\n".join("".join(cell["source"]) for cell in notebook(text)[1] if cell["cell_type"] == "code"))
    else:
        yield from python_names(text)


def dialect(tree):
    """Names in C++ and Python have none of a short list of words that mean nothing to an engineer (docs/notation.md has the words to use)."""
    for path in tree.ending(CPP + (".py", ".pyi", ".ipynb")):
        for number, name in names_in(path, tree.read(path)):
            plain = name.replace("wished_in_place", "")
            for word in re.split(r"_+|(?<=[a-z0-9])(?=[A-Z])", plain):
                if word.lower() in DIALECT:
                    yield f"{path}:{number}: '{word}' in {name}"
    yield from lines_matching(tree, tree.ending(CPP, "src/"), r"\"[^\"]*\bdo(?:es)? not go with\b", "a message says 'cannot be combined with'")


def anchors_of(page):
    """The anchors of the headings of a page, as GitHub and the site make them."""
    headings = re.findall(r"^#+ +(.+?) *$", re.sub(r"^```.*?^```", "", page, flags=re.S | re.M), re.M)
    plain = (re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower() for heading in headings)
    return {re.sub(r"[^\w\- ]", "", heading).replace(" ", "-") for heading in plain}


def links(tree):
    """Links between the pages of the manual lead somewhere: to a file and, where they name one, to a heading of the page."""
    for path in tree.ending(".md"):
        for target, anchor in re.findall(r"\]\(([^)\s#]*)#?([^)\s]*)[^)]*\)", tree.read(path)):
            if re.match(r"[a-z]+:", target):
                continue
            page = os.path.normpath(os.path.join(os.path.dirname(path), target)) if target else path
            if not os.path.exists(os.path.join(tree.root, page)):
                yield f"{path}: {target} does not exist"
            elif anchor and page.endswith(".md") and anchor not in anchors_of(tree.read(page)):
                yield f"{path}: {target} has no heading #{anchor}"


# Phrases that no geotechnical engineer writes, and what stands for them. Pages of parameters come from the program.
PROSE = {
    r"(?:cells|mesh) (?:without|of no) size": "zero cell size",
    r"knows? (?:its|the) strain rate|softens and knows": "rate-dependent, strain-softening",
    r"(?:row|frame) before[,.:;]": "the previous row",
    r"the begin of": "the start of",
    r"\bwavers?\b": "scatters, fluctuates",
    r"[Hh]oped for": "the target",
    r"no Lode angle": "circular in the deviatoric plane",
    r"the interface is given": "you give the interface",
    r"by repetition": "by Monte Carlo",
    r"(?:do|does) not go with\b": "cannot be combined with",
    r"driven body's way|pipe's way": "travel",
    r"larger by a part of": "larger by a fraction of",
    r"(?:is|are) told (?:as|with|in|for|velocities|beside)": "is given, is reported",
    r"\bswings?\b|\bswinging\b": "oscillates; of results: range",
    r"\bbut for (?:the|that|what|a)\b": "except for",
    r"(?:is|are) no (?:number|residual|result|bound|limit loads?|test)\b": "is not a",
    r"over one another": "in one figure",
    r"(?:minutes?|hours?|[0-9] s) of (?:one|two) (?:processor|core)": "on one processor",
    r"(?:particles|points) a (?:cell|square)\b": "per cell",
    r"half as (?:much|large|long) again": "1.5 times",
}
PAGE_LINES = 60  # of README.md, of an example's and of a decision; measurements stand in results.md or in the annex beside


def prose(tree):
    """The first pages are short, and pages are written in the words of the field (PROSE)."""
    for path in tree.ending(".md"):
        text = tree.read(path)
        if re.fullmatch(r"(?:examples/\w+/)?README\.md", path) and len(text.splitlines()) > PAGE_LINES:
            yield f"{path}: has {len(text.splitlines())} lines, {PAGE_LINES} at most"
        if path.startswith("docs/decisions/") or path in ("CHANGELOG.md", "docs/parameters.md"):
            continue
        for number, line in enumerate(text.splitlines(), 1):
            for phrase, better in PROSE.items():
                if found := re.search(phrase, line):
                    yield f"{path}:{number}: '{found.group()}': {better}"


def said(path, text):
    """What a user reads of a file, by lines: pages and cases whole, of a program its strings."""
    if path.endswith((".md", ".toml", ".ipynb")):
        return text.splitlines()
    plain = [re.sub(r"^\s*(?://|#).*", "", line) for line in text.splitlines()]
    return [" ".join(re.findall(r'"(?:\\.|[^"\\])*"|`[^`]*`|\'(?:\\.|[^\'\\])*\'', line)) for line in plain]


def glossary(tree):
    """Messages, pages and guides use the terms of docs/glossary.md, and no phrase of its third column."""
    rows = re.findall(r"^\| (.+?) \| .+? \| ?(.*?) ?\|$", tree.read("docs/glossary.md"), re.M)
    terms = {phrase: term for term, phrases in rows for phrase in re.findall(r"`(.+?)`", phrases)}
    places = ("src/", "web/src/", "python/", "docs/", "examples/", "README.md")
    for path in tree.ending(CPP + (".in", ".ts", ".py", ".md", ".toml", ".ipynb")):
        if not path.startswith(places) or path.startswith("docs/decisions/") or path == "docs/glossary.md":
            continue
        for number, line in enumerate(said(path, tree.read(path)), 1):
            for phrase, term in terms.items():
                if re.search(rf"\b{re.escape(phrase)}\b", line, re.I):
                    yield f"{path}:{number}: '{phrase}': the glossary has '{term}'"


def decisions(tree):
    """Each decision has 60 lines at most, one line in the table of decisions and a link to its annex, and no change stands twice in the list of changes."""
    table = re.findall(r"^\| \[\d+\]\((.+?)\)", tree.read("docs/decisions/README.md"), re.MULTILINE)
    for path in tree.ending(".md"):
        name = path.removeprefix("docs/decisions/")
        if name.startswith("annex/"):
            number = os.path.basename(name).removesuffix(".md")
            if not any(f"](annex/{number}.md" in tree.read(page) for page in tree.ending(".md", f"docs/decisions/{number}-")):
                yield f"{path}: decision {number} has no link to it"
        elif name != path and name != "README.md":
            if table.count(name) != 1:
                yield f"{path}: has {table.count(name)} lines in docs/decisions/README.md, not one"
            if (count := len(tree.read(path).splitlines())) > PAGE_LINES:
                yield f"{path}: has {count} lines, {PAGE_LINES} at most; tables go to docs/decisions/annex/"
    lines = [line for line in tree.read("CHANGELOG.md").splitlines() if line.startswith("- ")]
    yield from (f"CHANGELOG.md: says twice '{line[:60]}'" for line in sorted(set(lines)) if lines.count(line) > 1)


CHECKS = {globals()[name]: samples for name, samples in SAMPLES.items()}


def tells_apart(check):
    """Whether the check refuses each of its wrong samples and passes the right ones."""
    wrong, right = CHECKS[check]
    fine = True
    for samples, refused in ((wrong, True), (right, False)):
        for sample in samples:
            with tempfile.TemporaryDirectory() as folder:
                for path, text in sample.items():
                    os.makedirs(os.path.dirname(os.path.join(folder, path)), exist_ok=True)
                    with open(os.path.join(folder, path), "w", encoding="utf-8") as file:
                        file.write(text)
                found = list(check(Tree(folder)))
            if bool(found) != refused:
                fine = False
                print(f"{check.__name__} {'lets pass' if refused else 'refuses'} {sample}: {found}")
    return fine


def main(arguments):
    if arguments == ["--list"]:
        print("\n".join(check.__name__ for check in CHECKS))
        return 0
    by_name = {check.__name__: check for check in CHECKS}
    if not arguments or arguments[0] not in by_name or len(arguments) > 2:
        print(__doc__, file=sys.stderr)
        return 2
    check = by_name[arguments[0]]
    try:
        if arguments[1:] == ["--broken"]:
            return 0 if tells_apart(check) else 1
        found = list(check(Tree(arguments[1] if len(arguments) == 2 else REPOSITORY)))
    except Skip as reason:
        print(f"skipped: {reason}")
        return SKIPPED
    for line in found:
        print(line)
    if found:
        print(f"{check.__name__}: {check.__doc__}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
