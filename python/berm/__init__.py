# SPDX-License-Identifier: BSD-3-Clause
"""berm in Python: start runs, read what they leave, draw it::

    import berm
    case = berm.new("pipe-in-clay", "my_case.toml")
    run = berm.run(case, "out/my_case", set={"material.clay.undrained_strength": "3 kPa"})
    run.quantities["w_end_of_push"].value   # m
    run.history["H_N_m"]                  # an array
    run.plot()

`berm.engine` steps a case inside this process. SI units throughout; in plane strain forces are per metre run. Import is light: NumPy and
Matplotlib are loaded by what needs them.
"""

import importlib
from typing import Any

from .cpt import Cpt, cpt
from .curves import Drag, Push
from .cyclic import CyclicStrength, cyclic
from .element import element
from .errors import InputError, RunError, Stopped
from .fit import Fit, fit
from .frames import Field, Frame
from .history import Column, History
from .macro_element import macro_element
from .parameters import Parameter, parameters
from .program import check, export, find_program, fmu, include_folder, new, report, springs, version
from .quantity import Quantity
from .route import Route, route
from .run import Run, run
from .sea import SeaLoads, sea
from .study import Estimate, Row, Study, open, study

__version__ = "0.1.0"
__all__ = [
    "Column",
    "Cpt",
    "CyclicStrength",
    "Drag",
    "Estimate",
    "Field",
    "Fit",
    "Frame",
    "History",
    "InputError",
    "Parameter",
    "Push",
    "Quantity",
    "Route",
    "Row",
    "Run",
    "RunError",
    "SeaLoads",
    "Stopped",
    "Study",
    "check",
    "cpt",
    "cyclic",
    "element",
    "export",
    "find_program",
    "fit",
    "fmu",
    "include_folder",
    "macro_element",
    "new",
    "open",
    "parameters",
    "report",
    "route",
    "run",
    "sea",
    "springs",
    "study",
    "version",
]


def __getattr__(name: str) -> Any:
    """The engine, which is compiled, when it is first asked for. Throws ImportError where it is not there."""
    if name != "engine":
        raise AttributeError(f"module 'berm' has no attribute {name!r}")
    try:
        return importlib.import_module("berm.engine")
    except ModuleNotFoundError as error:
        raise ImportError(
            "berm.engine is compiled, and not beside this package: install python3-berm, or build it (ninja -C build/release "
            "berm_python) and name build/release/python in PYTHONPATH"
        ) from error
