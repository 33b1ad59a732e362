"""Everything that the package has is described, and the stub names all of it."""

import inspect
from pathlib import Path
from typing import Any

import pytest

import pycga


def members(owner: Any) -> list[tuple[str, Any]]:
    return [(name, value) for name, value in vars(owner).items() if not name.startswith("_")]


@pytest.mark.parametrize("name", [name for name in pycga.__all__ if name != "__version__"])
def test_each_item_has_a_description(name: str) -> None:
    item = getattr(pycga, name)
    assert inspect.getdoc(item), name
    if isinstance(item, type) and not issubclass(item, Exception):
        for member, value in members(item):
            assert inspect.getdoc(value), f"{name}.{member}"


def test_the_package_has_a_description_and_a_version() -> None:
    manifest = (Path(__file__).parent.parent / "Cargo.toml").read_text()
    assert f'version = "{pycga.__version__}"' in manifest and "CGA rules in Python" in (pycga.__doc__ or "")
