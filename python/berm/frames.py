# SPDX-License-Identifier: BSD-3-Clause
"""Frames of a run: particles (of finite elements: nodes) with their fields at a time, read from the VTU files that berm writes."""

from __future__ import annotations

import struct
import zlib
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree

from .errors import InputError, RunError
from .history import imported

if TYPE_CHECKING:
    from numpy.typing import NDArray

TYPES = {"Float64": "<f8", "Float32": "<f4", "Int64": "<i8", "Int32": "<i4", "UInt8": "u1"}


@dataclass(frozen=True)
class Field:
    """A field of a frame: label, unit ("": a bare number) and numbers, of shape (points,) or (points, components)."""

    label: str
    unit: str
    values: NDArray[Any]


class Vtu:
    """A VTU file of one piece with appended data in zlib blocks."""

    def __init__(self, file: Path) -> None:
        try:
            data = file.read_bytes()
            begin = data.index(b"<AppendedData")
            self._data = data[data.index(b"_", begin) + 1 :]
            root = ElementTree.fromstring(data[:begin] + b"</VTKFile>")
        except (OSError, ValueError, ElementTree.ParseError) as error:
            raise RunError(f"{file}: {error}") from None
        self._file = file
        self._arrays = {place.tag: {array.attrib["Name"]: array.attrib for array in place.iter("DataArray")} for place in root.iter()}

    def names(self, place: str) -> list[str]:
        return list(self._arrays.get(place, {}))

    def field(self, place: str, name: str) -> Field:
        """place: Points, Cells, PointData or CellData. Stress has the components xx yy zz xy yz xz."""
        import numpy as np

        array = self._arrays[place][name]
        components = int(array.get("NumberOfComponents", 1))
        values = np.frombuffer(self._bytes(int(array["offset"])), dtype=TYPES[array["type"]])
        return Field(array.get("Label", name), array.get("Unit", ""), values.reshape(-1, components) if components > 1 else values)

    def _bytes(self, offset: int) -> bytes:
        count, size, last = struct.unpack_from("<3Q", self._data, offset)
        sizes = struct.unpack_from(f"<{count}Q", self._data, offset + 24)
        at, parts = offset + 24 + 8 * count, []
        for compressed in sizes:
            parts.append(zlib.decompress(self._data[at : at + compressed]))
            at += compressed
        return b"".join(parts)


class Frame:
    """The soil at a time: frame.position, of shape (points, 3) in m, and frame["stress"], of shape (points, 6) in Pa, tension positive; frame.fields names them all."""

    def __init__(self, time: float, file: Path) -> None:
        self.time = time  #: s
        self.file = file

    @cached_property
    def _vtu(self) -> Vtu:
        return Vtu(self.file)

    @property
    def fields(self) -> list[str]:
        return self._vtu.names("PointData")

    @cached_property
    def position(self) -> NDArray[Any]:
        return self._vtu.field("Points", "Points").values

    def field(self, name: str) -> Field:
        """A field with its label and unit. Throws InputError where there is none of this name."""
        if name not in self.fields:
            raise InputError(f"the frame has no field {name!r}; it has {', '.join(self.fields)}")
        return self._vtu.field("PointData", name)

    def __getitem__(self, name: str) -> NDArray[Any]:
        return self.field(name).values

    def to_pyvista(self) -> Any:
        """The file as PyVista reads it. Needs python3-pyvista."""
        return imported("pyvista", "python3-pyvista").read(str(self.file))


def frames_in(run_folder: Path) -> list[Frame]:
    """The frames that frames.pvd of a run lists, in the order of time; none where there is no such file. Throws RunError where it is damaged."""
    file = run_folder / "frames" / "frames.pvd"
    if not file.exists():
        return []
    try:
        entries = [entry.attrib for entry in ElementTree.parse(file).iter("DataSet")]
        return [Frame(float(entry["timestep"]), file.parent / entry["file"]) for entry in entries if entry.get("part") == "0"]
    except (OSError, KeyError, ValueError, ElementTree.ParseError) as error:
        raise RunError(f"{file}: {error}") from None
