"""Lots: every form of a polygon makes the same building."""

import json
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely

import pycga

RING = [(0.0, 0.0), (10.0, 0.0), (10.0, 6.0), (0.0, 6.0)]
HOLE = [(4.0, 2.0), (6.0, 2.0), (6.0, 4.0), (4.0, 4.0)]


def closed(ring: list[tuple[float, float]]) -> list[list[float]]:
    return [list(corner) for corner in [*ring, ring[0]]]


def geo(*rings: list[tuple[float, float]]) -> dict[str, Any]:
    return {"type": "Polygon", "coordinates": [closed(ring) for ring in rings]}


POLYGON = shapely.Polygon(RING, [HOLE])
FORMS: dict[str, Any] = {
    "rings": [RING, HOLE],
    "tuples": (tuple(RING), tuple(HOLE)),
    "closed rings": [closed(RING), closed(HOLE)],
    "arrays": [np.array(RING), np.array(HOLE, dtype=np.float32)],
    "whole numbers": [np.array(RING, dtype=int), np.array(HOLE, dtype=int)],
    "wkb": POLYGON.wkb,
    "big-endian wkb": shapely.to_wkb(POLYGON, byte_order=0),
    "bytearray": bytearray(POLYGON.wkb),
    "extended wkb": shapely.to_wkb(shapely.set_srid(POLYGON, 32632), include_srid=True),
    "dict": geo(RING, HOLE),
    "text": json.dumps(geo(RING, HOLE)),
    "feature": {"type": "Feature", "properties": None, "geometry": geo(RING, HOLE)},
    "shapely": POLYGON,
    "one of several": shapely.MultiPolygon([POLYGON]),
}


@pytest.mark.parametrize("form", FORMS)
def test_all_forms_of_a_polygon_are_equal(box: pycga.RuleFile, solid: pycga.RuleFile, form: str) -> None:
    expected = box.generate([RING, HOLE])
    assert box.generate(FORMS[form]).to_glb() == expected.to_glb()
    assert solid.generate(pycga.Shape(FORMS[form])).volume == pytest.approx((60 - 4) * 5)


def test_a_ring_alone_is_a_polygon(box: pycga.RuleFile) -> None:
    forms: list[Any] = [RING, [RING], np.array(RING), np.array([RING])]
    assert len({box.generate(form).to_glb() for form in forms}) == 1


def test_north_is_minus_z(box: pycga.RuleFile) -> None:
    low, high = box.generate([(1, 2), (5, 2), (5, 9), (1, 9)]).bounds or ([], [])
    assert (low, high) == ([1.0, 0.0, -9.0], [5.0, 5.0, -2.0])
    # The first edge, which is in the south, is the front.
    front = next(mesh for mesh in box.generate([(1, 2), (5, 2), (5, 9), (1, 9)]).meshes() if mesh.rule == "Front")
    assert (front.positions[:, 2] == -2).all() and (front.normals == [0, 0, 1]).all()


def test_the_origin_moves_lots(box: pycga.RuleFile) -> None:
    east, north = 512_000.0, 5_400_000.0
    moved = [(x + east, y + north) for x, y in RING]
    assert box.generate(moved, origin=(east, north)).to_glb() == box.generate(RING).to_glb()
    assert box.generate(pycga.Shape(moved, origin=(east, north))).to_glb() == box.generate(RING).to_glb()
    far = box.generate(moved).meshes()[0]
    assert far.origin != (0.0, 0.0, 0.0) and np.abs(far.positions).max() < 20


def test_a_lot_stands_at_its_lowest_corner(box: pycga.RuleFile) -> None:
    heights = [(x, y, 100 + x / 10) for x, y in RING]
    forms: list[Any] = [heights, np.array(heights), shapely.Polygon(heights), shapely.to_wkb(shapely.Polygon(heights), output_dimension=3)]
    forms.append(shapely.to_wkb(shapely.Polygon(heights), output_dimension=3, flavor="iso"))
    for form in forms:
        bounds = box.generate(form).bounds
        assert bounds is not None and (bounds[0][1], bounds[1][1]) == (100.0, 105.0)
    bounds = box.generate(pycga.Shape(heights, height=-3)).bounds
    assert bounds is not None and bounds[0][1] == -3.0


def test_m_is_left_out(box: pycga.RuleFile) -> None:
    for kind, numbers, height in [(3, (), 0.0), (2003, (9.0,), 0.0), (1003, (7.0,), 7.0), (3003, (7.0, 9.0), 7.0), (0x4000_0003, (9.0,), 0.0)]:
        corners = [struct.pack("<dd" + "d" * len(numbers), x, y, *numbers) for x, y in RING]
        bounds = box.generate(struct.pack("<BIII", 1, kind, 1, 4) + b"".join(corners)).bounds
        assert bounds == ([0.0, height, -6.0], [10.0, height + 5.0, 0.0])


def test_each_polygon_of_several_is_a_lot(solid: pycga.RuleFile) -> None:
    several = shapely.MultiPolygon([shapely.box(0, 0, 2, 3), shapely.box(10, 0, 14, 3)])
    lots = pycga.shapes(several, name="pair", seed=5, attributes={"height": 2})
    assert [(lot.name, lot.seed) for lot in lots] == [("pair", 5), ("pair", 6)]
    assert [solid.generate(lot).volume for lot in lots] == [12.0, 24.0]
    with pytest.raises(pycga.ShapeError, match="2 polygons"):
        solid.generate(several)
    models = solid.generate_all([several, RING])
    assert [(model.row, model.lot) for model in models] == [(0, 0), (0, 1), (1, 2)]


def test_a_mesh_of_a_file_is_a_lot(solid: pycga.RuleFile, tmp_path: Path) -> None:
    (tmp_path / "lot.obj").write_text("v 0 0 0\nv 0 0 3\nv 4 0 3\nv 4 0 0\nf 1 2 3 4\n")
    assert solid.generate(pycga.Shape.from_mesh(tmp_path / "lot.obj", attributes={"height": 2})).volume == 24.0
    with pytest.raises(pycga.ShapeError, match="cannot read"):
        pycga.Shape.from_mesh(tmp_path / "none.obj")


def wkb_polygon(*counts: int) -> bytes:
    return struct.pack("<BI" + "I" * len(counts), 1, 3, *counts)


NAN, INFINITE = float("nan"), float("inf")
HOSTILE: dict[str, Any] = {
    "nothing": [],
    "empty rings": [[], []],
    "no bytes": b"",
    "bytes of something else": b"PK\x03\x04" * 10,
    "cut off": POLYGON.wkb[:-3],
    "four billion rings": wkb_polygon(0xFFFF_FFFF),
    "four billion corners": wkb_polygon(1, 0xFFFF_FFFF),
    "four billion polygons": struct.pack("<BII", 1, 6, 0xFFFF_FFFF),
    "nested collections": struct.pack("<BII", 1, 7, 1) * 100_000,
    "a point": shapely.Point(1, 2),
    "a line": shapely.LineString(RING),
    "a collection": shapely.GeometryCollection([POLYGON]),
    "an empty polygon": shapely.Polygon(),
    "NaN": [(0, 0), (1, 0), (NAN, 1)],
    "infinite": [(0, 0), (1, 0), (INFINITE, 1)],
    "huge": [(0, 0), (1e300, 0), (1e300, 1e300), (0, 1e300)],
    "no area": [(0, 0), (1, 0), (2, 0)],
    "one number": [(0, 0), (1,), (1, 1)],
    "text": [("a", "b"), (1, 0), (1, 1)],
    "numbers": [1, 2, 3],
    "nested lists": [[[[[0]]]]],
    "an object": object(),
    "an integer": 3,
    "broken GeoJSON": '{"type": "Polygon"',
    "deep GeoJSON": '{"type": "Polygon", "coordinates": ' + "[" * 100_000 + "]" * 100_000 + "}",
    "a list of GeoJSON": "[1]",
    "no type": {"coordinates": [RING]},
    "a feature in a feature": {"type": "Feature", "geometry": {"type": "Feature"}},
    "no coordinates": {"type": "Polygon"},
    "a type that is a number": {"type": 3, "coordinates": [RING]},
    "too many corners": [(n, (n * n) % 7) for n in range(30_000)],
    "an array with three axes": np.zeros((2, 3, 4, 5)),
    "an array of text": np.array([["a", "b"]]),
}


@pytest.mark.parametrize("name", HOSTILE)
def test_other_objects_are_shape_errors(box: pycga.RuleFile, name: str) -> None:
    with pytest.raises(pycga.ShapeError):
        box.generate(HOSTILE[name])
    with pytest.raises(pycga.ShapeError):
        box.generate(pycga.Shape(HOSTILE[name]))
    models = box.generate_all([RING, HOSTILE[name], RING])
    assert [model.row for model in models] == [0, 2]
    assert {failure.row for failure in models.failures} == {1} and models.failures[0].kind == "shape"


def test_an_object_that_contains_itself_is_refused(box: pycga.RuleFile) -> None:
    endless: list[Any] = []
    endless.append(endless)
    for given in (endless, {"type": "Polygon", "coordinates": endless}, {"type": "MultiPolygon", "coordinates": endless}):
        with pytest.raises(pycga.ShapeError):
            box.generate(given)


def test_wrong_rectangles_are_refused() -> None:
    for width, depth in [(0, 1), (-1, 1), (NAN, 1), (1, INFINITE)]:
        with pytest.raises(pycga.ShapeError, match="not a rectangle"):
            pycga.Shape.rectangle(width, depth)
