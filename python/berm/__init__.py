# SPDX-License-Identifier: BSD-3-Clause
"""berm in Python: start runs, read what they leave, draw it::

    import berm
    run = berm.run("my_case.toml", "out/my_case", set={"material.clay.cohesion": "5 kPa"})
    run.quantities["V_at_w_0.1D"].value   # N/m
    run.history["H_N_m"]                  # an array
    run.plot()

`berm.engine` steps a case inside this process. SI units throughout; in plane strain forces are per metre run. Import is light: NumPy and
Matplotlib are loaded by what needs them.
"""

from .element import element
from .errors import InputError, RunError, Stopped
from .frames import Field, Frame
from .history import Column, History
from .macro_element import macro_element
from .parameters import Parameter, parameters
from .program import check, export, find_program, include_folder, new, report, springs, version
from .quantity import Quantity
from .run import Run, run
from .study import Estimate, Row, Study, open, study
from .travel import Drag, Push

__version__ = "0.1.0"
__all__ = [
    "Column",
    "Drag",
    "Estimate",
    "Field",
    "Frame",
    "History",
    "InputError",
    "Parameter",
    "Push",
    "Quantity",
    "Row",
    "Run",
    "RunError",
    "Stopped",
    "Study",
    "check",
    "element",
    "export",
    "find_program",
    "include_folder",
    "macro_element",
    "new",
    "open",
    "parameters",
    "report",
    "run",
    "springs",
    "study",
    "version",
]
