"""The proof in one plain sentence, and what the model of the track does not know."""

from __future__ import annotations

from math import pi
from typing import Any

from mpsolve.engineering import pinned_pinned
from mpsolve.numbers.spoken import rounded
from mpsolve.page.parts import Parts
from mpsolve.page.words import speech
from mpsolve.spectrum.regions import Below, HalfPlane

_SPACING = "0.6 m"
_LAYERED = ("two-layer", "three-layer")


def plain(parts: Parts) -> str:
    """What is proved without a symbol; "" where nothing is, or the region is one that the reader chose."""
    spectrum = parts.spectrum
    region = spectrum.region
    if not spectrum.proved or getattr(region, "radius", None) is not None:
        return ""
    unstable = sum(root.multiplicity for root in spectrum.roots if root.q.imag < 0 and not root.q.real < 0)
    grows = "none grows" if not spectrum.unstable else f"{unstable} {'grow' if unstable > 1 else 'grows'}"
    if isinstance(region, HalfPlane):
        return "No vibration grows." if not spectrum.unstable else f"Of all vibrations {grows}."
    if not isinstance(region, Below):
        return ""
    number = sum(root.multiplicity for root in spectrum.roots if not root.q.real < 0)
    rate = speech(parts).rate(region.height)
    end = (
        ""
        if region.reach is None or not speech(parts).si
        else f" below {rounded(float(region.reach) / (2 * pi), 2)} Hz"
    )
    felt = " that a contact feels" if spectrum.unfelt else ""
    if not number:
        return f"No vibration{felt} decays more slowly than {rate}{end}, and none grows."
    many = f"1 vibration{felt} decays" if number == 1 else f"{number} vibrations{felt} decay"
    told = f"{many} more slowly than {rate}{end}"
    if spectrum.unstable:
        kind = f"vibration{felt} grows, or decays" if number == 1 else f"vibrations{felt} grow, or decay"
        told = f"{number} {kind} more slowly than {rate}{end}"
    return f"{told}, and all of them are in the table; {grows}."


def scope(parts: Parts) -> list[str]:
    """What a reader must know of the values, for a rail."""
    track: Any = parts.problem.track
    if not speech(parts).si or not hasattr(track, "EI"):
        return []
    said = ["Which rails the values are for: as a rule one rail, with half of each sleeper, wheelset and body."]
    if track.name in _LAYERED:
        limit = rounded(pinned_pinned(track.EI, track.m, _SPACING).value, 2)
        said.append(
            "Single sleepers: they are smeared along the track. Near and above the frequency at which the rail "
            f"vibrates between them, {limit} Hz if they are {_SPACING} apart, the model means little."
        )
    return said
