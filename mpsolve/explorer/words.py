"""What the page says of roots and proofs."""

from __future__ import annotations

from typing import Any

from mpsolve.explorer.proving import Proving


def vibration(q: complex) -> str:
    """A root as a vibration."""
    frequency, rate = abs(q.real) / 6.283185307179586, -q.imag
    grows = f"doubles every {0.6931471805599453 / rate:.3g} s" if rate > 0 else f"decays at {-rate:.3g} 1/s"
    return f"{frequency:.4g} Hz, {grows}"


def region_told(proving: Proving) -> str:
    """What is proved of the region, in words."""
    if proving.region is None:
        return ""
    ends = (f"{path} from {float(a):.5g} to {float(b):.5g}" for path, (a, b) in proving.region.items())
    return f"\nStable all over {' and '.join(ends)}: proved; outlined on the chart."


def told(answer: Any) -> str:
    """The verdict of a proof, what is proved, and what has confirmed it; the equations stand in the certificate."""
    from mpsolve.report import spectrum_words

    confirmed = spectrum_words.verified(answer).split("\n")[0]
    return "\n".join([spectrum_words.verdict(answer), *spectrum_words.proved(answer), confirmed])
