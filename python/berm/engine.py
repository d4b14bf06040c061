# SPDX-License-Identifier: BSD-3-Clause
"""What `import berm.engine` finds where the engine, a compiled module of the same name that Python prefers, is not beside the package."""

raise ImportError(
    "berm.engine is compiled, and not beside this package: install python3-berm (apt-get install ./python3-berm_*.deb), or build it "
    "(scripts/setup python, then ninja -C build/release berm_python) and name build/release/python in PYTHONPATH"
)
