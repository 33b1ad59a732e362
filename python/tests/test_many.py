"""Many lots: threads, failures, tables, seeds."""

import json
from typing import Any

import geopandas
import numpy as np
import pyarrow as pa
import pytest
import shapely

import pycga


def lots(count: int) -> list[pycga.Shape]:
    return [pycga.Shape.rectangle(8 + n % 7, 6 + n % 5, name=str(n), attributes={"height": 3 + n % 9}) for n in range(count)]


def rows(count: int) -> dict[str, Any]:
    boxes = [shapely.box(20 * n, 0, 20 * n + 8 + n % 7, 6 + n % 5) for n in range(count)]
    return {"id": [f"lot {n}" for n in range(count)], "height": [3.0 + n % 9 for n in range(count)], "geometry": boxes}


def table(count: int, **columns: Any) -> pa.Table:
    own = rows(count)
    return pa.table({**own, "geometry": shapely.to_wkb(own["geometry"]), **columns})


def collection(count: int) -> dict[str, Any]:
    own = rows(count)
    features = [
        {"type": "Feature", "id": name, "properties": {"height": height}, "geometry": shapely.geometry.mapping(box)}
        for name, height, box in zip(own["id"], own["height"], own["geometry"])
    ]
    return {"type": "FeatureCollection", "features": features}


def test_a_thousand_lots_are_equal_with_any_number_of_threads(house: pycga.RuleFile) -> None:
    shapes = lots(1000)
    alone = [house.generate(shape, seed=number).to_glb() for number, shape in enumerate(shapes)]
    for threads in (1, 3, None):
        models = house.generate_all(shapes, threads=threads, seed=0)
        assert [model.to_glb() for model in models] == alone and not models.failures
    assert [model.to_glb() for model in house.generate_all(shapes)] == alone


def test_lots_that_fail_are_data(box: pycga.RuleFile) -> None:
    deep = pycga.RuleFile.from_text("attr n = 1  Lot --> case n > 5 : Deep(n) else : extrude(2) X.  Deep(m) --> case m < 0 : X. else : Deep(m + 1)")
    given: list[Any] = [
        pycga.Shape.rectangle(2, 2, name="good"),
        [(0, 0), (1, 1)],
        pycga.Shape.rectangle(2, 2, name="deep", attributes={"n": 9}),
        pycga.Shape.rectangle(2, 2, name="wrong", attributes={"m": 9}),
        pycga.Shape.rectangle(2, 2, name="rule", start="None"),
        [(0, 0), (2, 0), (2, 2)],
    ]
    models = deep.generate_all(given)
    assert [(model.row, model.name) for model in models] == [(0, "good"), (5, "")]
    assert [(one.row, one.name, one.kind) for one in models.failures] == [
        (1, "", "shape"),
        (2, "deep", "run"),
        (3, "wrong", "attribute"),
        (4, "rule", "attribute"),
    ]
    assert "depth" in models.failures[1].reason and "`m`" in models.failures[2].reason
    lines = pa.table(models.table()).to_pydict()
    assert lines["row"] == [0, 1, 2, 3, 4, 5]
    assert [error is None for error in lines["error"]] == [True, False, False, False, False, True]


def test_models_are_a_sequence(house: pycga.RuleFile) -> None:
    models = house.generate_all(lots(5))
    assert len(models) == 5 and [model.name for model in models] == ["0", "1", "2", "3", "4"]
    assert models[-1].name == "4" and models[1].row == 1
    for index in (5, -6, 2**62):
        with pytest.raises(IndexError):
            models[index]
    assert len(house.generate_all([])) == 0


def test_tables_collections_and_frames_are_equal(house: pycga.RuleFile) -> None:
    frame = geopandas.GeoDataFrame(rows(50), crs=32632)
    expected = [model.to_glb() for model in house.generate_all(table(50), name="id")]
    assert len(set(expected)) == 50
    forms: list[Any] = [frame.to_arrow(), frame, collection(50), json.dumps(collection(50)), table(50).to_reader(max_chunksize=7)]
    forms += [table(50).set_column(2, "geometry", table(50)["geometry"].cast(kind)) for kind in (pa.large_binary(), pa.binary_view())]
    for form in forms:
        models = house.generate_all(form, name=None if isinstance(form, (dict, str)) else "id")
        assert [model.to_glb() for model in models] == expected and not models.failures
        assert models[9].attributes["height"] == 3.0 and models[8].attributes["height"] == 11.0


def test_polars_has_tables_too(house: pycga.RuleFile) -> None:
    polars = pytest.importorskip("polars")
    own = rows(20)
    frame = polars.DataFrame({**own, "geometry": list(shapely.to_wkb(own["geometry"]))})
    models = house.generate_all(frame, name="id")
    assert [model.to_glb() for model in models] == [model.to_glb() for model in house.generate_all(table(20), name="id")]
    assert polars.DataFrame(models.table())["floor area"].to_list() == models.reports()["floor area"].tolist()


def test_columns_of_other_names_types_and_nulls_set_attributes() -> None:
    rules = pycga.RuleFile.from_text(
        'attr h = 1  attr lit = false  attr kind = "a"  attr list = [0]  attr names = [""]  Lot --> print(h) print(lit) print(kind) print(list) print(names) X.'
    )
    columns = {
        "HOEHE": pa.array([2, None, 4], pa.int16()),
        "lit": pa.array([True, False, None]),
        "kind": pa.array(["x", "y", None]).dictionary_encode(),
        "list": pa.array([[1, 2], None, []], pa.list_(pa.float32())),
        "names": pa.array([["p"], ["q", "r"], None]),
        "other": pa.array([{"a": 1}] * 3),
    }
    models = rules.generate_all(table(3, **columns), columns={"h": "HOEHE"})
    assert [model.attributes for model in models] == [
        {"h": 2.0, "lit": True, "kind": "x", "list": [1.0, 2.0], "names": ["p"]},
        {"h": 1.0, "lit": False, "kind": "y", "list": [0.0], "names": ["q", "r"]},
        {"h": 4.0, "lit": False, "kind": "a", "list": [], "names": [""]},
    ]
    text = rules.generate_all(table(2, HOEHE=["12.5", "tall"]), columns={"h": "HOEHE"})
    assert text[0].attributes["h"] == 12.5 and not text[0].faults
    # The building stays, with a fault.
    assert text[1].attributes["h"] == 1.0 and "`h`" in text[1].faults[0].message
    with pytest.raises(pycga.AttributeValueError, match="no column `HOEHE`; the columns are id, height, geometry"):
        rules.generate_all(table(1), columns={"h": "HOEHE"})
    with pytest.raises(pycga.AttributeValueError, match="`g`; the attributes are h, lit, kind, list, names"):
        rules.generate_all(table(1), columns={"g": "HOEHE"})
    with pytest.raises(pycga.AttributeValueError, match="the column `lit` is Struct"):
        rules.generate_all(table(1, lit=[{"a": 1}]))
    with pytest.raises(pycga.AttributeValueError, match="and not WKB"):
        rules.generate_all(table(1), geometry="height")


def test_broken_rows_of_tables_are_failures(house: pycga.RuleFile) -> None:
    wkb = shapely.to_wkb(rows(4)["geometry"])
    broken = pa.table({"id": list("abcd"), "geometry": pa.array([wkb[0], None, b"\x01\x03\x00\x00\x00\xff\xff\xff\xff", wkb[3]], pa.binary())})
    models = house.generate_all(broken, name="id")
    assert [model.name for model in models] == ["a", "d"]
    assert [(one.row, one.name, one.kind) for one in models.failures] == [(1, "b", "shape"), (2, "c", "shape")]
    assert pa.table(models.table())["name"].to_pylist() == ["a", "b", "c", "d"]


def test_seeds_follow_from_names_or_count_on(house: pycga.RuleFile) -> None:
    whole, half = house.generate_all(table(40), name="id"), house.generate_all(table(40).slice(20), name="id")
    assert [model.to_glb() for model in half] == [model.to_glb() for model in whole][20:]
    assert len({model.seed for model in whole}) == 40
    assert [model.seed for model in house.generate_all(table(3), name="id", seed=7)] == [7, 8, 9]
    assert [model.seed for model in house.generate_all(table(3))] == [0, 1, 2]
    own = [pycga.Shape.rectangle(2, 2, seed=99), pycga.Shape.rectangle(2, 2)]
    assert [model.seed for model in house.generate_all(own, seed=5)] == [99, 6]


def test_reports_are_columns(house: pycga.RuleFile) -> None:
    models = house.generate_all(table(30), name="id")
    columns = models.reports()
    assert list(columns) == ["row", "name", "floor area", "wall"]
    assert columns["row"].tolist() == list(range(30)) and columns["name"][3] == "lot 3"
    assert columns["floor area"].dtype == np.float64
    assert columns["floor area"].tolist() == [model.reports["floor area"]["sum"] for model in models]
    assert columns["wall"] == [model.attributes["wall"] for model in models]
    assert models.reports("count")["floor area"].tolist() == [1.0] * 30
    with pytest.raises(ValueError, match='"sum"'):
        models.reports("median")
    made = models.table(glb=True)
    assert made.columns == ["row", "name", "error", "glb", "floor area", "wall"] and len(made) == 30
    lines = pa.table(made)
    assert lines["glb"].to_pylist() == [model.to_glb() for model in models]
    assert lines["floor area"].to_pylist() == columns["floor area"].tolist()


def test_models_join_to_one(house: pycga.RuleFile) -> None:
    models = house.generate_all(table(20), name="id")
    town = models.to_model()
    assert town.area == pytest.approx(sum(model.area for model in models))
    assert town.reports["floor area"]["count"] == 20
    assert {mesh.building for mesh in town.meshes(by="building")} == set(range(20))


def test_wrong_arguments_are_errors(house: pycga.RuleFile) -> None:
    for wrong in (5, None, object()):
        with pytest.raises(TypeError, match="has no lots"):
            house.generate_all(wrong)  # type: ignore[arg-type]
    with pytest.raises(pycga.ShapeError, match="`features`"):
        house.generate_all({"type": "FeatureCollection"})
    with pytest.raises(ValueError, match="threads"):
        house.generate_all([], threads=10**6)
    with pytest.raises(pycga.RunError, match="start rules are Lot"):
        house.generate_all([], start="None")


def test_a_property_that_no_feature_has_is_named(house: pycga.RuleFile) -> None:
    given = collection(3)
    for feature in given["features"]:
        feature["properties"]["storeys"] = 3
    for renamed in ("stories", "storey"):
        with pytest.raises(pycga.AttributeValueError, match=f"no feature has the property `{renamed}`; did you mean `storeys`"):
            house.generate_all(given, columns={"height": renamed})
    with pytest.raises(pycga.AttributeValueError, match="no feature has the property `osm`; the properties are height, storeys"):
        house.generate_all(given, name="osm")
    # One feature is enough.
    given["features"][1]["properties"]["osm"] = "way/7"
    assert [model.name for model in house.generate_all(given, name="osm")] == ["", "way/7", ""]


def test_a_column_of_a_table_has_a_proposal(house: pycga.RuleFile) -> None:
    with pytest.raises(pycga.AttributeValueError, match="no column `hieght`; did you mean `height`. The columns are id, height, geometry"):
        house.generate_all(table(2), columns={"height": "hieght"})
    with pytest.raises(pycga.AttributeValueError, match="no column `geom`; the columns are id, height, geometry"):
        house.generate_all(table(2), geometry="geom")


def test_degrees_are_refused(house: pycga.RuleFile) -> None:
    corners = [(11.0, 48.0), (11.0002, 48.0), (11.0002, 48.0001), (11.0, 48.0001)]
    with pytest.raises(pycga.ShapeError, match="probably degrees; convert them to metres"):
        house.generate(corners)
    frame = geopandas.GeoDataFrame({"id": ["mill"]}, geometry=[shapely.Polygon(corners)], crs=4326)
    models = house.generate_all(frame, name="id")
    assert [one.kind for one in models.failures] == ["shape"] and "estimate_utm_crs" in models.failures[0].reason
    assert len(house.generate_all(frame.to_crs(frame.estimate_utm_crs()), name="id")) == 1
