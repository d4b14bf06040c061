# SPDX-License-Identifier: BSD-3-Clause
"""For each check of the house, by its name, trees that it must refuse and trees that it must let pass: {path: text}."""

LICENCE = "SPDX-License-Identifier: BSD-3-Clause"
SPDX = "// " + LICENCE + "\n"
TIERS = "berm_room(engine/core ENGINE)\nberm_room(engine/mesh ENGINE USES core)\nberm_room(methods/mpm ENGINE USES core mesh)\nberm_room(case/input/inner USES mpm LINKS toml)\n"
CELL = '{"cell_type": "code", "source": ["sticky = 1"], "outputs": []}'
NOTEBOOK = f'{{"metadata": {{"license": "{LICENCE}"}}, "cells": [{CELL}]}}'
GLOSSARY = "| displacement | of a body | `largest way`, `its turn` |\n"
EXAMPLE = {"examples/slope/README.md": "a", "examples/slope/case.toml": "a", "examples/slope/expected.toml": "a"}

SAMPLES = {
    "licence": (
        [{"src/a.cpp": "int a;\n"}, {"run": "#!/bin/sh\nls\n"}, {"CMakeLists.txt": "\n\n# " + LICENCE + "\n"}],
        [{"src/a.cpp": SPDX, "run": "#!/bin/sh\n# " + LICENCE + "\n", "notes.md": "words"}],
    ),
    "notebooks": (
        [
            {"a.ipynb": NOTEBOOK.replace(LICENCE, "")},
            {"a.ipynb": NOTEBOOK.replace('"outputs": []', '"outputs": [1]')},
            {"a.ipynb": NOTEBOOK.replace(CELL, "")},
            {"a.ipynb": "words"},
        ],
        [{"a.ipynb": NOTEBOOK}],
    ),
    "width": ([{"python/berm/a.py": "a" * 141}, {"tests/python/a.py": "\n" + "a" * 141}], [{"python/a.py": "a" * 140, "scripts/a.py": "a" * 141}]),
    "length": ([{"a.cpp": "\n" * 601}, {"a.py": "\n" * 700}], [{"a.cpp": "\n" * 600, "a.md": "\n" * 900}]),
    "names": ([{"src/string_utils.hpp": ""}, {"src/common/a.hpp": ""}], [{"src/engine/mesh/locate.hpp": ""}]),
    "tiers": (
        [
            {"CMakeLists.txt": TIERS, "src/engine/core/a.hpp": '#include "mesh/mesh.hpp"\n'},
            {"CMakeLists.txt": TIERS, "src/engine/mesh/a.cpp": '#include "../core/a.hpp"\n'},
            {"CMakeLists.txt": TIERS, "src/methods/fem/a.cpp": ""},
            {"CMakeLists.txt": TIERS, "src/case/input/a.cpp": ""},
            {"CMakeLists.txt": "berm_room(core USES mesh)\nberm_room(mesh)\n"},
        ],
        [{"CMakeLists.txt": TIERS, "src/case/input/inner/a.cpp": '#include "core/a.hpp"\n#include "mpm/b.hpp"\n#include <vector>\n', "src/main.cpp": '#include "commands/a.hpp"\n'}],
    ),
    "floors": (
        [
            {"CMakeLists.txt": "berm_room(pages/report)\nberm_room(engine/core USES report)\n"},
            {"CMakeLists.txt": "berm_room(answers/structures/pipe)\nberm_room(pipeline/beam USES structures/pipe)\n"},
            {"CMakeLists.txt": "berm_room(attic/core)\n"},
            {"CMakeLists.txt": "".join(f"berm_room(base/room_{k})\n" for k in range(71))},
            {"CMakeLists.txt": "".join(f"berm_room(base/room_{k})\n" for k in range(23)) + "berm_room(run/simulation USES " + " ".join(f"room_{k}" for k in range(23)) + ")\n"},
        ],
        [{"CMakeLists.txt": "berm_room(base/os)\nberm_room(engine/core USES os)\nberm_room(methods/fem USES core)\nberm_room(commands USES fem)\n"}],
    ),
    "namespaces": (
        [{"src/engine/mesh/a.hpp": "namespace berm {\n}\n"}, {"src/pages/report/page/a.cpp": "namespace berm::page {\n}\n"}, {"tests/unit/mesh/a.cpp": "namespace berm::mesh {\n}\n"}],
        [{"src/engine/mesh/a.hpp": "namespace berm::mesh {\nnamespace {\n}\n}\n", "src/engine/core/a.hpp": "namespace berm {\n}\n", "src/answers/structures/pipe/a.hpp": "namespace berm::pipe {\n}\n", "tests/physics/a.cpp": "namespace berm::this_file {\n}\n"}],
    ),
    "type_names": (
        [
            {"src/engine/mesh/a.hpp": "namespace berm::mesh {\nstruct A {\n};\n}\n", "src/engine/mesh/b.cpp": "namespace berm::mesh {\nclass A {\n};\n}\n"},
            {"tests/a.hpp": "namespace berm {\nstruct A {\n};\n}\n", "tests/b.hpp": "namespace berm {\nenum class A { one };\n}\n"},
        ],
        [
            {
                "src/engine/mesh/a.hpp": "namespace berm::mesh {\nstruct A {\n};\nstruct B;\n}\n",
                "src/engine/mesh/b.cpp": "namespace berm::mesh {\nnamespace {\nstruct A {\n};\n}  // namespace\nstruct B {\n};\n}\n",
                "src/methods/fem/a.hpp": "namespace berm::fem {\nstruct A {\n};\n}\n",
            }
        ],
    ),
    "test_files": (
        [{"src/engine/mesh/a.cpp": ""}, {"src/engine/mesh/a.cpp": "\n// Tests: tests/b.cpp\n"}, {"tests/unit/mesh/a_test.cpp": ""}, {"src/engine/mesh/a.hpp": "", "tests/unit/mesh/test_a.cpp": ""}],
        [{"src/engine/mesh/a.cpp": "", "tests/unit/mesh/a_of_tests_test.cpp": "", "src/engine/mesh/b.cpp": "\n// Tests: tests/b.cpp\n", "tests/b.cpp": ""}],
    ),
    "places": (
        [{"a.md": "see /ho" + "me/me/x"}, {"a.sh": "cd /wo" + "rk/main"}, {"a.lock": "https://registry." + "npmjs.org/x"}],
        [{"a.md": "https://berm.example/work/x and out/work/y and /usr/bin/python3"}],
    ),
    "loose_ends": ([{"a.cpp": "// TO" + "DO later\n"}, {"a.md": "FIX" + "ME\n"}], [{"a.cpp": "// to do nothing is allowed\n"}]),
    "toml": (
        [{"src/a.cpp": "#include <toml++/toml.h>\n", "src/b.hpp": "#include <toml++/toml.h>\n"}],
        [{"src/a.cpp": "#include <toml++/toml.h>\n", "src/b.cpp": '#include "input/toml_reader.hpp"\n'}],
    ),
    "layout": (
        [{".clang-format": "BasedOnStyle: LLVM\n", "a.cpp": "int  a ;\n"}],
        [{".clang-format": "BasedOnStyle: LLVM\n", "a.cpp": "int a;\n"}],
    ),
    "examples": (
        [{path: text for path, text in EXAMPLE.items() if path != left_out} for left_out in EXAMPLE] + [{"examples/sizes/study.toml": "a"}],
        [EXAMPLE, {"examples/sizes/README.md": "a", "examples/sizes/study.toml": "a"}, {"examples/program/README.md": "a", "examples/program/CMakeLists.txt": "a"}],
    ),
    "starting": (
        [
            {"src/methods/fem/a.cpp": "void* a = dlopen(name, 0);\n"},
            {"src/engine/mesh/a.cpp": "const int a = std::system(words);\n"},
            {"src/pages/a.cpp": "ChildProcess a({words});\n"},
            {"src/exports/fmu/a.c": "execvp(name, words);\n"},
        ],
        [{"src/case/user_law/library.cpp": "void* a = ::dlopen(name, 0);\n", "src/studies/jobs/a.cpp": "ChildProcess a({words});\n", "src/methods/fem/a.cpp": "// dlopen(name)\nint unit_system();\nint a = ut_system();\n"}],
    ),
    "silence": (
        [
            {"src/methods/mpm/a.cpp": "std::cout << 1;\n"},
            {"src/engine/mesh/a.cpp": 'printf("x");\n'},
            {"src/base/io/table.cpp": 'std::fprintf(stderr, "x");\n'},
            {"src/methods/mpm/b.cpp": 'fmt::print("{}", 1);\n'},
            {"src/methods/fem/b.cpp": 'io::tell("{}", 1);\n'},
        ],
        [{"src/commands/a.cpp": "std::cout << 1;\n", "src/base/io/table.cpp": 'std::fprintf(file, "x"); // not printf( here\n', "src/methods/mpm/a.cpp": 'snprintf(s, 3, "a");\n'}],
    ),
    "reading": (
        [{"src/base/io/a.cpp": "std::ifstream lines(file);\n"}, {"src/engine/mesh/a.cpp": 'FILE* file = fopen(name, "r");\n'}],
        [{"src/base/io/a.cpp": "std::ofstream lines(file); // no std::ifstream\n", "tests/a.cpp": "std::ifstream lines(file);\n"}],
    ),
    "allocation": (
        [{"src/methods/mpm/a.cpp": "int* a = new int;\n"}, {"src/engine/contact/a.hpp": "void* p = std::malloc(3);\n"}],
        [{"src/methods/mpm/a.cpp": '// a new step\nthrow RunError("no new one");\n', "src/base/io/a.cpp": "new int;\n"}],
    ),
    "dialect": (
        [
            {"src/a.hpp": "Real initial_spin;\n"},
            {"src/a.hpp": "enum class Grip { open };\n"},
            {"src/a.hpp": "struct WishedPipe;\n"},
            {"tests/a.cpp": "TEST(Memory, is_foretold)\n"},
            {"src/a.cpp": "int a = stumble_;\n"},
            {"src/a.cpp": 'd.check(a, "b", "does not go with c");\n'},
            {"python/a.py": "def stumble(): pass\n"},
            {"a.ipynb": NOTEBOOK},
        ],
        [{"src/a.hpp": '/// spin, does not go with it\nconst char* former = "sticky";\nbool is_wished_in_place, spins_up, gripping;\n', "web/a.ts": "sticky\n", "python/a.py": "# spin\na = 'sticky'\n"}],
    ),
    "prose": (
        [{"README.md": "a\n" * 61}, {"examples/a/README.md": "a\n" * 61}, {"docs/a.md": "at zero cells.\nThe number wavers.\n"}, {"docs/a.md": "V swings.\n"}, {"docs/a.md": "All but for the last.\n"}, {"docs/a.md": "9 particles a cell\n"}],
        [{"README.md": "a\n" * 60, "docs/README.md": "a\n" * 61, "docs/decisions/0001-a.md": "It wavers.\n", "examples/a/results.md": "a\n" * 61}],
    ),
    "glossary": (
        [
            {"docs/glossary.md": GLOSSARY, "src/a.cpp": 'const char* a = "the largest way of it";\n'},
            {"docs/glossary.md": GLOSSARY, "docs/how_to/a.md": "Its largest way.\n"},
            {"docs/glossary.md": GLOSSARY, "web/src/a.ts": "const a = `Largest way ${u}`;\n"},
        ],
        [{"docs/glossary.md": GLOSSARY, "src/a.cpp": "// the largest way\nint largest_way;\n", "docs/decisions/0001-a.md": "its largest way", "tests/a.py": "'largest way'"}],
    ),
    "decisions": (
        [
            {"CHANGELOG.md": "", "docs/decisions/README.md": "| [1](1-a.md) | a |\n| [1](1-a.md) | b |\n", "docs/decisions/1-a.md": ""},
            {"CHANGELOG.md": "", "docs/decisions/README.md": "", "docs/decisions/1-a.md": ""},
            {"CHANGELOG.md": "- A.\n- B.\n- A.\n", "docs/decisions/README.md": ""},
            {"CHANGELOG.md": "", "docs/decisions/README.md": "| [1](1-a.md) | a |\n", "docs/decisions/1-a.md": "a\n" * 61},
            {"CHANGELOG.md": "", "docs/decisions/README.md": "| [1](1-a.md) | a |\n", "docs/decisions/1-a.md": "[b](annex/2.md)", "docs/decisions/annex/1.md": ""},
        ],
        [{"CHANGELOG.md": "- A.\n\n", "docs/decisions/README.md": "| [1](1-a.md) | a |\n", "docs/decisions/1-a.md": "[b](annex/1.md)\n" * 60, "docs/decisions/annex/1.md": "a\n" * 61}],
    ),
    "links": (
        [{"docs/a.md": "[b](b.md)"}, {"docs/a.md": "[b](../b.md#other)", "b.md": "# Part\n"}, {"a.md": "[b](#b)\n```\n# b\n```\n"}],
        [{"docs/a.md": "# One, `two`\n[b](../b.md#part-a_b) [1](#one-two) [c](https://berm.example/c.md#d)", "b.md": "## Part [a_b](c)\n", "c": ""}],
    ),
}
