"""Edits of nested data and of bytes that hypothesis draws; MPSOLVE_FUZZ_SECONDS asks for longer runs."""

from __future__ import annotations

import copy
import math
import os
import time
from collections.abc import Callable
from typing import Any

from hypothesis import HealthCheck, given, seed, settings
from hypothesis import strategies as st

SECONDS = float(os.environ.get("MPSOLVE_FUZZ_SECONDS", "0"))
"""So long each test may run; 0: a few seconds, always with the same examples."""

DEEP: Any = []
for _ in range(200):
    DEEP = [DEEP]

ODD: list[Any] = [
    0, 1, -1, 2, 3, 2**53, -(2**200), 2**200 + 1, 10**600, -1101, 1100, 65536, True, False, None,
    "", "0", "-0", "1", "-1", "1/0", "0/1", "1e9", "1e-400", "0x0", "-0x1", "0x", "nan", "inf", "½", "٣", "1_000",
    "9" * 119, "9" * 5000, "1/" + "9" * 119, "unstable", "below", "sheet", "link", "turn", "passive", "upper",
    [], {}, [0], [1, 0], [[]], [1, 0, 0], [0, 0, "1"], {"kind": "unstable"}, {"kind": "sheet"}, {"kind": ["x"]}, DEEP,
]  # fmt: skip


def fuzzed(quick: int, *strategies: st.SearchStrategy[Any]) -> Callable[[Callable[..., None]], Callable[[], None]]:
    """A test of `quick` examples, always the same; with SECONDS, more of them until these are over."""
    slow = [HealthCheck.too_slow, HealthCheck.data_too_large]
    few = settings(max_examples=quick, deadline=None, suppress_health_check=slow, derandomize=False, database=None)

    def wrap(one: Callable[..., None]) -> Callable[[], None]:
        def test() -> None:
            until, number = time.monotonic() + SECONDS, 0
            while not number or time.monotonic() < until:
                seed(number)(few(given(*strategies)(one)))()
                number += 1

        test.__name__, test.__doc__ = one.__name__, one.__doc__
        return test

    return wrap


def places(value: Any, at: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """The paths to all that is in nested lists and objects."""
    inner: list[tuple[Any, Any]] = []
    if isinstance(value, dict):
        inner = list(value.items())
    elif isinstance(value, list):
        inner = list(enumerate(value))
    return [at] * bool(at) + [place for k, v in inner for place in places(v, (*at, k))]


def near(value: Any) -> st.SearchStrategy[Any]:
    """Values like this one: numbers moved a little or far, texts and lists cut, doubled, turned round."""
    if isinstance(value, bool) or value is None:
        return st.sampled_from([True, False, None, 0, 1])
    if isinstance(value, int):
        moved = st.sampled_from([1, -1, 2, -2, 8, -8, 1000, -value, -2 * value, value, value * 2**40])
        return moved.map(lambda d: value + d)
    if isinstance(value, float):
        whole = int(value) if math.isfinite(value) else 0
        return st.sampled_from(
            [-value, 0.0, value / 2, value * 1e9, 1e308, 5e-324, float("inf"), float("nan"), whole]
        )
    if isinstance(value, str):
        number = st.integers(-999, 999)
        made = [value + "0", "-" + value, value[1:], value[:-1], value + "/3", value + "/7", value * 2, value.upper()]
        return st.one_of(st.sampled_from(made), number.map(str))
    if isinstance(value, list):
        made_lists = [value[:-1], value[1:], value + value[-1:], value[::-1], value * 2, [value], value[:1] * 40]
        return st.sampled_from(made_lists)
    return st.sampled_from([{}, [value], {**value, "more": 1}, dict(list(value.items())[1:])])


@st.composite
def edited(draw: st.DrawFn, whole: Any, most: int = 3) -> Any:
    """The data with one to `most` places changed."""
    out = copy.deepcopy(whole)
    for _ in range(draw(st.integers(1, most))):
        everywhere = places(out)
        if not everywhere:
            return out
        depth = draw(st.integers(1, 9))  # long lists of points do not take all the edits
        at = draw(st.sampled_from([p for p in everywhere if len(p) <= depth] or everywhere))
        home = out
        for key in at[:-1]:
            home = home[key]
        what = draw(st.integers(0, 9))
        if what == 0:
            del home[at[-1]]
        elif what < 4:
            home[at[-1]] = copy.deepcopy(draw(st.sampled_from(ODD)))
        elif what < 9:
            home[at[-1]] = copy.deepcopy(draw(near(home[at[-1]])))
        else:
            other = draw(st.sampled_from(everywhere))
            value = out
            for key in other:
                value = value[key] if not isinstance(value, str) and _has(value, key) else value
            home[at[-1]] = copy.deepcopy(value)
    return out


def _has(value: Any, key: Any) -> bool:
    return (
        key in value if isinstance(value, dict) else isinstance(value, list) and type(key) is int and key < len(value)
    )


@st.composite
def flipped(draw: st.DrawFn, raw: bytes) -> bytes:
    """The bytes with a few changed, cut out, doubled or put in."""
    out = bytearray(raw)
    for _ in range(draw(st.integers(1, 4))):
        at = draw(st.integers(0, len(out)))
        what = draw(st.integers(0, 4))
        if what == 0 and at < len(out):
            out[at] ^= 1 << draw(st.integers(0, 7))
        elif what == 1:
            del out[at : at + draw(st.integers(1, 40))]
        elif what == 2:
            out[at:at] = out[at : at + draw(st.integers(1, 40))]
        elif what == 3:
            out[at:at] = draw(st.binary(max_size=6))
        else:
            out[at:at] = draw(
                st.sampled_from([b"[", b"{", b'"', b",", b"9" * 5000, b"-", b"e9", b".5", b"\n", b"'''"])
            )
    return bytes(out)
