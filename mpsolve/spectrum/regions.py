"""The region in which roots are counted, in the problem's own units."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from mpsolve.errors import InputError
from mpsolve.numbers.model import rational, shown


@dataclass(frozen=True)
class HalfPlane:
    """Im q < 0; where `radius` is given, only |q| < radius."""

    radius: Fraction | None = None

    def __str__(self) -> str:
        return "Im q < 0" if self.radius is None else f"Im q < 0, |q| < {float(self.radius):.6g}"


@dataclass(frozen=True)
class Below:
    """Im q < 0, and with it Im q < height as far as |Re q| < reach; with a `radius`, below 0 only |q| < radius."""

    height: Fraction
    reach: Fraction | None = None
    radius: Fraction | None = None

    def __str__(self) -> str:
        reach = "" if self.reach is None else f" where |Re q| < {float(self.reach):.6g}"
        lower = "Im q < 0" if self.radius is None else f"Im q < 0, |q| < {float(self.radius):.6g}"
        return f"Im q < {float(self.height):.6g}{reach}, and {lower}"


@dataclass(frozen=True, init=False)
class Box:
    """The open rectangle re_min < Re q < re_max, im_min < Im q < im_max; the bounds are exact rationals."""

    re_min: Fraction
    re_max: Fraction
    im_min: Fraction
    im_max: Fraction

    def __init__(self, re_min: object, re_max: object, im_min: object, im_max: object) -> None:
        given = {"re_min": re_min, "re_max": re_max, "im_min": im_min, "im_max": im_max}
        vars(self).update({name: rational(value, f"region.{name}") for name, value in given.items()})
        for axis in ("re", "im"):
            low, high = getattr(self, f"{axis}_min"), getattr(self, f"{axis}_max")
            if not low < high:
                stated = f"is {shown(high)}, not above {axis}_min = {shown(low)}"
                raise InputError(f"region.{axis}_max", f"{stated}: give the bounds in order")

    def __str__(self) -> str:
        a, b, c, d = (f"{float(x):.6g}" for x in (self.re_min, self.re_max, self.im_min, self.im_max))
        return f"{a} < Re q < {b}, {c} < Im q < {d}"


Region = HalfPlane | Below | Box
