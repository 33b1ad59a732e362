"""The command `cga` makes the same bytes. `CGA_COMMAND` is its path; `.ci/python` builds it."""

import json
import math
import os
import subprocess
from pathlib import Path
from typing import Any

import pytest
from conftest import EXAMPLES

import pycga

COMMAND = os.environ.get("CGA_COMMAND")
pytestmark = pytest.mark.skipif(COMMAND is None, reason="CGA_COMMAND is not set")
RULES = EXAMPLES / "house.cga"


def made(folder: Path, *options: str) -> bytes:
    assert COMMAND is not None
    subprocess.run([COMMAND, "run", RULES, "-o", folder / "made.glb", *options], check=True, capture_output=True)
    return (folder / "made.glb").read_bytes()


@pytest.mark.parametrize(("seed", "values"), [(0, {}), (3, {"height": 12.5}), (2**63, {"wall": "#ff8000"}), (41, {"height": 30, "wall": "#336699"})])
def test_a_lot_has_the_bytes_of_the_command(tmp_path: Path, house: pycga.RuleFile, seed: int, values: dict[str, Any]) -> None:
    options = [option for name, value in values.items() for option in ("--set", f"{name}={value}")]
    expected = made(tmp_path, "--lot", "20.5x12", "--seed", str(seed), *options)
    assert house.generate(pycga.Shape.rectangle(20.5, 12), seed=seed, attributes=values).to_glb() == expected


def test_a_town_has_the_bytes_of_the_command(tmp_path: Path, house: pycga.RuleFile) -> None:
    # Around the equator, where the metres of a degree are exact: the command converts degrees around the middle of the file.
    equator, flattening = 6_378_137.0, 1.0 / 298.257_223_563
    metres = (equator * (math.pi / 180), equator * (1 - flattening * (2 - flattening)) * (math.pi / 180))
    size = 0.000_125
    corners = [(-1, -1), (0, -1), (0, 1), (1, 1), (1, -0.5)]
    boxes = [
        [(size * x, size * y), (size * (x + 0.5), size * y), (size * (x + 0.5), size * (y + 0.5)), (size * x, size * (y + 0.5))] for x, y in corners
    ]
    low = [min(corner[axis] for ring in boxes for corner in ring) for axis in (0, 1)]
    high = [max(corner[axis] for ring in boxes for corner in ring) for axis in (0, 1)]
    low[1], high[1] = -max(-low[1], high[1]), max(-low[1], high[1])
    boxes.append([(0.0, low[1]), (size / 4, low[1]), (size / 4, low[1] + size / 4), (0.0, low[1] + size / 4)])
    boxes.append([(0.0, high[1] - size / 4), (size / 4, high[1] - size / 4), (size / 4, high[1]), (0.0, high[1])])

    def collection(rings: list[Any]) -> dict[str, Any]:
        features = [
            {
                "type": "Feature",
                "id": f"lot {number}",
                "properties": {"height": 6 + number},
                "geometry": {"type": "Polygon", "coordinates": [[*ring, ring[0]]]},
            }
            for number, ring in enumerate(rings)
        ]
        return {"type": "FeatureCollection", "features": features}

    (tmp_path / "town.geojson").write_text(json.dumps(collection(boxes)))
    expected = made(tmp_path, "--footprint", str(tmp_path / "town.geojson"), "--seed", "5")
    middle = (low[0] + high[0]) / 2
    flat = [[((x - middle) * metres[0], y * metres[1]) for x, y in ring] for ring in boxes]
    town = house.generate_all(collection(flat), seed=5)
    assert len(town) == len(boxes) and town.to_model().to_glb() == expected
