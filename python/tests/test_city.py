"""Cities of tables: the files of the command `cga-city`, from batches in any order. `CGA_CITY_COMMAND` is its path; `.ci/python` builds it."""

import _thread
import os
import pickle
import struct
import subprocess
import threading
from pathlib import Path

import pyarrow as pa
import pytest
import shapely
import towns
from towns import ASKING, PLAIN, city, failures, files, groups, make

import pycga

COMMAND = os.environ.get("CGA_CITY_COMMAND")
NEEDS_COMMAND = pytest.mark.skipif(COMMAND is None, reason="CGA_CITY_COMMAND is not set")
CHANGED = "when the lots do not change any more"


@NEEDS_COMMAND
@pytest.mark.parametrize("rules", [PLAIN, ASKING])
def test_a_city_has_the_bytes_of_the_command(tmp_path: Path, rules: str) -> None:
    lots = towns.town()
    path, text = towns.write(tmp_path, rules, lots)
    choices = ["--lod", "Block", "--tile-lots", "16", "--set", "slope=40.5", "--quiet"]
    assert COMMAND is not None
    subprocess.run([COMMAND, path, "--rules", text, "--out", tmp_path / "expected", *choices], check=True, capture_output=True)
    numbers = make(city(tmp_path / "out", rules, attributes={"slope": 40.5}), towns.batches(lots, 50, 1))
    assert files(tmp_path / "out") == files(tmp_path / "expected")
    assert numbers["units"] == 2 and 60 < numbers["tiles"] and numbers["lots"] == 484
    found = failures(*(tmp_path / "out/failures").rglob("*.jsonl"))
    assert found == failures(tmp_path / "expected/problems.jsonl") and numbers["lost"] + numbers["notes"] + numbers["failed_rows"] == len(found)


def test_rules_that_ask_read_the_lots_of_other_units(tmp_path: Path) -> None:
    lots = towns.town()
    parts = towns.batches(lots, 100, 1)
    read = [sum(map(len, groups(towns.plan(city(tmp_path / name, rules), parts), parts))) for name, rules in [("plain", PLAIN), ("asking", ASKING)]]
    assert read[0] == 484 < read[1]


@pytest.mark.parametrize("rules", [PLAIN, ASKING])
def test_batches_make_no_difference_and_finished_units_are_kept(tmp_path: Path, rules: str) -> None:
    lots = towns.town()
    numbers = make(city(tmp_path / "one", rules), [lots])
    assert make(city(tmp_path / "two", rules), towns.batches(lots, 37, 2)) == numbers
    made = files(tmp_path / "one")
    assert 60 < len(made) and made == files(tmp_path / "two")
    tables = [[file.name for file in (tmp_path / name / "failures/rows").iterdir()] for name in ("one", "two")]
    assert len(tables[0]) == 1 < len(tables[1])

    # A part of the table for each batch of this run, a damaged tile of a finished unit, and a file that a lost machine had begun.
    units = {file: file.stat().st_mtime_ns for file in (tmp_path / "two/units").rglob("*.json")}
    (tmp_path / "two/tiles/.part-1").write_text("begun")
    assert make(city(tmp_path / "two", rules), towns.batches(lots, 200, 3)) == numbers
    assert units == {file: file.stat().st_mtime_ns for file in (tmp_path / "two/units").rglob("*.json")}
    assert made == files(tmp_path / "two") and not (tmp_path / "two/tiles/.part-1").exists()
    assert failures(*(tmp_path / "one/failures").rglob("*.jsonl")) == failures(*(tmp_path / "two/failures").rglob("*.jsonl"))

    # Other rules make other tiles, and a first city's files do not stay.
    fewer = lots.slice(0, 240)
    make(city(tmp_path / "two", rules, lod=[]), [fewer])
    make(city(tmp_path / "three", rules, lod=[]), [fewer])
    assert files(tmp_path / "two") == files(tmp_path / "three") != made


def test_rows_that_cannot_be_used_are_in_the_table(tmp_path: Path) -> None:
    numbers = make(city(tmp_path, PLAIN), towns.batches(towns.town(), 50, 1))
    rows = failures(*(tmp_path / "failures/rows").iterdir())
    assert [(name, lost) for name, lost, _ in rows] == [("482", True), ("483", True), ("484", True), ("485", False), ("486", False)]
    assert "`900` is not from 2 to 90" in rows[3][2] and "`castle` is not one of home, shop, hall" in rows[4][2]
    buildings = failures(*(tmp_path / "failures/buildings").iterdir())
    assert numbers["lost"] == len(buildings) > 10 and all(lost for _, lost, _ in buildings)
    assert (numbers["failed_rows"], numbers["lost_rows"]) == (5, 3)


def test_equal_batches_of_rows_that_cannot_be_used_have_all_their_lines(tmp_path: Path) -> None:
    house = pa.table({"geometry": pa.array([shapely.box(9, 48, 9.0001, 48.0001).wkb], pa.binary())})
    broken = pa.table({"geometry": pa.array([None, b""], pa.binary())})
    for count in (3, 2):
        numbers = make(city(tmp_path, PLAIN), [house] + count * [broken])
        assert (numbers["lots"], numbers["failed_rows"], numbers["lost_rows"]) == (1, 2 * count, 2 * count)
        assert len(failures(*(tmp_path / "failures/rows").iterdir())) == 2 * count


def test_lots_that_changed_after_they_were_counted_are_refused(tmp_path: Path) -> None:
    lots = towns.town(broken=False)
    plan = towns.plan(city(tmp_path, ASKING), [lots])
    taller = lots.set_column(1, "height", pa.array([7.5] * len(lots)))
    for changed in (lots.slice(1), pa.concat_tables([lots, lots.slice(0, 1)]), taller):
        with pytest.raises(pycga.CityError, match=CHANGED):
            [plan.make(group) for group in groups(plan, [changed])]
    far = shapely.box(20, 48, 20.0001, 48.0001).wkb
    with pytest.raises(pycga.CityError, match="the lots have changed since they were counted"):
        plan.lots(pa.table({"geometry": [far]}))
    assert not (tmp_path / "tileset.json").exists()


def test_all_units_are_needed(tmp_path: Path) -> None:
    lots = towns.town(broken=False)
    plan = towns.plan(city(tmp_path, PLAIN), [lots])
    one, other = groups(plan, [lots])
    made = plan.make(one)
    with pytest.raises(pycga.CityError, match="1 of 2 units are not made"):
        plan.finish([made, made])
    for group, why in [
        (pa.concat_tables([one, other]), "lots of several units"),
        (one.slice(0, 0), "the group is empty"),
        (lots, "no column `unit`"),
        (pa.table({"unit": [9], "lot": [b""]}), "no unit 9"),
        (pa.table({"unit": [0], "lot": [b"no"]}), "not a footprint"),
        (pa.table({"unit": [0], "lot": [bytes(14)]}), "not a footprint: a ring has no area"),
    ]:
        with pytest.raises(pycga.CityError, match=why):
            plan.make(group)
    with pytest.raises(pycga.CityError, match="not a result of `make`"):
        plan.finish([b"no"])
    assert plan.finish([plan.make(other), made])["units"] == len(plan) == 2


def test_wrong_choices_and_tables_are_refused_with_a_reason(tmp_path: Path) -> None:
    rules = pycga.RuleFile.from_text(PLAIN, name="town")
    (tmp_path / "own").mkdir()
    (tmp_path / "own/note.txt").write_text("mine")
    for error, why, folder, choices in [
        (pycga.CityError, "has files that are not a city", "own", {}),
        (pycga.CityError, "its start rules are Lot, Wall, Block", "out", {"lod": ["Blok"]}),
        (pycga.CityError, "hight", "out", {"attributes": {"hight": 3}}),
        (pycga.AttributeValueError, "`storeys` is not an attribute", "out", {"columns": {"storeys": "floors"}}),
        (ValueError, "crs: ", "out", {"crs": "Gauss"}),
        (ValueError, "from 0 to 1000 metres", "out", {"context_distance": 1001.0}),
        (ValueError, "lod: ", "out", {"lod": ["@2"]}),
    ]:
        with pytest.raises(error, match=why):
            pycga.City(tmp_path / folder, rules, **choices)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="not a RuleFile"):
        pycga.City(tmp_path / "out", "town.cga")  # type: ignore[arg-type]
    named = pycga.RuleFile(towns.write(tmp_path, PLAIN, towns.town())[1], name="other")
    with pytest.raises(ValueError, match="have the name of their file"):
        pycga.City(tmp_path / "out", named)

    lots = towns.town()
    one = city(tmp_path / "out", PLAIN)
    for choices, why in [({"name": "gid"}, "no column `gid`; did you mean `id`?"), ({"geometry": "geom"}, "no column `geom`")]:
        with pytest.raises(pycga.CityError, match=why):
            city(tmp_path / "out", PLAIN, **choices).count(lots)
    with pytest.raises(pycga.CityError, match="`height` is Float64, and not WKB|`height` is double, and not WKB"):
        city(tmp_path / "out", PLAIN, geometry="height").count(lots)
    with pytest.raises(pycga.CityError, match="the column `id` has the type"):
        one.count(lots.set_column(0, "id", pa.array([[1]] * len(lots))))
    for table in ([1], lots["geometry"], lots["geometry"].to_pandas()):
        with pytest.raises(TypeError, match="not a table of Arrow"):
            one.count(table)  # type: ignore[arg-type]
    with pytest.raises(pycga.CityError, match="count all rows again"):
        one.plan([city(tmp_path / "out", ASKING).count(lots)])
    with pytest.raises(pycga.CityError, match="not the counts of rows"):
        one.plan([b"no"])
    with pytest.raises(pycga.CityError, match="the city is empty"):
        one.plan([one.count(lots.slice(481, 3))])


def test_attributes_may_be_arrays(tmp_path: Path) -> None:
    names = ["", "shed", 'a "wide; low" \\ house']
    text = 'attr sizes = [1]  attr names = [""]  attr flags = [true]  Lot --> report("size", sizes[1, 1]) report("name", names[2]) '
    rules = pycga.RuleFile.from_text(text + 'report("flag", flags[1]) extrude(3) X.', name="town")
    third = 1 / 3
    for attributes, digits in [
        ({"sizes": [[1, 2], [3, third]], "names": names, "flags": [True, False]}, third),
        ({"sizes": [[1.0, 2.0], [3.0, 1e300]], "names": tuple(names), "flags": [False, True]}, 1e300),
    ]:
        folder = tmp_path / str(digits)
        make(pycga.City(folder, rules, attributes=attributes), [towns.town(1, 1, broken=False)])  # type: ignore[arg-type]
        (tile,) = folder.rglob("*.glb")
        bytes_of_tile = tile.read_bytes()
        assert struct.pack("<d", digits) in bytes_of_tile and names[2].encode() in bytes_of_tile
    make(pycga.City(tmp_path / "empty", rules, attributes={"sizes": [], "names": []}), [towns.town(1, 1, broken=False)])


def test_rules_of_several_files_and_metres(tmp_path: Path) -> None:
    files_of_rules = [pycga.RuleFile.from_text(PLAIN, name="town"), pycga.RuleFile.from_text("Lot --> extrude(3) Flat.", name="shed")]
    boxes = [shapely.box(500_000 + 30 * n, 5_300_000, 500_016 + 30 * n, 5_300_011).wkb for n in range(4)]
    lots = pa.table({"HOEHE": ["7.5", "8", "9", "10"], "rules": ["town", "shed", None, "barn"], "geometry": boxes})
    choices = {"columns": {"height": "HOEHE"}, "grammar_column": "rules", "crs": 25832}
    one = pycga.City(tmp_path, files_of_rules, **choices)  # type: ignore[arg-type]
    assert make(one, [lots])["buildings"] == 3
    assert [why for _, _, why in failures(*(tmp_path / "failures/rows").iterdir())] == ["`barn` is not one of the grammars town, shed"]


def test_ctrl_c_ends_a_unit_and_other_threads_go_on(tmp_path: Path) -> None:
    lots = towns.town(40, 100, broken=False)
    plan = towns.plan(city(tmp_path, ASKING, unit_lots=65_536), [lots])
    (group, *_) = groups(plan, [lots])
    timer = threading.Timer(0.2, _thread.interrupt_main)
    with pytest.raises(KeyboardInterrupt):
        timer.start()
        while True:
            plan.make(group, threads=1)
            for file in [*(tmp_path / "units").rglob("*.json"), *(tmp_path / "tiles").rglob("*.json")]:
                file.unlink()
    timer.join()


def test_a_machine_with_other_assets_makes_no_tiles(tmp_path: Path) -> None:
    sign = tmp_path / "assets/sign.obj"
    sign.parent.mkdir()
    sign.write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n")
    rules = pycga.RuleFile.from_text('Lot --> i("sign.obj") X.', name="town", assets=sign.parent)
    lots = towns.town(1, 4, broken=False)
    plan = towns.plan(pycga.City(tmp_path / "out", rules), [lots])
    copy = pickle.dumps(plan)
    assert pickle.loads(copy).finish([plan.make(group) for group in groups(plan, [lots])])["buildings"] == 4
    sign.write_text("v 0 0 0\nv 1 0 0\nv 2 2 0\nf 1 2 3\n")
    with pytest.raises(pycga.CityError, match="this machine has other assets"):
        pickle.loads(copy)
