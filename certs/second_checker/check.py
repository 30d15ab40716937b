"""A second checker of certificates of version 2, kind "spectrum": python certs/second_checker/check.py FILE…

Written from certs/SPEC2.md alone, with the standard library alone: balls on Python's integers, p-roots by moving
nodes, amplitudes from jumps, signs by Sturm and Bernstein over the rationals, pieces halved as this checker needs.
Exit status 0 if all files are valid, else 1. "partly checked" is never valid: it names what was not checked.
"""

from __future__ import annotations

import sys
from fractions import Fraction
from typing import Any

from balls import UnclearError
from counting import Walk, count
from enclosures import Root, check_places, check_root
from reading import NotCheckedError, Path, RefusedError, content, dyadic, keys, listed, need, rational, whole
from sheet import check_passive, count_sheet
from track import Track, Vehicle

REGIONS = {
    "unstable": {"kind"},
    "below": {"kind", "height", "reach"},
    "rectangle": {"kind", "re", "im"},
    "disc": {"kind", "radius"},
    "below disc": {"kind", "height", "radius"},
    "sheet": {"kind"},
}


def _region(value: Any) -> dict[str, Any]:
    need(isinstance(value, dict) and value.get("kind") in REGIONS, "the region is unknown")
    keys(value, REGIONS[value["kind"]], "the region")
    for key in ("height", "reach", "radius"):
        need(key not in value or rational(value[key]) > 0, f"{key} is not positive")
    for key in ("re", "im"):
        if key in value:
            low, high = (rational(c) for c in listed(value[key], 2, key))
            need(low < high, "the rectangle is empty")
    return value  # type: ignore[no-any-return]


def check(raw: bytes) -> str:
    """The claim in words, if it is proved. Raises RefusedError, or NotCheckedError."""
    file = content(raw)
    equations = keys(file["equations"], {"track", "velocity", "vehicle"}, "the equations")
    claim = keys(file["claim"], {"region", "count", "unstable"}, "the claim")
    region = _region(claim["region"])
    claimed = whole(claim["count"], 0, 10**6), whole(claim["unstable"], 0, 10**6)
    roots = [Root(value) for value in listed(file["roots"], 10**4, "roots")]
    v = rational(equations["velocity"])
    need(v >= 0, "the velocity is negative")
    track, vehicle = Track(equations["track"], v), Vehicle(equations["vehicle"])
    paths = [Path(value) for value in listed(file["paths"], 200, "paths")]
    need(check_places(roots, region, undamped(track, vehicle)) == claimed, "the balls do not add up to the claim")
    if file["basis"] is not None:
        raise NotCheckedError("everything, as there is a basis of neutral or unfelt motions")
    walk = Walk(track, vehicle)
    for root in roots:
        check_root(walk, root)
    if region["kind"] == "sheet":
        number, pieces = count_sheet(track, vehicle, paths, file["theorem"], dyadic(file["start"]))
        need(number == claimed[0], f"there are {number} frequencies, and the claim says {claimed[0]}")
        return _claim(claimed, region, len(roots), pieces)
    if region["kind"] not in ("unstable", "below", "rectangle"):  # half-discs
        raise NotCheckedError(
            f"that there are no frequencies but those of the {len(roots)} balls (region {region['kind']!r})"
        )
    if region["kind"] == "unstable" and file["theorem"] == {"half": "passive"}:
        check_passive(track, vehicle, paths)
        need(claimed[0] == 0, "nothing grows, and the claim says that something does")
        return _claim(claimed, region, len(roots), 0)
    if file["theorem"] == {"half": "behind"}:
        raise NotCheckedError("that no vibration grows, as all waves stay behind the contact (section 5)")
    top = rational(region["im"][1]) if "im" in region else rational(region.get("height", "0"))
    track.check_premise(max(top, Fraction(0)))
    number = count(walk, region, paths, file["theorem"], dyadic(file["start"]))
    need(number == claimed[0], f"there are {number} frequencies, and the claim says {claimed[0]}")
    return _claim(claimed, region, len(roots), walk.pieces)


def _claim(claimed: tuple[int, int], region: dict[str, Any], balls: int, pieces: int) -> str:
    held = f"exactly {claimed[0]} induced frequencies in {_words(region)}, {claimed[1]} of them with Im q < 0"
    return f"{held}, in {balls} balls, by {pieces} pieces"


def undamped(track: Track, vehicle: Vehicle) -> bool:
    """Whether nothing damps."""
    return all(j % 2 == 0 for _, j in (*track.D, *track.N)) and not any(map(any, vehicle.C))


def _words(region: dict[str, Any]) -> str:
    return ", ".join([str(region["kind"]), *(f"{k} {v}" for k, v in region.items() if k != "kind")])


def main(files: list[str]) -> int:
    """One line a file."""
    fine = bool(files)
    for name in files:
        try:
            with open(name, "rb") as file:
                raw = file.read(16_000_001)
            print(f"valid: {name}: {check(raw)}")
            continue
        except RefusedError as error:
            print(f"invalid: {name}: {error}")
        except NotCheckedError as error:
            print(f"partly checked: {name}: what was checked holds; not checked: {error}")
        except OSError as error:
            print(f"invalid: {name}: the file cannot be read: {error.strerror}")
        except (UnclearError, ArithmeticError, ValueError) as error:
            print(f"partly checked: {name}: not checked, numbers are out of this checker's range: {error}")
        fine = False
    return 0 if fine else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
