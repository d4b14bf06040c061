# SPDX-License-Identifier: BSD-3-Clause
"""berm in Python: start runs, read what they leave, draw it::

    import berm
    run = berm.run("my_case.toml", "out/my_case", set={"material.clay.cohesion": "5 kPa"})
    run.quantities["V_at_w_0.1D"].value   # N/m
    run.history["H_N_m"]                  # an array
    run.plot()

`berm.engine` steps a case inside this process. SI units throughout; in plane strain forces are per metre run. Import is light: NumPy and Matplotlib are loaded by what needs them.
"""

from .errors import InputError, RunError, Stopped
from .frames import Frame
from .history import Column, History
from .program import check, export, find_program, parameters, report, version
from .run import Quantity, Run, open, run
from .study import Study, study

__version__ = "0.1.0"
__all__ = [
    "Column",
    "Frame",
    "History",
    "InputError",
    "Quantity",
    "Run",
    "RunError",
    "Stopped",
    "Study",
    "check",
    "export",
    "find_program",
    "open",
    "parameters",
    "report",
    "run",
    "study",
    "version",
]
