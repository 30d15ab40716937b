"""The verdict on any track and vehicle, and the sentences that say exactly what is proved and what is assumed."""

from __future__ import annotations

from collections.abc import Iterator
from math import log, pi

from mpsolve.frozen import frozen
from mpsolve.numbers.balls import precision
from mpsolve.numbers.decimals import outward
from mpsolve.numbers.spoken import rounded, spoken
from mpsolve.outcome import Status
from mpsolve.problem.case import Case
from mpsolve.problem.cases import as_problem
from mpsolve.problem.line import line_height
from mpsolve.report.vibration import Trend, trend
from mpsolve.spectrum.behind import BEHIND
from mpsolve.spectrum.regions import Below, HalfPlane, Rectangle, Sheet
from mpsolve.spectrum.spectrum import Root, Spectrum, disjoint

ASSUMED = (
    "The model: an endless track that is the same everywhere, small motions, vehicles that move at a constant "
    "velocity and never leave it. The software: Python, and FLINT's ball arithmetic."
)
NOT_PROVED = f"Assumed, not proved. {ASSUMED}"
_PLACES = 8
_LONG = 130
"""Letters of a matrix that is read with ease."""


@frozen
class Units:
    """What q, frequency, growth rate and time are measured in."""

    q: str
    frequency: str
    rate: str
    time: str


SI = Units("rad/s", "Hz", "1/s", "s")
DIMENSIONLESS = Units("√(k/m)", "1/τ", "1/τ", "τ")


def units_of(spectrum: Spectrum) -> Units:
    """SI, as far as the problem is given in it; a Case has the paper's units."""
    return DIMENSIONLESS if isinstance(spectrum.problem, Case) else SI


def verdict(spectrum: Spectrum) -> str:
    """One sentence that begins with STABLE, UNSTABLE, NO GROWTH (in a part of the half-plane) or UNDECIDED.

    It is for whoever decides: the velocity, what grows, how fast. Figures are few, and hold for all of their balls.
    """
    if not spectrum.proved:
        return f"UNDECIDED: {spectrum.reason}."
    if spectrum.unstable:
        return f"UNSTABLE {at_velocity(spectrum)}: {_growing(spectrum)}."
    if spectrum.stable:
        return f"STABLE {at_velocity(spectrum)}: {_all_decay(spectrum)}."
    if isinstance(spectrum.region, Rectangle):
        return "NO GROWTH in this rectangle: no root with Im q < 0 there; outside it, none was looked for."
    radius = getattr(spectrum.region, "radius", None)
    shown = outward(float(radius), 6, up=False) if radius is not None else "its radius"
    return f"NO GROWTH where |q| < {shown}: no root with Im q < 0 there; beyond it, the question is open."


def proved(spectrum: Spectrum) -> tuple[str, ...]:
    """The sentences that are proved; where the answer is undecided, what is known all the same."""
    if not spectrum.proved:
        return tuple(_known(spectrum))
    number = spectrum.count or 0
    said = [f"{_roots(number)}{', counted with multiplicity,' if number > 1 else ''} {_where(spectrum)}."]
    if spectrum.note:
        said.append(f"The region is not all that was asked for: {spectrum.note}.")
    if spectrum.closing:
        said.append(f"None is missed: {spectrum.closing}.")
    said += filter(None, [beyond(spectrum)])
    return (*said, *_apart(spectrum), *_balls(spectrum))


def beyond(spectrum: Spectrum) -> str:
    """Which vibrations were not looked at, and where they show; "" where none were left out, or in a rectangle."""
    region, units = spectrum.region, units_of(spectrum)
    if not isinstance(region, (Below, HalfPlane)) or not spectrum.proved:
        return ""
    elsewhere = "the motion itself (response) holds all of them"
    if isinstance(region, HalfPlane):
        return f"Not looked at: vibrations that decay; {elsewhere}."
    time = log(2) / float(region.height)
    short = spoken(time, "s") if units.time == "s" else f"{rounded(time)} {units.time}"
    fast = ""
    if region.reach is not None:
        fast = f", nor those above {rounded(float(region.reach) / (2 * pi))} {units.frequency} that decay"
    return f"Not looked at: vibrations that halve in less than {short}, as waves of the track do{fast}; {elsewhere}."


def _known(spectrum: Spectrum) -> Iterator[str]:
    known = spectrum.known
    if "count" in known:
        found = sum(root.multiplicity for root in spectrum.roots)
        enclosed = f"; {found} of them are enclosed" if found and disjoint(spectrum.roots) else ""
        yield f"{_roots(known['count'])} {_where(spectrum)}{enclosed}."
    if "growth" in known:
        rate, units = outward(float(known["growth"]) * (1 + 2.0**-50), 6, up=True), units_of(spectrum)
        yield f"Nothing grows as fast as {rate} {units.rate}: no zero has Im q ≤ -{rate} {units.q}."
    if "outside" in known:
        depth, width = (outward(float(x), 6, up=True) for x in (-known["outside"].im_min, known["outside"].re_max))
        yield f"Whatever grows lies where |Re q| ≤ {width} and Im q ≥ -{depth}: no zero with Im q < 0 is elsewhere."
    for strip, number in known.get("strips", ()):
        yield f"{_roots(number)} where {strip}."
    if known.get("open"):
        yield f"Not counted yet: {'; '.join(map(str, known['open']))}."


def verified(spectrum: Spectrum) -> str:
    """What the standalone verifier has confirmed."""
    if spectrum.status is Status.UNVERIFIED:
        return f"Proved, not verified: {spectrum.verified or 'the certificate was not checked'}."
    return f"The standalone verifier confirms: {spectrum.verified}." if spectrum.verified else ""


def verified_briefly(spectrum: Spectrum) -> str:
    """The same for people: a matrix of many bodies by its size, as `mpsolve verify` prints it."""
    return "\n".join(
        f"{line.partition('=')[0]}= … ({line.count('], [') + 1} rows, printed by mpsolve verify)"
        if "= [[" in line and len(line) > _LONG
        else line
        for line in verified(spectrum).split("\n")
    )


def at_velocity(spectrum: Spectrum) -> str:
    """At which velocity, as people say it: "at 252 km/h (70 m/s)", "at rest", "at α = 0.67"."""
    given = spectrum.problem
    if isinstance(given, Case):
        return f"at α = {given.alpha.short()}"
    v = as_problem(given).v
    return f"at {spoken(v, 'm/s')} ({rounded(v)} m/s)" if v else "at rest"


def _growing(spectrum: Spectrum) -> str:
    """The unstable roots as vibrations: a pair q, −q̄ is one."""
    growing = [root for root in spectrum.roots if root.q.imag < 0 and not root.q.real < 0]
    if not growing:
        return f"{spectrum.unstable} roots q with Im q < 0, so that vibrations grow"
    with precision(max(64, *(root.q.bits() + 32 for root in growing))):
        first = max(growing, key=lambda root: float(root.growth.mid()))
        time = f"doubles every {_doubling(spectrum, first)}"
        swings = first.q.real != 0
        where = f"{rounded(first.frequency)} {units_of(spectrum).frequency}" if swings else "without oscillation"
        if len(growing) == 1:
            several = f" ({first.multiplicity} times)" if first.multiplicity > 1 else ""
            return f"a vibration at {where} {time}{several}" if swings else f"a deflection {time}, {where}"
        leads = all(other.growth < first.growth for other in growing if other is not first)
        place = f"at {where}" if swings else where
        return f"{len(growing)} vibrations grow; {'the fastest' if leads else 'one'}, {place}, {time}"


def _doubling(spectrum: Spectrum, root: Root) -> str:
    unit = units_of(spectrum).time
    return spoken(root.doubling_time, unit) if unit == "s" else f"{rounded(root.doubling_time)} {unit}"


def _all_decay(spectrum: Spectrum) -> str:
    if any(trend(root) is Trend.STEADY for root in spectrum.roots):
        return "no vibration grows; some neither grow nor decay"
    if line_height(as_problem(spectrum.problem).track) == 0:
        return "nothing grows; without damping of the track vibrations need not decay"
    if spectrum.closing == BEHIND:
        return "nothing grows; what no damper of the vehicle holds need not decay"
    if not all(q.imag > 0 for q in spectrum.unfelt):
        return "no vibration grows; one that no contact feels need not decay"
    return "every vibration decays"


def _roots(number: int) -> str:
    zeros = {0: "no zero", 1: "exactly one zero"}.get(number, f"exactly {number} zeros")
    return f"The characteristic function Δ(q) has {zeros}"


def _where(spectrum: Spectrum) -> str:
    region = spectrum.region
    if isinstance(region, Sheet):
        return "on the whole physical sheet (the q-plane without the branch cuts)"
    if isinstance(region, HalfPlane) and region.radius is None:
        return "in the whole unstable half-plane Im q < 0"
    if isinstance(region, Below):
        return f"in the region below the branch cuts {region}"
    return f"in the region {region}"


def _apart(spectrum: Spectrum) -> tuple[str, ...]:
    """What is left out of the count."""
    said = []
    if spectrum.neutral:
        times = "once" if spectrum.neutral == 1 else f"{spectrum.neutral} times"
        said.append(
            f"Besides, q = 0 is a root {times} by construction: bodies that dampers alone hold may stay anywhere."
        )
    if spectrum.unfelt:
        number = len(spectrum.unfelt)
        said.append(
            f"Besides, the vehicle has {number} roots of motions that no contact feels, which are listed apart."
        )
    return tuple(said)


def _balls(spectrum: Spectrum) -> tuple[str, ...]:
    if not spectrum.roots:
        return ()
    single = all(root.multiplicity == 1 for root in spectrum.roots)
    held = "exactly one zero" if single else "exactly as many zeros as its line says"
    said = (
        f"Each q stands for a ball of relative radius below 1e-{spectrum.digits} that holds {held}; the last digit "
        "of every number is right to one unit. The balls are disjoint."
    )
    mirrored = any(root.q.real > 0 or root.q.real < 0 for root in spectrum.roots)
    return (f"{said} Where Re q ≠ 0, −q̄ is a zero too, and both are one vibration." if mirrored else said,)
