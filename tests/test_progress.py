"""What long functions tell: stages with the part that is done, from 0 to 1."""

from __future__ import annotations

from collections import defaultdict

from mpsolve import Case, certify, onset
from mpsolve.progress import silent

PAIR = Case(alpha="0.67", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))


def test_stages_go_from_0_to_1() -> None:
    for work in (
        lambda tell: certify(PAIR, region="unstable", digits=15, progress=tell),
        lambda tell: onset(PAIR, over={"v": ("0.66", "0.68")}, progress=tell),
    ):
        told: dict[str, list[float]] = defaultdict(list)
        work(lambda stage, fraction, told=told: told[stage].append(fraction))
        assert told
        assert all(stage and all(0 <= x <= 1 for x in parts) for stage, parts in told.items())


def test_nobody_need_listen() -> None:
    assert silent("count", 0.5) is None  # type: ignore[func-returns-value]
