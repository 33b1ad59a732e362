"""Runs that are ended: Ctrl-C, deadlines, limits, memory. The interpreter lock is free meanwhile."""

import _thread
import subprocess
import sys
import threading
from collections.abc import Callable

import pytest
from conftest import ENDLESS, NO_LIMITS

import pycga

LOT = pycga.Shape.rectangle(4, 3)
Run = Callable[[pycga.RuleFile, float], object]
RUNS: list[Run] = [
    lambda rules, deadline: rules.generate(LOT, limits=NO_LIMITS, deadline=deadline),
    lambda rules, deadline: rules.generate_all([LOT] * 8, limits=NO_LIMITS, deadline=deadline),
]


def test_a_deadline_ends_a_run(endless: pycga.RuleFile) -> None:
    with pytest.raises(pycga.DeadlineError, match="0.05 seconds"):
        endless.generate(LOT, limits=NO_LIMITS, deadline=0.05)
    models = endless.generate_all([LOT] * 8, limits=NO_LIMITS, deadline=0.05)
    assert len(models) == 0 and [one.kind for one in models.failures] == ["deadline"] * 8
    for wrong in (-1.0, float("nan"), float("inf")):
        with pytest.raises(ValueError, match="deadline"):
            endless.generate(LOT, deadline=wrong)


@pytest.mark.parametrize("run", RUNS)
def test_other_threads_go_on_during_a_run(endless: pycga.RuleFile, run: Run) -> None:
    begun = threading.Event()

    # It can end the run only if it gets the interpreter lock before the deadline.
    def interrupt() -> None:
        begun.wait()
        for _ in range(100_000):
            pass
        _thread.interrupt_main()

    thread = threading.Thread(target=interrupt)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        begun.set()
        run(endless, 300.0)
    thread.join()
    # Nothing is left of the signal.
    assert len(pycga.RuleFile.from_text("Lot --> X.").generate(LOT)) == 1


def test_runs_of_several_threads_are_independent(house: pycga.RuleFile) -> None:
    made: dict[int, bytes] = {}

    def work(number: int) -> None:
        made[number] = house.generate(LOT, seed=number).to_glb()

    threads = [threading.Thread(target=work, args=(number,)) for number in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert made == {number: house.generate(LOT, seed=number).to_glb() for number in range(8)}


def test_limits_end_a_run(endless: pycga.RuleFile) -> None:
    with pytest.raises(pycga.RunError, match="more shapes than the limit of 1000 allows") as raised:
        endless.generate(LOT, limits={"shapes": 1000})
    assert raised.value.trail[0] == "Lot"
    for wrong in ({"shape": 3}, {"shapes": -1}, {"shapes": "many"}, {"shapes": 2**70}):
        with pytest.raises(ValueError, match="limits"):
            endless.generate(LOT, limits=wrong)  # type: ignore[arg-type]


HUNGRY = f"""
import resource, threading, pycga
resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
lot = pycga.Shape.rectangle(4, 3)
texts = [
    {ENDLESS!r},
    "Lot --> split(x) {{ {{ 0.000001 : X. }}* }}",
    "Lot --> Lot Lot",
    "f(n) = f(n + 1) + 1  Lot --> extrude(f(0)) X.",
    'f(s, n) = case n == 0 : s else : f(s + s, n - 1)  Lot --> print(f("abc", 60)) X.',
    "Lot --> " + "extrude(1) " * 1_000 + "X.",
    "Lot --> extrude(" + "(" * 100_000 + "1" + ")" * 100_000 + ") X.",
    "Lot --> " + "[" * 100_000 + "X." + "]" * 100_000,
    "a" * 1_000_000, "\\0\\ufffe", "Lot --> X. " * 20_000,
]
def run():
    for text in texts:
        try:
            rules = pycga.RuleFile.from_text(text)
            rules.generate(lot, limits={{"bytes": 200_000_000}}, deadline=60)
        except pycga.CgaError as error:
            print(type(error).__name__, str(error).splitlines()[0][:60])
        else:
            print("made")
# The stack of this thread does not matter.
threading.stack_size(256 * 1024)
thread = threading.Thread(target=run)
thread.start()
thread.join()
print("end")
"""


@pytest.mark.skipif(sys.platform != "linux", reason="the limit of memory is Linux's")
def test_bad_rules_are_exceptions_in_bounded_memory_and_stack() -> None:
    done = subprocess.run([sys.executable, "-c", HUNGRY], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout.endswith("end\n") and "Panic" not in done.stdout + done.stderr, done.stdout + done.stderr
    assert "panicked" not in done.stderr, done.stderr
    assert done.stdout.count("\n") == 12, done.stdout
