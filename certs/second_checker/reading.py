"""Reads a certificate of version 2: plain bounded values, or RefusedError."""

from __future__ import annotations

import hashlib
import itertools
import json
import re
from fractions import Fraction
from typing import Any

Point = tuple[Fraction, Fraction]
MOST_BYTES, MOST_POINTS = 16_000_000, 20_000
KEYS = {
    "format",
    "version",
    "kind",
    "equations",
    "basis",
    "bits",
    "start",
    "paths",
    "theorem",
    "claim",
    "roots",
    "sha256",
}
RATIONAL = re.compile(r"-?[0-9]{1,120}(/[0-9]{1,120})?", re.ASCII)


class RefusedError(Exception):
    """The certificate does not prove its claim, or is none."""


class NotCheckedError(Exception):
    """This checker cannot do that part. It says nothing about the certificate."""


def need(truth: bool, words: str) -> None:
    """Raise RefusedError unless it is so."""
    if truth is not True:
        raise RefusedError(words)


def keys(value: Any, names: set[str], what: str) -> dict[str, Any]:
    need(isinstance(value, dict) and set(value) == names, f"{what}: keys are missing or unknown")
    return value  # type: ignore[no-any-return]


def rational(value: Any) -> Fraction:
    need(isinstance(value, str) and RATIONAL.fullmatch(value) is not None, "a rational is not written as one")
    need("/" not in value or int(value.split("/")[1]) > 0, "a denominator is 0")
    return Fraction(value)


def whole(value: Any, low: int, high: int) -> int:
    need(type(value) is int and low <= value <= high, "an integer is out of range")
    return value  # type: ignore[no-any-return]


def dyadic(value: Any) -> Fraction:
    need(isinstance(value, list) and len(value) == 2, "a dyadic number is [m, e]")
    return whole(value[0], -(2**200), 2**200) * Fraction(2) ** whole(value[1], -1100, 1100)


def point(value: Any) -> Point:
    need(isinstance(value, list) and len(value) in (2, 3), "a point is [m, n, e] or two rationals")
    if len(value) == 2:
        return rational(value[0]), rational(value[1])
    unit = Fraction(2) ** whole(value[2], -1100, 1100)
    return whole(value[0], -(2**200), 2**200) * unit, whole(value[1], -(2**200), 2**200) * unit


def listed(value: Any, most: int, what: str) -> list[Any]:
    need(isinstance(value, list) and len(value) <= most, f"{what}: no list, or too long")
    return value  # type: ignore[no-any-return]


def matrix(value: Any, rows: int, columns: int, what: str) -> list[list[Fraction]]:
    for row in listed(value, 64, what):
        need(len(listed(row, 64, what)) == columns, f"{what} has another shape")
    need(len(value) == rows, f"{what} has another shape")
    return [[rational(x) for x in row] for row in value]


def _pairs(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    out = dict(pairs)
    need(len(out) == len(pairs), "a key is there twice")
    return out


def _no_float(text: str) -> Any:
    raise RefusedError(f"{text[:20]}: no floats belong in a certificate")


def content(raw: bytes) -> dict[str, Any]:
    """The content of a certificate's bytes, after the checks of the format that need no mathematics."""
    need(len(raw) <= MOST_BYTES, "the file is too large")
    try:
        value = json.loads(
            raw.decode("ascii"), object_pairs_hook=_pairs, parse_float=_no_float, parse_constant=_no_float
        )
    except (ValueError, RecursionError) as error:
        raise RefusedError(f"no JSON in ASCII ({str(error)[:80]})") from None
    need(isinstance(value, dict), "no object")
    kind = (value.get("format"), value.get("version"), value.get("kind"))
    need(
        kind == ("mpsolve certificate", 2, "spectrum") and type(kind[1]) is int,
        "no spectrum certificate of version 2",
    )
    keys(value, KEYS, "the certificate")
    rest = {k: v for k, v in value.items() if k != "sha256"}
    text = json.dumps(rest, sort_keys=True, separators=(",", ":"))
    need(value["sha256"] == hashlib.sha256(text.encode("ascii")).hexdigest(), "the checksum is of another content")
    whole(value["bits"], 53, 256)
    return rest | {"sha256": value["sha256"]}


class Path:
    """A path of the file."""

    def __init__(self, value: Any) -> None:
        need(isinstance(value, dict) and set(value) == {"kind", "points"}, "a path's keys")
        self.kind = value["kind"]
        need(self.kind in ("link", "turn", "passive"), "a path's kind is unknown")
        self.points = [point(p) for p in listed(value["points"], MOST_POINTS, "points")]
        need(len(self.points) >= 1, "a path without points")
        need(all(p != q for p, q in zip(self.points, self.points[1:], strict=False)), "a piece without length")


def along(points: list[Point], corners: list[Point]) -> bool:
    """Whether the points run in order along the polygon of the corners, each of which is a point."""
    if points[0] != corners[0] or points[-1] != corners[-1]:
        return False
    k = 0
    for p, q in itertools.pairwise(points):
        if k + 1 >= len(corners):
            return False
        (x, y), (u, w) = corners[k], corners[k + 1]
        dx, dy = u - x, w - y
        forward = (q[0] - p[0]) * dx + (q[1] - p[1]) * dy
        on = (q[0] - x) * dy == (q[1] - y) * dx
        inside = (u - q[0]) * dx + (w - q[1]) * dy
        if forward <= 0 or not on or inside < 0:
            return False
        if q == corners[k + 1]:
            k += 1
    return k + 1 == len(corners)
