"""The verdict, and the sentences that say exactly what is proved and what is assumed."""

from __future__ import annotations

import decimal

from mpsolve.certificate.sheet import SheetSpectrum, known_count
from mpsolve.fields import ball_arithmetic
from mpsolve.model.limits import critical_velocity_ratio, limiting_frequency
from mpsolve.numbers.decimals import proved_digits
from mpsolve.numbers.exact import Exact
from mpsolve.outcome import Status
from mpsolve.report.vibration import Trend, trend
from mpsolve.spectrum.regions import Rectangle

_LIMIT_BITS = 128
_LIMIT_DIGITS = 10


def verdict(spectrum: SheetSpectrum) -> str:
    """One sentence that begins with STABLE, UNSTABLE, NO GROWTH (in a rectangle only) or UNDECIDED."""
    if not spectrum.proved:
        return f"UNDECIDED: {spectrum.reason}."
    number = spectrum.unstable
    if number:
        return f"UNSTABLE: {_induced(number)} with Im q < 0, so the vibration grows without bound."
    if isinstance(spectrum.region, Rectangle):
        return "NO GROWTH in this rectangle: no root with Im q < 0 there; outside it, none was looked for."
    if not spectrum.case.eta_b:
        return "STABLE: no root with Im q < 0; the undamped vibration neither grows nor decays."
    return "STABLE: no root with Im q < 0, so every vibration decays."


def proved(spectrum: SheetSpectrum) -> tuple[str, ...]:
    """The sentences that are proved of the count, the far field and the balls; empty if nothing is."""
    return tuple(sentence for sentence in (_count(spectrum), _balls(spectrum), _verified(spectrum)) if sentence)


def radius_text(radius: float) -> str:
    """The radius, a dyadic float, in exact decimals."""
    return f"{decimal.Decimal(radius).normalize():f}"


def limits(spectrum: SheetSpectrum) -> dict[str, str]:
    """Proved digits of q_lm and α_C, under these names; empty where the cuts leave the line Im q = η_b.

    q_lm is left out where the cuts are joined.
    """
    if not spectrum.case.cuts_on_line:
        return {}
    with ball_arithmetic(_LIMIT_BITS) as field:
        found = {"α_C": proved_digits(critical_velocity_ratio(spectrum.case, field), _LIMIT_DIGITS)}
        start = limiting_frequency(spectrum.case, field)
        if start > 0:
            found["q_lm"] = proved_digits(start, _LIMIT_DIGITS)
    return found


def _induced(number: int) -> str:
    return "one induced frequency" if number == 1 else f"{number} induced frequencies"


def _count(spectrum: SheetSpectrum) -> str:
    number = known_count(spectrum)
    if number is None:
        return ""
    zeros = {0: "no zero", 1: "exactly one zero"}.get(number, f"exactly {number} zeros")
    counted = ", counted with multiplicity," if number > 1 else ""
    far = ""
    if spectrum.radius is not None and number:
        far = f", and none of them has |q − iη_b| ≥ {radius_text(spectrum.radius)}"
    name = "Δ(q), eq. (26)," if spectrum.case.count == 2 else "The characteristic function Δ(q), (26) for two masses,"
    return f"{name} has {zeros}{counted} {_scope(spectrum)}{far}."


def _scope(spectrum: SheetSpectrum) -> str:
    region = spectrum.region
    if isinstance(region, Rectangle):
        bounds = [Exact.parse(x).short(12) for x in region.bounds]
        return f"in the rectangle {bounds[0]} < Re q < {bounds[1]}, {bounds[2]} < Im q < {bounds[3]}"
    if region == "unstable":
        return "in the unstable half-plane Im q < 0"
    if "q_lm" in limits(spectrum):
        return "on the whole physical sheet (the q-plane without the two cuts Im q = η_b, |Re q| ≥ q_lm)"
    return "on the whole physical sheet (the q-plane without the joined cuts, the line Im q = η_b)"


def _verified(spectrum: SheetSpectrum) -> str:
    """Nothing where the verifier has confirmed it."""
    return "Proved, not verified: the certificate was not checked." if spectrum.status is Status.UNVERIFIED else ""


def _balls(spectrum: SheetSpectrum) -> str:
    """What the printed roots are; a multiplicity above 1 is the number of roots in a cluster's ball."""
    if not spectrum.roots:
        return ""
    single = all(root.multiplicity == 1 for root in spectrum.roots)
    held = "exactly one zero" if single else "exactly as many zeros as its line says"
    sentences = [
        f"Each q stands for a ball, of relative radius below 1e-{spectrum.digits}, that holds {held}; "
        "the last digit of every number is right to one unit.",
        "The balls are disjoint." if spectrum.proved else "There may be more zeros than these.",
    ]
    if any(root.q.real > 0 or root.q.real < 0 for root in spectrum.roots):
        sentences.append("Where Re q ≠ 0, −q̄ is a zero too, and both are one vibration.")
    if any(trend(root) is Trend.STEADY for root in spectrum.roots):
        sentences.append("A zero with Im q = 0 is proved to be real.")
    return " ".join(sentences)
