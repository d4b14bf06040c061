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
WRITTEN_AS = {"type": "UnstructuredGrid", "byte_order": "LittleEndian", "header_type": "UInt64", "compressor": "vtkZLibDataCompressor"}
QUADRATIC_TRIANGLE = 22  # VTK's number


@dataclass(frozen=True)
class Field:
    """A field of a frame: label, unit ("": a bare number) and numbers, of shape (points,) or (points, components)."""

    label: str
    unit: str
    values: NDArray[Any]


class Vtu:
    """A VTU file of one piece with appended data in zlib blocks. Its head is read; arrays are read when they are asked for."""

    def __init__(self, file: Path) -> None:
        """Throws RunError where this is no such file."""
        self._file = file
        try:
            with file.open("rb") as opened:
                head = b""
                while b"<AppendedData" not in head or b"_" not in head[head.index(b"<AppendedData") :]:
                    more = opened.read(8192)
                    if not more:
                        raise ValueError("there is no appended data")
                    head += more
            begin = head.index(b"<AppendedData")
            self._data = head.index(b"_", begin) + 1
            root = ElementTree.fromstring(head[:begin] + b"</VTKFile>")
            other = [f'{key}="{root.get(key)}"' for key, value in WRITTEN_AS.items() if root.get(key) != value]
            if other:
                raise ValueError(f"{', '.join(other)} is not what berm writes")
        except (OSError, ValueError, ElementTree.ParseError) as error:
            raise RunError(f"{file}: {error}") from None
        self._arrays = {place.tag: {array.attrib["Name"]: array.attrib for array in place.iter("DataArray")} for place in root.iter()}

    def names(self, place: str) -> list[str]:
        return list(self._arrays.get(place, {}))

    def field(self, place: str, name: str) -> Field:
        """place: Points, Cells, PointData or CellData. Stress is xx yy zz xy yz xz. Throws RunError where the file is damaged."""
        import numpy as np

        try:
            array = self._arrays[place][name]
            components = int(array.get("NumberOfComponents", 1))
            values = np.frombuffer(self._bytes(int(array["offset"])), dtype=TYPES[array["type"]])
            return Field(array.get("Label", name), array.get("Unit", ""), values.reshape(-1, components) if components > 1 else values)
        except (OSError, KeyError, ValueError, MemoryError, struct.error, zlib.error) as error:
            raise RunError(f"{self._file}: {name}: {error}") from None

    def _bytes(self, offset: int) -> bytes:
        with self._file.open("rb") as opened:
            opened.seek(self._data + offset)
            count, _, _ = struct.unpack("<3Q", opened.read(24))
            if count > self._file.stat().st_size:
                raise ValueError("more blocks than bytes")
            sizes = struct.unpack(f"<{count}Q", opened.read(8 * count))
            return b"".join(zlib.decompress(opened.read(size)) for size in sizes)


class Frame:
    """The soil at a time: frame.position, of shape (points, 3) in m, and frame["stress"], of shape (points, 6) in Pa, tension positive;
    frame.fields names them all. Numbers are read from the file when they are asked for."""

    def __init__(self, time: float, stage: str, file: Path, rigid_file: Path | None = None) -> None:
        self.time = time  #: s
        self.stage = stage  #: in which it was reached; "" where the history does not say
        self.file = file
        self.rigid_file = rigid_file

    def __repr__(self) -> str:
        return f"<frame at {self.time:.4g} s, {self.stage!r}: {self.file}>"

    @cached_property
    def _vtu(self) -> Vtu:
        return Vtu(self.file)

    @property
    def fields(self) -> list[str]:
        return self._vtu.names("PointData")

    @property
    def position(self) -> NDArray[Any]:
        return self._vtu.field("Points", "Points").values

    @property
    def triangles(self) -> NDArray[Any]:
        """Corners and middles of sides of quadratic triangles, numbers of points, of shape (triangles, 6); of particles there are none."""
        quadratic = (self._vtu.field("Cells", "types").values == QUADRATIC_TRIANGLE).all()
        corners = self._vtu.field("Cells", "connectivity").values
        return (corners if quadratic else corners[:0]).reshape(-1, 6)

    @property
    def rigid_bodies(self) -> list[NDArray[Any]]:
        """The cells of the surfaces of rigid bodies, in plane strain their outlines (and a radius that shows how a pipe rolls): points of
        shape (points, 3), m."""
        if self.rigid_file is None:
            return []
        import numpy as np

        vtu = Vtu(self.rigid_file)
        points, cells, ends = vtu.field("Points", "Points"), vtu.field("Cells", "connectivity"), vtu.field("Cells", "offsets")
        return [points.values[cell] for cell in np.split(cells.values, ends.values[:-1])]

    def field(self, name: str) -> Field:
        """A field with its label and unit. Throws InputError where there is none of this name."""
        if name not in self.fields:
            raise InputError(f"the frame has no field {name!r}; it has {', '.join(self.fields)}")
        return self._vtu.field("PointData", name)

    def __getitem__(self, name: str) -> NDArray[Any]:
        return self.field(name).values

    def to_pyvista(self) -> Any:
        """The file as PyVista, which Debian 12 does not have, reads it."""
        return imported("pyvista", "").read(str(self.file))


def frames_in(run_folder: Path) -> list[tuple[float, Path, Path | None]]:
    """Time, soil and rigid bodies of the frames that frames.pvd of a run lists, in the order of time; none where there is no such file.
    Throws RunError where it is damaged."""
    file = run_folder / "frames" / "frames.pvd"
    if not file.exists():
        return []
    found: dict[str, dict[str, Path]] = {}
    try:
        for entry in ElementTree.parse(file).iter("DataSet"):
            found.setdefault(entry.attrib["timestep"], {})[entry.attrib["name"]] = file.parent / entry.attrib["file"]
        return [(float(time), files.get("particles") or files["soil"], files.get("rigid")) for time, files in found.items()]
    except (OSError, KeyError, ValueError, ElementTree.ParseError) as error:
        raise RunError(f"{file}: {error}") from None
