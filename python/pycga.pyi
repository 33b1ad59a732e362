"""CGA rules in Python: the types of `pycga`. `help(pycga)` has the descriptions."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from os import PathLike
from typing import Any, Protocol, TypeAlias, TypedDict, final, type_check_only

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "Attribute",
    "AttributeValueError",
    "CgaError",
    "City",
    "CityError",
    "CityPlan",
    "DeadlineError",
    "Diagnostic",
    "Failure",
    "Fault",
    "LotTable",
    "Material",
    "Mesh",
    "Model",
    "Models",
    "ReportTable",
    "RuleError",
    "RuleFile",
    "RunError",
    "Shape",
    "ShapeError",
    "StartRule",
    "WriteError",
    "__version__",
    "shapes",
]

__version__: str

_Path: TypeAlias = str | PathLike[str]
_Scalar: TypeAlias = float | bool | str | np.generic
_Value: TypeAlias = _Scalar | Sequence[_Scalar] | Sequence[Sequence[_Scalar]] | NDArray[Any]
# Values of attributes as Python objects.
_Read: TypeAlias = float | bool | str | list[float] | list[bool] | list[str] | list[list[float]] | list[list[bool]] | list[list[str]]
_Point: TypeAlias = tuple[float, float]

@type_check_only
class _Geo(Protocol):
    @property
    def __geo_interface__(self) -> Any: ...

@type_check_only
class _Arrow(Protocol):
    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object: ...

# Coordinates, WKB, GeoJSON as text or dict, or an object such as a geometry of shapely.
_Geometry: TypeAlias = Sequence[Any] | NDArray[Any] | bytes | bytearray | str | dict[str, Any] | _Geo

@type_check_only
class _Report(TypedDict):
    count: int
    nans: int
    sum: float
    average: float | None
    min: float | None
    max: float | None
    texts: dict[str, int]

class CgaError(Exception): ...

class RuleError(CgaError):
    diagnostics: list[Diagnostic]

class AttributeValueError(CgaError): ...
class ShapeError(CgaError): ...

class RunError(CgaError):
    trail: list[str]

class DeadlineError(RunError): ...
class CityError(CgaError): ...
class WriteError(CgaError): ...

@final
class Diagnostic:
    @staticmethod
    def _rebuild(parts: tuple[str, str, str, list[str], str, Sequence[int], str]) -> Diagnostic: ...
    @property
    def level(self) -> str: ...
    @property
    def code(self) -> str: ...
    @property
    def message(self) -> str: ...
    @property
    def help(self) -> list[str]: ...
    @property
    def file(self) -> str: ...
    @property
    def line(self) -> int: ...
    @property
    def column(self) -> int: ...
    @property
    def end_line(self) -> int: ...
    @property
    def end_column(self) -> int: ...
    @property
    def text(self) -> str: ...

@final
class Attribute:
    @property
    def name(self) -> str: ...
    @property
    def type(self) -> str: ...
    @property
    def default(self) -> _Read | None: ...
    @property
    def range(self) -> tuple[float, float] | None: ...
    @property
    def step(self) -> float: ...
    @property
    def choices(self) -> list[float | bool | str] | None: ...
    @property
    def restricted(self) -> bool: ...
    @property
    def kind(self) -> str: ...
    @property
    def display_name(self) -> str: ...
    @property
    def group(self) -> list[str]: ...
    @property
    def about(self) -> str: ...
    @property
    def hidden(self) -> bool: ...

@final
class StartRule:
    @property
    def name(self) -> str: ...
    @property
    def about(self) -> str: ...
    @property
    def marked(self) -> bool: ...
    @property
    def hidden(self) -> bool: ...

@final
class Shape:
    def __new__(
        cls,
        geometry: _Geometry,
        *,
        name: str | None = None,
        attributes: Mapping[str, _Value | None] | None = None,
        seed: int | None = None,
        start: str | None = None,
        height: float | None = None,
        origin: _Point | None = None,
    ) -> Shape: ...
    @staticmethod
    def rectangle(
        width: float,
        depth: float,
        *,
        name: str | None = None,
        attributes: Mapping[str, _Value | None] | None = None,
        seed: int | None = None,
        start: str | None = None,
    ) -> Shape: ...
    @staticmethod
    def from_mesh(
        path: _Path,
        *,
        name: str | None = None,
        attributes: Mapping[str, _Value | None] | None = None,
        seed: int | None = None,
        start: str | None = None,
    ) -> Shape: ...
    @property
    def name(self) -> str: ...
    @property
    def attributes(self) -> dict[str, _Read]: ...
    @property
    def seed(self) -> int | None: ...
    @property
    def start(self) -> str | None: ...

def shapes(
    geometry: _Geometry,
    *,
    name: str | None = None,
    attributes: Mapping[str, _Value | None] | None = None,
    seed: int | None = None,
    start: str | None = None,
    height: float | None = None,
    origin: _Point | None = None,
) -> list[Shape]: ...

@final
class RuleFile:
    def __new__(
        cls,
        path: _Path,
        *,
        name: str | None = None,
        imports: dict[str, str] | None = None,
        assets: _Path | None = None,
        root: _Path | None = None,
    ) -> RuleFile: ...
    @staticmethod
    def from_text(text: str, *, name: str = "rules", imports: dict[str, str] | None = None, assets: _Path | None = None) -> RuleFile: ...
    @staticmethod
    def _rebuild(name: str, file: str, texts: dict[str, str], assets: _Path | None) -> RuleFile: ...
    @property
    def name(self) -> str: ...
    @property
    def about(self) -> str: ...
    @property
    def attributes(self) -> dict[str, Attribute]: ...
    @property
    def start_rules(self) -> list[StartRule]: ...
    @property
    def warnings(self) -> list[Diagnostic]: ...
    @property
    def texts(self) -> dict[str, str]: ...
    def generate(
        self,
        shape: Shape | _Geometry,
        *,
        attributes: Mapping[str, _Value | None] | None = None,
        seed: int | None = None,
        start: str | None = None,
        limits: Mapping[str, int] | None = None,
        deadline: float | None = None,
        origin: _Point | None = None,
    ) -> Model: ...
    def generate_all(
        self,
        lots: Sequence[Shape | _Geometry] | dict[str, Any] | str | _Geo | _Arrow,
        *,
        attributes: Mapping[str, _Value | None] | None = None,
        seed: int | None = None,
        start: str | None = None,
        limits: Mapping[str, int] | None = None,
        deadline: float | None = None,
        threads: int | None = None,
        origin: _Point | None = None,
        geometry: str = "geometry",
        name: str | None = None,
        columns: dict[str, str] | None = None,
    ) -> Models: ...

@final
class Fault:
    @property
    def kind(self) -> str: ...
    @property
    def message(self) -> str: ...
    @property
    def count(self) -> int: ...
    @property
    def trail(self) -> list[str]: ...
    @property
    def text(self) -> str: ...

@final
class Material:
    @property
    def name(self) -> str: ...
    @property
    def color(self) -> tuple[float, float, float]: ...
    @property
    def opacity(self) -> float: ...
    @property
    def metallic(self) -> float: ...
    @property
    def roughness(self) -> float: ...
    @property
    def texture(self) -> str: ...
    @property
    def double_sided(self) -> bool: ...

@final
class Mesh:
    @property
    def rule(self) -> str | None: ...
    @property
    def building(self) -> int | None: ...
    @property
    def material(self) -> Material: ...
    @property
    def positions(self) -> NDArray[np.float32]: ...
    @property
    def normals(self) -> NDArray[np.float32]: ...
    @property
    def uvs(self) -> NDArray[np.float32] | None: ...
    @property
    def indices(self) -> NDArray[np.uint32]: ...
    @property
    def places(self) -> NDArray[np.float64]: ...
    @property
    def origin(self) -> tuple[float, float, float]: ...

@final
class Model:
    @property
    def row(self) -> int: ...
    @property
    def lot(self) -> int: ...
    @property
    def name(self) -> str: ...
    @property
    def seed(self) -> int: ...
    @property
    def attributes(self) -> dict[str, _Read]: ...
    @property
    def reports(self) -> dict[str, _Report]: ...
    @property
    def prints(self) -> list[str]: ...
    @property
    def faults(self) -> list[Fault]: ...
    @property
    def counts(self) -> dict[str, int]: ...
    @property
    def area(self) -> float: ...
    @property
    def volume(self) -> float: ...
    @property
    def bounds(self) -> tuple[list[float], list[float]] | None: ...
    @property
    def triangle_count(self) -> int: ...
    def to_glb(self) -> bytes: ...
    def write_glb(self, path: _Path) -> None: ...
    def write(self, path: _Path, *, width: int = 1200, height: int = 800) -> None: ...
    def meshes(self, *, by: str = "rule") -> list[Mesh]: ...
    def __len__(self) -> int: ...
    def __bool__(self) -> bool: ...

@final
class Failure:
    @property
    def row(self) -> int: ...
    @property
    def lot(self) -> int: ...
    @property
    def name(self) -> str: ...
    @property
    def kind(self) -> str: ...
    @property
    def reason(self) -> str: ...

@final
class ReportTable:
    @property
    def columns(self) -> list[str]: ...
    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object: ...
    def __len__(self) -> int: ...

@final
class Models:
    @property
    def failures(self) -> list[Failure]: ...
    def to_model(self) -> Model: ...
    def reports(self, statistic: str = "sum") -> dict[str, Any]: ...
    def table(self, *, glb: bool = False, statistic: str = "sum") -> ReportTable: ...
    def __len__(self) -> int: ...
    def __getitem__(self, index: int, /) -> Model: ...
    def __iter__(self) -> Iterator[Model]: ...

@final
class City:
    def __new__(
        cls,
        folder: _Path,
        rules: RuleFile | Sequence[RuleFile],
        *,
        attributes: Mapping[str, _Value | None] | None = None,
        columns: dict[str, str] | None = None,
        name: str | None = None,
        grammar_column: str | None = None,
        start_column: str | None = None,
        geometry: str = "geometry",
        crs: int | str | None = None,
        lod: Sequence[str] | None = None,
        occlusion_distance: float | None = None,
        context_distance: float | None = None,
        tile_lots: int = 256,
        tile_size: int = 4096,
        unit_lots: int = 65_536,
    ) -> City: ...
    @staticmethod
    def _rebuild(work: bytes, folder: _Path, geometry: str, unit_lots: int) -> City: ...
    def count(self, table: _Arrow) -> bytes: ...
    def plan(self, counts: Iterable[bytes]) -> CityPlan: ...

@final
class CityPlan:
    @staticmethod
    def _rebuild(city: City, plan: bytes, failed: Sequence[int]) -> CityPlan: ...
    def lots(self, table: _Arrow) -> LotTable: ...
    def make(self, group: _Arrow, *, threads: int | None = None) -> bytes: ...
    def finish(self, made: Iterable[bytes]) -> dict[str, int]: ...
    def __len__(self) -> int: ...

@final
class LotTable:
    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object: ...
    def __len__(self) -> int: ...
