"""Rules and lots of several tests."""

from pathlib import Path

import pytest

import pycga

EXAMPLES = Path(__file__).parent.parent / "examples"

# A run of it does not end, and it keeps nothing.
ENDLESS = "Lot --> Grow(60)  Grow(n) --> case n < 1 : NIL else : Grow(n - 1) Grow(n - 1)"
NO_LIMITS = {"shapes": 10**18, "bytes": 10**18, "depth": 1000}


@pytest.fixture(scope="session")
def house() -> pycga.RuleFile:
    return pycga.RuleFile(EXAMPLES / "house.cga")


@pytest.fixture(scope="session")
def endless() -> pycga.RuleFile:
    return pycga.RuleFile.from_text(ENDLESS, name="endless")


@pytest.fixture(scope="session")
def box() -> pycga.RuleFile:
    """A box with a front and other sides."""
    return pycga.RuleFile.from_text(
        "attr height = 5  Lot --> extrude(height) comp(f) { front : Front. | side : Side. | top : Top. | bottom : Bottom. }", name="box"
    )


@pytest.fixture(scope="session")
def solid() -> pycga.RuleFile:
    """A box as one part, which has a volume."""
    return pycga.RuleFile.from_text("attr height = 5  Lot --> extrude(height) Solid.", name="solid")
