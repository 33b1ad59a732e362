"""Rules: loading, attributes, start rules, errors, copies."""

import multiprocessing
import pickle
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Any

import pytest
from conftest import EXAMPLES

import pycga

TYPES = """
/// How high it is.
@Group("Size") @Range(min = 3, max = 60, restricted = true) attr height = 12
@Enum("brick", "stone") attr wall = "brick"
attr lit = true
attr sizes = [1, 2; 3, 4]
attr flags = [true, false]
attr names = ["a", "b"]
attr width = scope.sx
@Hidden attr secret = 1
@StartRule Lot --> print(height) print(wall) print(lit) print(sizes) print(flags) print(names) print(width) print(secret) X.
/// Another one.
Other --> Y.
"""


@pytest.fixture(scope="module")
def types() -> pycga.RuleFile:
    return pycga.RuleFile.from_text(TYPES, name="types")


LOT = pycga.Shape.rectangle(4, 3)


def test_attributes_have_types_defaults_ranges_and_descriptions(types: pycga.RuleFile) -> None:
    rows = types.attributes
    assert list(rows) == ["height", "wall", "lit", "sizes", "flags", "names", "width", "secret"]
    assert [row.type for row in rows.values()] == ["float", "string", "bool", "float[]", "bool[]", "string[]", "float", "float"]
    height = rows["height"]
    assert (height.default, height.range, height.restricted, height.about, height.group) == (12.0, (3.0, 60.0), True, "How high it is.", ["Size"])
    assert (rows["wall"].choices, rows["wall"].default) == (["brick", "stone"], "brick")
    assert rows["lit"].default is True
    assert rows["sizes"].default == [[1.0, 2.0], [3.0, 4.0]]
    assert (rows["flags"].default, rows["names"].default) == ([True, False], ["a", "b"])
    assert rows["width"].default is None and rows["secret"].hidden
    assert [(rule.name, rule.marked, rule.about) for rule in types.start_rules] == [("Lot", True, ""), ("Other", False, "Another one.")]


def test_values_reach_the_rules_and_come_back(types: pycga.RuleFile) -> None:
    import numpy as np

    values: dict[str, Any] = {
        "height": np.float32(7.5),
        "wall": "stone",
        "lit": np.bool_(False),
        "sizes": np.array([[5, 6]]),
        "flags": (True,),
        "names": [],
        "width": 2,
    }
    model = types.generate(LOT, attributes=values)
    assert model.prints[0] == "7.5" and model.prints[2] == "false" and model.prints[6] == "2"
    expected = {"height": 7.5, "wall": "stone", "lit": False, "sizes": [5.0, 6.0], "flags": [True], "names": [], "width": 2.0, "secret": 1.0}
    assert model.attributes == expected
    again = types.generate(LOT, attributes=model.attributes)
    assert again.to_glb() == model.to_glb()
    # None is the default.
    assert types.generate(LOT, attributes={"height": None}).attributes["height"] == 12.0


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"hight": 3}, "unknown attribute `hight`; did you mean `height`?"),
        ({"colour": 3}, "unknown attribute `colour`; the attributes are height, wall, lit, sizes, flags, names, width"),
        ({"colour": None}, "colour"),
        ({"height": "tall"}, "attribute `height` is a number, and the value is text"),
        ({"height": True}, "attribute `height` is a number, and the value is true or false"),
        ({"height": [1, 2]}, "attribute `height` is a number, and the value is an array of numbers"),
        ({"height": 2}, "attribute `height`: 2 is outside of 3 to 60"),
        ({"height": object()}, "attribute `height`: an object of the type `object` is not a number"),
        ({"height": 10**400}, "attribute `height`: OverflowError"),
        ({"names": ["a", 1]}, "attribute `names`: its elements have different types"),
        ({"sizes": [[1, 2], [3]]}, "attribute `sizes`: its rows have different lengths"),
        ({"sizes": [[1], 2]}, "attribute `sizes`: some elements are lists and others are not"),
        ({"sizes": [[[1]]]}, "attribute `sizes`: an element is an object of the type `list`"),
        ({"wall": "\ud800"}, "attribute `wall`: UnicodeEncodeError"),
    ],
)
def test_wrong_values_are_named(types: pycga.RuleFile, values: dict[str, Any], message: str) -> None:
    for run in (lambda: types.generate(LOT, attributes=values), lambda: types.generate_all([LOT], attributes=values)):
        with pytest.raises(pycga.AttributeValueError) as raised:
            run()
        assert message in str(raised.value)


def test_several_wrong_values_are_named_at_once(types: pycga.RuleFile) -> None:
    with pytest.raises(pycga.AttributeValueError) as raised:
        types.generate(LOT, attributes={"hight": 3, "lit": 1})
    assert "`hight`" in str(raised.value) and "`lit`" in str(raised.value)


def test_the_values_of_a_lot_win(types: pycga.RuleFile) -> None:
    lot = pycga.Shape.rectangle(4, 3, name="Mill", attributes={"height": 20}, seed=7, start="Lot")
    model = types.generate(lot, attributes={"height": 10, "wall": "stone"})
    assert (model.attributes["height"], model.attributes["wall"], model.name, model.seed) == (20.0, "stone", "Mill", 7)
    assert (lot.attributes, lot.seed, lot.start) == ({"height": 20.0}, 7, "Lot")
    assert types.generate(lot, seed=3).seed == 3


def test_a_run_starts_with_a_rule(types: pycga.RuleFile) -> None:
    assert types.generate(LOT, start="Other").counts == {"Y": 1}
    with pytest.raises(pycga.RunError, match="`Oter` is not a start rule; the start rules are Lot, Other"):
        types.generate(LOT, start="Oter")


def test_errors_of_rules_are_text_and_data() -> None:
    with pytest.raises(pycga.RuleError) as raised:
        pycga.RuleFile.from_text("Lot -->\n  extrude(3, 4, 5) X.\nX -->", name="broken")
    assert "broken.cga:2:" in str(raised.value) and "extrude(3, 4, 5) X." in str(raised.value)
    first = next(diagnostic for diagnostic in raised.value.diagnostics if diagnostic.line == 2)
    assert (first.level, first.file) == ("error", "broken.cga")
    assert first.code and first.message and str(first) == first.text and first.text in str(raised.value)
    assert first.column < first.end_column


def test_a_missing_file_is_an_error_with_a_diagnostic(tmp_path: Path) -> None:
    with pytest.raises(pycga.RuleError, match="cannot read"):
        pycga.RuleFile(tmp_path / "none.cga")
    with pytest.raises(ValueError, match="does not exist"):
        pycga.RuleFile(EXAMPLES / "house.cga", assets=tmp_path / "none")


def test_warnings_are_data() -> None:
    rules = pycga.RuleFile.from_text("Lot --> extrude(3) Wal")
    assert [(one.level, one.code, one.line) for one in rules.warnings] == [("warning", "undefined_rule", 1)]


def test_imports_are_in_memory_or_on_the_disk(tmp_path: Path) -> None:
    text, walls = 'import walls : "walls.cga"  Lot --> extrude(3) walls.Wall', "Wall --> Brick."
    rules = pycga.RuleFile.from_text(text, name="lot", imports={"walls.cga": walls})
    assert rules.generate(LOT).counts == {"walls.Brick": 1} or list(rules.generate(LOT).counts.values()) == [1]
    assert rules.texts == {"lot.cga": text, "walls.cga": walls}
    (tmp_path / "lot.cga").write_text(text)
    (tmp_path / "walls.cga").write_text(walls)
    assert pycga.RuleFile(tmp_path / "lot.cga").generate(LOT).to_glb() == rules.generate(LOT).to_glb()
    with pytest.raises(pycga.RuleError):
        pycga.RuleFile.from_text(text, name="lot")
    with pytest.raises(ValueError, match="also the name of an import"):
        pycga.RuleFile.from_text(text, name="walls", imports={"walls.cga": walls})


def test_copies_are_made_from_texts(tmp_path: Path) -> None:
    (tmp_path / "lot.cga").write_text('import walls : "walls.cga"  Lot --> extrude(3) walls.Wall')
    (tmp_path / "walls.cga").write_text("Wall --> Brick.")
    rules = pycga.RuleFile(tmp_path / "lot.cga")
    data = pickle.dumps(rules)
    for file in ("lot.cga", "walls.cga"):
        (tmp_path / file).unlink()
    copy = pickle.loads(data)
    assert (copy.name, copy.texts) == (rules.name, rules.texts)
    assert copy.generate(LOT).to_glb() == rules.generate(LOT).to_glb()


def bytes_in_process(rules: pycga.RuleFile, width: float) -> bytes:
    return rules.generate(pycga.Shape.rectangle(width, 8)).to_glb()


def test_other_processes_make_the_same_bytes(house: pycga.RuleFile) -> None:
    widths = [10.0, 12.0, 14.0]
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn")) as pool:
        made = list(pool.map(bytes_in_process, [house] * 3, widths))
    assert made == [bytes_in_process(house, width) for width in widths]


def test_errors_of_workers_have_their_diagnostics() -> None:
    with ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn")) as workers:
        failed = workers.submit(pycga.RuleFile.from_text, "Lot --> extrude(").exception()
    assert isinstance(failed, pycga.RuleError) and "never closed" in str(failed)
    with pytest.raises(pycga.RuleError) as own:
        pycga.RuleFile.from_text("Lot --> extrude(")
    (found,), (expected,) = failed.diagnostics, own.value.diagnostics
    names = ("level", "code", "message", "help", "file", "line", "column", "end_line", "end_column", "text")
    assert [getattr(found, name) for name in names] == [getattr(expected, name) for name in names]
