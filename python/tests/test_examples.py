"""The examples run. Examples whose packages are missing are skipped; `.ci/python` names them."""

import importlib.util
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import towns
from conftest import EXAMPLES

import pycga

NEEDS = {
    "hello.py": [],
    "geopandas_town.py": ["geopandas"],
    "ray_town.py": ["ray"],
    "spark_town.py": ["pyspark"],
    "ray_tiles.py": ["ray"],
    "spark_tiles.py": ["pyspark"],
    "blender_house.py": ["bpy"],
}
SAYS = {
    "hello.py": "floor area: 816.0 m²",
    "geopandas_town.py": "100 houses,",
    "ray_town.py": "1000 rows",
    "spark_town.py": "1000",
    "ray_tiles.py": "'units': 2,",
    "spark_tiles.py": "'units': 2,",
    "blender_house.py": "objects: ['Glass', 'Roof', 'Wall']",
}


def test_each_example_is_listed_and_short() -> None:
    files = {file.name: file.read_text().count("\n") for file in EXAMPLES.glob("*.py")}
    assert set(files) == set(NEEDS) == set(SAYS) and max(files.values()) < 40


@pytest.mark.parametrize("name", NEEDS)
def test_examples_run(name: str, tmp_path: Path) -> None:
    for package in NEEDS[name]:
        if importlib.util.find_spec(package) is None:
            pytest.skip(f"{package} is not installed")
    if name.startswith("spark") and shutil.which("java") is None:
        pytest.skip("Java is not installed")
    arguments: list[Path] = []
    if name.endswith("_tiles.py"):
        arguments = [*towns.write(tmp_path, towns.ASKING, towns.town()), tmp_path / "tiles"]
    done = subprocess.run([sys.executable, EXAMPLES / name, *arguments], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert SAYS[name] in done.stdout
    if arguments:
        # An engine makes the tiles of one process.
        city = pycga.City(tmp_path / "expected", pycga.RuleFile(arguments[1]), unit_lots=1)
        numbers = towns.make(city, [towns.town()])
        assert towns.files(tmp_path / "tiles") == towns.files(tmp_path / "expected")
        assert str(numbers) in done.stdout
