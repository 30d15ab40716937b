"""Zeros of analytic functions: `roots` at 15 digits, proved and verified, beside cxroots and skzeros, uncertified.

cxroots gets f and f′ on numpy arrays and its Romberg integration, its fastest rule here; skzeros gets the same and a
disc's bounding square. One run each, in processor time, with an end after LIMIT seconds. "wrong": another number
of zeros than is proved, or a zero off by more than 10⁻⁶. `python tests/bench/bench_roots.py` prints the table of
docs/how-to/roots.md.
"""

from __future__ import annotations

import signal
import sys
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from time import process_time
from typing import Any

import numpy as np
import pytest
from measure import Counted, seconds
from roots_cases import Trial, trials

from mpsolve import Disc, real_roots, roots

LIMIT = 30
NEEDS = "the comparison needs cxroots: pip install '.[bench]'"
REAL = [
    ("IntervalRootFinding #122", "(z - 1)**3*(z**2 - 2*z - 24.11)", -10, 10, 3, 5),
    ("tan x", "tan(z)", -10, 10, 7, 7),
    ("tan √(2E) + √(E/(3π² − E))", "tan(sqrt(2*z)) + sqrt(z/(3*pi**2 - z))", "0.1", "29", 2, 2),
]


@dataclass(frozen=True)
class Theirs:
    """What another program found."""

    time: float
    evaluations: int
    zeros: tuple[complex, ...] | None
    failure: str = ""


def limited(find: Callable[[], list[complex]], f: Counted, df: Counted) -> Theirs:
    """The zeros that are found within LIMIT seconds, or why there are none."""

    def end(*_: Any) -> None:
        raise TimeoutError(f"not done in {LIMIT} s")

    before = signal.signal(signal.SIGVTALRM, end)
    signal.setitimer(signal.ITIMER_VIRTUAL, LIMIT)
    start = process_time()
    try:
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")
            zeros: tuple[complex, ...] | None = tuple(find())
            failure = ""
    except Exception as error:  # noqa: BLE001 — whatever the other program raises is its answer
        zeros, failure = None, f"{type(error).__name__}: {str(error)[:60]}"
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before)
    return Theirs(process_time() - start, f.points + df.points, zeros, failure)


def by_cxroots(cxroots: Any, trial: Trial) -> Theirs:
    f, df = Counted(trial.f), Counted(trial.df)
    region = trial.region
    if isinstance(region, Disc):
        contour = cxroots.Circle(complex(*map(float, region.centre)), float(region.radius))
    else:
        a, b, c, d = map(float, region.bounds)
        contour = cxroots.Rectangle((a, b), (c, d))

    def find() -> list[complex]:
        result = contour.roots(f, df, int_method="romb")
        return [
            complex(r) for r, n in zip(result.roots, result.multiplicities, strict=True) for _ in range(round(n.real))
        ]

    return limited(find, f, df)


def by_skzeros(skzeros: Any, trial: Trial) -> Theirs:
    f, df = Counted(trial.f), Counted(trial.df)
    box = trial.region.polygon
    low = complex(*(float(min(p[k] for p in box)) for k in (0, 1)))
    high = complex(*(float(max(p[k] for p in box)) for k in (0, 1)))

    def find() -> list[complex]:
        result = skzeros.find_zeros(skzeros.Rectangle(low, high), f, df, 5, rng=np.random.default_rng(1))
        pairs = zip(result.zeros, result.multiplicities, strict=True)
        zeros = [complex(z) for z, n in pairs for _ in range(round(float(n)))]
        if isinstance(trial.region, Disc):
            zeros = [z for z in zeros if abs(z) < float(trial.region.radius)]
        return zeros

    return limited(find, f, df)


def judged(theirs: Theirs, proved: list[complex]) -> tuple[str, bool]:
    """Digits, or what is wrong; and whether it is right."""
    if theirs.zeros is None:
        return theirs.failure, False
    if len(theirs.zeros) != len(proved):
        return f"wrong: {len(theirs.zeros)} of {len(proved)} zeros", False
    rest, worst = list(proved), 0.0
    for z in theirs.zeros:
        nearest = min(rest, key=lambda one: abs(one - z))
        rest.remove(nearest)
        worst = max(worst, abs(nearest - z) / max(abs(nearest), 1.0))
    if worst > 1e-6:
        return f"wrong: a zero off by {worst:.0e}", False
    return f"{-np.log10(max(worst, 1e-16)):.0f} digits", True


def ours(trial: Trial) -> tuple[Any, list[complex]]:
    roots(trial.text, trial.region, cuts=trial.cuts, check=False)  # imports and caches
    answer = roots(trial.text, trial.region, cuts=trial.cuts)
    return answer, [complex(zero.q) for zero in answer.roots for _ in range(zero.multiplicity)]


def others() -> list[tuple[str, Any, Callable[[Any, Trial], Theirs]]]:
    found = []
    for name, run in (("cxroots", by_cxroots), ("skzeros", by_skzeros)):
        try:
            found.append((name, __import__(name), run))
        except ImportError:
            continue
    return found


def row(
    trial: Trial, programs: list[tuple[str, Any, Callable[[Any, Trial], Theirs]]]
) -> tuple[list[str], dict[str, bool]]:
    """One line of the table, and which of the others are slower or wrong."""
    answer, proved = ours(trial)
    cells = [trial.name, str(answer.count if answer.proved else answer.reason)]
    cost = answer.cost
    cells.append(f"{seconds(cost.seconds).strip()} + {seconds(cost.verification).strip()}, {cost.evaluations}")
    beaten = {}
    for name, module, run in programs:
        theirs = run(module, trial)
        word, right = judged(theirs, proved)
        cells.append(f"{seconds(theirs.time).strip()}, {theirs.evaluations}, {word}")
        beaten[name] = not right or theirs.time > answer.cost.seconds + answer.cost.verification
    return cells, beaten


def table() -> None:
    programs = others()
    head = [
        "case",
        "zeros",
        "roots: proof + check, evaluations",
        *(f"{p[0]}: time, evaluations, digits" for p in programs),
    ]
    print("| " + " | ".join(head) + " |\n|" + "---|" * len(head))
    beaten: dict[str, int] = {}
    for trial in trials():
        cells, lost = row(trial, programs)
        print("| " + " | ".join(cells) + " |", flush=True)
        for name, better in lost.items():
            beaten[name] = beaten.get(name, 0) + better
    for name, text, a, b, *_ in REAL:
        real_roots(text, a, b)
        answer = real_roots(text, a, b)
        cost = answer.cost
        times = f"{seconds(cost.seconds).strip()} + {seconds(cost.verification).strip()}, {cost.evaluations}"
        print(f"| {name} | {answer.count} real | {times} |" + " — |" * len(programs), flush=True)
    print(f"\nfaster, or right where the other is wrong, in {beaten} of {len(trials())}")


@pytest.mark.parametrize("trial", trials(), ids=lambda trial: trial.name)
def test_zeros_are_proved_and_faster_than_by_cxroots(trial: Trial) -> None:
    cxroots = pytest.importorskip("cxroots", reason=NEEDS)
    cells, _ = row(trial, [("cxroots", cxroots, by_cxroots)])
    print(" | ".join(cells))
    assert cells[1] == str(trial.count)


if __name__ == "__main__":
    sys.exit(table())
