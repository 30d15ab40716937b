"""Verifying a certificate from its file, against certifying the case: ten cases, every kind of contour."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any
from unittest import mock

import pytest
from measure import Counted, median, seconds

import mpsolve.certificate.verify as verifier
from mpsolve import Case, Rectangle, certify

GOAL = 3
REPEATS = 3
ONE = {"eta_m": "70", "positions": "0"}
TWO = {"eta_m": ("70", "70"), "positions": ("0", "1.5")}
THREE = {"eta_m": ("20", "10", "5"), "positions": ("0", "1.5", "2.5")}
BELOW = Rectangle("-1", "1", "-0.5", "0.02")

CASES: dict[str, tuple[Case, Any]] = {
    "one mass, damped": (Case(alpha="0.6", eta_b="0.05", **ONE), "sheet"),
    "one mass, undamped": (Case(alpha="0.5", eta_b="0", **ONE), "sheet"),
    "two masses, damped": (Case(alpha="0.67", eta_b="0.05", **TWO), "sheet"),
    "two masses, undamped": (Case(alpha="0.5", eta_b="0", **TWO), "sheet"),
    "two masses, compressed": (Case(alpha="0.5", eta_b="0.05", eta_n="0.3", **TWO), "sheet"),
    "two masses at rest": (Case(alpha="0", eta_b="0.05", **TWO), "sheet"),
    "two masses, supercritical": (Case(alpha="1.2", eta_b="0.05", **TWO), "sheet"),
    "three masses, damped": (Case(alpha="0.6", eta_b="0.05", **THREE), "sheet"),
    "two masses, rectangle": (Case(alpha="0.67", eta_b="0.05", **TWO), BELOW),
    "two masses, unstable line": (Case(alpha="0.67", eta_b="1.2", **TWO), "unstable"),
}


def counted_verdict(path: Path) -> tuple[Any, int]:
    """The verdict, and the number of evaluations of Δ on the contour and at the roots."""
    edge, off_cut = Counted(verifier.edge), Counted(verifier.delta_off_cut)
    with mock.patch.object(verifier, "edge", edge), mock.patch.object(verifier, "delta_off_cut", off_cut):
        return verifier.verify(path), edge.calls + off_cut.calls


def compare(name: str) -> None:
    case, region = CASES[name]
    spectrum = certify(case, region=region)
    certifying = median(lambda: certify(case, region=region), REPEATS)
    assert spectrum.certificate is not None
    with tempfile.TemporaryDirectory() as folder:
        path = spectrum.certificate.save(Path(folder) / "case.json")
        verdict, evaluations = counted_verdict(path)
        verifying = median(lambda: verifier.verify(path), REPEATS)
    print(
        f"{name:26} {spectrum.count} roots   certify {seconds(certifying)} "
        f"({spectrum.evaluations} on the contour)   verify {seconds(verifying)} ({evaluations} in all)   "
        f"verify/certify = {verifying / certifying:.2f}  (goal: {GOAL} or less)"
    )
    assert spectrum.proved
    assert verdict.valid, verdict.reason


@pytest.mark.parametrize("name", CASES)
def test_what_is_certified_is_valid(name: str) -> None:
    compare(name)


def main() -> None:
    for name in CASES:
        compare(name)


if __name__ == "__main__":
    main()
