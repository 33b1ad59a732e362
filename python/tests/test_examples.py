"""The examples run. Examples whose packages are missing are skipped; `.ci/python` names them."""

import importlib.util
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import EXAMPLES

NEEDS = {
    "hello.py": [],
    "geopandas_town.py": ["geopandas"],
    "ray_town.py": ["ray"],
    "spark_town.py": ["pyspark"],
    "blender_house.py": ["bpy"],
}
SAYS = {
    "hello.py": "floor area: 816.0 m²",
    "geopandas_town.py": "100 houses,",
    "ray_town.py": "1000 rows",
    "spark_town.py": "1000",
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
    if name == "spark_town.py" and shutil.which("java") is None:
        pytest.skip("Java is not installed")
    done = subprocess.run([sys.executable, EXAMPLES / name], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert SAYS[name] in done.stdout
