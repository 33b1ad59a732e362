"""A town on both sides of a border between two units, and cities of it."""

import json
import pickle
import random
from pathlib import Path
from typing import Any

import geopandas
import pyarrow as pa
import shapely

import pycga

# Walls and roofs nearby, blocks far away. Low halls fail.
PLAIN = """
@Range(min = 2, max = 90)
attr height = 9
@Enum("home", "shop", "hall")
attr kind = "home"
attr slope = 34
@StartRule Lot --> case kind == "hall" && height < 7 : Endless(1) else : [ extrude(height) comp(f) { side : Wall } ] t(0, height, 0) roofHip(slope) Roof.
Endless(n) --> case n < 0 : X. else : Endless(n + 1)
Wall --> Face.
@StartRule Block --> extrude(height + 1) X.
"""
# The same without walls between neighbours, and with taller houses in the middle of others.
ASKING = PLAIN.replace("Wall --> Face.", "Wall --> case touches(inter) : NIL else : Face.").replace(
    "extrude(height)", 'extrude(height + contextCount(inter, "house")) label("house")'
)
# The longitude of a border between the widest tiles.
BORDER = 52 * 360 / 2048


def town(rows: int = 12, columns: int = 40, broken: bool = True) -> pa.Table:
    """Houses in rows from west to east that touch each other, and some rows that cannot be used."""
    numbers = random.Random(7)
    shapes: list[bytes | None] = []
    heights: list[float | None] = []
    kinds: list[str] = []
    for number in range(rows * columns):
        west = BORDER + (number % columns - columns / 2) * 0.00015
        south = 48 + number // columns * 0.0004
        shapes.append(shapely.box(west, south, west + 0.00015, south + 0.0001).wkb)
        heights.append(numbers.choice([5.0, 6.5, 9.0, 12.25]))
        kinds.append(numbers.choice(["home", "shop", "hall"]))
    if broken:
        two = shapely.MultiPolygon([shapely.box(BORDER + x, 48.01, BORDER + x + 0.0001, 48.0101) for x in (0, 0.0002)])
        crossed = shapely.Polygon([(BORDER, 48.01), (BORDER + 1e-4, 48.0101), (BORDER + 1e-4, 48.01), (BORDER, 48.0101)])
        shapes += [two.wkb, crossed.wkb, None, shapely.Point(BORDER, 48).wkb, shapes[0], shapes[1]]
        heights += [9.0, 9.0, 9.0, 9.0, 900.0, None]
        kinds += ["home", "home", "home", "home", "home", "castle"]
    columns_of_town = {"id": list(range(1, len(shapes) + 1)), "height": heights, "kind": kinds}
    return pa.table({**columns_of_town, "geometry": pa.array(shapes, pa.binary())})


def write(folder: Path, rules: str, lots: pa.Table) -> tuple[Path, Path]:
    """Writes lots as GeoParquet, and rules."""
    frame = lots.to_pandas()
    geometry = [None if one is None else shapely.from_wkb(one) for one in frame["geometry"]]
    geopandas.GeoDataFrame(frame.drop(columns="geometry"), geometry=geometry, crs=4326).to_parquet(folder / "lots.parquet")
    (folder / "town.cga").write_text(rules)
    return folder / "lots.parquet", folder / "town.cga"


def city(folder: Path, rules: str, **choices: Any) -> pycga.City:
    """A city with small tiles and small units."""
    texts = pycga.RuleFile.from_text(rules, name="town")
    return pycga.City(folder, texts, **{"lod": ["Block"], "tile_lots": 16, "unit_lots": 1, **choices})


def batches(lots: pa.Table, size: int, seed: int) -> list[pa.Table]:
    """The rows in another order."""
    order = list(range(len(lots)))
    random.Random(seed).shuffle(order)
    return [lots.take(order[at : at + size]) for at in range(0, len(order), size)]


def plan(city: pycga.City, parts: list[pa.Table]) -> pycga.CityPlan:
    return city.plan(city.count(part) for part in parts)


def groups(plan: pycga.CityPlan, parts: list[pa.Table]) -> list[pa.Table]:
    """The lots of each unit, from the last unit to the first."""
    lots = pa.concat_tables([pa.table(plan.lots(part)) for part in parts])
    units = sorted(set(lots["unit"].to_pylist()), reverse=True)
    return [lots.filter(pa.compute.equal(lots["unit"], unit)) for unit in units]


def make(city: pycga.City, parts: list[pa.Table]) -> dict[str, int]:
    """Makes a city in one process, with copies as other processes have them."""
    planned = plan(pickle.loads(pickle.dumps(city)), parts)
    copy = pickle.loads(pickle.dumps(planned))
    return planned.finish(copy.make(group, threads=2) for group in groups(copy, parts))


def files(folder: Path) -> dict[str, bytes]:
    """The files that viewers and further runs read."""
    found = [folder / "tileset.json", *(folder / "tiles").rglob("*"), *(folder / "sets").rglob("*")]
    return {str(file.relative_to(folder)): file.read_bytes() for file in found if file.is_file()}


def failures(*tables: Path) -> list[tuple[str, bool, str]]:
    """The lines of tables of problems."""
    lines = [json.loads(line) for table in tables for line in table.read_text().splitlines()]
    return sorted((line["id"], line["lost"], line["reason"]) for line in lines)
