"""A hostile file cannot keep the verifier busy: what it asks for is added up first, and refused at once."""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from functools import cache
from typing import Any

import pytest

from mpsolve import Case
from mpsolve.certificate import verify
from mpsolve.certificate.format import digest
from mpsolve.certificate.sheet import certify_sheet as certify
from mpsolve.certificate.verify import MAX_WORK, judge, work

Content = dict[str, Any]
QUICK = 3.0  # seconds of the processor for a file of megabytes
LONG = "0x1" + "3" * 29_000


@cache
def sheet() -> str:
    certificate = certify(
        Case(alpha="0.67", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5")), digits=15
    ).certificate
    assert certificate is not None
    return json.dumps(certificate.content)


def crowd(content: Content, masses: int = 24) -> None:
    content["case"].update(eta_m=["1"] * masses, positions=[str(k) for k in range(masses)])


def breaks(number: int) -> list[Any]:
    return [[hex(2**20 + k), -20] for k in range(number)]


def crossings(content: Content, number: int = 1000) -> None:
    one = {"x": LONG, "x_exponent": -116_002, "t": LONG, "t_exponent": -116_002, "direction": 1, "reach": ["0x1", -9]}
    base = {"t": "1/2", "certificate": json.loads(sheet())}
    family = {"parameter": "alpha", "start": "1/4", "end": "3/4"}
    case = content["case"]
    content.clear()
    content |= {"format": "mpsolve certificate", "version": 1, "kind": "crossings", "case": case, "family": family}
    content |= {"height": "0", "radius": ["0x1", 9], "crossings": [one] * number, "base": base}
    content |= {"claim": {"counts": [0] * (number + 1)}}


def heavy_base(content: Content) -> None:
    crossings(content, 0)
    crowd(content)
    inner = content["base"]["certificate"]
    crowd(inner)
    inner["contour"]["breaks"] = breaks(200_000)
    inner["sha256"] = digest({k: v for k, v in inner.items() if k != "sha256"})


LONG_ROOT = {"re": LONG, "im": LONG, "exponent": -116_002, "multiplicity": 1, "axis": "none"}
HOSTILE: dict[str, Callable[[Content], object]] = {
    "pieces for many masses": lambda c: (crowd(c), c["contour"].update(breaks=breaks(300_000))),
    "pieces at a high precision": lambda c: (crowd(c, 8), c["contour"].update(bits=512, breaks=breaks(299_000))),
    "long roots": lambda c: c.update(roots=[LONG_ROOT] * 300, identity=[1] * 300),
    "long roots of many masses": lambda c: (crowd(c), c.update(roots=[LONG_ROOT] * 12, identity=[1] * 12)),
    "long clusters": lambda c: c.update(roots=[LONG_ROOT | {"multiplicity": 2}] * 100, identity=[2] * 100),
    "long crossings": crossings,
    "a heavy base": heavy_base,
}


@pytest.mark.parametrize("name", HOSTILE)
def test_too_much_work_is_refused_at_once(name: str) -> None:
    content = json.loads(sheet())
    HOSTILE[name](content)
    content.pop("sha256", None)
    raw = json.dumps(content | {"sha256": digest(content)}).encode()
    start = time.process_time()
    verdict = judge(raw)
    assert time.process_time() - start < QUICK
    assert not verdict.valid
    assert "too much work" in verdict.reason


def test_the_bisection_is_bounded_by_what_is_left() -> None:
    """With 24 masses a box takes a tenth of a second: no more than two thousand are looked at."""
    assert MAX_WORK // work(24, 64) < 2_500
    case = Case(alpha="0.5", eta_b="0.1", eta_m=(1, 1), positions=(0, 1))
    with verify.precision(64):
        family = verify.Family(verify.numbers(verify.problem(case.as_dict())), "alpha", verify.arb(0))
        with pytest.raises(verify.Refused, match="5 boxes do not prove"):
            verify.prove_free(family, (0.0, 64.0, 0.0, 2.0), [], 5 * work(2, 64))


@pytest.mark.parametrize(("masses", "bits"), [(1, 64), (2, 64), (4, 64), (2, 10_000), (3, 1_000)])
def test_the_estimate_of_work_is_about_a_microsecond(masses: int, bits: int) -> None:
    case = Case(alpha="0.3", eta_b="0.1", eta_m=(1,) * masses, positions=range(masses))
    with verify.precision(bits):
        n = verify.numbers(verify.problem(case.as_dict()))
        start = time.process_time()
        for _ in range(3):
            verify.delta_off_cut(n, verify.acb("2.5", "0.2"))
        spent = (time.process_time() - start) / 3
    assert spent < 20e-6 * work(masses, bits)


def test_p_roots_that_meet_are_told_apart_without_a_high_precision() -> None:
    """Seeds of a long root take the precision of its digits once at most, not sixteen times as much."""
    start = time.process_time()
    with verify.precision(60_000):
        n = verify.numbers(verify.problem(Case(alpha=0, eta_b="0.6", eta_m=1).as_dict()))
        with pytest.raises(verify.Refused):
            verify.roots_off_cut(n, verify.acb("0.8", "0.6"))  # r = β = 4/5: all four roots are two double ones
    assert time.process_time() - start < QUICK
