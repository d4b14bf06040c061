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

from .commands import draw, export, fmu, kinds, new, report, soils, springs
from .cpt import Cpt, cpt
from .curves import Drag, Push
from .cyclic import CyclicStrength, cyclic
from .desk import Desk, desk
from .element import element
from .envelope import Envelope, envelope
from .errors import InputError, RunError, Stopped
from .findings import Effort, Finding, Findings, check
from .fit import Fit, fit
from .frames import Field, Frame
from .history import Column, History
from .live import LiveRun, Progress, start
from .macro_element import fit_macro_element, macro_element
from .parameters import Parameter, parameters
from .program import find_program, include_folder, version
from .quantity import Quantity
from .route import Route, route
from .run import Run, run, run_both
from .safety import Safety, safety
from .sea import SeaLoads, sea
from .study import Estimate, Row, Study, open, study
from .table import Table

__version__ = "0.1.0"
__all__ = [
    "Column",
    "Cpt",
    "CyclicStrength",
    "Desk",
    "Drag",
    "Effort",
    "Envelope",
    "Estimate",
    "Field",
    "Finding",
    "Findings",
    "Fit",
    "Frame",
    "History",
    "InputError",
    "LiveRun",
    "Parameter",
    "Progress",
    "Push",
    "Quantity",
    "Route",
    "Row",
    "Run",
    "RunError",
    "Safety",
    "SeaLoads",
    "Stopped",
    "Study",
    "Table",
    "check",
    "cpt",
    "cyclic",
    "desk",
    "draw",
    "element",
    "envelope",
    "export",
    "find_program",
    "fit",
    "fit_macro_element",
    "fmu",
    "include_folder",
    "kinds",
    "macro_element",
    "new",
    "open",
    "parameters",
    "report",
    "route",
    "run",
    "run_both",
    "safety",
    "sea",
    "soils",
    "springs",
    "start",
    "study",
    "version",
]


def __getattr__(name: str) -> Any:
    """The engine, which is compiled, when it is first asked for. Throws ImportError where it is not there."""
    if name != "engine":
        raise AttributeError(f"module 'berm' has no attribute {name!r}")
    return importlib.import_module("berm.engine")
